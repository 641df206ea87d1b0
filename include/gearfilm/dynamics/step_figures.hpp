// The table of a time step's figures, one record each: a new figure is a new record (figure.hpp).
#pragma once

#include "gearfilm/dynamics/step_record.hpp"

namespace gearfilm {

inline constexpr auto step_figures = std::to_array<Figure<StepRecord>>({
    {.name = "H0",
     .symbol = "H_0",
     .value = [](const StepRecord& step) { return step.motion.H0; },
     .meaning = "rigid displacement of the flanks",
     .reduced = {{{"H0", Reduction::last, units::number, "rigid displacement at the end", Shown::march}}}},
    {.name = "V0",
     .symbol = "V_0",
     .value = [](const StepRecord& step) { return step.motion.V0; },
     .meaning = "its velocity, dH_0/dT",
     .reduced = {{{"V0", Reduction::last, units::number, "its velocity at the end", Shown::march}}}},
    {.name = "h0",
     .symbol = "h_0",
     .unit = units::metre,
     .value = [](const StepRecord& step) { return step.motion.H0; },
     .meaning = "rigid displacement; the transmission error is its negative"},
    {.name = "force_total",
     .symbol = "w",
     .unit = units::newton,
     .value = [](const StepRecord& step) { return step.pressure_integral(); },
     .meaning = "force on all contacts together",
     .reduced = {{{"total_force_ratio_max", Reduction::largest, units::static_force,
                   "largest force on all contacts together over the static force", Shown::march},
                  {"total_force_ratio_min", Reduction::smallest, units::static_force,
                   "smallest force on all contacts together over the static force", Shown::sweep}}}},
    {.name = "contacts",
     .unit = units::count,
     .value = [](const StepRecord& step) { return static_cast<double>(step.contacts.size()); },
     .meaning = "number of contacts",
     .reduced = {{{"steps", Reduction::steps, units::count, "time steps"},
                  {"contact_steps", Reduction::sum, units::count, "time steps of contacts, each counted by itself"}}}},
    {.name = "newton",
     .unit = units::count,
     .value = [](const StepRecord& step) { return static_cast<double>(step.newton); },
     .meaning = "iterations of Newton's method",
     .reduced = {{{"newton_iterations", Reduction::sum, units::count, "iterations of Newton's method"}}}},
    {.name = "krylov",
     .unit = units::count,
     .value = [](const StepRecord& step) { return static_cast<double>(step.krylov); },
     .meaning = "iterations of the linear solver",
     .reduced = {{{"krylov_iterations", Reduction::sum, units::count, "iterations of the linear solver"}}}},
    {.name = "wall_time",
     .unit = units::seconds,
     .value = [](const StepRecord& step) { return step.wall_seconds; },
     .meaning = "time the step took",
     .reduced = {{{"wall_time", Reduction::sum, units::seconds, "time the steps took"}}}},
});

}  // namespace gearfilm
