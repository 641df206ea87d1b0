#include "output/xdmf.hpp"

#include <algorithm>
#include <sstream>

#include "gearfilm/error.hpp"
#include "output/output_directory.hpp"

namespace gearfilm {
namespace {

/// Values that stand in the results, or zeros.
void write_data(std::ostream& file, const std::string& size, int zeros, const std::string& dataset) {
  file << "<DataItem Format=\"" << (zeros > 0 ? "XML" : "HDF")
       << "\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"" << size << "\">" << (zeros > 0 ? "0" : dataset);
  for (int n = 1; n < zeros; ++n) file << " 0";
  file << "</DataItem>";
}

/// The fields of a contact; of one that is absent four nodes at one point. Names of grids are made different by
/// readers: they are so here.
void write_contact(std::ostream& file, const std::string& grid, double time, const std::string& results_name,
                   const FieldGroup& group, bool absent) {
  const std::string size = absent ? "2 2" : worded(group.shape.nx, " ", group.shape.ny());
  file << "      <Grid Name=\"" << grid << "\" GridType=\"Uniform\">\n"
       << "        <Time Value=\"" << time << "\"/>\n"
       << "        <Topology TopologyType=\"2DSMesh\" Dimensions=\"" << size << "\"/>\n"
       << "        <Geometry GeometryType=\"XY\">";
  write_data(file, size + " 2", absent ? 8 : 0, results_name + ":" + group.mesh);
  file << "</Geometry>\n";
  for (const std::string& name : group.datasets) {
    file << "        <Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Node\">";
    write_data(file, size, absent ? 4 : 0, results_name + ":" + group.name + "/" + name);
    file << "</Attribute>\n";
  }
  file << "      </Grid>\n";
}

}  // namespace

void write_xdmf(MPI_Comm comm, const std::filesystem::path& path, const std::string& results_name,
                const std::vector<TimedFields>& series) {
  std::size_t blocks = 1;
  for (const TimedFields& fields : series) blocks = std::max(blocks, fields.groups.size());
  std::ostringstream file;
  file.precision(12);
  file << xdmf_head;
  for (std::size_t block = 0; block < blocks; ++block) {
    const std::string name = "pair" + std::to_string(block);
    file << "    <Grid Name=\"" << name << "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (std::size_t n = 0; n < series.size(); ++n) {
      const std::vector<FieldGroup>& groups = series[n].groups;
      if (groups.empty()) continue;
      const std::string grid = name + "_" + std::to_string(n);
      const double time = series[n].time - series.front().time;
      const auto here = std::ranges::find_if(
          groups, [&](const FieldGroup& group) { return static_cast<std::size_t>(group.contact) % blocks == block; });
      const bool absent = here == groups.end();
      write_contact(file, grid, time, results_name, absent ? groups.front() : *here, absent);
    }
    file << "    </Grid>\n";
  }
  file << "  </Domain>\n</Xdmf>\n";
  write_whole(comm, path, file.str());
}

}  // namespace gearfilm
