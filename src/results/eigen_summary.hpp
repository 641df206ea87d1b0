// What the summary of `eigen` says of the dry pair and of its swing on films.
#pragma once

#include "input/case.hpp"
#include "orbits/film_swing.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Stiffness, inertias, natural frequencies and modes of the dry pair.
Summary dry_pair_summary(const CaseInput& problem);
/// What the damper beside dry contacts makes of their frequency [Hz].
Summary damper_summary(const CaseInput& problem, double f_n);
/// Frequency and damping ratio with their errors, null where no coarser grid has a mode; what the mode took. On stiff
/// films also what the damping ratio is at most.
void add_swing(const FilmSwing& swing, const SwingQuantities& quantities, Summary& summary);

/// What is in these, in the manual's Markdown.
std::string modes_markdown();

}  // namespace gearfilm
