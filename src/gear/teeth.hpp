// The teeth of a pair in mesh beyond the rigid perfect involute: the gap that their flanks leave at a contact, and how
// far they bend under the forces.
//
//   e_k(xi) = E_1(rho_1) + E_2(rho_2) - f_1[tooth] - f_2[tooth]       flank.hpp; f: how far a flank stands proud
//   gap opened at contact k = e_k + sum_j c_kj F_j                    tooth_compliance.hpp, both gears together
// Contact n has tooth n mod Z of either gear. The pinion's tooth whose front flank is at xi has its reverse flank at
//   xi_b = -(xi - s_w1 cos alpha' + n p_b)                             within the path of contact, moving backwards.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gear/chebyshev.hpp"
#include "gear/line_of_action.hpp"
#include "gear/local_profile.hpp"
#include "gear/tooth_compliance.hpp"
#include "gear/uneven_flank.hpp"

namespace gearfilm {

/// One gear's flanks.
struct GearFlanks {
  FlankModification modification;
  std::vector<double> pitch_errors;  ///< cumulative, one a tooth, positive where the flank stands proud [m]; or none
  UnevenFlank beside_middle{};       ///< what the modification, that of the middle of the face, leaves out
};

/// What bends, in a pair.
struct ComplianceOptions {
  std::optional<FoundationModel> teeth{};          ///< absent: rigid teeth, or those of the table
  std::vector<std::pair<double, double>> table{};  ///< xi [m] and c_kk of a pair of teeth [m/N], ascending
  double factor = 1.0;                             ///< on the computed teeth and foundations
  double mesh = 0.0;                               ///< of shafts and bearings, on the sum of forces [m/N]
  bool body_coupling = true;                       ///< c_kj of bodies with bores
};

/// How flanks act on a contact: as one gap, or along it too.
enum class ProfileAction { offset, field };

class Teeth {
public:
  /// Rigid perfect involutes.
  Teeth() = default;
  /// Throws InputError where reliefs are longer than the active flanks or leave no tooth, errors are not one a tooth or
  /// as large as half a pitch, or the bodies give way to a neighbour's force more than to the tooth's own.
  Teeth(const SpurGearPair& pair, const LineOfAction& line, std::array<GearFlanks, 2> flanks,
        const ComplianceOptions& compliance, ProfileAction action = ProfileAction::offset);

  /// A copy without pitch errors.
  Teeth without_pitch_errors() const;

  bool perfect() const { return perfect_; }
  bool rigid() const { return rigid_; }

  /// e_k of a contact at xi [m].
  double gap(int contact, double xi) const;
  /// Profile beside a contact at xi; none where flanks act as one gap.
  LocalProfile local(double xi) const;
  /// Beside the middle of the face, of a contact at xi; none where flanks are alike all over it.
  UnevenProfile beside_middle(double xi) const;
  /// c_kk of a contact at xi [m/N].
  double compliance(double xi) const;
  /// c_kj of contacts so many pitches apart [m/N].
  double coupling(int pitches) const;
  /// j_n [m]; absent: reverse flanks never touch.
  const std::optional<double>& backlash() const { return backlash_; }
  /// Where reverse flanks meet on their own line of action when a contact of front flanks is at xi [m].
  std::vector<double> back_positions(double xi) const;
  /// E_1 + E_2 at xi [m]; of reverse flanks too, which are taken to be modified alike.
  double removed(double xi) const;
  /// Where reliefs begin [m], at which e_k has kinks; those of measured profiles are not among them.
  const std::vector<double>& relief_places() const { return relief_places_; }
  /// After how many mesh periods the same teeth meet again that errors can tell apart.
  long pattern() const { return pattern_; }

private:
  void add_relief_places(const FlankModification& modification, int gear, double start, double tip);
  void set_compliance(const SpurGearPair& pair, const LineOfAction& line, const ComplianceOptions& options);
  void set_backlash(const SpurGearPair& pair, const LineOfAction& line);

  bool perfect_ = true;
  bool rigid_ = true;
  long pattern_ = 1;
  double at_pitch_pinion_ = 0.0;  ///< rho_1 at the pitch point [m]
  double at_pitch_wheel_ = 0.0;
  std::array<double, 2> base_radius_{};
  std::shared_ptr<const std::array<Flank, 2>> flanks_;
  std::shared_ptr<const std::array<UnevenFlank, 2>> beside_middle_;  ///< null: alike all over the face
  ProfileAction action_ = ProfileAction::offset;
  std::array<std::vector<double>, 2> errors_;
  std::vector<double> relief_places_;
  double low_ = 0.0, high_ = 0.0;  ///< the path of contact
  Chebyshev<32> own_;              ///< c_kk over it [m/N]
  std::vector<std::pair<double, double>> table_;
  double mesh_ = 0.0;
  std::array<double, 2> coupling_{};
  std::optional<double> backlash_{};
  double thickness_ = 0.0;  ///< s_w1 cos alpha' of the pinion's teeth on the working pitch circle [m]
  double base_pitch_ = 0.0;
};

}  // namespace gearfilm
