#include "output/xdmf.hpp"

#include <algorithm>
#include <sstream>

#include "output/output_directory.hpp"

namespace gearfilm {
namespace {

void write_data(std::ostream& file, const std::string& size, const std::string& dataset) {
  file << "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"" << size << "\">" << dataset
       << "</DataItem>";
}

/// Names of grids are made different by readers: they are so here.
void begin_grid(std::ostream& file, const std::string& name, double time, const std::string& size) {
  file << "      <Grid Name=\"" << name << "\" GridType=\"Uniform\">\n"
       << "        <Time Value=\"" << time << "\"/>\n"
       << "        <Topology TopologyType=\"2DSMesh\" Dimensions=\"" << size << "\"/>\n"
       << "        <Geometry GeometryType=\"XY\">";
}

void write_contact(std::ostream& file, const std::string& grid, double time, const std::string& results_name,
                   const FieldGroup& group) {
  const std::string size = std::to_string(group.shape.nx) + " " + std::to_string(group.shape.ny());
  begin_grid(file, grid, time, size);
  write_data(file, size + " 2", results_name + ":" + group.mesh);
  file << "</Geometry>\n";
  for (const std::string& name : group.datasets) {
    file << "        <Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Node\">";
    write_data(file, size, results_name + ":" + group.name + "/" + name);
    file << "</Attribute>\n";
  }
  file << "      </Grid>\n";
}

/// Four nodes at one point.
void write_absent(std::ostream& file, const std::string& grid, double time, const std::vector<std::string>& datasets) {
  const auto zeros = [&](const char* size, int count) {
    file << "<DataItem Format=\"XML\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"" << size << "\">0";
    for (int n = 1; n < count; ++n) file << " 0";
    file << "</DataItem>";
  };
  begin_grid(file, grid, time, "2 2");
  zeros("2 2 2", 8);
  file << "</Geometry>\n";
  for (const std::string& name : datasets) {
    file << "        <Attribute Name=\"" << name << "\" AttributeType=\"Scalar\" Center=\"Node\">";
    zeros("2 2", 4);
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
      if (here != groups.end()) {
        write_contact(file, grid, time, results_name, *here);
      } else {
        write_absent(file, grid, time, groups.front().datasets);
      }
    }
    file << "    </Grid>\n";
  }
  file << "  </Domain>\n</Xdmf>\n";
  write_whole(comm, path, file.str());
}

}  // namespace gearfilm
