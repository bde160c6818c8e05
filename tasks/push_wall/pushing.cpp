#include "push_wall/pushing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/sentence.hpp"
#include "burnish/dynamics/placement.hpp"

namespace burnish::push_wall {
namespace {

using pressing::slid;

void follow(double& mean, double value, double dt, double over) noexcept {
  mean += -std::expm1(-dt / over) * (value - mean);
}

constexpr unsigned contact_event = 1U, limit_event = 2U;  // bits

}  // namespace

Pushing::Pushing(const MpcSpec& spec, const Task& task, const Setting& setting,
                 std::shared_ptr<LeanState> lean)
    : task_(task),
      setting_(setting),
      lean_(std::move(lean)),
      least_(setting.com.z()),
      bearing_(make_bearing(task, setting)) {
  const RigidBody body(spec.problem.model);
  for (std::size_t h = 0; h < 2; ++h) hands_[h].frame = body.frame(task.hands[h]);
  for (const std::string& foot : task.standing.feet) {
    feet_.push_back(body.frame(foot));
    p_feet_.push_back(frame_placement(spec.problem.model, setting.q_start, foot).translation());
  }
  p_crept_ = p_feet_;
  Pushing::reset();
}

std::vector<WatchedQuantity> Pushing::watched() const {
  // explain() and watch() know their places.
  const std::string left = "hand " + in_quotes(task_.hands[0]),
                    right = "hand " + in_quotes(task_.hands[1]);
  std::vector<WatchedQuantity> all{{"force of a hand", "N", FaultKind::ForceLimit, left},
                                   {"force of a hand", "N", FaultKind::ForceLimit, right},
                                   {"time without force", "s", FaultKind::ContactLost, left},
                                   {"time without force", "s", FaultKind::ContactLost, right},
                                   {"lateness of contact", "s", FaultKind::ContactLate},
                                   {"slip of " + left, "m"},
                                   {"slip of " + right, "m"},
                                   {"way down of the centre of mass", "m"}};
  for (const std::string& foot : task_.standing.feet)
    all.push_back({"slip of foot " + in_quotes(foot), "m"});
  return all;
}

void Pushing::reset() noexcept {
  for (Hand& hand : hands_) hand = {.frame = hand.frame};
  behind_ = infeasible_ = late_ = asked_ = short_ = 0.0;
  lean_->reached = -1.0;
  lean_->limit = 0;
  lean_->where = -1;
}

void Pushing::feel(const TaskView& view) noexcept {
  const auto& wrenches = view.measurement.support_wrenches;
  const auto first = static_cast<Eigen::Index>(feet_.size());
  if (wrenches.cols() != first + 2) return;
  for (int h = 0; h < 2; ++h) {
    Hand& hand = hands_[static_cast<std::size_t>(h)];
    const Eigen::Vector3d f_world =
        view.body.placement(hand.frame).linear() * wrenches.col(first + h).head<3>();
    const double force = f_world.dot(setting_.wall_axes.col(2));
    follow(hand.quick, force, view.dt, 5e-3);
    follow(hand.touch, force, view.dt, 10e-3);
  }
}

unsigned Pushing::sense(const TaskView& view) noexcept {
  feel(view);
  const int phase = view.schedule.phase();
  if (phase == approach) {
    const bool both = std::all_of(hands_.begin(), hands_.end(), [&](const Hand& hand) {
      return hand.touch > task_.contact_threshold;
    });
    late_ = view.schedule.waits() ? late_ + view.dt : 0.0;
    if (!both) return 0;
    for (Hand& hand : hands_) hand.contact = view.body.placement(hand.frame);
    return contact_event;
  }
  late_ = 0.0;
  if (phase != lean) {
    creep(view.body);
    return 0;
  }
  int where = -1;
  const Limit found = look(view, where);
  if (found == Limit::None) return 0;
  lean_->where = where;
  lean_->limit = static_cast<int>(found);
  lean_->reached = force_at(task_, setting_, *lean_, view.schedule.time());
  return limit_event;
}

/// Whether the posture, at rest, bears the force and the reserve; false once it has not for a
/// while.
bool Pushing::bears(const TaskView& view, double force) noexcept {
  constexpr double between = 0.02, patience = 0.1;  // s
  asked_ += view.dt;
  if (asked_ < between) return true;
  const double most = bearing_.most(view.body);
  short_ = most < (1.0 + task_.lean.reserve) * force ? short_ + asked_ : 0.0;
  asked_ = 0.0;
  return short_ < patience;
}

/// What ends the search now.
Limit Pushing::look(const TaskView& view, int& where) noexcept {
  constexpr double patience = 0.05;  // s of plans that cannot keep their limits
  const double wanted = force_at(task_, setting_, *lean_, view.schedule.time());
  follow(behind_, wanted - 0.5 * (hands_[0].touch + hands_[1].touch), view.dt, 0.1);
  infeasible_ = view.command.limits_infeasible ? infeasible_ + view.dt : 0.0;
  int hand = -1, foot = -1;
  if (slides(view, hand, foot)) {
    where = hand >= 0 ? hand : foot;
    return hand >= 0 ? Limit::Hand : Limit::Foot;
  }
  if (infeasible_ > patience) return Limit::Plan;
  if (behind_ > task_.lean.give) return Limit::Give;
  if (!bears(view, wanted)) {
    where = bearing_.limit();
    return Limit::Bear;
  }
  return view.schedule.waits() ? Limit::Most : Limit::None;
}

/// From here on what slides is told.
void Pushing::creep(const RigidBody& body) noexcept {
  for (Hand& hand : hands_)
    hand.crept =
        slid(hand.contact, body.placement(hand.frame), setting_.wall_axes.col(2), task_.tip_radius);
  for (std::size_t i = 0; i < feet_.size(); ++i)
    p_crept_[i] = body.placement(feet_[i]).translation();
}

/// Whether one is off where it was about a second ago, so that what creeps does not count.
bool Pushing::slides(const TaskView& view, int& hand, int& foot) noexcept {
  constexpr double memory = 1.0;  // s
  const double share = -std::expm1(-view.dt / memory);
  const Eigen::Vector3d n = setting_.wall_axes.col(2);
  for (int h = 0; h < 2; ++h) {
    Hand& at = hands_[static_cast<std::size_t>(h)];
    const Eigen::Vector3d way =
        slid(at.contact, view.body.placement(at.frame), n, task_.tip_radius) - at.crept;
    at.crept += share * way;
    if (way.norm() > task_.lean.slip) hand = h;
  }
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Eigen::Vector3d way = view.body.placement(feet_[i]).translation() - p_crept_[i];
    p_crept_[i] += share * way;
    if (way.head<2>().norm() > task_.lean.slip) foot = static_cast<int>(i);
  }
  return hand >= 0 || foot >= 0;
}

