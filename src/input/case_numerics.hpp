// Grid, solvers and time steps of a case: what is given, and what the program chooses where nothing is.
#pragma once

#include <string>

#include "input/case.hpp"

namespace gearfilm {

/// Domain, nodes and solvers of the films; the scales and gears of the case are set.
void set_film_numerics(CaseInput& result);

/// Time steps of a gear pair; its grid is set.
void set_time_steps(CaseInput& result);

/// The thinnest film [m] that the program chooses a grid for. Molecules of oil are 1 to 2 nm long; oil between walls
/// less than about ten of them apart is no continuum any more.
constexpr double thinnest_film = 10e-9;
/// What is to be said where the expected film is thinner and the grid chosen; else empty.
std::string thin_film_remark(const CaseInput& problem);

/// The pair has inertia, and it is part of its motion.
bool swings(const CaseInput& problem);
/// The period of a free oscillation of the dry pair [T], of one with inertia; on films, in a drive train, of the
/// highest mode that the mesh feels.
double natural_period(const CaseInput& problem);
/// The largest speed of a march over its first; 1 without a ramp.
double largest_speed_ratio(const ParameterValues& values);
/// The mesh period of a gear pair at the first speed [T].
double mesh_period(const CaseInput& problem);

/// Steps that a mesh period and a free oscillation are given at least, where the program chooses.
constexpr double steps_in_mesh_period = 100.0;
constexpr double steps_in_swing = 40.0;
/// Steps, at least, in which the load of bodies without inertia passes to other contacts.
constexpr int steps_of_transfer = 8;

/// The case as it is, or, where its pair swings so often in a mesh period and it neither says how the bodies move nor
/// asks for what has inertia alone, with bodies in balance at every moment; a remark says so.
CaseInput with_chosen_motion(const CaseInput& given, double many_swings, std::string& remark);

}  // namespace gearfilm
