#include "mpc/contact_force_estimate.hpp"

#include <algorithm>

#include "base/to_size.hpp"
#include "dynamics/reference.hpp"
#include "mpc/closed_dynamics.hpp"
#include "mpc/horizon.hpp"

namespace burnish {
namespace {

/// Returns the contacts with zero gains. In plans, the gains keep the tool on the surface; in an
/// estimate, they would turn velocity noise into force.
std::vector<ContactSpec> without_gains(std::vector<ContactSpec> contacts) {
  for (ContactSpec& contact : contacts) contact.with_gains(0.0, 0.0);
  return contacts;
}

}  // namespace

ContactForceEstimate::ContactForceEstimate(const MpcSpec& spec)
    : xyzw_(4),
      dynamics_(spec.problem.model,
                without_gains(contacts_at(spec.problem.contacts, spec.problem.start_time)),
                {.mu = 1e-9}),
      following_(contacts_on_surface(spec)),
      with_friction_(contacts_with_friction(spec)) {
  const ProblemSpec& problem = spec.problem;
  for (const ContactSpec& contact : problem.contacts)
    rotations_.push_back(contact.reference.rotation_over_time);
  for (const ContactSpec& contact : problem.contacts)
    carries_.push_back(carries(spec, contact) ? 1 : 0);
  for (const Stage& stage : problem.stages) {
    std::vector<char>& holds = holds_.emplace_back();
    for (const ContactSpec& contact : problem.contacts)
      holds.push_back(std::find(stage.contacts.begin(), stage.contacts.end(), contact.name) !=
                              stage.contacts.end()
                          ? 1
                          : 0);
  }
}

void ContactForceEstimate::set_surface(const Quadric& surface) noexcept {
  for (const int contact : following_) (void)dynamics_.set_surface(contact, surface);
}

void ContactForceEstimate::set_friction(double coefficient) noexcept {
  for (const int contact : with_friction_) (void)dynamics_.set_friction(contact, coefficient);
}

bool ContactForceEstimate::has_contact(int stage) const noexcept {
  const std::vector<char>& holds = holds_[to_size(stage)];
  for (std::size_t c = 0; c < holds.size(); ++c)
    if (holds[c] != 0 && carries_[c] == 0) return true;
  return false;
}

bool ContactForceEstimate::set_rotations(double time) noexcept {
  for (std::size_t c = 0; c < rotations_.size(); ++c) {
    if (rotations_[c].empty()) continue;
    try {
      rotations_[c].at(time, xyzw_);
    } catch (...) {  // a function of the specification threw an exception
      return false;
    }
    if (!is_unit_quaternion(xyzw_)) return false;
    (void)dynamics_.set_reference_rotation(static_cast<int>(c), rotation_matrix(xyzw_));
  }
  return true;
}

bool ContactForceEstimate::forward(int stage, double time, bool with_all, const ConstVectorRef& q,
                                   const ConstVectorRef& v, const Eigen::VectorXd& tau) noexcept {
  if (!set_rotations(time)) return false;
  const std::vector<char>& holds = holds_[to_size(stage)];
  for (int c = 0; c < static_cast<int>(holds.size()); ++c) {
    const auto at = to_size(c);
    const bool active = holds[at] != 0 && (with_all || carries_[at] != 0);
    if (dynamics_.is_active(c) != active) dynamics_.set_active(c, active);
  }
  return is_usable(dynamics_.forward(q, v, tau));
}

bool ContactForceEstimate::force_at(int stage, double time, const Eigen::VectorXd& q,
                                    const Eigen::VectorXd& v, const Eigen::VectorXd& tau,
                                    Eigen::Vector3d& out) noexcept {
  out.setZero();
  if (!has_contact(stage) || !forward(stage, time, true, q, v, tau)) return false;
  const std::vector<char>& holds = holds_[to_size(stage)];
  for (int c = 0; c < static_cast<int>(holds.size()); ++c)
    if (dynamics_.is_active(c) && carries_[to_size(c)] == 0)
      out += dynamics_.wrench(c, Reference::centered()).head<3>();
  return true;
}

}  // namespace burnish
