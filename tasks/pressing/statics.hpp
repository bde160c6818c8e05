// Statics of a standing robot: the largest force with which the robot can push while at rest.
#pragma once

#include <Eigen/LU>
#include <string>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish::pressing {

/// Limits of a robot that stands and pushes.
struct StaticsSpec {
  /// Feet on level ground. Foot forces stay within friction, centres of pressure within the soles.
  std::vector<TouchSpec> feet;
  double min_load = 0.0;  ///< Smallest load of each foot [N].
  /// Frames that push, all with equal forces; empty: the robot only stands.
  std::vector<std::string> hands = {};
  /// Unit normal of the surface that the hands push against.
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  double hand_friction = 0.0;    ///< Largest friction coefficient that the hands use.
  Eigen::VectorXd torque_limit;  ///< Torque limits (nv) [Nm (N)]; infinite: none.
};

/// Linear program for the largest force F of each hand along the normal n, at gravity torque g(q):
///   max F  with  S^T tau + J_feet^T f + J_hands^T (F n + t) = g(q),
/// where the torques |tau| of the motors, selected by S, are within their limits. The wrench f of
/// each foot is within friction, pressure and smallest load, and the tangential force t of each
/// hand is within friction. Friction cones are approximated by inscribed octagons. The
/// interior-point solver has a fixed size, does not allocate, and takes about 0.2 ms.
class Statics {
 public:
  /// The first joint of the model must be its floating base. Throws Error for an unknown frame.
  Statics(const Model& model, const StaticsSpec& spec);

  /// Returns the largest force of each hand with which the robot can stay at rest in the
  /// configuration of `body` [N]. `body` must be of the same model. The result is negative if
  /// standing alone violates a limit. Without hands, it is zero if standing is within all limits.
  double max_force(const RigidBody& body) noexcept;
  /// Returns the index of the limit that bounds the last max_force(). name() returns its name, such
  /// as "friction of left_foot" or "torque limits/arm_left_7_joint".
  int limit() const { return limit_; }
  const std::string& name(int limit) const { return names_[to_size(limit)]; }

 private:
  void name_rows(const Model& model);
  void fill(const RigidBody& body) noexcept;
  void fill_foot(const RigidBody& body, std::size_t foot, Eigen::Index column,
                 Eigen::Index& row) noexcept;
  void fill_cone(Eigen::Index x, Eigen::Index y, Eigen::Index z, double friction,
                 Eigen::Index& row) noexcept;
  bool solve() noexcept;
  bool step() noexcept;

  StaticsSpec spec_;
  int nv_, forces_;
  /// Weight, the unit of forces [N]; the unit of moments is 0.1 m times the weight.
  double weight_;
  std::vector<int> feet_, hands_;   ///< Frame indices for RigidBody.
  std::vector<int> limited_;        ///< Entries of v with a torque limit.
  std::vector<std::string> names_;  ///< Names of the limits, one per row of G.
  /// Per row of G: index of the normal force that scales the limit, or -1.
  std::vector<Eigen::Index> loads_;
  int limit_ = 0;
  FrameDerivatives at_;
  RowMatrix force_map_;  ///< J^T of the unknown forces and moments (nv x unknowns).
  // Linear program min c x with A x = b, G x + w = h, w >= 0. The multipliers are y and z.
  Eigen::MatrixXd A_, G_, KKT_;
  Eigen::VectorXd b_, c_, h_, x_, y_, w_, z_, dx_, dw_, dz_, rhs_, solution_, rows_;
  /// Returns the limit in `row` of G at the last solution, such as friction * load; torques: 1.
  double amount(Eigen::Index row) const noexcept;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace burnish::pressing
