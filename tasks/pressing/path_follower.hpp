// Phases of controllers without plans: approach to the surface, force ramp, path.
#pragma once

#include <string>

#include "base/description.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "estimate/contact_detector.hpp"

namespace burnish::pressing {

/// Returns `path` with its normal scaled to length one. Throws Error for an unset `task`, a
/// posture that does not fit the model, and numbers of `spec` that are out of range. The messages
/// begin with the name of the controller. `spec`: specification of the controller, which contains
/// `path`. `description`: description of `spec`.
PressingPath checked_path(const Model& model, const PressingPath& path,
                          const Description& description, const void* spec,
                          const std::string& controller);

class PathFollower {
 public:
  /// `path`: result of checked_path().
  explicit PathFollower(const PressingPath& path);

  void reset(Command& command) noexcept;
  /// Switches to the next phase if its time has come, and returns the current target with its
  /// normal. Writes phase, target and force estimate to `command`. `force_world`: measured force on
  /// the tool, finite [N].
  TaskPoint update(const Eigen::Vector3d& force_world, Command& command) noexcept;

  /// Returns the last target, with position, velocity and normal extrapolated by `lead` [s].
  TaskPoint ahead(double lead) const noexcept;

  Phase phase() const noexcept { return phase_; }
  /// Returns whether the last update() detected the first contact.
  bool touched() const noexcept { return touched_; }
  /// Returns the force along the normal that was measured at the last update() [N].
  double measured() const noexcept { return measured_; }

 private:
  Eigen::Vector3d normal_;
  std::function<TaskPoint(double t)> task_;
  double period_, touch_force_, ramp_;
  ContactDetector touch_;
  Phase phase_ = Phase::Approach;
  bool touched_ = false;
  TaskPoint target_;
  double since_ = 0.0;  ///< Time since the phase began [s].
  double measured_ = 0.0;
};

/// Returns whether any torque exceeds its limit (nv each). A limit of 0 means no limit.
bool at_limit(const Eigen::VectorXd& tau, const Eigen::VectorXd& effort_limit) noexcept;

}  // namespace burnish::pressing
