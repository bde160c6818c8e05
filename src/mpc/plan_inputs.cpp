#include "mpc/plan_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "mpc/closed_dynamics.hpp"
#include "mpc/ground_figures.hpp"

namespace burnish {
namespace {

constexpr const char* surface_name = "surface";
constexpr const char* friction_name = "tool_friction";
constexpr const char* force_name = "force_error";
constexpr const char* torque_name = "torque_error";
std::string friction_name_of(const std::string& support) { return support + "/friction"; }

/// Returns the index of an input, which must be of the given kind; -1 if there is none.
int find_input(const ProblemSpec& problem, const std::string& name, InputKind kind) {
  for (std::size_t i = 0; i < problem.inputs.size(); ++i) {
    if (problem.inputs[i].name != name) continue;
    if (problem.inputs[i].kind != kind)
      throw Error("MPC: input " + in_quotes(name) +
                  " has another kind than the controller's input of this name; wanted the same "
                  "kind, or another name");
    return static_cast<int>(i);
  }
  return -1;
}

/// Adds an input, unless the specification has it. Returns true if the input was added.
bool add(ProblemSpec& problem, InputSpec input) {
  if (find_input(problem, input.name, input.kind) >= 0) return false;
  problem.inputs.push_back(std::move(input));
  return true;
}

void name_if_empty(std::string& input, const std::string& name) {
  if (input.empty()) input = name;
}

/// Returns the frame of the surface as in ContactSpec::base; "world" for a fixed surface.
std::string base_of(const MpcSpec& spec) { return spec.base.empty() ? "world" : spec.base; }

bool is_at_tool(const MpcSpec& spec, const ContactSpec& contact) {
  return contact.tool == spec.tool && contact.base == base_of(spec);
}

/// Returns true for a ContactForce of a one-directional contact, in the contact's reference frame.
bool is_one_force(const Residual& residual, const std::vector<ContactSpec>& contacts) {
  const auto* force = std::get_if<residual::ContactForce>(&residual);
  if (force == nullptr || force->reference || force->target.size() != 1) return false;
  return std::any_of(contacts.begin(), contacts.end(), [&](const ContactSpec& contact) {
    const std::string& name = contact.name.empty() ? contact.tool : contact.name;
    return name == force->contact && contact.directions.count() == 1;
  });
}

/// Returns true for a FramePosition of the tool with a target relative to MpcSpec::base.
bool is_place_of_tool(const Residual& residual, const MpcSpec& spec) {
  const Anchor from = spec.base.empty() ? Anchor(Anchor::World) : Anchor(spec.base);
  const auto* place = std::get_if<residual::FramePosition>(&residual);
  return place != nullptr && place->frame == spec.tool && place->target.size() == 3 &&
         place->reference.origin == from && !place->reference.quadric;
}

/// Calls see(term) for each cost and constraint of the stages; skips terms at the horizon's end.
template <class See>
void each_term(ProblemSpec& problem, const See& see) {
  for (Stage& stage : problem.stages) {
    for (CostTerm& cost : stage.costs) see(cost);
    for (Constraint& constraint : stage.constraints) see(constraint);
  }
}

void add_surface_input(MpcSpec& spec) {
  ProblemSpec& problem = spec.problem;
  if (!add(problem, {.name = surface_name, .kind = InputKind::Surface})) return;
  for (ContactSpec& contact : problem.contacts)
    if (contact.reference.quadric && is_at_tool(spec, contact))
      name_if_empty(contact.surface_input, surface_name);
  const auto follow = [&](auto& term) {
    if (is_place_of_tool(term.residual, spec)) name_if_empty(term.surface_input, surface_name);
  };
  each_term(problem, follow);
  for (CostTerm& cost : problem.terminal) follow(cost);
}

void add_friction_input(MpcSpec& spec) {
  ProblemSpec& problem = spec.problem;
  const Signal coefficient(spec.friction_estimate.coefficient);
  if (!add(problem, {.name = friction_name, .value = coefficient})) return;
  for (ContactSpec& contact : problem.contacts)
    if (contact.friction && is_at_tool(spec, contact))
      name_if_empty(contact.friction->coefficient_input, friction_name);
}

void add_error_inputs(MpcSpec& spec) {
  ProblemSpec& problem = spec.problem;
  if (spec.model_error.kind == ModelErrorKind::Force && add(problem, {.name = force_name}))
    each_term(problem, [&](auto& term) {
      if (is_one_force(term.residual, problem.contacts))
        name_if_empty(term.offset_input, force_name);
    });
  if (spec.model_error.kind == ModelErrorKind::Torque && problem.torque_bias_input.empty()) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.model.nv);
    if (!add(problem, {.name = torque_name, .kind = InputKind::Vector, .value = none}))
      throw Error(
          std::string("MPC: the problem has an input '") + torque_name +
          "', but torque_bias_input is empty, so plans would ignore torque errors; wanted '" +
          torque_name + "' as torque_bias_input, or another name for the input");
    problem.torque_bias_input = torque_name;
  }
}

