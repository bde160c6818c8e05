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
  std::vector<int> tools;      ///< Per contact: tool at whose frame the contact is; -1: none.
  std::vector<int> surfaces;   ///< Per contact: tool whose surface the contact has; -1: none.
  std::vector<int> frictions;  ///< Per contact: tool whose friction the contact has; -1: none.
};

class ContactForceEstimate {
 public:
  ContactForceEstimate(StageContacts contacts, std::size_t tools);
  /// Stores the surface under a tool, which place() sets for contacts in StageContacts::surfaces.
  void set_surface(std::size_t tool, const Quadric& surface) noexcept { surfaces_[tool] = surface; }
  /// Stores the coefficient of friction at a tool, which place() sets for contacts in
  /// StageContacts::frictions.
  void set_friction(std::size_t tool, double coefficient) noexcept {
    frictions_[tool] = coefficient;
  }
  /// Returns true if the stage has a contact of the tool that is neither support nor loop.
  bool has_contact(int stage, std::size_t tool) const noexcept;
  /// Returns the active contacts of a stage, without those of tools that do not touch. `touches`:
  /// 1 for each tool that touches its surface, 0 for other tools.
  const RobotState::ActiveContacts& active(int stage, const std::vector<char>& touches) noexcept;
  /// Sets reference rotations, surface and friction of the contacts in the dynamics of `state`.
  /// `time`: time of the schedule [s]. Returns false if a rotation cannot be evaluated.
  bool place(RobotState& state, double time) noexcept;
  /// Sets `out` to the sum of the contact forces on each tool in a stage, in world axes, 3 x tools
  /// [N]. Forces of supports and loops are not included. `tau`: torques (nv) [Nm or N]. `time`:
  /// time of the schedule at which references are evaluated [s]. Returns false and zero forces if
  /// no tool has a contact in the stage, or if the dynamics have no solution.
  bool forces_at(RobotState& state, int stage, double time, const Eigen::VectorXd& tau,
                 Eigen::Matrix3Xd& out) noexcept;

 private:
  bool is_at_tool(int stage, std::size_t contact) const noexcept;

  StageContacts contacts_;
  RobotState::ActiveContacts active_;
  Eigen::VectorXd xyzw_;
  std::vector<std::optional<Quadric>> surfaces_;  ///< Surface under each tool.
  std::vector<std::optional<double>> frictions_;  ///< Coefficient of friction at each tool.
};

}  // namespace burnish
