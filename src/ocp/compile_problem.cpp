// Compiles a problem: robot, actuators, contacts and stages. Throws Error for an invalid
// specification.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/model/state.hpp"
#include "model/followers.hpp"
#include "model/loops.hpp"
#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {
namespace {

StateLayout make_layout(const ProblemSpec& spec) {
  if (!std::isfinite(spec.start_time))
    throw Error("start_time is " + number(spec.start_time) + " s; wanted a finite number");
  StateLayout layout;
  layout.nq = spec.model.nq;
  layout.nv = spec.model.nv;
  const auto add = [&](const Joint& joint) {
    for (int k = 0; k < joint.nv; ++k) layout.actuated.push_back(joint.v_index + k);
  };
  for (const std::string& name : spec.actuation.joints) {
    const Joint& joint = spec.model.joints[to_size(spec.model.joint_index(name))];
    if (joint.follows) throw Error("actuation: " + that_it_follows(spec.model, joint));
    if (std::find(layout.actuated.begin(), layout.actuated.end(), joint.v_index) !=
        layout.actuated.end())
      throw Error("actuation: joint " + in_quotes(name) + " is named twice");
    add(joint);
  }
  if (spec.actuation.joints.empty())
    for (const Joint* joint : driven_joints(spec.model, spec.actuation)) add(*joint);
  layout.nu = static_cast<int>(layout.actuated.size());
  if (layout.nu == 0) throw Error("actuation: no joint is driven; wanted at least one");
  if (spec.torque_model) layout.filtered = layout.nu;
  layout.holds_torque = spec.torque_model && spec.torque_model->is_held();
  return layout;
}

/// Finds the contacts with force states, and adds entries for these force states to the layout.
std::vector<ForceState> compile_force_states(const ProblemSpec& spec, const ContactSet& contacts,
                                             StateLayout& layout) {
  std::vector<ForceState> result;
  for (const std::string& name : spec.force_states) {
    int contact = -1;
    try {
      contact = contacts.index(name);
    } catch (const Error& error) {
      throw Error(std::string("force_states: ") + error.what());
    }
    for (const ForceState& other : result)
      if (other.contact == contact)
        throw Error("force_states: contact " + in_quotes(name) + " is named twice");
    const auto& directions = contacts.contacts()[to_size(contact)].directions;
    result.push_back({contact, static_cast<int>(directions.size()), layout.force_states});
    layout.force_states += result.back().rows;
  }
  return result;
}

StateShape make_shape(const StateLayout& layout, const std::vector<TangentBlock>& blocks) {
  // Impacts change neither force states nor filtered torques, so both are counted together. With
  // force states, stages other than impacts are linearized as DynamicsForm::Dense.
  StateShape shape{layout.nx(), layout.ndx(), layout.nv, layout.filtered + layout.force_states, {}};
  for (const TangentBlock& block : blocks) shape.blocks.push_back({block.first, block.size});
  return shape;
}

void check_initial_state(const ProblemSpec& spec, const StateLayout& layout) {
  const Eigen::VectorXd& x = spec.initial_state;
  if (x.size() != layout.nx())
    throw Error("initial_state has " + std::to_string(x.size()) + " entries; wanted " +
                std::to_string(layout.nx()) + " (q: " + std::to_string(layout.nq) +
                ", v: " + std::to_string(layout.nv) +
                (layout.filtered > 0 ? ", tau: " + std::to_string(layout.filtered) : "") +
                (layout.force_states > 0
                     ? ", forces of the previous step: " + std::to_string(layout.force_states)
                     : "") +
                ")");
  check_configuration(spec.model, x.head(layout.nq), "initial_state");
  check_tangent(spec.model, x.segment(layout.nq, layout.nv), "initial_state");
  for (const LoopMiss& miss : loop_misses(spec.model, x.head(layout.nq))) {
    const LoopDistance distance{miss.translation, miss.rotation};
    if (!distance.closes())
      throw Error("initial_state does not close loop " + in_quotes(miss.loop) + ": the gap is " +
                  distance.text() + "; wanted a posture from project_onto_loops()");
  }
  if (!x.allFinite())
    throw Error(
        "initial_state holds a NaN or an infinity in its torques or forces; wanted finite numbers");
}

void check_torque_model(const std::optional<TorqueModel>& model) {
  if (!model) return;
  if (model->is_held() && model->cutoff != 0.0)
    throw Error("torque_model: held torques have a cut-off of " + number(model->cutoff) +
                " rad/s; wanted 0 rad/s, or the exact discretisation");
  if (!model->is_held() && (!(model->cutoff > 0.0) || !std::isfinite(model->cutoff)))
    throw Error("torque_model: the cut-off is " + number(model->cutoff) +
                " rad/s; wanted a positive number");
}

/// Returns the fraction of a torque error that remains after `time` [s].
double decay_after(const TorqueModel& model, double time) {
  if (model.is_held()) return 0.0;
  return model.discretization == TorqueModel::Discretization::Exact ? std::exp(-model.cutoff * time)
                                                                    : 1.0 - model.cutoff * time;
}

/// Adds the rotations, surfaces and friction coefficients of the active contacts to the stage's
/// targets.
void place_contacts(const ProblemSpec& spec, const CompiledProblem& problem, CompiledStage& stage) {
  for (std::size_t c = 0; c < spec.contacts.size(); ++c) {
    if (stage.active[c] == 0) continue;
    const ContactSpec& given = problem.contacts.contacts()[c].spec;
    const int contact = static_cast<int>(c);
    const int coefficient = given.friction ? stage.targets++ : -1;
    if (given.friction)
      stage.frictions.push_back({given.friction->coefficient, coefficient, contact});
    const Reference& reference = spec.contacts[c].reference;
    add_turning(reference, contact, "contact " + in_quotes(given.name), stage);
    const int surface = add_surface(reference, {.surface = {}, .contact = contact}, stage);
    problem.inputs.use(given, coefficient, surface, stage);
  }
}

CompiledStage make_stage(const ProblemSpec& spec, const CompiledProblem& problem,
                         const Stage& given) {
  const std::string place = "stage " + in_quotes(given.name);
  CompiledStage stage;
  stage.name = given.name;
  stage.impact = given.impact;
  stage.integrator = given.integrator;
  stage.dense = !given.impact &&
                (given.integrator == Integrator::RungeKutta4 || problem.layout.force_states > 0);
  stage.step = given.impact ? 0.0 : given.step;
  if (!given.impact) problem.check_step(place, given.step);
  stage.nu = given.impact ? 0 : problem.layout.nu;
  stage.solves_contacts = !given.impact;
  stage.active.assign(to_size(problem.contacts.size()), 0);
  for (const std::string& name : given.contacts) {
    try {
      stage.active[to_size(problem.contacts.index(name))] = 1;
    } catch (const Error& error) {
      throw Error(place + ": " + error.what());
    }
  }
  if (given.impact && given.contacts.empty())
    throw Error(place + ": the impact has no contacts; wanted at least one");
  place_contacts(spec, problem, stage);
  compile_terms(spec, problem, given.costs, given.constraints, place, stage);
  return stage;
}

void check_weights(const std::vector<CompiledStage>& stages) {
  bool has_weight = false, has_term = false;
  for (const CompiledStage& stage : stages)
    for (const CompiledTerm& term : stage.cost_terms()) {
      has_term = true;
      has_weight =
          has_weight || (term.weight > 0.0 && std::any_of(term.weights.begin(), term.weights.end(),
                                                          [](double w) { return w > 0.0; }));
    }
  if (!has_term) throw Error("the problem has no cost terms; wanted at least one");
  if (!has_weight)
    throw Error("all weights of the problem are zero; wanted at least one positive weight");
}

void find_largest(CompiledProblem& problem) {
  for (const CompiledStage& stage : problem.stages) {
    problem.has_impacts = problem.has_impacts || stage.impact;
    problem.has_dense_stages = problem.has_dense_stages || stage.dense;
    problem.largest_targets = std::max(problem.largest_targets, stage.targets);
    problem.largest_terms = std::max(problem.largest_terms, static_cast<int>(stage.terms.size()));
    problem.largest_curvatures = std::max(problem.largest_curvatures, stage.curvature_rows);
    problem.largest_limited_rows = std::max(problem.largest_limited_rows, stage.rows());
    for (const CompiledTerm& term : stage.terms) {
      problem.largest_rows = std::max(problem.largest_rows, term.rows);
      problem.largest_jacobian = std::max(problem.largest_jacobian, term.jacobian_size);
      problem.has_custom =
          problem.has_custom || std::holds_alternative<CustomResidual>(term.residual);
    }
  }
}

}  // namespace

