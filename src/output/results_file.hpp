// results.h5: fields of contacts, with parameters and version as attributes.
//
//   /                attributes: program, format_version (format_version.hpp), command, those of provenance.hpp; x_min,
//                    x_max, y_half of the domain [a, a, b]
//   /parameters      attributes: every parameter of the run
//   /scales          attributes: what 1 of X, H, P, T, of a pressure integral and of a velocity is in SI
//   /contact0        attributes: position and scales of the contact
//   /contact0/P, H   pressure [Pa] and film thickness [m] as (nx, ny)
//   /contact0/x, y   coordinates along and across entrainment [m]: dimension scales of the fields
//   /contact0/mesh   the same as (nx, ny, 2), for ParaView through results.xmf
// Text is UTF-8. Written by all processes together; every write that fails is an OutputError on all.
#pragma once

#include <hdf5.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "contact/scales.hpp"
#include "gearfilm/error.hpp"
#include "output/whole_domain.hpp"
#include "parallel/agreement.hpp"

namespace gearfilm {

class ResultsFile {
public:
  /// Opens the file as part_of(path): it takes the place of an earlier one in publish() or finish().
  ResultsFile(MPI_Comm comm, std::filesystem::path path);
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  void attribute(const std::string& group, const std::string& name, const std::string& value);
  void attribute(const std::string& group, const std::string& name, double value);
  void attribute(const std::string& group, const std::string& name, int value);
  /// An attribute of a dataset, which must exist.
  void dataset_attribute(const std::string& dataset, const std::string& name, const std::string& value);

  /// Coordinates of a contact's grid [m].
  void grid(const std::string& group, const WholeDomain& domain, const Scales& scales);
  /// One field in SI: values times scale; `axes` is the group of its coordinates, made by grid().
  void field(const std::string& group, const std::string& name, const std::string& unit, const WholeDomain& domain,
             const Field<double>& values, double scale, const std::string& axes);

  /// A row of so many values after the other, all on the first process; elsewhere `values` counts for nothing. There
  /// are `rows` of them.
  void rows(const std::string& group, const std::string& name, const std::string& unit, int rows, int columns,
            const std::vector<double>& values);

  /// So many such blocks of rows.
  void blocks(const std::string& group, const std::string& name, const std::string& unit,
              const std::array<int, 3>& size, const std::vector<double>& values);

  /// Gives the open file its name: for runs that append to it for long.
  void publish();
  bool published() const { return published_; }
  void finish();

  /// Collective write to the file: OutputError on all processes where it fails on any.
  template <class Action>
  void write(Action&& action) {
    try {
      write_together(comm_, path_, action);
    } catch (const OutputError&) {
      damaged_ = true;
      throw;
    }
  }
  /// After a failed write; nothing more can be expected of the file.
  bool damaged() const { return damaged_; }

  hid_t hdf5_file() const { return file_; }
  int rank() const { return rank_; }
  MPI_Comm comm() const { return comm_; }

private:
  void take_name();
  void put(const std::string& group, const std::string& name, const DistributedArray& array, const std::string& unit);
  /// An array that the first process has.
  void put_by_first(const std::string& group, const std::string& name, const std::vector<hsize_t>& all,
                    const std::vector<double>& values, const std::string& unit);

  MPI_Comm comm_;
  int rank_;
  std::filesystem::path path_;
  /// Without finish() left to the end of the program: closing takes all processes, but an error may have struck this
  /// one alone; and HDF5 cannot close what it could not write.
  hid_t file_ = H5I_INVALID_HID;
  std::map<std::string, int> fields_of_;  // by the group of their axes
  bool published_ = false;
  bool damaged_ = false;
};

}  // namespace gearfilm
