// The spectrum of a motion: the table /spectrum, and its peaks for the summary.
#pragma once

#include "contact/scales.hpp"
#include "orbits/spectrum.hpp"
#include "output/results_file.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// Writes the table, and returns the largest peaks. Collective.
Summary write_spectrum(ResultsFile& file, const Scales& scales, const std::vector<SpectralLine>& lines,
                       SpectralWindow window);
std::string spectrum_markdown();

}  // namespace gearfilm