void add_support_inputs(MpcSpec& spec) {
  for (const ContactSpec& support : supports_of(spec)) {
    if (std::isinf(ground_figures(spec.problem, support.name).friction)) continue;
    const std::string name = friction_name_of(support.name);
    if (!add(spec.problem, {.name = name})) continue;
    each_term(spec.problem, [&](auto& term) {
      if (friction_of(term.residual, support.name) > 0.0)
        name_if_empty(term.friction_ratio_input, name);
    });
  }
}

template <class Uses>
std::vector<int> contacts_that(const std::vector<ContactSpec>& contacts, const Uses& uses) {
  std::vector<int> result;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (uses(contacts[c])) result.push_back(static_cast<int>(c));
  return result;
}

}  // namespace

MpcSpec completed(MpcSpec spec) {
  spec.normal_base.normalize();
  spec.problem = with_fade_speeds(with_loops(std::move(spec.problem)));
  add_surface_input(spec);
  add_friction_input(spec);
  add_error_inputs(spec);
  add_support_inputs(spec);
  return spec;
}

std::vector<int> contacts_on_surface(const std::vector<ContactSpec>& contacts) {
  return contacts_that(
      contacts, [](const ContactSpec& contact) { return contact.surface_input == surface_name; });
}

std::vector<int> contacts_with_friction(const std::vector<ContactSpec>& contacts) {
  return contacts_that(contacts, [](const ContactSpec& contact) {
    return contact.friction && contact.friction->coefficient_input == friction_name;
  });
}

PlanInputs::PlanInputs(const MpcSpec& spec)
    : surface_(find_input(spec.problem, surface_name, InputKind::Surface)),
      friction_(find_input(spec.problem, friction_name, InputKind::Scalar)),
      force_error_(find_input(spec.problem, force_name, InputKind::Scalar)),
      torque_error_(find_input(spec.problem, spec.problem.torque_bias_input, InputKind::Vector)) {
  const std::vector<ContactSpec> supports = supports_of(spec);
  cones_.resize(static_cast<Eigen::Index>(supports.size()));
  for (std::size_t i = 0; i < supports.size(); ++i) {
    cones_[static_cast<Eigen::Index>(i)] = ground_figures(spec.problem, supports[i].name).friction;
    support_friction_.push_back(
        find_input(spec.problem, friction_name_of(supports[i].name), InputKind::Scalar));
  }
}

namespace {
/// Sets a scalar input; does nothing if `input` is -1.
void set_scalar(Problem& problem, int input, double value) noexcept {
  if (input >= 0) (void)problem.set_input(input, value);
}
}  // namespace

void PlanInputs::set_friction(Problem& problem, double coefficient) const noexcept {
  set_scalar(problem, friction_, coefficient);
}

void PlanInputs::set_support_friction(Problem& problem,
                                      const Eigen::VectorXd& friction) const noexcept {
  for (Eigen::Index i = 0; i < cones_.size(); ++i)
    if (std::isfinite(cones_[i]))
      set_scalar(problem, support_friction_[to_size(i)], std::min(1.0, friction[i] / cones_[i]));
}

void PlanInputs::set_surface(Problem& problem, const Quadric& surface,
                             double depth) const noexcept {
  if (surface_ >= 0) (void)problem.set_input(surface_, surface, depth);
}

void PlanInputs::set_force_error(Problem& problem, double error) const noexcept {
  set_scalar(problem, force_error_, -error);
}

bool PlanInputs::set_torque_error(Problem& problem, const Eigen::VectorXd& lasting,
                                  const Eigen::VectorXd& decaying,
                                  double decay_time) const noexcept {
  if (torque_error_ < 0) return true;
  const Status status = std::isinf(decay_time)
                            ? problem.set_input(torque_error_, lasting)
                            : problem.set_input(torque_error_, lasting, decaying, decay_time);
  return status == Status::Ok;
}

}  // namespace burnish
