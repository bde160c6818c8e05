// States between burnish and MuJoCo. MuJoCo counts an angle for a continuous joint, writes
// quaternions w first, and takes the translation rate of planar and floating joints along fixed
// axes: v = T qvel with T orthogonal, so that M_ours = T M T^T, tau_theirs = T^T tau_ours and
// a_ours = T qacc + (dT/dt) qvel.
#pragma once

#include <mujoco/mujoco.h>

#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish::mujoco {

/// Nothing allocates after construction but what returns a matrix.
class Coordinates {
 public:
  /// Throws Error if MuJoCo's model counts other degrees of freedom.
  Coordinates(const Model& model, const mjModel& theirs);

  /// Writes qpos and qvel.
  void store(const ConstVectorRef& q, const ConstVectorRef& v, mjData& data);
  /// Reads them into q (nq) and v (nv).
  void load(const mjData& data, Eigen::VectorXd& q, Eigen::VectorXd& v);
  /// T^T tau: torques into MuJoCo's entries (nv), and T tau back, at the last state.
  void torque_to(const ConstVectorRef& tau, mjtNum* theirs) const;
  void torque_from(const mjtNum* theirs, Eigen::VectorXd& tau) const;

  const Eigen::MatrixXd& T() const { return T_; }
  /// (dT/dt) qvel at the last store().
  const Eigen::VectorXd& correction() const { return correction_; }

 private:
  void turn(const Joint& joint, const Eigen::Matrix3d& rotation);
  void correct(const Joint& joint, const ConstVectorRef& v);

  std::vector<Joint> joints_;
  Eigen::MatrixXd T_;
  Eigen::VectorXd correction_;
};

/// M and b(q, v) in burnish's entries; after mj_fwdPosition and mj_fwdVelocity.
Eigen::MatrixXd mass_matrix(const mjModel& model, const mjData& data, const Coordinates& at);
Eigen::VectorXd bias(const mjModel& model, const mjData& data, const Coordinates& at);

}  // namespace burnish::mujoco
