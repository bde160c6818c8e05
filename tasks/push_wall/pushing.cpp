#include "push_wall/pushing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"

namespace burnish::push_wall {
namespace {

using pressing::slid;

/// Adds the sample `value` to the low-pass filter `mean`, which has the given time constant [s].
void low_pass(double& mean, double value, double dt, double time_constant) noexcept {
  mean += -std::expm1(-dt / time_constant) * (value - mean);
}

constexpr unsigned contact_event = 1U, limit_event = 2U;  // bits of the events

}  // namespace

Pushing::Pushing(const MpcSpec& spec, const Task& task, const Setting& setting,
                 std::shared_ptr<SearchState> force_search)
    : task_(task),
      setting_(setting),
      search_(std::move(force_search)),
      start_height_(setting.com.z()),
      statics_(make_statics(task, setting)) {
  const RigidBody body(spec.problem.model);
  for (std::size_t h = 0; h < 2; ++h) {
    hands_[h].frame = body.frame(task.hands[h]);
    hands_[h].column = wrench_column(spec, task.hands[h]);
  }
  for (const std::string& foot : task.standing.feet) {
    feet_.push_back(body.frame(foot));
    p_feet_.push_back(frame_placement(spec.problem.model, setting.q_start, foot).translation());
  }
  p_slow_ = p_feet_;
  Pushing::reset();
}

std::vector<WatchedQuantity> Pushing::watched() const {
  // The order must match explain() and watch().
  const std::string left = "hand " + in_quotes(task_.hands[0]),
                    right = "hand " + in_quotes(task_.hands[1]);
  std::vector<WatchedQuantity> all{{"force of a hand", "N", FaultKind::ForceLimit, left},
                                   {"force of a hand", "N", FaultKind::ForceLimit, right},
                                   {"time without force", "s", FaultKind::ContactLost, left},
                                   {"time without force", "s", FaultKind::ContactLost, right},
                                   {"lateness of contact", "s", FaultKind::ContactLate},
                                   {"slip of " + left, "m"},
                                   {"slip of " + right, "m"},
                                   {"drop of the centre of mass", "m"}};
  for (const std::string& foot : task_.standing.feet)
    all.push_back({"slip of foot " + in_quotes(foot), "m"});
  return all;
}

void Pushing::reset() noexcept {
  for (Hand& hand : hands_) hand = {.frame = hand.frame, .column = hand.column};
  behind_ = infeasible_ = late_ = unchecked_ = short_ = 0.0;
  search_->reached = -1.0;
  search_->limit = 0;
  search_->where = -1;
}

void Pushing::filter_forces(const TaskView& view) noexcept {
  for (Hand& hand : hands_) {
    const Eigen::Vector3d f_world =
        view.body.placement(hand.frame).linear() * view.measurement.force_at(hand.column);
    const double force = f_world.dot(setting_.wall_axes.col(2));
    low_pass(hand.quick, force, view.dt, 5e-3);
    low_pass(hand.touch, force, view.dt, 10e-3);
  }
}

unsigned Pushing::sense(const TaskView& view) noexcept {
  filter_forces(view);
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
  if (phase != force_search) {
    reset_slow_slip(view.body);
    return 0;
  }
  int where = -1;
  const Limit found = look(view, where);
  if (found == Limit::None) return 0;
  search_->where = where;
  search_->limit = static_cast<int>(found);
  search_->reached = force_at(task_, setting_, *search_, view.schedule.time());
  return limit_event;
}

/// Returns whether the posture can hold the force with the required reserve while at rest. Returns
/// false only after the reserve has been missing for 0.1 s.
bool Pushing::has_static_reserve(const TaskView& view, double force) noexcept {
  // Period of checks, and longest time without the reserve [s]; chosen by hand.
  constexpr double check_period = 0.02, patience = 0.1;
  unchecked_ += view.dt;
  if (unchecked_ < check_period) return true;
  const double max_force = statics_.max_force(view.body);
  short_ = max_force < (1.0 + task_.force_search.reserve) * force ? short_ + unchecked_ : 0.0;
  unchecked_ = 0.0;
  return short_ < patience;
}

/// Returns the condition that now ends the search for the largest force, or Limit::None.
Limit Pushing::look(const TaskView& view, int& where) noexcept {
  constexpr double patience = 0.05;  // longest time with infeasible plans [s], chosen by hand
  const double wanted = force_at(task_, setting_, *search_, view.schedule.time());
  low_pass(behind_, wanted - 0.5 * (hands_[0].touch + hands_[1].touch), view.dt, 0.1);
  infeasible_ = view.command.constraints_infeasible ? infeasible_ + view.dt : 0.0;
  int hand = -1, foot = -1;
  if (slides(view, hand, foot)) {
    where = hand >= 0 ? hand : foot;
    return hand >= 0 ? Limit::Hand : Limit::Foot;
  }
  if (infeasible_ > patience) return Limit::Plan;
  if (behind_ > task_.force_search.force_tolerance) return Limit::Tracking;
  if (!has_static_reserve(view, wanted)) {
    where = statics_.limit();
    return Limit::Statics;
  }
  return view.schedule.waits() ? Limit::ForceMax : Limit::None;
}

/// Restarts the low-pass filters that slides() uses, at the current slip.
void Pushing::reset_slow_slip(const RigidBody& body) noexcept {
  for (Hand& hand : hands_)
    hand.slow_slip =
        slid(hand.contact, body.placement(hand.frame), setting_.wall_axes.col(2), task_.tip_radius);
  for (std::size_t i = 0; i < feet_.size(); ++i)
    p_slow_[i] = body.placement(feet_[i]).translation();
}

/// Returns whether a hand or a foot has slipped during about the last second, and sets `hand` or
/// `foot` to its index. A high-pass filter removes slow creep.
bool Pushing::slides(const TaskView& view, int& hand, int& foot) noexcept {
  // Time constant of the high-pass filter [s], chosen by hand.
  constexpr double time_constant = 1.0;
  const double gain = -std::expm1(-view.dt / time_constant);
  const Eigen::Vector3d n = setting_.wall_axes.col(2);
  for (int h = 0; h < 2; ++h) {
    Hand& at = hands_[to_size(h)];
    const Eigen::Vector3d slip =
        slid(at.contact, view.body.placement(at.frame), n, task_.tip_radius) - at.slow_slip;
    at.slow_slip += gain * slip;
    if (slip.norm() > task_.force_search.slip) hand = h;
  }
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Eigen::Vector3d slip = view.body.placement(feet_[i]).translation() - p_slow_[i];
    p_slow_[i] += gain * slip;
    if (slip.head<2>().norm() > task_.force_search.slip) foot = static_cast<int>(i);
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
  out[7] = {start_height_ - view.body.com().z(), task_.sink};
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Eigen::Vector3d off = view.body.placement(feet_[i]).translation() - p_feet_[i];
    out[8 + i] = {off.head<2>().norm(), task_.slip};
  }
}

void Pushing::explain(std::size_t quantity, std::span<char> clause) const noexcept {
  if (quantity == 2 || quantity == 3)
    std::snprintf(clause.data(), clause.size(),
                  "the largest force was %.2g N; contact needs %.2g N", hands_[quantity - 2].felt,
                  0.5 * task_.contact_threshold);
  if (quantity == 4)
    std::snprintf(clause.data(), clause.size(),
                  "the largest forces were %.2g and %.2g N; contact needs %.2g N in both hands",
                  hands_[0].felt, hands_[1].felt, task_.contact_threshold);
}

void Pushing::aim(double time, Command& command) {
  ToolCommand& targets = command.tools.front();
  targets.p_target_world = setting_.p_hands.col(1);
  targets.target_force = force_at(task_, setting_, *search_, time);
}

}  // namespace burnish::push_wall
