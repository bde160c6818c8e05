// One knot as a user's own residual sees it: values and derivatives that the other terms of the
// knot have already paid for.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "burnish/base/views.hpp"
#include "burnish/dynamics/reference.hpp"

namespace burnish {

/// Where the parts of z = (du, dq, dv, dtau, dforce) start, and how many entries they have.
/// @described ocp
struct StateLayout {
  int nq = 0;
  int nv = 0;
  int filtered = 0;  ///< torques in the state (torque model), or 0
  /// those are the controls of the step before, and what acts is the control itself
  bool holds_torque = false;
  int remembered = 0;  ///< forces of the step before in the state, N and Nm (remembered_forces)
  int nu = 0;
  std::vector<int> actuated;  ///< entry of v that control i drives; nu entries

  /// What acts is the torque in the state.
  bool acts_from_state() const { return filtered > 0 && !holds_torque; }
  int nx() const { return nq + nv + filtered + remembered; }
  int ndx() const { return 2 * nv + filtered + remembered; }
  int nz() const { return nu + ndx(); }
  int column_q() const { return nu; }
  int column_v() const { return nu + nv; }
  int column_tau() const { return nu + 2 * nv; }
  int column_force() const { return nu + 2 * nv + filtered; }
};

/// Frames and contacts go by their place in the lists that the residual declares.
class NodeView {
 public:
  virtual ~NodeView() = default;
  virtual const StateLayout& layout() const = 0;
  virtual double time() const = 0;   ///< s
  virtual VectorView q() const = 0;  ///< nq
  virtual VectorView v() const = 0;  ///< nv
  virtual VectorView u() const = 0;  ///< nu, zero at the end of the horizon
  /// nv: what the actuators apply, Nm (N).
  virtual VectorView tau() const = 0;
  /// nv, rad/s^2 (m/s^2); zero where nothing solves for it (impacts, the end of the horizon).
  virtual VectorView acceleration() const = 0;

  virtual Eigen::Isometry3d placement(int frame) const = 0;
  virtual Vector6 velocity(int frame, const Reference& reference) const = 0;
  /// Force of a contact in its own reference (rows held), N and Nm.
  virtual VectorView force(int contact) const = 0;

  /// d(velocity)/dv in that reference, 6 x nv; its linear rows in Reference::centered() are dp/dq.
  /// Valid until the next call.
  virtual MatrixView jacobian(int frame, const Reference& reference) const = 0;
  /// d(force)/dz, rows x nz; inside the residual's own jacobian() only.
  virtual MatrixView force_derivative(int contact) const = 0;
};

}  // namespace burnish
