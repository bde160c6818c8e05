#include "pressing/standing_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/decomposition.hpp"
#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/residual.hpp"
#include "pressing/arm.hpp"

namespace burnish::pressing {
namespace {

const Joint* floating_base(const Model& model) {
  for (const Joint& joint : model.joints)
    if (joint.kind == JointKind::FreeFlyer) return &joint;
  return nullptr;
}

/// Returns the load of a foot if all feet carry equal loads [N].
double weight_per_foot(const Model& model, const Standing& standing) {
  return model.total_mass() * model.gravity.norm() / static_cast<double>(standing.feet.size());
}

struct Ground {
  double stiffness, damping;  ///< Stiffness [N/m] and damping [Ns/m].
};
/// Returns the stated stiffness and damping of the ground, or automatic values that depend on the
/// weight. Under a light robot, the automatic ground is softer, so that light feet do not bounce.
Ground ground_of(const Model& model, const Standing& standing) {
  // Indentation of the ground under the weight [m], and ratio of damping to stiffness [s]. The
  // values follow from the shipped tasks: 2e6 N/m under a sole of Talos, 2e5 N/m under a point foot
  // of the quadruped.
  constexpr double sole_indentation = 2.305e-4, point_indentation = 2.4525e-4;
  constexpr double sole_lag = 0.05, point_lag = 0.02;
  const double indentation = standing.has_soles() ? sole_indentation : point_indentation;
  const double stiffness =
      standing.stiffness.value_or(weight_per_foot(model, standing) / indentation);
  return {stiffness,
          standing.damping.value_or(stiffness * (standing.has_soles() ? sole_lag : point_lag))};
}

}  // namespace

std::string ground_note(const Model& model, const Standing& standing) {
  constexpr double max_ratio = 10.0;
  Standing by_weight = standing;
  by_weight.stiffness = std::nullopt;
  const double fitting = ground_of(model, by_weight).stiffness;
  if (!standing.stands() || standing.stiffness.value_or(fitting) < max_ratio * fitting) return "";
  return "standing.stiffness: " + number(*standing.stiffness) + " N/m is " +
         number(std::round(*standing.stiffness / fitting)) +
         " times the value for the robot's weight (auto: " + number(std::round(fitting)) +
         " N/m); light feet bounce on ground that stiff";
}

void check_standing(const Model& model, const Standing& standing) {
  const bool floats = floating_base(model) != nullptr;
  if (!floats && standing.stands())
    throw EntryError("standing.feet",
                     "robot " + in_quotes(model.name) +
                         " has a fixed base; wanted no feet, or a robot with a floating base");
  if (floats && !standing.stands())
    throw EntryError(
        "robot", "the base of robot " + in_quotes(model.name) +
                     " floats free, and the task states no feet; wanted the frames of the feet "
                     "(standing.feet), or a fixed base, such as a variant in the robot's settings");
  if (standing.feet == std::vector<std::string>{"auto"})
    throw EntryError(
        "standing.feet",
        "auto is accepted by `task: stand` only; wanted frames of robot " + in_quotes(model.name));
  for (const std::string& foot : standing.feet)
    if (!model.has_frame(foot)) throw EntryError("standing.feet", "frame " + none_of(model, foot));
  if ((standing.half_x > 0.0) != (standing.half_y > 0.0))
    throw EntryError("standing.half_x",
                     "half_x and half_y are " + number(standing.half_x) + " and " +
                         number(standing.half_y) +
                         " m; wanted both above 0 (soles) or both 0 (point feet)");
  constexpr std::size_t min_points = 3;  // fewer than three point feet do not span an area
  if (standing.stands() && !standing.has_soles() && standing.feet.size() < min_points)
    throw EntryError("standing.feet",
                     "robot " + in_quotes(model.name) + " cannot stand still on " +
                         std::to_string(standing.feet.size()) +
                         (standing.feet.size() == 1 ? " point foot" : " point feet") +
                         "; wanted at least three, or soles (half_x, half_y)");
}

namespace {
double degrees_from_vertical(const Eigen::Isometry3d& at) {
  const double angle = std::acos(std::clamp(at.linear()(2, 2), -1.0, 1.0));
  return std::round(angle * 180.0 / std::numbers::pi);
}
}  // namespace

std::vector<TouchSpec> supports_at(const Model& model, const Standing& standing,
                                   const Eigen::VectorXd& q) {
  std::vector<TouchSpec> supports;
  const Ground ground = ground_of(model, standing);
  // Indentation of the compliant ground under the weight [m].
  const double sinks = weight_per_foot(model, standing) / ground.stiffness;
  for (const std::string& foot : standing.feet) {
    TouchSpec support{
        .frame = foot,
        .half_x = standing.half_x,
        .half_y = standing.half_y,
        .radius = standing.radius,
        .surface = {.friction = standing.friction,
                    .stiffness = ground.stiffness,
                    .damping = ground.damping},
        .is_support = true,
        .sensor = standing.force_sensors ? WrenchSensor::Automatic : WrenchSensor::None};
    const Eigen::Isometry3d at = frame_placement(model, q, foot);
    support.surface.point = at.translation();
    constexpr double upright = 0.98;  // cosine of 11 degrees, the largest tilt
    if (standing.has_soles() && !(at.linear()(2, 2) > upright))
      throw EntryError(
          "standing.feet",
          "the sole of " + in_quotes(foot) +
              " is not level at the start: the z axis of this frame, which is the sole's normal, "
              "is " +
              number(degrees_from_vertical(at)) +
              " degrees off the vertical; wanted at most 11 degrees. Remedies: a posture with "
              "level "
              "soles; a frame whose z axis points up from the sole (key `frames` of robot.yaml); "
              "point feet (standing.half_x and half_y 0)");
    support.surface.point.z() += sinks - (standing.has_soles() ? 0.0 : standing.radius);
    supports.push_back(support);
  }
  return supports;
}

HoistSpec hoist_of(const Model& model, const Standing& standing) {
  if (!standing.stands()) return {};
  for (const Frame& frame : model.frames)
    if (frame.body >= 0 && model.joints[to_size(frame.body)].kind == JointKind::FreeFlyer)
      return {frame.name, std::min(standing.hoist, standing.settle)};
  return {};
}

Eigen::MatrixXd support_jacobian(const Model& model, const RigidBody& body,
                                 const std::vector<TouchSpec>& supports) {
  Eigen::Index rows = 0;
  for (const TouchSpec& support : supports) rows += support.is_rectangle() ? 6 : 3;
  Eigen::MatrixXd J(rows, model.nv);
  rows = 0;
  FrameDerivatives at;
  for (const TouchSpec& support : supports) {
    body.frame_derivatives(body.frame(support.frame), Reference::centered(), at);
    const Eigen::Index held = support.is_rectangle() ? 6 : 3;
    J.middleRows(rows, held) = at.jacobian.topRows(held);
    rows += held;
  }
  return J;
}

Eigen::VectorXd torque_on_supports(const Model& model, const RigidBody& body,
                                   const std::vector<TouchSpec>& supports,
                                   const Eigen::VectorXd& needed) {
  const Joint* base = floating_base(model);
  if (supports.empty() || base == nullptr) return needed;
  const Eigen::MatrixXd J = support_jacobian(model, body, supports);
  std::vector<int> driven;
  for (int k = 0; k < model.nv; ++k)
    if (k < base->v_index || k >= base->v_index + base->nv) driven.push_back(k);
  // Solves S^T tau + J^T f = needed for motor torques tau and support forces f. S selects motors.
  const auto motors = static_cast<Eigen::Index>(driven.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(model.nv, motors + J.rows());
  for (Eigen::Index i = 0; i < motors; ++i) A(driven[to_size(i)], i) = 1.0;
  A.rightCols(J.rows()) = J.transpose();
  const Eigen::VectorXd solution = least_squares(A, needed);
  Eigen::VectorXd torque = Eigen::VectorXd::Zero(model.nv);
  for (Eigen::Index i = 0; i < motors; ++i) torque[driven[to_size(i)]] = solution[i];
  return torque;
}

std::vector<CostTerm> standing_costs(const Model& model, const Standing& standing,
                                     const Eigen::VectorXd& q_start) {
  if (!standing.stands()) return {};
  RigidBody body(model);
  if (!is_usable(body.update(q_start, Eigen::VectorXd::Zero(model.nv))))
    throw Error("the starting posture cannot be evaluated");
  const Eigen::Vector3d com = body.com();
  return {{.name = "balance", .residual = residual::CenterOfMass{com}, .weight = standing.balance},
          {.name = "momentum",
           .residual = residual::CentroidalMomentum{},
           .weight = standing.momentum}};
}

void set_standing(const Standing& standing, MpcSpec& mpc) {
  if (!standing.stands()) return;
  mpc.supports = standing.feet;
  if (standing.force_sensors)
    for (const std::string& foot : standing.feet) mpc.touches.push_back({foot});
  mpc.settle = standing.settle;
  mpc.slip = standing.slip;
  mpc.slip.radius = standing.has_soles() ? 0.0 : standing.radius;
  mpc.fallback = standing.fallback;
  // Smallest load of a foot at which a slip is detected, as a fraction of the mean load of the
  // feet. For the shipped quadruped, the smallest load is 30 N, the mean load 49 N.
  constexpr double slip_load = 0.612;
  mpc.slip.load = std::min(mpc.slip.load, slip_load * weight_per_foot(mpc.problem.model, standing));
}

std::optional<BaseEstimatorOptions> base_estimator(const Standing& standing) {
  if (!standing.stands() || !standing.estimate) return std::nullopt;
  // Noise of a good inertial measurement unit, with some margin. Feet count as fixed unless a slip
  // is detected. The ground yields by tenths of a millimetre, and soles tilt as the load moves.
  // Soles turn in place more than they slide, so that the positions of the feet determine the yaw
  // of the base.
  BaseEstimatorOptions options{.imu_frame = standing.imu_frame,
                               .gyro_noise = 3e-4,
                               .accelerometer_noise = 5e-3,
                               .place_noise = 5e-4,
                               .turn_noise = 2e-3,
                               .slip_noise = 1e-5,
                               .sole_turn_noise = 3e-3,
                               .gate = 1.0 - 1e-12,
                               .tilt_deviation = 5e-3,
                               .velocity_deviation = 0.01};
  // An IMU fault switches the base estimate to leg kinematics. The offset that prevents a jump
  // at this switch decays with this time constant [s]. A faster decay would count as a push.
  options.watch.decay_time = 0.2;
  for (const std::string& foot : standing.feet)
    options.feet.push_back({foot, standing.has_soles() ? FootKind::Sole : FootKind::Ball});
  return options;
}

FootContactOptions foot_contact_options(const Model& model) {
  // Largest force noise density as a fraction of the weight [1/sqrt(Hz)], chosen by hand.
  constexpr double max_noise = 1e-3;
  FootContactOptions options;
  options.force_noise =
      std::min(options.force_noise, max_noise * model.total_mass() * model.gravity.norm());
  return options;
}

Disturbances for_feet(const Model& model, const Standing& standing, Disturbances disturbances) {
  // Largest force noise as a fraction of the mean load of the feet. For the shipped quadruped, the
  // largest noise is about 1 N, the mean load 49 N.
  constexpr double fraction = 0.022;
  constexpr double arm = 0.1;  // ratio of moment noise to force noise [m], chosen by hand
  const double max_noise = fraction * weight_per_foot(model, standing);
  disturbances.support_force_noise = std::min(disturbances.support_force_noise, max_noise);
  disturbances.support_moment_noise = std::min(disturbances.support_moment_noise, arm * max_noise);
  return disturbances;
}

double min_load_of(const Model& model, const Standing& standing) {
  // Smallest load as a fraction of the mean load of the feet. For Talos, 40 N of 450 N.
  constexpr double fraction = 0.09;
  return standing.min_load.value_or(fraction * weight_per_foot(model, standing));
}

std::vector<TouchSpec> within_plans(std::vector<TouchSpec> feet, const Standing& standing) {
  for (TouchSpec& foot : feet) {
    foot.surface.friction = standing.plan_friction;
    foot.half_x *= standing.plan_sole;
    foot.half_y *= standing.plan_sole;
  }
  return feet;
}

namespace {

/// Returns the entries of a wrench (6) for the directions that a contact holds.
Eigen::VectorXd held_of(const ContactSpec& contact, const Eigen::VectorXd& wrench) {
  Eigen::VectorXd rows(contact.directions.count());
  Eigen::Index row = 0;
  for (int d = 0; d < 6; ++d)
    if (contact.directions.has(d)) rows[row++] = wrench[d];
  return rows;
}

/// Returns costs on the forces of each foot along the ground and on its moment about the normal.
std::vector<CostTerm> internal_force_costs(const Standing& standing,
                                           const std::vector<ContactSpec>& feet) {
  std::vector<CostTerm> terms;
  if (standing.internal_forces == 0.0) return terms;
  Vector6 weights = Vector6::Zero();
  weights.head<2>().setOnes();
  // Weight of the moment. A moment M about the normal costs as much as a single force M / half_x.
  if (standing.has_soles()) weights[5] = 1.0 / (standing.half_x * standing.half_x);
  for (const ContactSpec& foot : feet)
    terms.push_back({.name = "internal forces of " + foot.name,
                     .residual = residual::ContactForce{foot.name},
                     .weight = standing.internal_forces,
                     .weights = held_of(foot, weights)});
  return terms;
}

/// Returns constraints on friction, load and pressure of every foot.
std::vector<Constraint> standing_constraints(const Model& model, const Standing& standing,
                                             const std::vector<ContactSpec>& feet) {
  std::vector<Constraint> rows;
  Vector6 lower = Vector6::Constant(-std::numeric_limits<double>::infinity());
  lower[2] = min_load_of(model, standing);
  // Scale of the load constraint: about twice the mean load of the feet, at most 100 N. Chosen by
  // hand.
  constexpr double max_scale = 100.0, weights_per_foot = 2.04;
  const double scale = std::min(max_scale, weights_per_foot * weight_per_foot(model, standing));
  for (const ContactSpec& foot : feet) {
    rows.push_back({.name = "friction of " + foot.name,
                    .residual = residual::FrictionCone{foot.name, standing.plan_friction}});
    rows.push_back({.name = "load of " + foot.name,
                    .residual = residual::ContactForce{foot.name},
                    .lower = held_of(foot, lower),
                    .scale = Eigen::VectorXd::Constant(foot.directions.count(), scale)});
    if (!standing.has_soles()) continue;
    rows.push_back(
        {.name = "pressure of " + foot.name,
         .residual = residual::CenterOfPressure{foot.name, standing.plan_sole * standing.half_x,
                                                standing.plan_sole * standing.half_y,
                                                standing.plan_friction / std::numbers::sqrt2}});
  }
  return rows;
}

}  // namespace

void keep_standing(const Model& model, const Standing& standing,
                   const std::vector<ContactSpec>& feet, Stage& stage) {
  for (const CostTerm& term : internal_force_costs(standing, feet)) stage.costs.push_back(term);
  for (const Constraint& rows : standing_constraints(model, standing, feet))
    stage.constraints.push_back(rows);
}

}  // namespace burnish::pressing
