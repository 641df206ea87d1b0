// A drive train as linear algebra: rotating nodes that may move in their plane too, and what joins them.
//
//   M q'' + C q' + K q + sum_p k_p B_p^T B_p q = 0 ,     q = (phi, x, y of every node)            [rad, m]
//   M   inertias I [kg m^2] and masses m [kg] of the nodes; of a shaft with an inertia I_s of its own
//       I_s/6 [2 1; 1 2] at its ends, that of a twist which is linear along it
//   K, C  sum over the elements of G^T k G and G^T c G: G q are the ways that an element resists, a twist
//       phi_a - phi_b [N m/rad], a displacement (x, y) in a bearing [N/m], a rotation against the ground
//   B   rows of the contacts between gears: h = B q parts the flanks [m]
// A rotation counts in the sense in which the gears of its side turn. A node without a mass has no x and y; one whose
// speed is imposed has no phi.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace gearfilm {

struct TrainNode {
  std::string name;
  double inertia = 0.0;          ///< [kg m^2]
  std::optional<double> mass{};  ///< absent: it stays in its place [kg]
  double radius = 1.0;           ///< makes lengths of rotations, where both are compared [m]
  bool fixed = false;            ///< turns at an imposed speed
};

struct TrainElement {
  std::string name;
  Eigen::MatrixXd rows;                   ///< G, one row a way
  Eigen::MatrixXd stiffness;              ///< k; only its symmetric part stores energy
  Eigen::MatrixXd damping{};              ///< c; empty: none
  std::optional<double> damping_ratio{};  ///< absent: by the damping alone (train_damping.hpp)
};

struct Shaft {
  double stiffness = 0.0;  ///< k_t [N m/rad]
  double damping = 0.0;    ///< [N m s/rad]
  double inertia = 0.0;    ///< I_s of its own [kg m^2]
};

struct Bearing {
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< [N/m]
  Eigen::Matrix2d damping = Eigen::Matrix2d::Zero();    ///< [N s/m]
  std::optional<double> damping_ratio{};
};

class Train {
public:
  explicit Train(std::vector<TrainNode> nodes);

  /// Which node has this name, if any.
  std::optional<std::size_t> find(const std::string& name) const;
  const TrainNode& node(std::size_t n) const { return nodes_[n]; }
  std::size_t node_count() const { return nodes_.size(); }
  /// Entries of q.
  Eigen::Index freedoms() const { return mass_.rows(); }

  /// phi of a node, and its (x, y), as rows of q; zero where it has none.
  Eigen::RowVectorXd rotation(std::size_t n) const;
  Eigen::MatrixXd translation(std::size_t n) const;
  /// What makes lengths of the entries of q: a radius, or 1.
  Eigen::VectorXd lengths() const;

  void add_shaft(std::size_t a, std::size_t b, const Shaft& shaft);
  /// Between a node and the ground.
  void add_bearing(std::size_t n, const Bearing& bearing);
  /// Against the rotation of a node.
  void add_ground(std::size_t n, double stiffness, double damping);
  void add_element(TrainElement element) { elements_.push_back(std::move(element)); }
  void add_contact(const Eigen::RowVectorXd& row);
  void set_damping(std::size_t element, const Eigen::MatrixXd& damping) { elements_[element].damping = damping; }

  const std::vector<TrainElement>& elements() const { return elements_; }
  const Eigen::MatrixXd& contacts() const { return contacts_; }  ///< B, one row a contact
  const Eigen::MatrixXd& mass() const { return mass_; }
  /// Without that of the contacts.
  Eigen::MatrixXd stiffness() const;
  Eigen::MatrixXd damping() const;

private:
  std::vector<TrainNode> nodes_;
  std::vector<Eigen::Index> first_;  ///< of each node in q: phi, then x and y
  std::vector<TrainElement> elements_;
  Eigen::MatrixXd contacts_, mass_;
};

}  // namespace gearfilm
