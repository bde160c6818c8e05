// Warnings about a valid problem that can probably not be solved well.
#include <algorithm>
#include <cmath>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/check.hpp"
#include "burnish/ocp/step_check.hpp"
#include "derivatives/explanation.hpp"
#include "ocp/problem_impl.hpp"
#include "ocp/reach.hpp"

namespace burnish {
namespace {

using ocp::CompiledTerm;
using ocp::ProblemInside;

/// First knot at which a term causes a warning, and the number of further such knots.
struct Finding {
  int knot = -1;
  int more = 0;
  std::string what;
  void add(int at, const std::string& sentence) {
    if (knot >= 0) {
      ++more;
      return;
    }
    knot = at;
    what = sentence;
  }
};

/// Returns the frame whose position the residual specifies; null: none.
const std::string* reaching_frame(const Residual& residual) {
  if (const auto* r = std::get_if<residual::FramePosition>(&residual)) return &r->frame;
  if (const auto* r = std::get_if<residual::FramePlacement>(&residual)) return &r->frame;
  return nullptr;
}

std::string out_of_reach(const std::string& frame, const ocp::Reach& reach,
                         const Eigen::Vector3d& target) {
  const double distance = (target - reach.origin).norm();
  if (!(distance > reach.distance + 1e-6)) return "";
  if (reach.joint.empty())
    return "frame " + in_quotes(frame) + " cannot move, and the target is " + number(distance) +
           " m from it";
  return "the target is " + number(distance) + " m from joint " + in_quotes(reach.joint) +
         "; wanted at most " + number(reach.distance) + " m, the reach of " + in_quotes(frame) +
         " from this joint";
}

/// Returns a warning about the target of a term at a knot; empty: none.
std::string target_complaint(const Problem& problem, int knot, const CompiledTerm& term,
                             const std::string* frame) {
  const auto& impl = ProblemInside::of(problem);
  const double* const stored = impl.targets.data() +
                               static_cast<std::ptrdiff_t>(knot) * impl.compiled.largest_targets +
                               term.target;
  const Eigen::Map<const Eigen::VectorXd> target(stored, term.target_size);
  if (!target.allFinite()) return "the target holds a NaN or an infinity";
  if (term.load != CompiledTerm::Load::Plain) {
    Eigen::VectorXd given(term.signal_size);
    term.signal.at(problem.time_of(knot), given);
    const double length = given.tail<4>().norm();
    if (std::abs(length - 1.0) > 1e-6)
      return "the target's quaternion has length " + number(length) + "; wanted 1";
  }
  if (frame == nullptr) return "";
  return out_of_reach(*frame, ocp::reach_of(problem.model(), *frame), target.head<3>());
}

void about_targets(const Problem& problem, std::vector<std::string>& sentences) {
  const auto& impl = ProblemInside::of(problem);
  const ProblemSpec& spec = problem.spec();
  for (std::size_t s = 0; s < impl.compiled.stages.size(); ++s) {
    const ocp::CompiledStage& stage = impl.compiled.stages[s];
    std::vector<const Residual*> residuals;
    for (const CostTerm& cost : stage.terminal ? spec.terminal : spec.stages[s].costs)
      residuals.push_back(&cost.residual);
    for (const Constraint& constraint :
         stage.terminal ? spec.terminal_constraints : spec.stages[s].constraints)
      residuals.push_back(&constraint.residual);
    for (std::size_t t = 0; t < residuals.size(); ++t) {
      Finding finding;
      for (int k = 0; k <= problem.knots(); ++k) {
        if (problem.stage_of(k) != static_cast<int>(s)) continue;
        const std::string what =
            target_complaint(problem, k, stage.terms[t], reaching_frame(*residuals[t]));
        if (!what.empty()) finding.add(k, what);
      }
      if (finding.knot < 0) continue;
      sentences.push_back(
          problem.knot_name(finding.knot) + ", term " + in_quotes(stage.terms[t].name) + ": " +
          finding.what +
          (finding.more > 0 ? " (and at " + std::to_string(finding.more) + " more knots)" : ""));
    }
  }
}

void about_initial_state(const Problem& problem, std::vector<std::string>& sentences) {
  const Model& model = problem.model();
  const StateLayout& l = problem.layout();
  const Eigen::Map<const Eigen::VectorXd> x(problem.initial_state(), l.nx());
  const auto compare = [&](const std::string& name, double value, double lower, double upper) {
    if (value >= lower - 1e-9 && value <= upper + 1e-9) return;
    sentences.push_back("initial state: " + name + " is " + number(value) + "; its limits are " +
                        number(lower) + " and " + number(upper));
  };
  for (const Joint& joint : model.joints)
    if (joint.nq == 1)
      compare("joint " + in_quotes(joint.name), x[joint.q_index], model.q_lower[joint.q_index],
              model.q_upper[joint.q_index]);
  for (int k = 0; k < l.nv; ++k)
    compare("the velocity of " + in_quotes(model.v_name(k)), x[l.nq + k], -model.velocity_limit[k],
            model.velocity_limit[k]);
  for (int i = 0; i < l.filtered; ++i) {
    const int k = l.actuated[to_size(i)];
    compare("the torque of " + in_quotes(model.v_name(k)), x[l.nq + l.nv + i],
            -model.effort_limit[k], model.effort_limit[k]);
  }
}

/// Static balance M u = c between the controls u and the load c, projected onto the null space of
/// the contact Jacobian. This projection removes the contact forces.
struct Balance {
  Eigen::MatrixXd M;
  Eigen::VectorXd c;
};

Balance balance_of(const Problem& problem, std::size_t index, const Eigen::VectorXd& q) {
  const auto& impl = ProblemInside::of(problem);
  const ocp::CompiledStage& stage = impl.compiled.stages[index];
  const StateLayout& l = problem.layout();
  ContactDynamics dynamics(problem.model(), impl.contacts_of(static_cast<int>(index)),
                           {.mu = 1e-6});
  for (int c = 0; c < impl.compiled.contacts.size(); ++c)
    dynamics.set_active(c, stage.active[to_size(c)] != 0);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(l.nv);
  if (dynamics.acceleration(q, rest, rest) != Status::Ok)
    return {Eigen::MatrixXd(0, l.nu), Eigen::VectorXd(0)};  // no equations, hence no warning
  Eigen::MatrixXd N = Eigen::MatrixXd::Identity(l.nv, l.nv);
  if (dynamics.rows() > 0) N = null_space(dynamics.jacobian());
  const Eigen::VectorXd b = dynamics.bias() - ocp::torque_at_rest(impl.compiled, q);
  Balance balance{Eigen::MatrixXd(N.cols(), l.nu), N.transpose() * b};
  for (int i = 0; i < l.nu; ++i) balance.M.col(i) = N.row(l.actuated[to_size(i)]).transpose();
  return balance;
}

/// Minimizes |M u - c| for controls u within the bounds, by coordinate descent. Returns the largest
/// absolute entry of M u - c.
double least_imbalance(const Balance& balance, const std::vector<double>& lower,
                       const std::vector<double>& upper, Eigen::VectorXd u) {
  const Eigen::MatrixXd G = balance.M.transpose() * balance.M;
  const Eigen::VectorXd g = balance.M.transpose() * balance.c;
  const auto clamped = [&](Eigen::Index i, double value) {
    const auto place = to_size(i);
    return std::clamp(value, lower[place], upper[place]);
  };
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = clamped(i, u[i]);
  for (int sweep = 0; sweep < 10000; ++sweep) {
    double moved = 0.0;
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      if (G(i, i) < 1e-12) continue;
      const double next = clamped(i, u[i] + (g[i] - G.row(i).dot(u)) / G(i, i));
      moved = std::max(moved, std::abs(next - u[i]));
      u[i] = next;
    }
    if (moved < 1e-9) break;
  }
  return balance.c.size() == 0 ? 0.0 : (balance.M * u - balance.c).cwiseAbs().maxCoeff();
}

void about_bounds(const Problem& problem, std::vector<std::string>& sentences) {
  const auto& impl = ProblemInside::of(problem);
  if (impl.lower.empty()) return;
  const StateLayout& l = problem.layout();
  const Eigen::Map<const Eigen::VectorXd> x(problem.initial_state(), l.nx());
  for (std::size_t s = 0; s + 1 < impl.compiled.stages.size(); ++s) {
    const ocp::CompiledStage& stage = impl.compiled.stages[s];
    if (stage.impact) continue;
    const Problem::QuasiStatic rest = problem.quasi_static(static_cast<int>(s), x);
    const Balance balance = balance_of(problem, s, x.head(l.nq));
    const double scale =
        std::max(1.0, balance.c.size() == 0 ? 0.0 : balance.c.cwiseAbs().maxCoeff());
    // If unbounded controls cannot balance the robot either, the bounds are not the cause.
    if (rest.residual > 1e-6 * scale) continue;
    if (least_imbalance(balance, impl.lower, impl.upper, rest.control) < 1e-4 * scale) continue;
    int worst = 0;
    double max_violation = 0.0;
    for (int i = 0; i < l.nu; ++i) {
      const auto place = to_size(i);
      const double violation =
          std::max(impl.lower[place] - rest.control[i], rest.control[i] - impl.upper[place]);
      if (violation <= max_violation) continue;
      max_violation = violation;
      worst = i;
    }
    sentences.push_back("stage " + in_quotes(stage.name) +
                        ": the control bounds do not allow rest in the initial posture: " +
                        in_quotes(problem.control_names()[to_size(worst)]) + " needs " +
                        number(rest.control[worst]) + ", but its bounds are " +
                        number(impl.lower[to_size(worst)]) + " and " +
                        number(impl.upper[to_size(worst)]));
  }
}

/// Warns about redundant contacts of a stage that contradict each other at the initial state.
/// Torques do not affect the contradiction.
void about_contradictions(const Problem& problem, std::size_t index,
                          std::vector<std::string>& sentences) {
  const auto& impl = ProblemInside::of(problem);
  const ocp::CompiledStage& stage = impl.compiled.stages[index];
  const StateLayout& l = problem.layout();
  const Eigen::Map<const Eigen::VectorXd> x(problem.initial_state(), l.nx());
  ContactSolver solver = impl.compiled.contact_solver;
  const bool iterates = solver.max_proximal_iterations > 0;
  if (!iterates) solver.max_proximal_iterations = 1;
  ContactDynamics dynamics(problem.model(), impl.contacts_of(static_cast<int>(index)), solver);
  for (int c = 0; c < impl.compiled.contacts.size(); ++c)
    dynamics.set_active(c, stage.active[to_size(c)] != 0);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(l.nv);
  if (dynamics.forward(x.head(l.nq), x.segment(l.nq, l.nv), none) != Status::NotConverged) return;
  const double unmet =
      dynamics.rows() == 0 ? 0.0 : Eigen::VectorXd(dynamics.unmet()).cwiseAbs().maxCoeff();
  if (unmet == 0.0) return;
  const Eigen::VectorXd rows = dynamics.unmet();
  const std::string opposing =
      contradicting(unmet_rows(dynamics.row_names(), {rows.data(), rows.data() + rows.size()})) +
      " contradict each other; without proximal iterations, they exert opposing forces of up to " +
      number(unmet / solver.mu) + " N (Nm)";
  sentences.push_back("stage " + in_quotes(stage.name) +
                      ", initial state: " + (iterates ? dynamics.explanation() : opposing));
}

void about_contacts(const Problem& problem, std::vector<std::string>& sentences) {
  const auto& impl = ProblemInside::of(problem);
  if (impl.compiled.contact_solver.mu > 0.0) {
    for (std::size_t s = 0; s < impl.compiled.stages.size(); ++s)
      if (!impl.compiled.stages[s].terminal && !impl.compiled.stages[s].impact)
        about_contradictions(problem, s, sentences);
    return;
  }
  const Eigen::Map<const Eigen::VectorXd> q(problem.initial_state(), problem.layout().nq);
  for (std::size_t s = 0; s < impl.compiled.stages.size(); ++s) {
    const ocp::CompiledStage& stage = impl.compiled.stages[s];
    if (stage.terminal) continue;
    std::vector<int> active;
    for (int c = 0; c < impl.compiled.contacts.size(); ++c)
      if (stage.active[to_size(c)] != 0) active.push_back(c);
    if (active.empty()) continue;
    const ContactSet contacts(problem.model(), impl.contacts_of(static_cast<int>(s)));
    for (const RedundantRow& row : diagnose(problem.model(), contacts, q, active).redundant)
      sentences.push_back("stage " + in_quotes(stage.name) + ", initial posture: " + row.text() +
                          "; wanted independent contact directions, or contact_solver.mu > 0");
  }
}

/// Returns the height of x above a surface, as residual::FrameHeight defines it [m].
double height_above(const Quadric& surface, const Eigen::Vector3d& x) {
  const Eigen::Vector3d g = surface.gradient(x);
  const double phi = surface.value(x), squared = g.squaredNorm();
  const double curvature = g.dot(surface.Q * g) / squared;
  return 2.0 * phi /
         (g.norm() + std::sqrt(std::max(squared - 2.0 * phi * curvature, 0.01 * squared)));
}

/// Warns about contacts that start away from their surface. A contact constrains only the rate of
/// the distance, so the distance stays constant.
void about_surfaces(const Problem& problem, std::vector<std::string>& sentences) {
  constexpr double max_height = 1e-3;  // largest height without a warning, chosen by hand [m]
  const auto& impl = ProblemInside::of(problem);
  const ocp::CompiledStage& stage = impl.stage(0);
  const Eigen::Map<const Eigen::VectorXd> q(problem.initial_state(), problem.layout().nq);
  const std::vector<ContactSpec> contacts = impl.compiled.contacts.specs();
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ContactSpec& contact = contacts[c];
    const std::optional<Quadric>& surface = contact.reference.quadric;
    if (!surface || stage.active[c] == 0 || !contact.directions.has(2)) continue;
    const Eigen::Vector3d tool = frame_placement(problem.model(), q, contact.base).inverse() *
                                 frame_placement(problem.model(), q, contact.tool).translation();
    const double height = height_above(*surface, tool);
    if (!(std::abs(height) > max_height)) continue;
    sentences.push_back(
        "stage " + in_quotes(stage.name) + ", initial posture: " + in_quotes(contact.tool) +
        " is about " + number(std::abs(height)) + (height > 0.0 ? " m above" : " m below") +
        " the surface of contact " + in_quotes(contact.name) +
        ", and the contact holds it at that distance; wanted an initial posture with the tool on "
        "the surface");
  }
}

