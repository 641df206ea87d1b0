// Pressure and film fields of a march at chosen times, in results.h5 and as a time series for ParaView.
//
//   /mesh/x, y, mesh                       coordinates of every contact's grid [m] (results_file.hpp)
//   /snapshots/0000                        attributes T, t
//   /snapshots/0000/contact0/P, H          [Pa], [m]; attribute xi
#pragma once

#include "gearfilm/dynamics/step_record.hpp"
#include "gearfilm/io/results_file.hpp"

namespace gearfilm {

class Snapshots {
public:
  /// xdmf: the file that describes them, rewritten whole at every snapshot.
  Snapshots(ResultsFile& file, const Grid& grid, const Scales& scales, std::filesystem::path xdmf);

  void write(const StepRecord& record, const std::vector<LiveContact>& contacts);

  /// For fields of which only later is known whether they are wanted: keeps them in memory, then writes those after a
  /// time and drops the others.
  void hold(const StepRecord& record, const std::vector<LiveContact>& contacts);
  void write_held(double T_after);
  void drop_held() { held_.clear(); }

private:
  struct ContactFields {
    int contact = 0;
    double position = 0.0;  ///< [m]
    const Field<double>* pressure = nullptr;
    const Field<double>* film = nullptr;
  };
  struct HeldContact {
    int contact;
    double position;
    Field<double> pressure;
    Field<double> film;
  };
  struct Held {
    double T = 0.0;
    std::vector<HeldContact> contacts;
  };

  void write(double T, const std::vector<ContactFields>& contacts);

  ResultsFile& file_;
  WholeDomain domain_;
  Scales scales_;
  std::filesystem::path xdmf_;
  std::vector<TimedFields> written_;
  std::vector<Held> held_;
};

}  // namespace gearfilm
