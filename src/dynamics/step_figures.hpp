// The table of a time step's figures, one record each: a new figure is a new record (figure.hpp).
#pragma once

#include <functional>

#include "dynamics/step_record.hpp"

namespace gearfilm {

namespace figure {

/// The value of a StepRecord's data member, or what its member function returns.
template <auto member, class... Rest>
constexpr Figure<StepRecord> of_step(const Rest&... rest) {
  return of<StepRecord>([](const StepRecord& step) { return static_cast<double>(std::invoke(member, step)); }, rest...);
}

}  // namespace figure

inline constexpr auto step_figures = std::to_array<Figure<StepRecord>>(
    {figure::of<StepRecord>(
         [](const StepRecord& step) { return step.motion.H0(); }, "H0", "H_0", units::number,
         "rigid displacement of the flanks", Needs::nothing,
         Reduced{"H0", Reduction::last, units::number, "rigid displacement at the end", Shown::march}),
     figure::of<StepRecord>([](const StepRecord& step) { return step.motion.V0(); }, "V0", "V_0", units::number,
                            "its velocity, dH_0/dT", Needs::nothing,
                            Reduced{"V0", Reduction::last, units::number, "its velocity at the end", Shown::march}),
     figure::of<StepRecord>([](const StepRecord& step) { return step.motion.H0(); }, "h0", "h_0", units::metre,
                            "rigid displacement", Needs::nothing),
     figure::of<StepRecord>([](const StepRecord& step) { return -step.motion.H0(); }, "transmission_error", "",
                            units::metre, "by how much the gears have approached along the line of action: -h_0",
                            Needs::nothing),
     figure::of_step<&StepRecord::pressure_integral>(
         "force_total", "w", units::newton, "force on all contacts together", Needs::nothing,
         Reduced{"total_force_ratio_max", Reduction::largest, units::static_force,
                 "largest force on all contacts together over the static force", Shown::march},
         Reduced{"total_force_ratio_min", Reduction::smallest, units::static_force,
                 "smallest force on all contacts together over the static force", Shown::sweep}),
     figure::of_step<&StepRecord::back_force>(
         "force_back", "w_b", units::newton, "force on back flanks, against that on the contacts", Needs::nothing,
         Reduced{"back_force_ratio_max", Reduction::largest, units::static_force,
                 "largest force on back flanks over the static force", Shown::march}),
     figure::of_step<&StepRecord::power_sliding>("power_sliding", "", units::watt,
                                                 "power that all contacts lose by sliding", Needs::friction,
                                                 Reduced{"power_sliding", Reduction::mean, units::watt,
                                                         "power lost by sliding, mean in time", Shown::everywhere}),
     figure::of_step<&StepRecord::power_rolling>("power_rolling", "", units::watt,
                                                 "power that all contacts lose by rolling", Needs::friction,
                                                 Reduced{"power_rolling", Reduction::mean, units::watt,
                                                         "power lost by rolling, mean in time", Shown::everywhere}),
     figure::of<StepRecord>([](const StepRecord& step) { return step.power_sliding() + step.power_rolling(); },
                            "power_loss", "", units::watt, "both together", Needs::friction,
                            Reduced{"power_loss", Reduction::mean, units::watt,
                                    "power lost by sliding and rolling, mean in time", Shown::everywhere}),
     figure::of<StepRecord>(
         [](const StepRecord& step) { return static_cast<double>(step.contacts.size()); }, "contacts", "", units::count,
         "number of contacts", Needs::nothing, Reduced{"steps", Reduction::steps, units::count, "time steps"},
         Reduced{"contact_steps", Reduction::sum, units::count, "time steps of contacts, each counted by itself"}),
     figure::of_step<&StepRecord::newton>(
         "newton", "", units::count, "iterations of Newton's method", Needs::nothing,
         Reduced{"newton_iterations", Reduction::sum, units::count, "iterations of Newton's method"}),
     figure::of_step<&StepRecord::krylov>(
         "krylov", "", units::count, "iterations of the linear solver", Needs::nothing,
         Reduced{"krylov_iterations", Reduction::sum, units::count, "iterations of the linear solver"}),
     figure::of_step<&StepRecord::wall_seconds>(
         "wall_time", "", units::seconds, "time the step took", Needs::nothing,
         Reduced{"wall_time", Reduction::sum, units::seconds, "time the steps took"})});

}  // namespace gearfilm
