// State of a robot at one measurement, shared by all estimators of a controller.
#pragma once

#include <vector>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "estimate/tool_motion.hpp"

namespace burnish {

/// Kinematics and dynamics at a measured configuration and velocity. update() computes the
/// kinematics. Tool motions, mass matrix and bias are computed on first use. Allocates nothing
/// after construction.
class RobotState {
 public:
  /// Selection of contacts for forward(), one entry per contact: 1 if the contact is active.
  using ActiveContacts = std::vector<char>;

  /// - `contacts`: contacts and loops that can be active. Their Baumgarte gains are set to zero,
  ///   because they would turn measurement noise into forces.
  /// - `tools`: tools of the robot, see ToolMotion.
  ///
  /// Throws Error for an unknown frame, and for contacts that ContactSet rejects.
  RobotState(const Model& model, std::vector<ContactSpec> contacts,
             const std::vector<ToolFrames>& tools);

  /// Evaluates a state: `q` (nq) and `v` (nv). Returns WrongSize, NotFinite or NotNormalized and
  /// changes nothing if the state is invalid; otherwise returns Ok.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;
  /// Sets the payload at a frame, see ContactDynamics::set_payload().
  Status set_payload(std::string_view frame, const InertiaSpec& payload);

  const Eigen::VectorXd& q() const { return q_; }
  const Eigen::VectorXd& v() const { return v_; }
  const RigidBody& body() const { return body_; }
  /// Returns the motion of each tool relative to its surface, at the state.
  const std::vector<ToolMotion>& tools() noexcept;
  /// Computes accelerations and contact forces for joint torques `tau` (nv) [Nm or N], with the
  /// contacts in `active`. The result is in dynamics().
  Status forward(const ActiveContacts& active, const ConstVectorRef& tau) noexcept;
  /// Does what forward() does, at another configuration and velocity. The state does not change.
  Status forward_at(const ConstVectorRef& q, const ConstVectorRef& v, const ActiveContacts& active,
                    const ConstVectorRef& tau) noexcept;
  /// Returns the dynamics, with the result of the last forward() or forward_at(). References,
  /// surfaces and friction of its contacts may be changed before the next call of these functions.
  ContactDynamics& dynamics() noexcept { return dynamics_; }
  /// Returns the selection of all loops and of all contacts whose names occur in `contacts`.
  ActiveContacts active_in(const std::vector<ContactSpec>& contacts) const;

 private:
  void activate(const ActiveContacts& active) noexcept;

  RigidBody body_;
  ContactDynamics dynamics_;
  std::vector<ToolMotion> tools_;
  std::vector<char> is_loop_;  ///< Per contact: 1 for a loop of the robot.
  Eigen::VectorXd q_, v_;
  bool has_tools_ = false;     ///< True if tools_ is updated to q_ and v_.
  bool has_dynamics_ = false;  ///< True if dynamics_ is updated to q_ and v_.
};

}  // namespace burnish
