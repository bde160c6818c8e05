#include "ocp/sliding_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "ocp/horizon_knots.hpp"

namespace burnish::ocp {
namespace {

constexpr double standard_gravity = 9.80665;  // m/s^2, ISO 80000-3
constexpr double compliance = 1e-6;           // m/s^2 per N: redundant contacts are no trouble

bool holds(const Stage& stage, const ContactSpec& contact) {
  return std::find(stage.contacts.begin(), stage.contacts.end(), contact.name) !=
         stage.contacts.end();
}

/// The normal of a contact with friction, as an entry of its directions.
int normal_of(const ContactSpec& contact) {
  for (int d = 0; d < 3; ++d)
    if (contact.directions.has(d)) return d;
  return 2;
}

/// Size of the force along the normal in a target or a limit: of a reference of its own, whose axes
/// may be others, that of the whole force.
double along_normal(const residual::ContactForce& asked, const Eigen::VectorXd& value) {
  if (value.size() == 0) return 0.0;
  const double size =
      asked.reference ? value.head(std::min<Eigen::Index>(3, value.size())).norm() : value[0];
  return std::isfinite(size) ? std::abs(size) : 0.0;
}

/// The largest force along the normal that a stage asks for, N; zero where it asks for none.
double asked_force(const ProblemSpec& spec, const Stage& stage, const ContactSpec& contact) {
  double largest = 0.0;
  const auto asks = [&](const Residual& residual) {
    const auto* force = std::get_if<residual::ContactForce>(&residual);
    return force != nullptr && force->contact == contact.name ? force : nullptr;
  };
  const std::vector<double> steps = knot_steps(spec);
  for (const CostTerm& cost : stage.costs) {
    const residual::ContactForce* const force = asks(cost.residual);
    if (force == nullptr || force->target.empty() || cost.weight == 0.0) continue;
    Eigen::VectorXd value(force->target.size());
    double time = spec.start_time;
    for (const double step : steps) {
      force->target.at(time, value);
      largest = std::max(largest, along_normal(*force, value));
      time += step;
    }
  }
  for (const Constraint& constraint : stage.constraints)
    if (const residual::ContactForce* const force = asks(constraint.residual))
      for (const Eigen::VectorXd& limit : {constraint.lower, constraint.upper})
        largest = std::max(largest, along_normal(*force, limit));
  return largest;
}

/// Of the tool's point where friction acts, at the initial posture: rows of its Jacobian along two
/// directions across the normal.
std::optional<Eigen::MatrixXd> across_normal(const ProblemSpec& spec, const ContactSpec& contact,
                                             const Eigen::VectorXd& q,
                                             const Eigen::VectorXd& zero) {
  ContactSpec axes = contact, point = contact;
  for (ContactSpec* each : {&axes, &point}) {
    each->friction.reset();
    each->with_gains(0.0, 0.0);
    each->acceleration = Acceleration::TimeDerivative;
  }
  point.reference = Reference::centered();
  point.directions = Directions::all();
  ContactDynamics looked(spec.model, {axes}, {.mu = compliance});
  ContactDynamics moved(spec.model, {point}, {.mu = compliance});
  if (looked.acceleration(q, zero, zero) > Status::NotConverged ||
      moved.acceleration(q, zero, zero) > Status::NotConverged)
    return std::nullopt;
  const Eigen::Matrix3d R = looked.force(0).axes();
  const int normal = normal_of(contact);
  const Eigen::Vector3d arm = -contact.friction->radius * R.col(normal);
  const Eigen::MatrixXd J = moved.jacobian();  // at the tool's origin, axes of the world
  Eigen::MatrixXd at_point = J.topRows(3);
  for (Eigen::Index k = 0; k < J.cols(); ++k)
    at_point.col(k) += Eigen::Vector3d(J.col(k).tail<3>()).cross(arm);
  Eigen::MatrixXd result(2, J.cols());
  for (int i = 0; i < 2; ++i) result.row(i) = R.col((normal + 1 + i) % 3).transpose() * at_point;
  return result;
}

/// The least mass that the tool moves with across the normal while the stage's contacts hold, kg.
std::optional<double> sliding_mass(const ProblemSpec& spec, const Stage& stage,
                                   const ContactSpec& contact) {
  const Eigen::VectorXd q = spec.initial_state.head(spec.model.nq);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(spec.model.nv);
  std::vector<ContactSpec> held;
  for (ContactSpec each : contacts_at(spec.contacts, spec.start_time)) {
    if (!holds(stage, each)) continue;
    each.friction.reset();
    held.push_back(std::move(each));
  }
  const std::vector<ContactSpec> now = contacts_at({contact}, spec.start_time);
  const std::optional<Eigen::MatrixXd> J = across_normal(spec, now.front(), q, zero);
  if (!J) return std::nullopt;
  ContactDynamics dynamics(spec.model, held, {.mu = compliance});
  if (dynamics.forward(q, zero, zero) > Status::NotConverged) return std::nullopt;
  const Eigen::VectorXd at_rest = dynamics.a();
  Eigen::Matrix2d mobility;  // 1/kg
  for (int i = 0; i < 2; ++i) {
    const Eigen::VectorXd torque = J->row(i);
    if (dynamics.forward(q, zero, torque) > Status::NotConverged) return std::nullopt;
    mobility.col(i) = *J * (dynamics.a() - at_rest);
  }
  const Eigen::Matrix2d symmetric = 0.5 * (mobility + mobility.transpose());
  const double most = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(symmetric).eigenvalues()[1];
  constexpr double immovable = 1e-9;  // 1/kg: no joint moves the tool across the normal
  if (!(most > immovable)) return std::nullopt;
  return 1.0 / most;
}

}  // namespace

double explicit_step(const ProblemSpec& spec, const Stage& stage) {
  if (stage.impact) return 0.0;
  const HorizonKnots knots = knots_of(spec);
  double longest = 0.0;
  for (std::size_t k = 0; k < knots.stages.size(); ++k) {
    if (&spec.stages[static_cast<std::size_t>(knots.stages[k])] != &stage) continue;
    const double own = knots.own_steps[k];
    longest = std::max(longest, own > 0.0 ? std::min(own, stage.step) : stage.step);
  }
  return longest > 0.0 ? longest : stage.step;
}

std::optional<SlidingStep> sliding_step(const ProblemSpec& spec, const Stage& stage,
                                        const ContactSpec& contact) {
  const std::optional<double> mass = sliding_mass(spec, stage, contact);
  if (!mass) return std::nullopt;
  const double force = asked_force(spec, stage, contact);
  const double coefficient = contact.friction->coefficient;
  return SlidingStep{.coefficient = coefficient > 0.0 ? coefficient : SlidingFriction().coefficient,
                     .force = force > 0.0 ? force : *mass * standard_gravity,
                     .mass = *mass,
                     .step = explicit_step(spec, stage)};
}

}  // namespace burnish::ocp

namespace burnish {

ProblemSpec with_fade_speeds(ProblemSpec spec) {
  constexpr double margin = 4.0;  // measured: 2 takes tens of iterations beside limits of forces
  if (spec.initial_state.size() < spec.model.nq || !spec.initial_state.allFinite()) return spec;
  for (ContactSpec& contact : spec.contacts) {
    if (!contact.friction || contact.friction->speed) continue;
    double speed = contact.friction->fade_speed();
    try {
      for (const Stage& stage : spec.stages) {
        if (stage.impact || !ocp::holds(stage, contact)) continue;
        if (const auto step = ocp::sliding_step(spec, stage, contact))
          speed = std::max(speed, margin * step->speed());
      }
    } catch (const Error&) {
      return spec;  // what is wrong with it is said where it is compiled
    }
    contact.friction->speed = speed;
  }
  return spec;
}

}  // namespace burnish
