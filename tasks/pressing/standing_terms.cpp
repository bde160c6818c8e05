#include "pressing/standing_terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/decomposition.hpp"
#include "base/entry_error.hpp"
#include "base/sentence.hpp"
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

}  // namespace

void check_standing(const Model& model, const Standing& standing) {
  const bool floats = floating_base(model) != nullptr;
  if (!floats && standing.stands())
    throw EntryError("standing.feet", "robot " + in_quotes(model.name) +
                                          " has a fixed base; wanted none, or a robot that floats");
  if (floats && !standing.stands())
    throw EntryError("robot",
                     "the base of robot " + in_quotes(model.name) +
                         " floats free, and nothing holds it while it presses; wanted "
                         "standing.feet, the frames that it stands on, or a fixed base, as "
                         "a variant of its settings may have");
  for (const std::string& foot : standing.feet)
    if (!model.has_frame(foot)) throw EntryError("standing.feet", "frame " + none_of(model, foot));
  if ((standing.half_x > 0.0) != (standing.half_y > 0.0))
    throw EntryError("standing.half_x", "half sides of " + number(standing.half_x) + " and " +
                                            number(standing.half_y) +
                                            " m; wanted both of a sole, or neither of a ball");
}

std::vector<SupportSpec> supports_at(const Model& model, const Standing& standing,
                                     const Eigen::VectorXd& q) {
  std::vector<SupportSpec> supports;
  // As far into what gives way as the weight presses them: the robot has been let down already.
  const double sinks = model.total_mass() * model.gravity.norm() /
                       (static_cast<double>(standing.feet.size()) * standing.stiffness);
  for (const std::string& foot : standing.feet) {
    SupportSpec support{.frame = foot,
                        .half_x = standing.half_x,
                        .half_y = standing.half_y,
                        .radius = standing.radius,
                        .friction = standing.friction,
                        .stiffness = standing.stiffness,
                        .damping = standing.damping};
    const Eigen::Isometry3d at = frame_placement(model, q, foot);
    support.point = at.translation();
    constexpr double upright = 0.98;  // cosine: 11 degrees
    if (standing.has_soles() && !(at.linear()(2, 2) > upright))
      throw EntryError("standing.feet",
                       "the z axis of " + in_quotes(foot) + " points along [" +
                           number(at.linear()(0, 2)) + ", " + number(at.linear()(1, 2)) + ", " +
                           number(at.linear()(2, 2)) +
                           "] at the start; wanted a frame whose z is up, with the sole in its x "
                           "and y, as frames: of robot.yaml can add");
    support.point.z() += sinks - (standing.has_soles() ? 0.0 : standing.radius);
    supports.push_back(support);
  }
  return supports;
}

HoistSpec hoist_of(const Model& model, const Standing& standing) {
  if (!standing.stands()) return {};
  for (const Frame& frame : model.frames)
    if (frame.body >= 0 &&
        model.joints[static_cast<std::size_t>(frame.body)].kind == JointKind::FreeFlyer)
      return {frame.name, std::min(standing.hoist, standing.settle)};
  return {};
}

std::vector<ContactSpec> foot_contacts(const Standing& standing) {
  std::vector<ContactSpec> contacts;
  for (const std::string& foot : standing.feet) {
    ContactSpec contact{.name = foot, .tool = foot};
    contact.directions = standing.has_soles() ? Directions::all() : Directions::linear();
    contact.reference = Reference::centered();
    contact.with_gains(0.0, standing.contact_kd);
    contacts.push_back(contact);
  }
  return contacts;
}

Eigen::MatrixXd support_jacobian(const Model& model, const RigidBody& body,
                                 const std::vector<SupportSpec>& supports) {
  Eigen::Index rows = 0;
  for (const SupportSpec& support : supports) rows += support.is_sole() ? 6 : 3;
  Eigen::MatrixXd J(rows, model.nv);
  rows = 0;
  FrameDerivatives at;
  for (const SupportSpec& support : supports) {
    body.frame_derivatives(body.frame(support.frame), Reference::centered(), at);
    const Eigen::Index held = support.is_sole() ? 6 : 3;
    J.middleRows(rows, held) = at.jacobian.topRows(held);
    rows += held;
  }
  return J;
}

