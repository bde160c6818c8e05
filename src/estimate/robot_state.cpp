#include "estimate/robot_state.hpp"

#include <utility>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "contact/compiled_contact.hpp"

namespace burnish {
namespace {

std::vector<ContactSpec> without_gains(std::vector<ContactSpec> contacts) {
  for (ContactSpec& contact : contacts) contact.with_gains(0.0, 0.0);
  return contacts;
}

}  // namespace

RobotState::RobotState(const Model& model, std::vector<ContactSpec> contacts,
                       const std::vector<ToolFrames>& tools)
    : body_(model),
      // The regularization `mu` allows postures in which the contact equations are singular.
      dynamics_(model, without_gains(std::move(contacts)), {.mu = 1e-9}),
      q_(model.q_neutral),
      v_(Eigen::VectorXd::Zero(model.nv)) {
  for (const ToolFrames& frames : tools) tools_.emplace_back(body_, frames);
  for (const CompiledContact& contact : dynamics_.contacts().contacts())
    is_loop_.push_back(is_loop(model, contact.spec) ? 1 : 0);
}

Status RobotState::update(const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  const Status status = body_.update(q, v);
  if (!is_usable(status)) return status;
  q_ = q;
  v_ = v;
  has_tools_ = has_dynamics_ = false;
  return status;
}

Status RobotState::set_payload(std::string_view frame, const InertiaSpec& payload) {
  const Status status = dynamics_.set_payload(frame, payload);
  if (status != Status::Ok) return status;
  has_dynamics_ = false;
  return body_.set_payload(frame, payload);
}

const std::vector<ToolMotion>& RobotState::tools() noexcept {
  if (!has_tools_)
    for (ToolMotion& tool : tools_) tool.update(body_);
  has_tools_ = true;
  return tools_;
}

void RobotState::activate(const ActiveContacts& active) noexcept {
  for (int c = 0; c < static_cast<int>(active.size()); ++c) {
    const bool is_active = active[to_size(c)] != 0;
    if (dynamics_.is_active(c) != is_active) dynamics_.set_active(c, is_active);
  }
}

Status RobotState::forward(const ActiveContacts& active, const ConstVectorRef& tau) noexcept {
  activate(active);
  if (!has_dynamics_) (void)dynamics_.update(body_);  // dynamics_.forward() reports errors
  has_dynamics_ = true;
  return dynamics_.forward(tau);
}

Status RobotState::forward_at(const ConstVectorRef& q, const ConstVectorRef& v,
                              const ActiveContacts& active, const ConstVectorRef& tau) noexcept {
  has_dynamics_ = false;
  activate(active);
  return dynamics_.forward(q, v, tau);
}

RobotState::ActiveContacts RobotState::active_in(const std::vector<ContactSpec>& contacts) const {
  ActiveContacts active = is_loop_;
  for (const ContactSpec& contact : contacts)
    active[to_size(dynamics_.contacts().index(contact.name))] = 1;
  return active;
}

}  // namespace burnish
