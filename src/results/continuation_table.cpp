#include "results/continuation_table.hpp"

#include "input/case_at.hpp"
#include "input/case_setup.hpp"
#include "output/run_identity.hpp"

namespace gearfilm {
namespace {

std::vector<TableColumn> point_columns() {
  return {{"branch", "-", true},
          {"order", "-", true},
          {"kind", "-", true},
          {"speed_rpm", "rpm"},
          {"torque", "N m"},
          {"m_ge", "kg"},
          {"viscosity", "Pa s"},
          {"f_m", "Hz"},
          {"f_n", "Hz"},
          {"H0_after_leaving", "-"},
          {"V0_after_leaving", "-"},
          {"force_ratio_max", "-"},
          {"total_force_ratio_min", "-"},
          {"floquet_1_re", "-"},
          {"floquet_1_im", "-"},
          {"floquet_2_re", "-"},
          {"floquet_2_im", "-"},
          {"stable", "-", true}};
}

std::string kind_names() {
  std::string names;
  for (const PointKind kind :
       {PointKind::regular, PointKind::fold, PointKind::flip, PointKind::neimark_sacker, PointKind::grazing}) {
    names += std::to_string(static_cast<int>(kind)) + " " + name_of(kind) + "\n";
  }
  return names;
}

}  // namespace

ContinuationTable::ContinuationTable(MPI_Comm comm, const CaseInput& problem)
    : problem_(problem), file_(comm, problem.run.directory / "results.h5") {
  write_identity(file_, problem, "continuation");
  table_.emplace(file_, "/continuation", point_columns());
  file_.dataset_attribute("/continuation", "kinds", kind_names());
  file_.publish();
}

Summary ContinuationTable::add(const Branch& branch, PointKind kind, const BranchPoint& point) {
  const CaseInput here = case_at(problem_, problem_.continuation.parameter, point.state.parameter);
  const MeshModel mesh = mesh_after_leaving(here);
  const auto mu = point.multipliers();
  const double speed = here.parameters.real("pinion.speed_rpm"), mass = *here.pair.equivalent_mass;
  const Lubricant& oil = here.scales.oil;
  table_->append({static_cast<double>(branch.number), static_cast<double>(branch.order), static_cast<double>(kind),
                  speed, here.pair.torque, mass, oil.viscosity, mesh.mesh_frequency_si(), mesh.frequency_si(),
                  point.state.motion.H0(), point.state.motion.V0(), point.value.largest_force,
                  point.value.smallest_force, mu[0].real(), mu[0].imag(), mu[1].real(), mu[1].imag(),
                  static_cast<double>(point.stable())});
  Summary summary = {{"speed_rpm", speed}, {"torque", here.pair.torque}, {"m_ge", mass}, {"viscosity", oil.viscosity}};
  summary["H0_after_leaving"] = point.state.motion.H0();
  summary["V0_after_leaving"] = point.state.motion.V0();
  summary["force_ratio_max"] = point.value.largest_force;
  summary["total_force_ratio_min"] = point.value.smallest_force;
  summary["floquet"] = mu;
  return summary;
}

void ContinuationTable::finish() {
  table_->write();
  table_.reset();
  file_.finish();
}

}  // namespace gearfilm
