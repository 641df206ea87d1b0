// The table of a time step's quantities, one record each: a new quantity is a new record (quantity.hpp).
#pragma once

#include <functional>

#include "dynamics/step_record.hpp"

namespace gearfilm {

namespace quantity {

/// The value of a StepRecord's data member, or what its member function returns.
template <auto member, class... Rest>
constexpr Quantity<StepRecord> of_step(const Rest&... rest) {
  return of<StepRecord>([](const StepRecord& step) { return static_cast<double>(std::invoke(member, step)); }, rest...);
}

}  // namespace quantity

inline constexpr auto step_quantities = std::to_array<Quantity<StepRecord>>(
    {quantity::of<StepRecord>(
         [](const StepRecord& step) { return step.motion.H0(); }, "H0", "H_0", units::number,
         "rigid displacement of the flanks", RequiredModel::nothing,
         Reduced{"H0", Reduction::last, units::number, "rigid displacement at the end", ShownIn::march}),
     quantity::of<StepRecord>([](const StepRecord& step) { return step.motion.V0(); }, "V0", "V_0", units::number,
                              "its velocity, dH_0/dT", RequiredModel::nothing,
                              Reduced{"V0", Reduction::last, units::number, "its velocity at the end", ShownIn::march}),
     quantity::of<StepRecord>([](const StepRecord& step) { return step.motion.H0(); }, "h0", "h_0", units::metre,
                              "rigid displacement", RequiredModel::nothing),
     quantity::of<StepRecord>([](const StepRecord& step) { return -step.motion.H0(); }, "transmission_error", "",
                              units::metre, "by how much the gears have approached along the line of action: -h_0",
                              RequiredModel::nothing),
     quantity::of_step<&StepRecord::pressure_integral>(
         "force_total", "w", units::newton, "force on all contacts together", RequiredModel::nothing,
         Reduced{"total_force_ratio_max", Reduction::largest, units::static_force,
                 "largest force on all contacts together over the static force", ShownIn::march},
         Reduced{"total_force_ratio_min", Reduction::smallest, units::static_force,
                 "smallest force on all contacts together over the static force", ShownIn::sweep}),
     quantity::of_step<&StepRecord::asperity_load_share>(
         "asperity_load_share", "L_a", units::number, "part of the force that asperities carry",
         RequiredModel::asperities,
         Reduced{"asperity_load_share_mean", Reduction::mean, units::number,
                 "part of the force on all contacts together that asperities carry, mean in time",
                 ShownIn::everywhere}),
     quantity::of_step<&StepRecord::back_force>(
         "force_back", "w_b", units::newton, "force on reverse flanks, against that on the contacts",
         RequiredModel::nothing,
         Reduced{"back_force_ratio_max", Reduction::largest, units::static_force,
                 "largest force on reverse flanks over the static force", ShownIn::march}),
     quantity::of_step<&StepRecord::power_sliding>("power_sliding", "", units::watt,
                                                   "power that all contacts lose by sliding", RequiredModel::friction,
                                                   Reduced{"power_sliding", Reduction::mean, units::watt,
                                                           "power lost by sliding, mean in time", ShownIn::everywhere}),
     quantity::of_step<&StepRecord::power_rolling>("power_rolling", "", units::watt,
                                                   "power that all contacts lose by rolling", RequiredModel::friction,
                                                   Reduced{"power_rolling", Reduction::mean, units::watt,
                                                           "power lost by rolling, mean in time", ShownIn::everywhere}),
     quantity::of<StepRecord>([](const StepRecord& step) { return step.power_sliding() + step.power_rolling(); },
                              "power_loss", "", units::watt, "both together", RequiredModel::friction,
                              Reduced{"power_loss", Reduction::mean, units::watt,
                                      "power lost by sliding and rolling, mean in time", ShownIn::everywhere}),
     quantity::of<StepRecord>(
         [](const StepRecord& step) { return static_cast<double>(step.contacts.size()); }, "contacts", "", units::count,
         "number of contacts", RequiredModel::nothing, Reduced{"steps", Reduction::steps, units::count, "time steps"},
         Reduced{"contact_steps", Reduction::sum, units::count, "time steps of contacts, each counted by itself"}),
     quantity::of_step<&StepRecord::newton>(
         "newton", "", units::count, "iterations of Newton's method", RequiredModel::nothing,
         Reduced{"newton_iterations", Reduction::sum, units::count, "iterations of Newton's method"}),
     quantity::of_step<&StepRecord::krylov>(
         "krylov", "", units::count, "iterations of the linear solver", RequiredModel::nothing,
         Reduced{"krylov_iterations", Reduction::sum, units::count, "iterations of the linear solver"}),
     quantity::of_step<&StepRecord::wall_seconds>(
         "wall_time", "", units::seconds, "time the step took", RequiredModel::nothing,
         Reduced{"wall_time", Reduction::sum, units::seconds, "time the steps took"})});

}  // namespace gearfilm
