#include "ocp/sliding_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "ocp/horizon_knots.hpp"

namespace burnish::ocp {
namespace {

constexpr double standard_gravity = 9.80665;  // m/s^2, ISO 80000-3
constexpr double compliance = 1e-6;           // m/s^2 per N, allows redundant contacts

bool holds(const Stage& stage, const ContactSpec& contact) {
  return std::find(stage.contacts.begin(), stage.contacts.end(), contact.name) !=
         stage.contacts.end();
}

/// Returns the index of the normal of a contact with friction among x, y, z.
int normal_of(const ContactSpec& contact) {
  for (int d = 0; d < 3; ++d)
    if (contact.directions.has(d)) return d;
  return 2;
}

/// Returns the magnitude of the normal force in a target or a limit. If the residual has its own
/// reference, whose axes may differ, returns the magnitude of the whole force.
double along_normal(const residual::ContactForce& residual, const Eigen::VectorXd& value) {
  if (value.size() == 0) return 0.0;
  const double size =
      residual.reference ? value.head(std::min<Eigen::Index>(3, value.size())).norm() : value[0];
  return std::isfinite(size) ? std::abs(size) : 0.0;
}

/// Returns the largest normal force in the stage's force targets and limits [N]; 0: none.
double largest_force(const ProblemSpec& spec, const Stage& stage, const ContactSpec& contact) {
  double largest = 0.0;
  const auto force_of = [&](const Residual& residual) {
    const auto* force = std::get_if<residual::ContactForce>(&residual);
    return force != nullptr && force->contact == contact.name ? force : nullptr;
  };
  const std::vector<double> steps = knot_steps(spec);
  for (const CostTerm& cost : stage.costs) {
    const residual::ContactForce* const force = force_of(cost.residual);
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
    if (const residual::ContactForce* const force = force_of(constraint.residual))
      for (const Eigen::VectorXd& limit : {constraint.lower, constraint.upper})
        largest = std::max(largest, along_normal(*force, limit));
  return largest;
}

/// Returns the Jacobian of the point where friction acts on the tool, along two directions
/// perpendicular to the normal (2 x nv).
std::optional<Eigen::MatrixXd> sliding_jacobian(const ProblemSpec& spec, const ContactSpec& contact,
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
  ContactDynamics in_axes(spec.model, {axes}, {.mu = compliance});
  ContactDynamics at_tool(spec.model, {point}, {.mu = compliance});
  if (!is_usable(in_axes.acceleration(q, zero, zero)) ||
      !is_usable(at_tool.acceleration(q, zero, zero)))
    return std::nullopt;
  const Eigen::Matrix3d R = in_axes.force(0).axes();
  const int normal = normal_of(contact);
  const Eigen::Vector3d arm = -contact.friction->radius * R.col(normal);
  const Eigen::MatrixXd J = at_tool.jacobian();  // at the tool's origin, axes of the world
  Eigen::MatrixXd at_point = J.topRows(3);
  for (Eigen::Index k = 0; k < J.cols(); ++k)
    at_point.col(k) += Eigen::Vector3d(J.col(k).tail<3>()).cross(arm);
  Eigen::MatrixXd result(2, J.cols());
  for (int i = 0; i < 2; ++i) result.row(i) = R.col((normal + 1 + i) % 3).transpose() * at_point;
  return result;
}

/// Returns the smallest apparent mass of the tool perpendicular to the normal while the stage's
/// contacts are active [kg].
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
  const std::optional<Eigen::MatrixXd> J = sliding_jacobian(spec, now.front(), q, zero);
  if (!J) return std::nullopt;
  ContactDynamics dynamics(spec.model, held, {.mu = compliance});
  if (!is_usable(dynamics.forward(q, zero, zero))) return std::nullopt;
  const Eigen::VectorXd at_rest = dynamics.a();
  Eigen::Matrix2d mobility;  // 1/kg
  for (int i = 0; i < 2; ++i) {
    const Eigen::VectorXd torque = J->row(i);
    if (!is_usable(dynamics.forward(q, zero, torque))) return std::nullopt;
    mobility.col(i) = *J * (dynamics.a() - at_rest);
  }
  const Eigen::Matrix2d symmetric = 0.5 * (mobility + mobility.transpose());
  const double max_mobility =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(symmetric).eigenvalues()[1];
  constexpr double min_mobility = 1e-9;  // smaller: no joint moves the tool sideways [1/kg]
  if (!(max_mobility > min_mobility)) return std::nullopt;
  return 1.0 / max_mobility;
}

}  // namespace

double explicit_step(const ProblemSpec& spec, const Stage& stage) {
  if (stage.impact) return 0.0;
  const HorizonKnots knots = knots_of(spec);
  double max_step = 0.0;
  for (std::size_t k = 0; k < knots.stages.size(); ++k) {
    if (&spec.stages[to_size(knots.stages[k])] != &stage) continue;
    const double own = knots.own_steps[k];
    max_step = std::max(max_step, own > 0.0 ? std::min(own, stage.step) : stage.step);
  }
  return max_step > 0.0 ? max_step : stage.step;
}

std::optional<SlidingStep> sliding_step(const ProblemSpec& spec, const Stage& stage,
                                        const ContactSpec& contact) {
  const std::optional<double> mass = sliding_mass(spec, stage, contact);
  if (!mass) return std::nullopt;
  const double force = largest_force(spec, stage, contact);
  const double coefficient = contact.friction->coefficient;
  return SlidingStep{.coefficient = coefficient > 0.0 ? coefficient : SlidingFriction().coefficient,
                     .force = force > 0.0 ? force : *mass * standard_gravity,
                     .mass = *mass,
                     .step = explicit_step(spec, stage)};
}

}  // namespace burnish::ocp

namespace burnish {

ProblemSpec with_fade_speeds(ProblemSpec spec) {
  // Ratio of the fade speed to the speed that friction removes in a step. With a ratio of 2, the
  // solver needed tens of iterations for problems with force limits.
  constexpr double margin = 4.0;
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
      return spec;  // compilation reports the error
    }
    contact.friction->speed = speed;
  }
  return spec;
}

}  // namespace burnish
