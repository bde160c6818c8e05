#include "estimate/contact_force_estimate.hpp"

#include <utility>

#include "dynamics/reference.hpp"

namespace burnish {

ContactForceEstimate::ContactForceEstimate(StageContacts contacts)
    : contacts_(std::move(contacts)), xyzw_(4) {}

bool ContactForceEstimate::has_contact(int stage) const noexcept {
  return contacts_.all[to_size(stage)] != contacts_.supports[to_size(stage)];
}

bool ContactForceEstimate::place(RobotState& state, double time) noexcept {
  ContactDynamics& dynamics = state.dynamics();
  if (surface_)
    for (const int contact : contacts_.following) (void)dynamics.set_surface(contact, *surface_);
  if (friction_)
    for (const int contact : contacts_.with_friction)
      (void)dynamics.set_friction(contact, *friction_);
  for (std::size_t c = 0; c < contacts_.rotations.size(); ++c) {
    if (contacts_.rotations[c].empty()) continue;
    try {
      contacts_.rotations[c].at(time, xyzw_);
    } catch (...) {  // a rotation given as a user's function can throw
      return false;
    }
    if (!is_unit_quaternion(xyzw_)) return false;
    (void)dynamics.set_reference_rotation(static_cast<int>(c), rotation_matrix(xyzw_));
  }
  return true;
}

bool ContactForceEstimate::force_at(RobotState& state, int stage, double time,
                                    const Eigen::VectorXd& tau, Eigen::Vector3d& out) noexcept {
  out.setZero();
  if (!has_contact(stage) || !place(state, time) ||
      !is_usable(state.forward(contacts_.all[to_size(stage)], tau)))
    return false;
  for (std::size_t c = 0; c < contacts_.rotations.size(); ++c)
    if (contacts_.all[to_size(stage)][c] != contacts_.supports[to_size(stage)][c])
      out += state.dynamics().wrench(static_cast<int>(c), Reference::centered()).head<3>();
  return true;
}

}  // namespace burnish
