#include "pressing/path_follower.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"

namespace burnish::pressing {
namespace {

constexpr double touch_window = 5e-3;  // time window of the contact detector [s]; chosen by hand

/// Returns the cubic from 0 to 1 over unit time, at rest at both ends.
double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

}  // namespace

PressingPath checked_path(const Model& model, const PressingPath& path,
                          const Description& description, const void* spec,
                          const std::string& controller) {
  const auto refuse = [&](const std::string& what) {
    throw Error("the " + controller + "'s " + what);
  };
  check_ranges(description, spec,
               [&](const std::string& entry) { return "the " + controller + "'s " + entry; });
  if (!path.task) refuse("task is empty; wanted a function of time");
  if (path.posture.size() != model.nq)
    refuse("posture has " + std::to_string(path.posture.size()) + " entries; wanted " +
           std::to_string(model.nq));
  PressingPath checked = path;
  checked.normal_world.normalize();
  return checked;
}

PathFollower::PathFollower(const PressingPath& path)
    : normal_(path.normal_world),
      task_(path.task),
      period_(path.period),
      touch_force_(path.touch_force),
      ramp_(path.ramp),
      touch_(path.contact_threshold, static_cast<int>(std::lround(touch_window / path.period))) {}

void PathFollower::reset(Command& command) noexcept {
  since_ = measured_ = 0.0;
  touched_ = false;
  touch_.reset();
  phase_ = Phase::Approach;
  command.tau.setZero();
  command.phase = number_of(phase_);
  command.tools.front().normal_world = normal_;
  command.status = Status::Ok;
}

TaskPoint PathFollower::update(const Eigen::Vector3d& force_world, Command& command) noexcept {
  ToolCommand& tool = command.tools.front();
  measured_ = force_world.dot(tool.normal_world);
  const Phase before = phase_;
  touch_.add(measured_, phase_ == Phase::Approach);
  touched_ = phase_ == Phase::Approach && touch_.touches();
  if (touched_)
    phase_ = Phase::Ramp;
  else if (phase_ == Phase::Ramp && since_ >= ramp_)
    phase_ = Phase::Track;
  command.phase = number_of(phase_);
  since_ = phase_ == before ? since_ + period_ : 0.0;
  TaskPoint target = task_(phase_ == Phase::Track ? since_ : 0.0);
  if (phase_ == Phase::Approach) target.force = 0.0;
  if (phase_ == Phase::Ramp) {
    const double first = std::min(touch_force_, target.force);
    target.force = first + (target.force - first) * (ramp_ > 0.0 ? smooth(since_ / ramp_) : 1.0);
  }
  if (phase_ != Phase::Track) target.v_world.setZero(), target.a_world.setZero();
  if (target.normal_world.isZero(0.0)) target.normal_world = normal_;
  tool.target_force = target.force;
  tool.normal_world = target.normal_world;
  tool.p_target_world = target.p_world;
  tool.force_estimate_world = force_world;
  target_ = target;
  return target;
}

TaskPoint PathFollower::ahead(double lead) const noexcept {
  if (phase_ != Phase::Track || lead <= 0.0) return target_;
  TaskPoint target = task_(since_ + lead);
  target.force = target_.force;
  if (target.normal_world.isZero(0.0)) target.normal_world = normal_;
  return target;
}

bool at_limit(const Eigen::VectorXd& tau, const Eigen::VectorXd& effort_limit) noexcept {
  return (tau.array().abs() > effort_limit.array() && effort_limit.array() > 0.0).any();
}

}  // namespace burnish::pressing