double Pushing::slip_of(const Hand& hand, const RigidBody& body) const noexcept {
  return slid(hand.contact, body.placement(hand.frame), setting_.wall_axes.col(2), task_.tip_radius)
      .norm();
}

void Pushing::watch(const TaskView& view, std::span<Reading> out) noexcept {
  const int phase = view.schedule.phase();
  const bool pushes = phase >= ramp && phase <= release;
  for (std::size_t h = 0; h < 2; ++h) {
    Hand& hand = hands_[h];
    const bool lost = pushes && hand.touch < 0.5 * task_.contact_threshold;
    const bool goes_on = (lost && hand.without > 0.0) || late_ > view.dt;
    hand.felt = goes_on ? std::max(hand.felt, hand.touch) : hand.touch;
    hand.without = lost ? hand.without + view.dt : 0.0;
    out[h] = {hand.quick, task_.force_limit};
    out[2 + h] = {hand.without, task_.contact_lost};
    out[5 + h] = {pushes ? slip_of(hand, view.body) : 0.0, task_.slip};
  }
  out[4] = {late_, task_.late_contact};
  out[7] = {least_ - view.body.com().z(), task_.sink};
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Eigen::Vector3d off = view.body.placement(feet_[i]).translation() - p_feet_[i];
    out[8 + i] = {off.head<2>().norm(), task_.slip};
  }
}

void Pushing::explain(std::size_t quantity, std::span<char> clause) const noexcept {
  if (quantity == 2 || quantity == 3)
    std::snprintf(clause.data(), clause.size(),
                  "the force came to %.2g N at most; less than %.2g N is no contact",
                  hands_[quantity - 2].felt, 0.5 * task_.contact_threshold);
  if (quantity == 4)
    std::snprintf(clause.data(), clause.size(),
                  "the hands came to %.2g and %.2g N at most; %.2g N in both count as contact",
                  hands_[0].felt, hands_[1].felt, task_.contact_threshold);
}

void Pushing::aim(double time, Command& command) {
  command.p_target_world = setting_.p_hands.col(1);
  command.target_force = force_at(task_, setting_, *lean_, time);
}

}  // namespace burnish::push_wall
