// What `info` and `eigen` say of a drive train: its modes and where the mesh meets them.
#pragma once

#include "input/case.hpp"
#include "orbits/film_swing.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// What is known of a mode on films; absent where it was not found.
using ModeOnFilms = std::optional<SwingQuantities>;

/// Adds `modes` and what else follows from the train. on_films: of each mode; empty: modes of the dry pair.
void add_train(const CaseInput& problem, const DampedTrain& train, const std::vector<ModeOnFilms>& on_films,
               Summary& summary);

/// Lines of the modes for the screen, of a summary that has them.
std::vector<std::string> mode_lines(const Summary& summary);
/// Where the dampers of elements with a ratio come from.
std::vector<std::string> damping_lines(const Summary& summary);

/// Stiffnesses that are far apart, modes that no step of time could follow, and bearings so soft that the centre
/// distance is another one under load.
std::vector<std::string> train_warnings(const CaseInput& problem, const DampedTrain& train);

/// The tables of the manual, in Markdown.
std::string train_markdown();

}  // namespace gearfilm
