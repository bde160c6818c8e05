// burnish model compiled by MuJoCo, with MuJoCo's results in burnish's conventions: the same order
// of v, twists of floating bodies in body axes, linear part first.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"
#include "mujoco/mujoco_coordinates.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::test {

/// Constraint between two frames in MuJoCo: at the tool's origin, or in all six directions.
struct Tie {
  enum class Kind { Connect, Weld };
  Kind kind = Kind::Connect;
  std::string tool;
  std::string base = "world";
};

/// Result of MuJoCo's constraint solver.
struct TiedMotion {
  Eigen::VectorXd a;       ///< nv
  Eigen::VectorXd lambda;  ///< per tie in world axes at the tool's origin: 3, or 6 for a weld
};

/// Follower joints are independent in MuJoCo. Its results are reduced by q_full = S q + s: S^T M S
/// and S^T b.
class MujocoModel {
 public:
  /// Throws Error with MuJoCo's sentence if it refuses the model.
  explicit MujocoModel(const Model& model, const std::vector<Tie>& ties = {});

  /// Loads a state for the other functions. Ties hold their frames at the positions of that state.
  void set_state(const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  Eigen::MatrixXd mass_matrix();
  Eigen::VectorXd bias();
  Eigen::VectorXd forward(const Eigen::VectorXd& tau);
  Eigen::VectorXd inverse(const Eigen::VectorXd& a);

  Eigen::Isometry3d placement(const std::string& frame) const;
  /// World axes, at the frame's origin: 6 x nv, linear rows first.
  Eigen::MatrixXd jacobian(const std::string& frame) const;

  /// Solves with compliance mu [m/s^2 per N of lambda] in place of MuJoCo's softness, and with the
  /// drift of the constraint, which MuJoCo omits. The velocity of every tie between two moving
  /// bodies, and of every weld, must be zero.
  TiedMotion forward_tied(const Eigen::VectorXd& tau, double mu);

 private:
  int site(const std::string& frame) const;
  void place_ties();
  void load_torque(const Eigen::VectorXd& tau);
  Eigen::VectorXd acceleration_from(const double* qacc) const;
  Vector6 drift(const std::string& frame);
  Eigen::MatrixXd relative_jacobian(const Tie& tie) const;
  Vector6 relative_drift(std::size_t tie);

  Model model_;
  std::vector<Tie> ties_;
  mujoco::ModelPointer m_;
  mujoco::DataPointer d_;
  mujoco::Coordinates coordinates_;
};

}  // namespace burnish::test
