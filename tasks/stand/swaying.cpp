#include "stand/swaying.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/sentence.hpp"
#include "burnish/dynamics/placement.hpp"
#include "pressing/sliding.hpp"
#include "pressing/stage_terms.hpp"

namespace burnish::stand {
namespace {

/// Displacement of the trunk from its start, in the axes Setting::heading: shift [m] and turn
/// [rad].
struct TrunkOffset {
  Eigen::Vector3d shift, turn;
};

/// Returns the displacement of the trunk at the time `time` after the sway began [s].
TrunkOffset offset_at(const Task& task, const Sway& s, double time) {
  const double envelope =
      pressing::smooth(time / s.rise) * pressing::smooth((task.sway_duration - time) / s.rise);
  const auto sine = [&](const Eigen::Vector3d& amplitude, const Eigen::Vector3d& rate) {
    Eigen::Vector3d value;
    for (int i = 0; i < 3; ++i)
      value[i] = envelope * amplitude[i] * std::sin(2.0 * std::numbers::pi * rate[i] * time);
    return value;
  };
  return {sine(s.shift, s.shift_rate), sine(s.turn, s.turn_rate)};
}

}  // namespace

Trunk trunk_at(const Task& task, const Setting& setting, double time) {
  constexpr double h = 1e-4;  // step of central differences [s]
  const double since = time - task.settle_duration;
  const TrunkOffset now = offset_at(task, setting.sway, since);
  Trunk trunk;
  trunk.com = setting.com + setting.heading * now.shift;
  trunk.com_velocity = setting.heading * ((offset_at(task, setting.sway, since + h).shift -
                                           offset_at(task, setting.sway, since - h).shift) /
                                          (2.0 * h));
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(now.turn.z(), Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(now.turn.y(), Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(now.turn.x(), Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  trunk.base = setting.heading * turn * setting.heading.transpose() * setting.R_base;
  return trunk;
}

double slip_of(const Eigen::Isometry3d& start, const Eigen::Isometry3d& now,
               const Standing& standing) {
  const double radius = standing.has_soles() ? 0.0 : standing.radius;
  return pressing::slid(start, now, Eigen::Vector3d::UnitZ(), radius).norm();
}

double turn_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.transpose() * b)).angle();
}

TrunkFall lying_at(const Setting& setting, const Trunk& wanted, const Eigen::Vector3d& com,
                   const Eigen::Matrix3d& R_base) {
  const double height = setting.com.z() - setting.ground.point.z();
  return {(wanted.com.z() - com.z()) / height, turn_between(wanted.base, R_base)};
}

Swaying::Swaying(const MpcSpec& spec, Task task, Setting setting)
    : task_(std::move(task)), setting_(std::move(setting)) {
  const RigidBody body(spec.problem.model);
  base_ = body.frame(setting_.base);
  for (const std::string& foot : setting_.standing.feet) {
    feet_.push_back(body.frame(foot));
    start_.push_back(frame_placement(spec.problem.model, setting_.q_start, foot));
  }
}

std::vector<WatchedQuantity> Swaying::watched() const {
  std::vector<WatchedQuantity> all{{"drop of the centre of mass as a fraction of its height", ""},
                                   {"angle of the base from its target", "rad"}};
  for (const std::string& foot : setting_.standing.feet)
    all.push_back({"slip of foot " + in_quotes(foot), "m"});
  return all;
}

void Swaying::watch(const TaskView& view, std::span<Reading> out) noexcept {
  const Trunk wanted = trunk_at(task_, setting_, view.schedule.time());
  const TrunkFall lying =
      lying_at(setting_, wanted, view.body.com(), view.body.placement(base_).linear());
  out[0] = {lying.sunk, task_.sink};
  out[1] = {lying.turned, task_.tilt};
  for (std::size_t i = 0; i < feet_.size(); ++i)
    out[2 + i] = {slip_of(start_[i], view.body.placement(feet_[i]), setting_.standing), task_.slip};
}

/// Sets the recorded target: the position that the base would have if it moved with the centre of
/// mass.
void Swaying::aim(double time, Command& command) {
  command.tools.front().p_target_world =
      setting_.p_base + trunk_at(task_, setting_, time).com - setting_.com;
}

}  // namespace burnish::stand