Eigen::VectorXd torque_on_supports(const Model& model, const RigidBody& body,
                                   const std::vector<SupportSpec>& supports,
                                   const Eigen::VectorXd& needed) {
  const Joint* base = floating_base(model);
  if (supports.empty() || base == nullptr) return needed;
  const Eigen::MatrixXd J = support_jacobian(model, body, supports);
  std::vector<int> driven;
  for (int k = 0; k < model.nv; ++k)
    if (k < base->v_index || k >= base->v_index + base->nv) driven.push_back(k);
  // The base has no motors: S^T tau + J^T f = needed.
  const auto motors = static_cast<Eigen::Index>(driven.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(model.nv, motors + J.rows());
  for (Eigen::Index i = 0; i < motors; ++i) A(driven[static_cast<std::size_t>(i)], i) = 1.0;
  A.rightCols(J.rows()) = J.transpose();
  const Eigen::VectorXd solution = least_squares(A, needed);
  Eigen::VectorXd torque = Eigen::VectorXd::Zero(model.nv);
  for (Eigen::Index i = 0; i < motors; ++i)
    torque[driven[static_cast<std::size_t>(i)]] = solution[i];
  return torque;
}

std::vector<CostTerm> standing_costs(const Model& model, const Standing& standing,
                                     const Eigen::VectorXd& q_start) {
  if (!standing.stands()) return {};
  RigidBody body(model);
  if (body.update(q_start, Eigen::VectorXd::Zero(model.nv)) > Status::NotConverged)
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
  mpc.support_sensors = standing.force_sensors;
  mpc.settle = standing.settle;
  mpc.slip = standing.slip;
  mpc.slip.radius = standing.has_soles() ? 0.0 : standing.radius;
  mpc.fallback = standing.fallback;
}

std::optional<BaseEstimatorOptions> base_estimator(const Standing& standing) {
  if (!standing.stands() || !standing.estimate) return std::nullopt;
  // Of a good unit, with some room, and feet that stand as long as nothing says that they slip.
  // The ground gives way under them by tenths of a millimetre: soles tilt as the load moves, and
  // turn on the spot more than they slide, so that yaw is to be held by where the feet stand.
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
  // A base that is moved faster than this is felt as a push.
  options.watch.fading = 0.2;
  for (const std::string& foot : standing.feet)
    options.feet.push_back({foot, standing.has_soles() ? FootKind::Sole : FootKind::Ball});
  return options;
}

FootContactOptions foot_contact_options(const Model& model) {
  constexpr double share = 1e-3;  // 1/sqrt(Hz), of the weight
  FootContactOptions options;
  options.force_noise =
      std::min(options.force_noise, share * model.total_mass() * model.gravity.norm());
  return options;
}

std::vector<SupportSpec> within_plans(std::vector<SupportSpec> feet, const Standing& standing) {
  for (SupportSpec& foot : feet) {
    foot.friction = standing.plan_friction;
    foot.half_x *= standing.plan_sole;
    foot.half_y *= standing.plan_sole;
  }
  return feet;
}

namespace {

/// What each foot bears along the ground and about its normal.
std::vector<CostTerm> rubbing_costs(const Standing& standing) {
  std::vector<CostTerm> terms;
  if (standing.rubbing == 0.0) return terms;
  // A moment is as bad as the forces at the ends of a sole that make it.
  const double per_square = 1.0 / (standing.half_x * standing.half_x);
  for (const std::string& foot : standing.feet) {
    Eigen::VectorXd rows = Eigen::VectorXd::Zero(standing.has_soles() ? 6 : 3);
    rows.head<2>().setOnes();
    if (standing.has_soles()) rows[5] = per_square;
    terms.push_back({.name = "rubbing of " + foot,
                     .residual = residual::ContactForce{foot},
                     .weight = standing.rubbing,
                     .weights = rows});
  }
  return terms;
}

/// Friction, load and pressure of every foot.
std::vector<Constraint> standing_constraints(const Standing& standing) {
  std::vector<Constraint> rows;
  for (const std::string& foot : standing.feet) {
    rows.push_back({.name = "friction of " + foot,
                    .residual = residual::FrictionCone{foot, standing.plan_friction}});
    Eigen::VectorXd least = Eigen::VectorXd::Constant(standing.has_soles() ? 6 : 3,
                                                      -std::numeric_limits<double>::infinity());
    least[2] = standing.least_load;
    rows.push_back({.name = "load of " + foot,
                    .residual = residual::ContactForce{foot},
                    .lower = least,
                    .scale = Eigen::VectorXd::Constant(least.size(), 100.0)});
    if (!standing.has_soles()) continue;
    rows.push_back(
        {.name = "pressure of " + foot,
         .residual = residual::CenterOfPressure{foot, standing.plan_sole * standing.half_x,
                                                standing.plan_sole * standing.half_y,
                                                standing.plan_friction / std::numbers::sqrt2}});
  }
  return rows;
}

}  // namespace

void keep_standing(const Standing& standing, Stage& stage) {
  for (const CostTerm& term : rubbing_costs(standing)) stage.costs.push_back(term);
  for (const Constraint& rows : standing_constraints(standing)) stage.constraints.push_back(rows);
}

}  // namespace burnish::pressing
