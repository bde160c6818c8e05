// States between burnish and MuJoCo. MuJoCo counts an angle for a continuous joint, writes
// quaternions w first, and takes the translation rate of planar and floating joints along fixed
// axes: v = T qvel with T orthogonal, so that M_ours = T M T^T, tau_theirs = T^T tau_ours and
// a_ours = T qacc + (dT/dt) qvel.
//
// In MuJoCo a follower has coordinates of its own. T is then T_own S^T with T_own the same for the
// entries of joints that follow none and zero elsewhere: qvel = T^T v, M_ours = T M T^T and
// tau_ours = T tau_theirs hold as before, while v = T_own qvel, and tau_theirs = T_own^T tau_ours
// puts all torque on the leaders.
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
  /// T_own^T tau: torques into MuJoCo's entries, and T theirs back, at the last state.
  void torque_to(const ConstVectorRef& tau, mjtNum* theirs) const;
  void torque_from(const mjtNum* theirs, Eigen::VectorXd& tau) const;

  const Eigen::MatrixXd& T() const { return T_; }
  /// MuJoCo's entry of entry k of v.
  int entry(int k) const { return entry_[static_cast<std::size_t>(k)]; }
  /// (dT/dt) qvel at the last store().
  const Eigen::VectorXd& correction() const { return correction_; }

 private:
  void turn(const Joint& joint, int first, const Eigen::Matrix3d& rotation);
  void correct(const Joint& joint, const ConstVectorRef& v);

  Model model_;
  std::vector<int> entry_;
  Eigen::MatrixXd T_, T_own_;
  Eigen::VectorXd correction_;
};

/// M and b(q, v) in burnish's entries; after mj_fwdPosition and mj_fwdVelocity.
Eigen::MatrixXd mass_matrix(const mjModel& model, const mjData& data, const Coordinates& at);
Eigen::VectorXd bias(const mjModel& model, const mjData& data, const Coordinates& at);

}  // namespace burnish::mujoco
