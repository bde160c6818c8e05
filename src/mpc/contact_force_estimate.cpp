#include "mpc/contact_force_estimate.hpp"

#include <algorithm>

namespace burnish {
namespace {

/// Stabilisation keeps plans on the surface; in an estimate it would turn the noise of velocities
/// into force.
std::vector<ContactSpec> without_gains(std::vector<ContactSpec> contacts) {
  for (ContactSpec& contact : contacts) contact.with_gains(0.0, 0.0);
  return contacts;
}

}  // namespace

ContactForceEstimate::ContactForceEstimate(const ProblemSpec& problem)
    : dynamics_(problem.model, without_gains(problem.contacts), {.mu = 1e-9}) {
  for (const Stage& stage : problem.stages) {
    std::vector<char>& holds = holds_.emplace_back();
    for (const ContactSpec& contact : problem.contacts)
      holds.push_back(std::find(stage.contacts.begin(), stage.contacts.end(), contact.name) !=
                              stage.contacts.end()
                          ? 1
                          : 0);
  }
}

bool ContactForceEstimate::has_contact(int stage) const noexcept {
  const std::vector<char>& holds = holds_[static_cast<std::size_t>(stage)];
  return std::find(holds.begin(), holds.end(), 1) != holds.end();
}

bool ContactForceEstimate::force_at(int stage, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                    const Eigen::VectorXd& tau, Eigen::Vector3d& out) noexcept {
  out.setZero();
  if (!has_contact(stage)) return false;
  const std::vector<char>& holds = holds_[static_cast<std::size_t>(stage)];
  for (int c = 0; c < static_cast<int>(holds.size()); ++c) {
    const bool active = holds[static_cast<std::size_t>(c)] != 0;
    if (dynamics_.is_active(c) != active) dynamics_.set_active(c, active);
  }
  if (dynamics_.forward(q, v, tau) > Status::NotConverged) return false;
  for (int c = 0; c < static_cast<int>(holds.size()); ++c)
    if (dynamics_.is_active(c)) out += dynamics_.wrench(c, Reference::centered()).head<3>();
  return true;
}

}  // namespace burnish
