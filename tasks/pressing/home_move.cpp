#include "pressing/home_move.hpp"

#include <algorithm>
#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "pressing/quintic.hpp"
#include "pressing/reach_walk.hpp"

namespace burnish::pressing {
namespace {

void refuse_impossible(const Model& model) {
  if (!model.loops.empty())
    throw EntryError("home", "robot " + in_quotes(model.name) +
                                 " has closed loops, which a straight move of its joints would "
                                 "open; wanted a robot without loops");
  for (const Joint& joint : model.joints)
    if (joint.kind == JointKind::FreeFlyer)
      throw EntryError(
          "home", "the base of robot " + in_quotes(model.name) +
                      " floats, and the robot could fall during a straight move of its joints; "
                      "wanted a fixed base");
}

Eigen::VectorXd home_configuration(const HomeSpec& home, const Robot& robot,
                                   const Eigen::VectorXd& q_start) {
  const Model& model = robot.model;
  Eigen::VectorXd q =
      home.posture.empty() ? q_start : about("home", [&] { return robot.posture(home.posture); });
  for (const auto& [name, value] : home.joints) {
    std::vector<std::string> names;
    bool found = false;
    for (const Joint& joint : model.joints) {
      if (joint.follows) continue;
      names.push_back(joint.name);
      if (joint.name != name) continue;
      found = true;
      if (joint.nq == 1) {
        q[joint.q_index] = value;
      } else if (joint.kind == JointKind::Continuous) {
        q.segment<2>(joint.q_index) << std::cos(value), std::sin(value);
      } else {
        throw EntryError("home.joints",
                         "joint " + in_quotes(name) +
                             " has several position entries; wanted a joint with one, "
                             "or home.posture");
      }
    }
    if (!found)
      throw EntryError("home.joints", "robot " + in_quotes(model.name) + " has no moving joint " +
                                          in_quotes(name) + did_you_mean(name, names));
  }
  return q;
}

void check_limits(const Model& model, const Eigen::VectorXd& q) {
  const std::string beyond = beyond_limits(model, q);
  if (!beyond.empty())
    throw EntryError("home", beyond + "; wanted another posture, or other values in home.joints");
}

/// Returns the shortest duration of a leg of the move (the motion between two corners) within the
/// velocity limits [s]. `fastest`: receives the entry of v that needs this duration.
double time_at_limit(const Model& model, const Eigen::VectorXd& displacement, int& fastest) {
  // Velocity limit assumed for joints without one [rad/s (m/s)]. Chosen by hand.
  constexpr double usual = 1.0;
  double longest = 0.0;
  for (int k = 0; k < model.nv; ++k) {
    const double limit = model.velocity_limit[k];
    const double time = quintic_speed * std::abs(displacement[k]) /
                        (std::isfinite(limit) && limit > 0.0 ? limit : usual);
    if (time <= longest) continue;
    longest = time;
    fastest = k;
  }
  return longest;
}

/// Returns the factor by which a leg of the move (the motion between two corners) must last longer
/// so that torques stay within 0.8 of their limits; at most 5. Torques of the motion are
/// proportional to the inverse square of the duration.
double stretch_for_torque(const Model& model, const Eigen::VectorXd& q_begin,
                          const Eigen::VectorXd& displacement, double duration) {
  constexpr int samples = 40;
  constexpr double torque_fraction = 0.8;  // default of ReachOptions::torque_share
  // Fraction of a torque limit that is always left for the motion; chosen by hand.
  constexpr double min_fraction = 0.1;
  constexpr double max_stretch = 5.0;  // largest returned factor; chosen by hand
  ContactDynamics dynamics(model);
  double stretch = 1.0;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  for (int i = 0; i <= samples; ++i) {
    const Quintic at = quintic(static_cast<double>(i) / samples);
    const Eigen::VectorXd q = integrate(model, q_begin, at.s * displacement);
    if (!is_usable(dynamics.forward(q, zero, zero))) continue;
    const Eigen::VectorXd rest = dynamics.bias();
    if (!is_usable(dynamics.forward(q, at.ds / duration * displacement, zero))) continue;
    const Eigen::VectorXd motion =
        dynamics.bias() - rest +
        at.ds2 / (duration * duration) * (dynamics.mass_matrix() * displacement);
    for (int k = 0; k < model.nv; ++k) {
      const double limit = model.effort_limit[k];
      if (!std::isfinite(limit) || limit <= 0.0) continue;
      const double left =
          std::max(min_fraction * limit, torque_fraction * limit - std::abs(rest[k]));
      stretch = std::max(stretch, std::sqrt(std::abs(motion[k]) / left));
    }
  }
  return std::min(stretch, max_stretch);
}

/// Sets the durations of the legs of the move, and the joint that moves most.
void set_durations(const HomeSpec& home, const Model& model, HomeMove& move) {
  // Shortest duration of a leg of the move [s], chosen by hand.
  constexpr double min_duration = 1.0;
  double at_limit = 0.0;
  std::string fastest;
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(model.nv);
  for (std::size_t i = 0; i + 1 < move.corners.size(); ++i) {
    const Eigen::VectorXd displacement = difference(model, move.corners[i], move.corners[i + 1]);
    moved += displacement.cwiseAbs();
    int k = 0;
    const double time = time_at_limit(model, displacement, k);
    if (i == 0) fastest = model.v_name(k);
    at_limit += time;
    const double usual = std::max(min_duration, time / home.speed_ratio);
    move.durations.push_back(usual *
                             stretch_for_torque(model, move.corners[i], displacement, usual));
  }
  Eigen::Index farthest = 0;
  move.farthest = moved.maxCoeff(&farthest);
  move.farthest_joint = model.v_name(static_cast<int>(farthest));
  if (!home.duration) return;
  if (at_limit > *home.duration)
    throw EntryError("home.duration", "it is " + number(*home.duration) + " s, and joint " +
                                          in_quotes(fastest) + " needs " + number(at_limit) +
                                          " s at its velocity limit; wanted at least " +
                                          number(at_limit) + " s, or auto");
  const double scale = *home.duration / move.duration();
  for (double& duration : move.durations) duration *= scale;
}

HomeMove move_over(const HomeSpec& home, const Model& model, std::vector<Eigen::VectorXd> corners) {
  HomeMove move{.corners = std::move(corners)};
  set_durations(home, model, move);
  return move;
}

}  // namespace

std::optional<HomeMove> home_move(const HomeSpec& home, const Robot& robot,
                                  const Eigen::VectorXd& q_start, const SceneSpec& scene) {
  if (!home.is_stated()) return std::nullopt;
  const Model& model = robot.model;
  refuse_impossible(model);
  const Eigen::VectorXd q_home = home_configuration(home, robot, q_start);
  check_limits(model, q_home);
  const HomeMove straight = move_over(home, model, {q_home, q_start});
  const ReachOptions usual;
  if (check_home_move(straight, model, scene, usual).problem != ReachProblem::Collision)
    return straight;
  ReachWalk walk(model, scene, q_start, usual);
  const Eigen::Vector3d p = frame_placement(model, q_start, scene.tool().frame).translation();
  double before = 0.0;
  for (const double lift : {0.05, 0.1, 0.2}) {
    const Eigen::Vector3d& n = scene.tool().surface.normal;
    if (!walk.visit_line(p + before * n, p + lift * n, 0.0)) break;
    before = lift;
    HomeMove lifted = move_over(home, model, {q_home, walk.posture(), q_start});
    if (check_home_move(lifted, model, scene, usual).ok()) return lifted;
  }
  return straight;
}

ReachReport check_home_move(const HomeMove& move, const Model& model, const SceneSpec& scene,
                            const ReachOptions& options) {
  constexpr double spacing = 0.02;      // step of the check at the joint that moves most [rad (m)]
  constexpr double max_steps = 1000.0;  // largest number of steps per leg of the move
  ReachWalk walk(model, scene, move.corners.back(), options);
  double passed = 0.0;
  for (std::size_t leg = 0; leg < move.durations.size(); ++leg) {
    const Eigen::VectorXd& from = move.corners[leg];
    const Eigen::VectorXd displacement = difference(model, from, move.corners[leg + 1]);
    const double size = std::ceil(displacement.cwiseAbs().maxCoeff() / spacing);
    const int steps = static_cast<int>(std::clamp(size, 1.0, max_steps));
    for (int i = 0; i <= steps; ++i) {
      const double fraction = static_cast<double>(i) / steps;
      const double done = (passed + fraction * move.durations[leg]) / move.duration();
      const std::string where =
          done == 0.0 ? "at home"
                      : number(std::round(100.0 * done)) + " % along the move from home";
      if (!walk.pass(integrate(model, from, fraction * displacement), where)) return walk.report();
    }
    passed += move.durations[leg];
  }
  return walk.report();
}

double time_from_home(const std::optional<HomeMove>& move) {
  // Longest wait at the end of the move [s]; equals max_lateness in home_controller.cpp.
  constexpr double lateness = 2.0;
  return move ? move->duration() + move->settle + lateness : 0.0;
}

}  // namespace burnish::pressing
