// Estimate of contact forces in a stage of the schedule, by forward dynamics with given torques.
#pragma once

#include "base/to_size.hpp"
#include "burnish/base/signal.hpp"
#include "estimate/robot_state.hpp"

namespace burnish {

/// Contacts of a task, in the order and with the indices of the contacts of a RobotState.
struct StageContacts {
  std::vector<RobotState::ActiveContacts> all;       ///< Active contacts of each stage.
  std::vector<RobotState::ActiveContacts> supports;  ///< Active supports and loops of each stage.
  /// Rotation over time of each contact's reference frame; an empty Signal if it is constant.
  std::vector<Signal> rotations;
  std::vector<int> following;      ///< Contacts whose surface set_surface() replaces.
  std::vector<int> with_friction;  ///< Contacts whose friction set_friction() replaces.
};

class ContactForceEstimate {
 public:
  explicit ContactForceEstimate(StageContacts contacts);
  /// Stores the surface that place() sets for the contacts in `following`.
  void set_surface(const Quadric& surface) noexcept { surface_ = surface; }
  /// Stores the coefficient of friction that place() sets for the contacts in `with_friction`.
  void set_friction(double coefficient) noexcept { friction_ = coefficient; }
  /// Returns true if the stage has a contact other than supports and loops.
  bool has_contact(int stage) const noexcept;
  /// Returns the active contacts of a stage; if `with_all` is false, only supports and loops.
  const RobotState::ActiveContacts& active(int stage, bool with_all) const noexcept {
    return (with_all ? contacts_.all : contacts_.supports)[to_size(stage)];
  }
  /// Sets reference rotations, surface and friction of the contacts in the dynamics of `state`.
  /// `time`: time of the schedule [s]. Returns false if a rotation cannot be evaluated.
  bool place(RobotState& state, double time) noexcept;
  /// Sets `out` to the sum of the contact forces on the robot in a stage, in world axes [N]. Forces
  /// of supports and loops are not included. `tau`: torques (nv) [Nm or N]. `time`: time of the
  /// schedule at which references are evaluated [s]. Returns false and a zero force if the stage
  /// has only supports and loops, or if the dynamics have no solution.
  bool force_at(RobotState& state, int stage, double time, const Eigen::VectorXd& tau,
                Eigen::Vector3d& out) noexcept;

 private:
  StageContacts contacts_;
  Eigen::VectorXd xyzw_;
  std::optional<Quadric> surface_;
  std::optional<double> friction_;
};

}  // namespace burnish
