#include "estimate/contact_force_estimate.hpp"

#include <utility>

#include "dynamics/reference.hpp"

namespace burnish {

ContactForceEstimate::ContactForceEstimate(StageContacts contacts, std::size_t tools)
    : contacts_(std::move(contacts)),
      active_(contacts_.rotations.size()),
      xyzw_(4),
      surfaces_(tools),
      frictions_(tools) {}

/// Returns true if a contact is active in a stage, is at a tool, and is neither support nor loop.
bool ContactForceEstimate::is_at_tool(int stage, std::size_t contact) const noexcept {
  return contacts_.tools[contact] >= 0 &&
         contacts_.all[to_size(stage)][contact] != contacts_.supports[to_size(stage)][contact];
}

bool ContactForceEstimate::has_contact(int stage, std::size_t tool) const noexcept {
  for (std::size_t c = 0; c < contacts_.tools.size(); ++c)
    if (contacts_.tools[c] == static_cast<int>(tool) && is_at_tool(stage, c)) return true;
  return false;
}

const RobotState::ActiveContacts& ContactForceEstimate::active(
    int stage, const std::vector<char>& touches) noexcept {
  active_ = contacts_.all[to_size(stage)];
  for (std::size_t c = 0; c < active_.size(); ++c)
    if (is_at_tool(stage, c) && touches[to_size(contacts_.tools[c])] == 0) active_[c] = 0;
  return active_;
}

bool ContactForceEstimate::place(RobotState& state, double time) noexcept {
  ContactDynamics& dynamics = state.dynamics();
  for (std::size_t c = 0; c < contacts_.rotations.size(); ++c) {
    const int contact = static_cast<int>(c);
    const int surface = contacts_.surfaces[c], friction = contacts_.frictions[c];
    if (surface >= 0 && surfaces_[to_size(surface)])
      (void)dynamics.set_surface(contact, *surfaces_[to_size(surface)]);
    if (friction >= 0 && frictions_[to_size(friction)])
      (void)dynamics.set_friction(contact, *frictions_[to_size(friction)]);
    if (contacts_.rotations[c].empty()) continue;
    try {
      contacts_.rotations[c].at(time, xyzw_);
    } catch (...) {  // a rotation given as a user's function can throw
      return false;
    }
    if (!is_unit_quaternion(xyzw_)) return false;
    (void)dynamics.set_reference_rotation(contact, rotation_matrix(xyzw_));
  }
  return true;
}

bool ContactForceEstimate::forces_at(RobotState& state, int stage, double time,
                                     const Eigen::VectorXd& tau, Eigen::Matrix3Xd& out) noexcept {
  out.setZero();
  bool has_any = false;
  for (std::size_t c = 0; c < contacts_.tools.size(); ++c)
    has_any = has_any || is_at_tool(stage, c);
  if (!has_any || !place(state, time) ||
      !is_usable(state.forward(contacts_.all[to_size(stage)], tau)))
    return false;
  for (std::size_t c = 0; c < contacts_.tools.size(); ++c)
    if (is_at_tool(stage, c))
      out.col(contacts_.tools[c]) +=
          state.dynamics().wrench(static_cast<int>(c), Reference::centered()).head<3>();
  return true;
}

}  // namespace burnish
