// What a robot on its feet can bear at rest: how hard it may push where it is.
#pragma once

#include <Eigen/LU>
#include <string>
#include <vector>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish::pressing {

/// What holds while a robot stands and pushes.
struct BearingSpec {
  /// on level ground, with the friction and the sides that are to be kept within
  std::vector<SupportSpec> feet;
  double least_load = 0.0;  ///< N, on each foot
  std::vector<std::string> hands =
      {};  ///< frames that push, each with the same force; none: it stands
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< of length one, of what they push on
  double hand_friction = 0.0;                               ///< that they may use across it
  Eigen::VectorXd torque_limit;                             ///< nv, Nm (N); infinite: none
};

/// The linear program
///   max F  with  S^T tau + J_feet^T f + J_hands^T (F n + t) = g(q),
/// |tau| within its limits, each foot's wrench f within friction, pressure and least load, and each
/// hand's t within friction, cones as inscribed octagons. An interior-point method of fixed size:
/// it allocates nothing and takes some 0.2 ms.
class Bearing {
 public:
  /// Throws Error for a frame that there is not. The floating base is the model's first joint.
  Bearing(const Model& model, const BearingSpec& spec);

  /// N, the largest force of each hand at the place where `body`, of the same model, is, at rest;
  /// negative where not even standing there is within all limits. Without hands zero where it is.
  double most(const RigidBody& body) noexcept;
  /// Which limit ended the last most(), and what it is called: "friction of left_foot", "load of
  /// left_foot", "pressure of left_foot", "torque limits/arm_left_7_joint".
  int limit() const { return limit_; }
  const std::string& name(int limit) const { return names_[static_cast<std::size_t>(limit)]; }

 private:
  void name_rows(const Model& model);
  void fill(const RigidBody& body) noexcept;
  void fill_foot(const RigidBody& body, std::size_t foot, Eigen::Index column,
                 Eigen::Index& row) noexcept;
  void fill_cone(Eigen::Index x, Eigen::Index y, Eigen::Index z, double friction,
                 Eigen::Index& row) noexcept;
  bool solve() noexcept;
  bool step() noexcept;

  BearingSpec spec_;
  int nv_, forces_;
  double weight_;                    ///< N: forces are in its unit, moments in 0.1 m of it
  std::vector<int> feet_, hands_;    ///< frames
  std::vector<int> limited_;         ///< entries of v
  std::vector<std::string> names_;   ///< of rows
  std::vector<Eigen::Index> loads_;  ///< of rows: the normal force that the limit goes with, or -1
  int limit_ = 0;
  FrameDerivatives at_;
  RowMatrix bears_;  ///< nv x unknowns: J^T of what they are
  // min c x  with  A x = b,  G x + w = h,  w >= 0; y and z are the prices of the two.
  Eigen::MatrixXd A_, G_, KKT_;
  Eigen::VectorXd b_, c_, h_, x_, y_, w_, z_, dx_, dw_, dz_, rhs_, solution_, rows_;
  /// Of a row, how much of its limit there is: what it lets f be, or 1 of a torque.
  double amount(Eigen::Index row) const noexcept;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace burnish::pressing
