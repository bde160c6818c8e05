#include "limit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/dynamics/placement.hpp"
#include "burnish/dynamics/reference.hpp"
#include "burnish/model/state.hpp"

namespace burnish::bench {
namespace {

/// Bundled arm, with the frame that presses, a pressing posture and the range of the contact force.
struct ShippedArm {
  const char *robot, *frame, *posture;
  double min_force, max_force;  ///< Range of the contact force [N].
};
constexpr ShippedArm shipped_arms[] = {
    {"arm7", "tool", "ready", 10.0, 25.0},
    {"talos:right_arm", "tool", "table", 10.0, 40.0},
    {"talos:right_arm", "tool", "tilt_45", 10.0, 40.0},
    {"crane:left_only", "left_tip", "work", 20.0, 100.0},
};

/// Limit too wide to have an effect, in the unit of any row.
constexpr double far_away = 1e6;

/// Returns the posture with random small displacements of all joints, well inside their limits.
Eigen::VectorXd near_posture(Draws& draws, const Model& model, const Eigen::VectorXd& posture) {
  Eigen::VectorXd dq(model.nv);
  for (const Joint& joint : model.joints)
    for (int i = 0; i < joint.nv; ++i) {
      const double size = joint.kind == JointKind::Prismatic ? 0.03 : 0.15;
      dq[joint.v_index + i] = draws.uniform(-size, size);
    }
  Eigen::VectorXd q = integrate(model, posture, dq);
  for (const Joint& joint : model.joints) {
    if (joint.nq != 1) continue;
    const double low = model.q_lower[joint.q_index], high = model.q_upper[joint.q_index];
    const double margin = std::isfinite(high - low) ? 0.1 * (high - low) : 0.0;
    q[joint.q_index] = std::clamp(q[joint.q_index], low + margin, high - margin);
  }
  return q;
}

/// Returns `from` rotated by an angle about a random axis.
Eigen::Vector3d tilted(Draws& draws, const Eigen::Vector3d& from, double angle) {
  const Eigen::Vector3d about = from.cross(draws.direction()).normalized();
  return Eigen::AngleAxisd(angle, about) * from;
}

/// Returns the limits of the description, with 10 in place of limits that it does not state.
Eigen::VectorXd stated(const Eigen::VectorXd& limits) {
  return limits.unaryExpr([](double x) { return std::isfinite(x) && x > 0.0 ? x : 10.0; });
}

Limit wide(LimitKind kind, std::vector<std::string> rows, bool late) {
  const auto count = static_cast<Eigen::Index>(std::max<std::size_t>(rows.size(), 1));
  return {.kind = kind,
          .rows = std::move(rows),
          .lower = Eigen::VectorXd::Constant(count, -far_away),
          .upper = Eigen::VectorXd::Constant(count, far_away),
          .late = late};
}

}  // namespace

Draws::Draws(std::uint64_t seed) : state_(seed) {
  for (int i = 0; i < 8; ++i) next();
}

/// SplitMix64 (G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators",
/// 2014).
std::uint64_t Draws::next() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Draws::uniform(double low, double high) {
  return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
}
double Draws::log_uniform(double low, double high) {
  return std::exp(uniform(std::log(low), std::log(high)));
}
double Draws::either_sign(double low, double high) {
  const double size = uniform(low, high);
  return chance(0.5) ? size : -size;
}
int Draws::whole(int low, int high) {
  return low + static_cast<int>(uniform(0.0, static_cast<double>(high - low + 1)));
}
bool Draws::chance(double probability) { return uniform(0.0, 1.0) < probability; }
Eigen::Vector3d Draws::direction() {
  const double z = uniform(-1.0, 1.0), angle = uniform(0.0, 2.0 * std::numbers::pi);
  const double flat = std::sqrt(1.0 - z * z);
  return {flat * std::cos(angle), flat * std::sin(angle), z};
}

std::string_view name_of(LimitKind kind) {
  constexpr std::string_view names[] = {"band",   "inclination", "speed", "range",
                                        "effort", "box",         "cone"};
  return names[static_cast<std::size_t>(kind)];
}

Eigen::Matrix3d LimitProblem::board() const {
  return Reference::surface_with_normal(normal).rotation;
}

LimitProblem draw_problem(Draws& draws, const RobotChoice& choice) {
  const ShippedArm& arm = shipped_arms[draws.whole(0, std::size(shipped_arms) - 1)];
  const bool shipped = choice.robot.empty();
  const Robot robot = load_robot(shipped ? arm.robot : choice.robot);
  const Model& model = robot.model;
  LimitProblem p;
  p.robot = shipped ? arm.robot : choice.robot;
  p.frame = shipped ? arm.frame : choice.frame;
  p.start = near_posture(draws, model,
                         shipped ? robot.posture(arm.posture) : robot.reference_configuration());
  p.normal = tilted(draws, Eigen::Vector3d::UnitZ(), draws.uniform(0.0, 0.6));
  const Eigen::Matrix3d turned = frame_placement(model, p.start, p.frame).linear();
  p.axis = turned.transpose() * tilted(draws, p.normal, draws.uniform(0.0, 0.4));
  p.holds = draws.chance(0.35);
  p.knots = draws.whole(50, 200);
  p.step = draws.log_uniform(0.005, 0.02);
  p.force = shipped ? draws.uniform(arm.min_force, arm.max_force) : draws.uniform(10.0, 20.0);
  p.rate = draws.uniform(2.0, 10.0);
  p.phase = draws.uniform(0.0, 2.0 * std::numbers::pi);
  p.circle = draws.chance(0.3);
  p.path_angle = draws.uniform(0.0, 2.0 * std::numbers::pi);
  p.aims = {.posture = draws.log_uniform(0.01, 1.0),
            .torque = draws.log_uniform(1e-5, 1e-3),
            .along = draws.log_uniform(1e3, 1e5),
            .force = draws.log_uniform(0.01, 1.0),
            .turn = draws.log_uniform(10.0, 1000.0),
            .length = draws.uniform(0.02, 0.12),
            .swing = draws.uniform(0.0, 0.3) * p.force,
            .sideways = draws.uniform(0.0, 0.5) * p.force,
            .inclination_goal = {draws.uniform(-0.4, 0.4), draws.uniform(-0.4, 0.4)}};
  if (p.circle) p.aims.length *= 0.4;
  p.early = draws.chance(0.4) ? draws.whole(10, p.knots / 2) : 0;
  p.weight = model.total_mass() * model.gravity.norm();
  return p;
}

Aims other_aims(Draws& draws, const Aims& aims) {
  Aims other = aims;
  other.posture *= draws.log_uniform(0.5, 20.0);
  other.torque *= draws.log_uniform(0.5, 20.0);
  other.length *= draws.uniform(0.5, 0.95);
  other.swing *= draws.uniform(0.3, 0.9);
  other.sideways *= draws.uniform(0.3, 0.9);
  other.inclination_goal *= draws.uniform(0.3, 0.9);
  return other;
}

std::vector<Limit> draw_kinds(Draws& draws, const LimitProblem& p) {
  struct Offer {
    LimitKind kind;
    std::vector<std::string> rows;
    double probability;
  };
  const std::vector<Offer> offers = {
      {LimitKind::Band, {"z"}, 0.6},
      {LimitKind::Inclination, {}, 0.5},
      {LimitKind::Speed, {}, 0.35},
      {LimitKind::Range, {}, 0.25},
      {LimitKind::Effort, {}, 0.35},
      {LimitKind::Box, {"x", "y"}, p.holds ? 0.0 : 0.35},
      {LimitKind::Cone, {}, p.holds ? 0.8 : 0.0},
  };
  std::vector<Limit> limits;
  while (limits.empty()) {
    for (const Offer& offer : offers) {
      const bool taken = draws.chance(offer.probability);
      const bool late = draws.chance(0.6) && p.early > 0;
      if (taken && limits.size() < 4) limits.push_back(wide(offer.kind, offer.rows, late));
    }
  }
  for (Limit& limit : limits)
    if (limit.kind == LimitKind::Cone && draws.chance(0.4)) limit.sides = draws.whole(3, 8);
  return limits;
}

std::vector<Limit> free_limits(Draws& draws, const LimitProblem& p,
                               const std::vector<Limit>& kinds) {
  std::vector<Limit> limits = kinds;
  const Model model = load_robot(p.robot).model;
  for (Limit& limit : limits) {
    const double moved = limit.late && draws.chance(0.5) ? 1.0 : 0.0;
    const auto symmetric = [&](const Eigen::VectorXd& size) {
      limit.upper = size;
      limit.lower = -size;
    };
    switch (limit.kind) {
      case LimitKind::Band: {
        const double half = draws.uniform(0.03, 0.3) * p.force;
        limit.lower = Eigen::VectorXd::Constant(1, p.force - half);
        limit.upper = Eigen::VectorXd::Constant(1, p.force + half * draws.uniform(0.5, 1.0));
        break;
      }
      case LimitKind::Inclination:
        symmetric(Eigen::VectorXd::Constant(1, draws.uniform(0.05, 0.5)));
        break;
      case LimitKind::Speed:
        symmetric(stated(model.velocity_limit) * draws.log_uniform(0.01, 0.3));
        break;
      case LimitKind::Range: {
        const double half = draws.uniform(0.02, 0.3);
        limit.rows.clear();
        Eigen::VectorXd middle(model.nv);
        Eigen::Index count = 0;
        for (const Joint& joint : model.joints)
          if (joint.nq == 1 && std::isfinite(model.q_upper[joint.q_index])) {
            limit.rows.push_back(joint.name);
            middle[count++] =
                p.start[joint.q_index] + draws.uniform(-0.8, 0.8) * (half + 0.2 * moved);
          }
        middle.conservativeResize(count);
        limit.lower = middle.array() - half;
        limit.upper = middle.array() + half;
        break;
      }
      case LimitKind::Effort:
        symmetric(stated(model.effort_limit) * draws.log_uniform(0.05, 0.7));
        break;
      case LimitKind::Box: {
        // A box that applies only to later knots need not contain the start.
        const Eigen::Vector2d middle =
            moved * Eigen::Vector2d(draws.uniform(-0.15, 0.15), draws.uniform(-0.15, 0.15));
        limit.lower = middle - Eigen::Vector2d(draws.uniform(0.0, 0.1), draws.uniform(0.0, 0.1));
        limit.upper = middle + Eigen::Vector2d(draws.uniform(0.0, 0.1), draws.uniform(0.0, 0.1));
        break;
      }
      case LimitKind::Cone:
        limit.friction = draws.uniform(0.1, 0.8);
        break;
    }
  }
  return limits;
}

}  // namespace burnish::bench
