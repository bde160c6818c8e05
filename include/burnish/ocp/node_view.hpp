// View of one knot for a user's own residual: values and derivatives that are already computed for
// the other terms of the knot.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "burnish/base/views.hpp"
#include "burnish/dynamics/reference.hpp"

namespace burnish {

/// Sizes of the parts of the state and the control, and the first column of each part in
/// z = (du, dq, dv, dtau, dforce).
/// @described ocp
struct StateLayout {
  int nq = 0;
  int nv = 0;
  int filtered = 0;  ///< Number of torques in the state: nu with a torque model, else 0

  /// True if the torques in the state are the control of the previous step; the current control
  /// then acts on the robot
  bool holds_torque = false;
  /// Number of contact forces in the state; they are forces of the previous step (N, Nm)
  int force_states = 0;
  int nu = 0;
  /// For each control, the index in v of the entry that the control drives
  std::vector<int> actuated;

  /// Returns true if the torques in the state act on the robot, and false if the current control
  /// acts.
  bool acts_from_state() const { return filtered > 0 && !holds_torque; }
  int nx() const { return nq + nv + filtered + force_states; }
  int ndx() const { return 2 * nv + filtered + force_states; }
  int nz() const { return nu + ndx(); }
  int column_q() const { return nu; }
  int column_v() const { return nu + nv; }
  int column_tau() const { return nu + 2 * nv; }
  int column_force() const { return nu + 2 * nv + filtered; }
};

/// Values and derivatives at one knot, for a user's own residual. The arguments `frame` and
/// `contact` are indices in the residual's own lists `frames` and `contacts`.
class NodeView {
 public:
  virtual ~NodeView() = default;
  virtual const StateLayout& layout() const = 0;
  virtual double time() const = 0;   ///< Time of the knot [s]
  virtual VectorView q() const = 0;  ///< Configuration, nq entries
  virtual VectorView v() const = 0;  ///< Velocity, nv entries
  virtual VectorView u() const = 0;  ///< Control, nu entries; zero at impacts and the horizon's end

  /// Torques that the actuators apply, nv entries [Nm, N].
  virtual VectorView tau() const = 0;
  /// Joint accelerations, nv entries [rad/s^2, m/s^2]. Zero at impacts. Also zero at the end of the
  /// horizon, unless a cost or constraint at the end uses contact forces.
  virtual VectorView acceleration() const = 0;

  virtual Eigen::Isometry3d placement(int frame) const = 0;
  virtual Vector6 velocity(int frame, const Reference& reference) const = 0;
  /// Returns the force of a contact in its constrained directions, written in the Reference of the
  /// contact [N, Nm].
  virtual VectorView force(int contact) const = 0;

  /// Returns d(velocity)/dv of a frame, written in `reference`, 6 x nv. With Reference::centered(),
  /// the linear rows are dp/dq for the frame's position p. The result is valid until the next call.
  virtual MatrixView jacobian(int frame, const Reference& reference) const = 0;
  /// Returns d(force)/dz of a contact, rows x nz. Call this function only inside the residual's own
  /// jacobian().
  virtual MatrixView force_derivative(int contact) const = 0;
};

}  // namespace burnish
