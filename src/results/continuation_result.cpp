#include "results/continuation_result.hpp"

#include <array>

#include "input/case_setup.hpp"
#include "input/case_with_parameter.hpp"
#include "output/run_identity.hpp"
#include "results/members.hpp"
#include "results/orbit_summary.hpp"
#include "results/pair_conditions.hpp"

namespace gearfilm {
namespace {

/// How a branch ends, in words.
const char* words_of(BranchEnd end) {
  constexpr std::array names = {"at an end of the range", "closed", "at a flip of a branch of half its order",
                                "after continuation.points points", "lost"};
  return names[static_cast<std::size_t>(end)];
}

struct PointOnBranch {
  const Branch& branch;
  PointKind kind;
  const BranchPoint& point;
};

constexpr auto place_members = std::to_array<Member<PointOnBranch>>({
    {"branch", "", "-", "number of the branch, from 1",
     [](const PointOnBranch& at) -> Summary { return at.branch.number; }, Column::whole},
    {"order", "k", "-", "mesh periods, or patterns of teeth with errors, after which its states repeat",
     [](const PointOnBranch& at) -> Summary { return at.branch.order; }, Column::whole},
    {"kind", "", "",
     "kind of the bifurcation; in the table its number, named by the attribute kinds, 0 for other points",
     [](const PointOnBranch& at) -> Summary { return name_of(at.kind); }},
});

constexpr auto point_members = std::to_array<Member<PointOnBranch>>({
    {"H0_after_leaving", "H_0", "-", "H_0 just after a contact has left",
     [](const PointOnBranch& at) -> Summary { return at.point.state.motion.H0(); }, Column::real},
    {"V0_after_leaving", "V_0", "-", "V_0 there",
     [](const PointOnBranch& at) -> Summary { return at.point.state.motion.V0(); }, Column::real},
    {"force_ratio_max", "", "-", "largest force on one contact over the static force",
     [](const PointOnBranch& at) -> Summary { return at.point.value.largest_force; }, Column::real},
    {"total_force_ratio_min", "", "-", "smallest force on all contacts together over it",
     [](const PointOnBranch& at) -> Summary { return at.point.value.smallest_force; }, Column::real},
    {"floquet", "mu", "-", "Floquet multipliers, real and imaginary part each; four columns of the table",
     [](const PointOnBranch& at) -> Summary { return at.point.multipliers(); }},
});

constexpr auto branch_members = std::to_array<Member<Branch>>({
    {"number", "", "-", "number of the branch, from 1", [](const Branch& of) -> Summary { return of.number; }},
    {"order", "k", "-", "periods after which its states repeat", [](const Branch& of) -> Summary { return of.order; }},
    {"born_on", "", "-", "branch at whose flip it is born; null: none",
     [](const Branch& of) -> Summary { return of.parent == 0 ? Summary() : Summary(of.parent); }},
    {"born_at", "", "", "value of the parameter there",
     [](const Branch& of) -> Summary { return of.born ? Summary(of.born->parameter) : Summary(); }},
    {"points", "", "-", "points on it", [](const Branch& of) -> Summary { return of.points; }},
    {"end", "", "", "how it ends", [](const Branch& of) -> Summary { return words_of(of.end); }},
    {"last_value", "", "", "value of the parameter there",
     [](const Branch& of) -> Summary { return of.last.parameter; }},
    {"last_H0", "H_0", "-", "H_0 there", [](const Branch& of) -> Summary { return of.last.motion.H0(); }},
    {"last_V0", "V_0", "-", "V_0 there", [](const Branch& of) -> Summary { return of.last.motion.V0(); }},
});

constexpr auto stretch_members = std::to_array<Member<Stretch>>({
    {"branch", "", "-", "number of the branch", [](const Stretch& of) -> Summary { return of.branch; }},
    {"order", "k", "-", "periods after which its states repeat", [](const Stretch& of) -> Summary { return of.order; }},
    {"from", "", "", "value of the parameter where it begins", [](const Stretch& of) -> Summary { return of.from; }},
    {"to", "", "", "value of the parameter where it ends", [](const Stretch& of) -> Summary { return of.to; }},
    {"stable", "", "", "whether its states are stable", [](const Stretch& of) -> Summary { return of.stable; }},
});

std::vector<TableColumn> point_columns() {
  std::vector<TableColumn> columns = columns_of(place_members);
  columns.push_back({"kind", "-", true});
  for (const auto& more : {condition_columns(), columns_of(point_members), multiplier_columns()})
    columns.insert(columns.end(), more.begin(), more.end());
  columns.push_back({"stable", "-", true});
  return columns;
}

std::string kind_names() {
  std::string names;
  for (const PointKind kind :
       {PointKind::regular, PointKind::fold, PointKind::flip, PointKind::neimark_sacker, PointKind::grazing}) {
    names += std::to_string(static_cast<int>(kind)) + " " + name_of(kind) + "\n";
  }
  return names;
}

template <class Members, class Results>
Summary list_of(const Members& members, const Results& results) {
  Summary list = Summary::array();
  for (const auto& result : results) list.push_back(as_summary(members, result));
  return list;
}

}  // namespace

ContinuationResult::ContinuationResult(MPI_Comm comm, const CaseInput& problem)
    : comm_(comm), problem_(problem), file_(comm, problem.run.directory / "results.h5") {
  write_identity(file_, problem, "continuation");
  table_.emplace(file_, "/continuation", point_columns());
  file_.dataset_attribute("/continuation", "kinds", kind_names());
  file_.publish();
}

void ContinuationResult::add(const Branch& branch, PointKind kind, const BranchPoint& point) {
  const CaseInput here = case_with_parameter(problem_, problem_.continuation.parameter, point.state.parameter);
  const MeshModel mesh = mesh_after_leaving(here);
  const PointOnBranch at{branch, kind, point};
  const PairConditions conditions{here, mesh};
  std::vector<double> row;
  add_to_row(place_members, at, row);
  row.push_back(static_cast<double>(kind));
  add_conditions_to_row(conditions, row);
  add_to_row(point_members, at, row);
  add_multipliers_to_row(point.multipliers(), row);
  row.push_back(static_cast<double>(point.stable()));
  table_->append(row);
  ++points_;
  stretches_.add(branch, kind, point);
  if (kind == PointKind::regular) return;
  Summary found = as_summary(place_members, at);
  add_conditions(conditions, found);
  add_members(point_members, at, found);
  bifurcations_.push_back(std::move(found));
}

void ContinuationResult::write(const std::vector<Branch>& branches, const double* mesh_periods, bool completed) {
  table_->write();
  table_.reset();
  file_.finish();
  Summary summary = {{"case", problem_.name}, {"over", problem_.continuation.parameter}, {"points", points_}};
  if (mesh_periods) summary["mesh_periods"] = *mesh_periods;
  summary["branches"] = list_of(branch_members, branches);
  summary["bifurcations"] = bifurcations_;
  summary["stretches"] = list_of(stretch_members, stretches_.all());
  summary["completed"] = completed;
  write_summary(comm_, problem_.run.directory, summary);
}

std::string continuation_markdown() {
  return members_markdown("Points of `continuation`",
                          "Columns of `/continuation` and keys of each of the `bifurcations` in its summary, both with "
                          "the conditions; the table has `stable` too.",
                          place_members) +
         members_markdown("The state there", "Likewise.", point_members) +
         members_markdown("Branches", "Keys of each of the `branches`; values are those of the parameter, in its unit.",
                          branch_members) +
         members_markdown("Where they are stable", "Keys of each of the `stretches`.", stretch_members);
}

}  // namespace gearfilm
