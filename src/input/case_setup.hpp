// From a case to the objects that solve it.
#pragma once

#include "dynamics/pair_march.hpp"
#include "input/case.hpp"

namespace gearfilm {

/// Throws InputError where the contact carries a point load that stands for a line contact, and not the tooth force.
void require_tooth_force(const CaseInput& problem, const std::string& what);

/// The grid of a case.
GridShape case_grid(const CaseInput& problem);
/// What all films of a case share. Collective.
SharedDiscretisation discretise(MPI_Comm comm, const CaseInput& problem);
/// A discretisation on another grid than the case's.
SharedDiscretisation discretise(const Grid& grid, const CaseInput& problem);
/// Most contacts that a march of the case has at a time: those of a pair share its grid, one that is followed by itself
/// is alone.
int contacts_at_a_time(const CaseInput& problem);
/// Points across films that feel their heat; 0 where they do not.
int heated_points(const CaseInput& problem);
/// Observers that are called when a grid is widened. Both throw SolveError where so many contacts on the new grid, with
/// so many points across films that feel their heat, do not fit into memory; the second one also prints a line.
/// Collective.
WideningObserver widening_check(int contacts, int points);
WideningObserver widening_notice(const Scales& scales, int contacts, int points);
/// Throws InputError unless the case is a gear pair with inertia.
void require_inertia(const CaseInput& problem);
/// Throws InputError for a case whose march is of one contact, of contacts that are held, or of dry ones, where a
/// command needs all lubricated contacts (or dry ones too), which travel.
void require_moving_contacts(const CaseInput& problem, const std::string& command, bool dry_too);
/// Throws InputError where heights of the flanks travel, which a film at rest cannot follow.
void require_standing_heights(const CaseInput& problem, const std::string& command);
/// Throws InputError where pitch errors make a mesh period differ from the next.
void require_one_pattern(const CaseInput& problem, const std::string& command);
/// The case whose periodic state is sought, with the motion that the program may choose (with_chosen_motion), which the
/// remark then says. Throws InputError for a case that has none.
CaseInput periodic_case(const CaseInput& given, std::string& remark);
/// The case that `transient` marches, with the motion that the program may choose, which the remark then says. Throws
/// InputError for one without inertia, or whose drive train cannot move.
CaseInput transient_case(const CaseInput& given, std::string& remark);
/// The given ones, else those of two discs with the equivalent mass.
GearInertias inertias_of(const CaseInput& problem);

/// The case's pair in mesh, with a contact at the given position at T = 0 [m]. It has an inertia where the case has
/// one.
MeshModel mesh_model(const CaseInput& problem, double start, MeshGeometry geometry = MeshGeometry::moving,
                     const SpeedCourse& course = {});
/// The mesh of a case in which a contact has just left at T = 0.
MeshModel mesh_after_leaving(const CaseInput& problem);
/// A march of the case's lubricated pair.
MeshMarch make_march(const CaseInput& problem, const SharedDiscretisation& films, const MeshModel& mesh,
                     StepObserver observer, RunStore* store = nullptr);
/// The march of `transient`: on films of a discretisation, or dry without one. A store must outlive it.
PairMarch make_pair_march(const CaseInput& problem, const MeshModel& mesh, const SharedDiscretisation& films,
                          StepObserver observer, RunStore* store = nullptr);
/// The search for the case's periodic state.
OrbitProblem orbit_problem(const CaseInput& problem);

}  // namespace gearfilm
