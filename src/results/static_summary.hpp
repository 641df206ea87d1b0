// What the results say of the dry pair turned slowly under one load: summary, rows of the table /static, and the shares
// of the load that a contact carries on its way.
#pragma once

#include <string>
#include <vector>

#include "mesh/static_mesh.hpp"
#include "output/results_table.hpp"
#include "output/summary.hpp"

namespace gearfilm {

/// One load in SI. Mesh and what was found must outlive it.
class StaticLoad {
public:
  StaticLoad(const MeshModel& mesh, const StaticMesh& found) : mesh_(mesh), scales_(mesh.scales), found_(found) {}

  const MeshModel& mesh() const { return mesh_; }
  const StaticMesh& found() const { return found_; }
  double length(double H) const { return scales_.thickness * H; }                    ///< [m]
  double stiffness(double K) const { return scales_.force(K) / scales_.thickness; }  ///< [N/m]
  /// Largest pressure at any position [Pa].
  double largest_pressure() const;

  Summary summary() const;
  /// What is in it, in the manual's Markdown.
  static std::string markdown();
  /// Columns of the table, which has one row a position.
  static std::vector<TableColumn> columns();
  void append_rows(double load_ratio, std::vector<double>& rows) const;
  /// xi [m] and share of one contact, from its entering to its leaving: a file for load_sharing.file.
  std::string shares() const;

private:
  /// Equally spaced between events, both sides of which stay: a jump of the share needs room behind it.
  std::vector<StaticPosition> every_eighth() const;
  double largest_pressure(const StaticPosition& position) const;

  const MeshModel& mesh_;
  const Scales& scales_;
  const StaticMesh& found_;
};

}  // namespace gearfilm