void about_springs(const Problem& problem, std::vector<std::string>& sentences) {
  if (ProblemInside::of(problem).compiled.passive || Springs(problem.model()).empty()) return;
  sentences.push_back(
      "the robot has springs or tendons, which the problem ignores; wanted passive_torques in the "
      "actuation");
}

/// Warns about joints that move no mass. Returns false in this case, because the warnings about
/// contacts need a regular mass matrix.
bool about_mass(const Problem& problem, std::vector<std::string>& sentences) {
  const Eigen::Map<const Eigen::VectorXd> q(problem.initial_state(), problem.layout().nq);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(problem.layout().nv);
  ContactDynamics dynamics(problem.model());
  if (dynamics.forward(q, rest, rest) != Status::SingularMass) return true;
  sentences.push_back("initial posture: " + dynamics.explanation());
  return false;
}

}  // namespace

std::vector<std::string> complaints(const Problem& problem) {
  std::vector<std::string> sentences;
  about_targets(problem, sentences);
  about_initial_state(problem, sentences);
  about_bounds(problem, sentences);
  about_springs(problem, sentences);
  about_surfaces(problem, sentences);
  if (!about_mass(problem, sentences)) return sentences;
  about_contacts(problem, sentences);
  for (std::string& sentence : step_complaints(problem)) sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace burnish
