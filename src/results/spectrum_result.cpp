#include "results/spectrum_result.hpp"

#include "results/members.hpp"

namespace gearfilm {
namespace {

constexpr std::size_t peak_count = 8;

struct LineOfPair {
  const Scales& scales;
  const SpectralLine& line;
};

constexpr auto line_members = std::to_array<Member<LineOfPair>>({
    {"frequency", "f", "Hz", "frequency of the line",
     [](const LineOfPair& of) -> Summary { return of.line.frequency / of.scales.time; }, Column::real},
    {"H0", "H_0", "-", "amplitude of the rigid displacement; of the line at zero: its mean",
     [](const LineOfPair& of) -> Summary { return of.line.amplitude; }, Column::real},
    {"h0", "h_0", "m", "the same",
     [](const LineOfPair& of) -> Summary { return of.scales.thickness * of.line.amplitude; }, Column::real},
});

}  // namespace

Summary write_spectrum(ResultsFile& file, const Scales& scales, const std::vector<SpectralLine>& lines,
                       SpectralWindow window) {
  std::vector<double> rows;
  for (const SpectralLine& line : lines) add_to_row(line_members, LineOfPair{scales, line}, rows);
  write_table(file, "/spectrum", columns_of(line_members), rows);
  Summary peaks = Summary::array();
  for (const SpectralLine& peak : spectral_peaks(lines, window, peak_count))
    peaks.push_back(as_summary(line_members, LineOfPair{scales, peak}));
  return peaks;
}

std::string spectrum_markdown() {
  return members_markdown("`/spectrum`",
                          "One row a line, with `output.spectrum_periods` and of `periodic`; the largest are the "
                          "`spectrum_peaks` of the summary.",
                          line_members);
}

}  // namespace gearfilm
