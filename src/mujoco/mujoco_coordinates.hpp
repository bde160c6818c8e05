// Conversion of states between burnish and MuJoCo. In MuJoCo,
//  - a continuous joint has an angle as its coordinate,
//  - quaternions have the order w, x, y, z,
//  - the linear velocity of planar and floating joints is along fixed axes.
// Therefore v = T qvel with an orthogonal matrix T. Mass matrix, torques and accelerations follow:
// M_ours = T M T^T, tau_theirs = T^T tau_ours, a_ours = T qacc + (dT/dt) qvel.
//
// A joint that follows another one (a follower) has its own coordinates in MuJoCo. T then also
// contains the multipliers of followers, and qvel = T^T v, M_ours = T M T^T and
// tau_ours = T tau_theirs still hold. The conversions back are v = T_own qvel and
// tau_theirs = T_own^T tau_ours. T_own is T with zero columns for followers, so it puts all torque
// on the leaders.
#pragma once

#include <mujoco/mujoco.h>

#include "base/to_size.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish::mujoco {

/// Converts states and torques. After construction, only functions that return a matrix allocate.
class Coordinates {
 public:
  /// Throws Error if MuJoCo's model has a different number of degrees of freedom.
  Coordinates(const Model& model, const mjModel& theirs);

  /// Writes the state (q, v) to qpos and qvel.
  void store(const ConstVectorRef& q, const ConstVectorRef& v, mjData& data);
  /// Reads qpos and qvel into q (nq) and v (nv).
  void load(const mjData& data, Eigen::VectorXd& q, Eigen::VectorXd& v);
  /// Convert torques to MuJoCo's entries and back, at the state of the last store() or load().
  void torque_to(const ConstVectorRef& tau, mjtNum* theirs) const;
  void torque_from(const mjtNum* theirs, Eigen::VectorXd& tau) const;

  const Eigen::MatrixXd& T() const { return T_; }
  /// Returns the index in MuJoCo's qvel for entry k of v.
  int entry(int k) const { return entry_[to_size(k)]; }
  /// Returns (dT/dt) qvel at the last store().
  const Eigen::VectorXd& correction() const { return correction_; }

 private:
  void turn(const Joint& joint, int first, const Eigen::Matrix3d& rotation);
  void correct(const Joint& joint, const ConstVectorRef& v);

  Model model_;
  std::vector<int> entry_;
  Eigen::MatrixXd T_, T_own_;
  Eigen::VectorXd correction_;
};

/// Return M and b(q, v) in burnish's entries. Must be called after mj_fwdPosition and
/// mj_fwdVelocity.
Eigen::MatrixXd mass_matrix(const mjModel& model, const mjData& data, const Coordinates& at);
Eigen::VectorXd bias(const mjModel& model, const mjData& data, const Coordinates& at);

}  // namespace burnish::mujoco
