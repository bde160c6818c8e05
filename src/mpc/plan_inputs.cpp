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

constexpr const char* torque_name = "torque_error";
std::string surface_name(const ToolSpec& tool) { return tool.frame + "/surface"; }
std::string force_name(const ToolSpec& tool) { return tool.frame + "/force_error"; }
/// `part`: name of a support, or frame of a tool.
std::string friction_name(const std::string& part) { return part + "/friction"; }

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

/// Returns true if the contact is between the tool and the frame that carries its surface.
bool is_of_tool(const ContactSpec& contact, const ToolSpec& tool) {
  return contact.tool == tool.frame && contact.base == (tool.base.empty() ? "world" : tool.base);
}

/// Returns true for a ContactForce of a one-dimensional contact of the tool, in the contact's
/// reference frame.
bool is_force_of(const ToolSpec& tool, const Residual& residual,
                 const std::vector<ContactSpec>& contacts) {
  const auto* force = std::get_if<residual::ContactForce>(&residual);
  if (force == nullptr || force->reference || force->target.size() != 1) return false;
  return std::any_of(contacts.begin(), contacts.end(), [&](const ContactSpec& contact) {
    const std::string& name = contact.name.empty() ? contact.tool : contact.name;
    return name == force->contact && contact.directions.count() == 1 && is_of_tool(contact, tool);
  });
}

/// Returns true for a FramePosition of the tool with a target relative to ToolSpec::base.
bool is_place_of(const ToolSpec& tool, const Residual& residual) {
  const Anchor from = tool.base.empty() ? Anchor(Anchor::World) : Anchor(tool.base);
  const auto* place = std::get_if<residual::FramePosition>(&residual);
  return place != nullptr && place->frame == tool.frame && place->target.size() == 3 &&
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

void add_surface_input(ProblemSpec& problem, const ToolSpec& tool) {
  const std::string name = surface_name(tool);
  if (!add(problem, {.name = name, .kind = InputKind::Surface})) return;
  for (ContactSpec& contact : problem.contacts)
    if (contact.reference.quadric && is_of_tool(contact, tool))
      name_if_empty(contact.surface_input, name);
  const auto follow = [&](auto& term) {
    if (is_place_of(tool, term.residual)) name_if_empty(term.surface_input, name);
  };
  each_term(problem, follow);
  for (CostTerm& cost : problem.terminal) follow(cost);
}

void add_friction_input(ProblemSpec& problem, const ToolSpec& tool) {
  const std::string name = friction_name(tool.frame);
  if (!add(problem, {.name = name, .value = Signal(tool.friction.coefficient)})) return;
  for (ContactSpec& contact : problem.contacts)
    if (contact.friction && is_of_tool(contact, tool))
      name_if_empty(contact.friction->coefficient_input, name);
}

void add_force_input(ProblemSpec& problem, const ToolSpec& tool) {
  const std::string name = force_name(tool);
  if (!add(problem, {.name = name})) return;
  each_term(problem, [&](auto& term) {
    if (is_force_of(tool, term.residual, problem.contacts)) name_if_empty(term.offset_input, name);
  });
}

void add_torque_input(MpcSpec& spec) {
  ProblemSpec& problem = spec.problem;
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
    const std::string name = friction_name(support.name);
    if (!add(spec.problem, {.name = name})) continue;
    each_term(spec.problem, [&](auto& term) {
      if (friction_of(term.residual, support.name) > 0.0)
        name_if_empty(term.friction_ratio_input, name);
    });
  }
}

/// Returns the first tool for which uses(contact, tool) is true, for each contact; -1: none.
template <class Uses>
std::vector<int> tools_that(const MpcSpec& spec, const Uses& uses) {
  std::vector<int> result;
  for (const ContactSpec& contact : spec.problem.contacts) {
    const auto tool = std::find_if(spec.tools.begin(), spec.tools.end(),
                                   [&](const ToolSpec& each) { return uses(contact, each); });
    result.push_back(tool == spec.tools.end() ? -1 : static_cast<int>(tool - spec.tools.begin()));
  }
  return result;
}

}  // namespace

MpcSpec completed(MpcSpec spec) {
  spec.problem = with_fade_speeds(with_loops(std::move(spec.problem)));
  for (ToolSpec& tool : spec.tools) {
    tool.normal_base.normalize();
    add_surface_input(spec.problem, tool);
    add_friction_input(spec.problem, tool);
    if (spec.model_error.kind == ModelErrorKind::Force) add_force_input(spec.problem, tool);
  }
  add_torque_input(spec);
  add_support_inputs(spec);
  return spec;
}

std::vector<int> tools_of_surfaces(const MpcSpec& spec) {
  return tools_that(spec, [](const ContactSpec& contact, const ToolSpec& tool) {
    return contact.surface_input == surface_name(tool);
  });
}

std::vector<int> tools_of_friction(const MpcSpec& spec) {
  return tools_that(spec, [](const ContactSpec& contact, const ToolSpec& tool) {
    return contact.friction && contact.friction->coefficient_input == friction_name(tool.frame);
  });
}

PlanInputs::PlanInputs(const MpcSpec& spec)
    : torque_error_(find_input(spec.problem, spec.problem.torque_bias_input, InputKind::Vector)) {
  for (const ToolSpec& tool : spec.tools)
    tools_.push_back(
        {.surface = find_input(spec.problem, surface_name(tool), InputKind::Surface),
         .friction = find_input(spec.problem, friction_name(tool.frame), InputKind::Scalar),
         .force_error = find_input(spec.problem, force_name(tool), InputKind::Scalar)});
  const std::vector<ContactSpec> supports = supports_of(spec);
  cones_.resize(static_cast<Eigen::Index>(supports.size()));
  for (std::size_t i = 0; i < supports.size(); ++i) {
    cones_[static_cast<Eigen::Index>(i)] = ground_figures(spec.problem, supports[i].name).friction;
    support_friction_.push_back(
        find_input(spec.problem, friction_name(supports[i].name), InputKind::Scalar));
  }
}

namespace {
/// Sets a scalar input; does nothing if `input` is -1.
void set_scalar(Problem& problem, int input, double value) noexcept {
  if (input >= 0) (void)problem.set_input(input, value);
}
}  // namespace

void PlanInputs::set_friction(Problem& problem, std::size_t tool,
                              double coefficient) const noexcept {
  set_scalar(problem, tools_[tool].friction, coefficient);
}

void PlanInputs::set_support_friction(Problem& problem,
                                      const Eigen::VectorXd& friction) const noexcept {
  for (Eigen::Index i = 0; i < cones_.size(); ++i)
    if (std::isfinite(cones_[i]))
      set_scalar(problem, support_friction_[to_size(i)], std::min(1.0, friction[i] / cones_[i]));
}

void PlanInputs::set_surface(Problem& problem, std::size_t tool, const Quadric& surface,
                             double depth) const noexcept {
  const int input = tools_[tool].surface;
  if (input >= 0) (void)problem.set_input(input, surface, depth);
}

void PlanInputs::set_force_error(Problem& problem, std::size_t tool, double error) const noexcept {
  set_scalar(problem, tools_[tool].force_error, -error);
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