CompiledProblem::CompiledProblem(const ProblemSpec& spec)
    : model(spec.model),
      tree(model),
      layout(make_layout(spec)),
      blocks(tangent_blocks(tree)),
      contacts(model, contacts_at(spec.contacts, spec.start_time)),
      inputs(spec),
      contact_solver(spec.contact_solver),
      torque_model(spec.torque_model),
      torque_bias(to_size(model.nv), 0.0),
      decaying_torque(torque_bias) {
  check_torque_model(torque_model);
  force_states = compile_force_states(spec, contacts, layout);
  shape = make_shape(layout, blocks);
  if (spec.actuation.passive_torques) passive.emplace(model, spec.actuation.slip_velocity);
  check_initial_state(spec, layout);
  for (const Stage& given : spec.stages) {
    for (const CompiledStage& other : stages)
      if (other.name == given.name)
        throw Error("stage " + in_quotes(given.name) + ": the name is used twice");
    if (given.name.empty()) throw Error("a stage has no name; wanted a name");
    if (given.name == "terminal")
      throw Error(
          "stage 'terminal': the name is reserved for the end of the horizon; wanted another name");
    stages.push_back(make_stage(spec, *this, given));
  }
  CompiledStage terminal;
  terminal.name = "terminal";
  terminal.terminal = true;
  terminal.solves_contacts = false;
  terminal.active.assign(to_size(contacts.size()), 0);
  // With filtered torques in the state, the terminal state determines contact forces. In this case,
  // the contacts of the horizon's last stage are active in the terminal stage.
  if (layout.acts_from_state() && !spec.horizon.empty() && !stages.empty())
    for (const CompiledStage& stage : stages)
      if (stage.name == spec.horizon.back().stage) terminal.active = stage.active;
  place_contacts(spec, *this, terminal);
  compile_terms(spec, *this, spec.terminal, spec.terminal_constraints, "terminal", terminal);
  stages.push_back(std::move(terminal));
  check_weights(stages);
  for (const CompiledStage& stage : stages) inputs.mark_friction(stage);
  find_largest(*this);
}

KnotTime<double> CompiledProblem::timing(const CompiledStage& stage, double step) const {
  KnotTime<double> result;
  if (!stage.passes_time()) return result;
  result.step = result.weight = step;
  result.per_second = 1.0 / step;
  if (step > stage.step) result.step_ratio = stage.step / step;
  if (torque_model) {
    result.decay = decay_after(*torque_model, step);
    result.half_decay = decay_after(*torque_model, 0.5 * step);
  }
  return result;
}

void CompiledProblem::check_step(const std::string& place, double step) const {
  if (!(step > 0.0) || !std::isfinite(step))
    throw Error(place + ": the step is " + number(step) + " s; wanted a positive number");
  if (torque_model && std::abs(decay_after(*torque_model, step)) > 1.0)
    throw Error(place + ": the torque model of " + number(torque_model->cutoff) +
                " rad/s is unstable with Euler steps of " + number(step) +
                " s; wanted a step below " + number(2.0 / torque_model->cutoff) +
                " s or the exact discretisation");
}

}  // namespace burnish::ocp
