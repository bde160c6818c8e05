#include "burnish/files/problem_file.hpp"

#include <algorithm>
#include <iterator>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "files/read_inputs.hpp"
#include "files/read_parts.hpp"
#include "files/read_problem.hpp"
#include "files/read_solver.hpp"
#include "files/read_terms.hpp"
#include "robots/read_inertia.hpp"

namespace burnish::files {
namespace {

/// Returns the names of a stage's active contacts: the stated contacts and the robot's loops.
std::vector<std::string> read_stage_contacts(const Reader& stage, const ProblemScope& scope) {
  const auto given = stage.find("contacts");
  std::vector<std::string> names;
  if (given && !(given->is_list() && given->entries().empty())) names = given->texts();
  for (const std::string& name : names) given->named([&] { ocp::contact_named(scope.spec, name); });
  for (const ContactSpec& contact : scope.spec.contacts)
    if (is_loop(scope.model(), contact) &&
        std::find(names.begin(), names.end(), contact.name) == names.end())
      names.push_back(contact.name);
  return names;
}

/// Returns the longest step of all stages except impacts [s].
double longest_step(const Reader& stages) {
  double max_step = 0.0;
  for (const auto& [name, stage] : stages.items()) {
    const auto impact = stage.find("impact");
    if (impact && impact->yes_or_no()) continue;
    const auto step = stage.find("step");
    max_step = std::max(max_step, step ? step->positive() : Stage().step);
  }
  return max_step;
}

Stage read_stage(const std::string& name, const Reader& reader, const ProblemScope& scope,
                 const std::optional<Reader>& shared) {
  reader.allow_only({"contacts", "costs", "constraints", "step", "integrator", "impact"});
  Stage stage{.name = name};
  stage.contacts = read_stage_contacts(reader, scope);
  if (const auto step = reader.find("step")) stage.step = step->positive();
  if (const auto integrator = reader.find("integrator"))
    stage.integrator = integrator->word({"semi_implicit_euler", "runge_kutta_4"}) == "runge_kutta_4"
                           ? Integrator::RungeKutta4
                           : Integrator::SemiImplicitEuler;
  if (const auto impact = reader.find("impact")) stage.impact = impact->yes_or_no();
  if (const auto costs = reader.find("costs"))
    stage.costs = read_costs(scope, shared, stage.contacts, *costs);
  if (const auto constraints = reader.find("constraints"))
    stage.constraints = read_constraints(scope, stage.contacts, *constraints);
  return stage;
}

/// Reads a segment: a number of knots, or a map with knots, step and duration.
HorizonSegment read_segment(const std::string& stage, const Reader& reader) {
  if (!reader.is_map()) return {.stage = stage, .knots = reader.count(1)};
  reader.allow_only({"knots", "step", "duration"});
  HorizonSegment segment{.stage = stage, .knots = reader["knots"].count(1)};
  if (const auto step = reader.find("step")) segment.step = step->positive();
  if (const auto duration = reader.find("duration")) segment.duration = duration->positive();
  return segment;
}

/// Reads a list of {stage: knots} and {repeat: times, of: [...]}. `known` are the names of the
/// stages.
void read_horizon(const Reader& reader, const std::vector<std::string>& known,
                  std::vector<HorizonSegment>& horizon) {
  for (const Reader& entry : reader.entries()) {
    if (entry.has("repeat")) {
      entry.allow_only({"repeat", "of"});
      std::vector<HorizonSegment> once;
      read_horizon(entry["of"], known, once);
      const int times = entry["repeat"].count(1);
      // Checks the size before copying. Each segment in `once` has at least one knot.
      if (to_size(times) > max_knots / once.size())
        entry.refuse("the repeated entries have more than " + std::to_string(max_knots) +
                     " knots, the maximum number");
      for (int i = 1; i < times; ++i) horizon.insert(horizon.end(), once.begin(), once.end());
      // The last repetition is moved instead of copied, which keeps nested repeats cheap.
      if (horizon.empty())
        horizon = std::move(once);
      else
        horizon.insert(horizon.end(), std::move_iterator(once.begin()),
                       std::move_iterator(once.end()));
    } else {
      if (!entry.is_map())
        entry.refuse(
            "it is not a stage with its number of knots; wanted an entry such as 'press: 100'");
      entry.allow_only(known);
      for (const auto& [stage, knots] : entry.items())
        horizon.push_back(read_segment(stage, knots));
    }
    if (horizon.size() > max_knots)
      reader.refuse("the horizon has more than " + std::to_string(max_knots) +
                    " knots, the maximum number");
  }
  if (horizon.empty())
    reader.refuse("the horizon has no knots; wanted stages with their numbers of knots");
}

/// Projects the velocity at the start onto the velocities that the loops allow. Joints whose
/// velocity is stated in the file keep it.
void close_velocity(const Reader& stated, ProblemSpec& spec) {
  if (spec.model.loops.empty()) return;
  std::vector<std::string> keep;
  if (stated.is_map())
    for (const auto& [joint, value] : stated.items())
      if (joint != "other") keep.push_back(joint);
  auto v = spec.initial_state.segment(spec.model.nq, spec.model.nv);
  v = project_velocity_onto_loops(spec.model, spec.initial_state.head(spec.model.nq), v,
                                  LoopMetric::Plain, keep);
}

/// Reads the configuration, velocity and time of `start`. set_torques() and set_forces() read the
/// other keys, which need the contacts of the first stage.
void read_start(const Reader& reader, const Robot& robot, ProblemSpec& spec) {
  reader.allow_only({"posture", "q", "velocity", "torques", "forces", "time"});
  if (reader.has("posture") && reader.has("q"))
    reader.refuse("keys 'posture' and 'q' are both stated; state one");
  for (const char* key : {"posture", "q"})
    if (const auto q = reader.find(key))
      spec.initial_state.head(spec.model.nq) = read_configuration(robot, *q);
  if (const auto v = reader.find("velocity")) {
    spec.initial_state.segment(spec.model.nq, spec.model.nv) =
        read_rows(*v, velocity_rows(spec.model), 0.0);
    close_velocity(*v, spec);
  }
  if (const auto time = reader.find("time")) spec.start_time = time->number();
}

/// Sets the torques of the initial state, if the state has any. Default: the torques that keep the
/// robot at rest.
void set_torques(const std::optional<Reader>& given, const std::vector<std::string>& contacts,
                 const ProblemScope& scope, ProblemSpec& spec) {
  if (!spec.torque_model) {
    if (given)
      given->refuse(
          "torques are part of the state only with a 'torque_model'; wanted this key, or no "
          "'torques'");
    return;
  }
  auto tau = spec.initial_state.segment(scope.model().nq + scope.model().nv, scope.controls());
  if (!given || is_hold(*given)) {
    const HeldForces forces = given ? read_held_forces(scope, contacts, *given) : HeldForces();
    tau = hold(spec, contacts, scope.q, forces).control;
    return;
  }
  std::vector<RowGroup> rows;
  for (const Joint* joint : scope.driven()) rows.push_back({joint->name, joint->nv});
  tau = read_rows(*given, rows, 0.0);
}

/// Sets the force states of the initial state, if the state has any. Default: the forces that keep
/// the robot at rest, given the forces that `torques: {hold: ...}` prescribes.
void set_forces(const std::optional<Reader>& start, const std::vector<std::string>& contacts,
                const ProblemScope& scope, ProblemSpec& spec) {
  const auto given = start ? start->find("forces") : std::nullopt;
  const auto torques = start ? start->find("torques") : std::nullopt;
  if (spec.force_states.empty()) {
    if (given)
      given->refuse(
          "forces are part of the state only with 'force_states'; wanted this key, or no 'forces'");
    return;
  }
  const bool held = torques && is_hold(*torques);
  HeldForces forces = hold(spec, contacts, scope.q,
                           held ? read_held_forces(scope, contacts, *torques) : HeldForces())
                          .forces;
  if (given) {
    given->allow_only(spec.force_states);
    for (const auto& [name, value] : given->items()) {
      const int rows = ocp::contact_named(scope.spec, name).directions.count();
      forces[name] = rows == 1 && value.is_number() ? Eigen::VectorXd::Constant(1, value.number())
                                                    : Eigen::VectorXd(value.numbers(rows));
    }
  }
  const Eigen::VectorXd rows = force_states_of(spec, forces);
  const Eigen::Index before = spec.initial_state.size();
  spec.initial_state.conservativeResize(before + rows.size());
  spec.initial_state.tail(rows.size()) = rows;
}

/// Returns the name of the horizon's first stage; empty if the horizon is invalid.
std::string first_stage(const Reader& horizon) {
  if (horizon.is_list()) {
    const std::vector<Reader> entries = horizon.entries();
    return entries.empty() ? "" : first_stage(entries.front());
  }
  if (const auto repeated = horizon.find("of")) return first_stage(*repeated);
  return horizon.is_map() && !horizon.items().empty() ? horizon.items().front().first : "";
}

/// Returns the active contacts of the horizon's first stage.
std::vector<std::string> first_contacts(const Reader& top, const ProblemScope& scope) {
  const auto stage = top["stages"].find(first_stage(top["horizon"]));
  return stage ? read_stage_contacts(*stage, scope) : std::vector<std::string>();
}

/// Reads a contact, and checks the names of its inputs.
ContactSpec read_contact_with_inputs(const std::string& name, const Reader& reader,
                                     const ProblemSpec& spec, const std::filesystem::path& folder) {
  ContactSpec contact =
      read_contact(name, reader, spec.model, spec.initial_state.head(spec.model.nq), &folder);
  contact.surface_input = read_input_name(reader, "surface_input", spec);
  if (const auto friction = reader.find("friction"))
    contact.friction->coefficient_input = read_input_name(*friction, "coefficient_input", spec);
  return contact;
}

/// Reads the parts of a problem file that do not depend on stages. The words `hold` and `here` in
/// stages use values of these parts.
void read_scope(const Reader& top, const std::filesystem::path& folder, ProblemFile& result) {
  ProblemSpec& spec = result.spec;
  const Model& model = spec.model;
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
  spec.initial_state.head(model.nq) = result.robot.reference_configuration();
  if (const auto start = top.find("start")) read_start(*start, result.robot, spec);
  if (const auto inputs = top.find("inputs")) spec.inputs = read_inputs(*inputs, model, folder);
  spec.torque_bias_input = read_input_name(top, "torque_bias_input", spec);
  if (const auto contacts = top.find("contacts"))
    for (const auto& [name, contact] : contacts_in(*contacts))
      spec.contacts.push_back(read_contact_with_inputs(name, contact, spec, folder));
  if (!model.loops.empty())
    spec.contacts = with_loops(model, std::move(spec.contacts),
                               LoopGains::for_step(longest_step(top["stages"])));
  if (const auto solver = top.find("contact_solver"))
    spec.contact_solver = read_contact_solver(*solver);
  if (const auto actuation = top.find("actuation"))
    spec.actuation = read_actuation(*actuation, model);
  if (const auto torque_model = top.find("torque_model"))
    spec.torque_model = read_torque_model(*torque_model);
  if (const auto force_states = top.find("force_states")) {
    spec.force_states = force_states->texts();
    const ProblemScope scope{result.robot, spec, spec.initial_state.head(model.nq), folder};
    for (const std::string& name : spec.force_states)
      force_states->named([&] { (void)ocp::contact_named(scope.spec, name); });
  }
}

void read_stages(const Reader& top, const ProblemScope& scope, ProblemSpec& spec) {
  const auto shared = top.find("terms");
  if (shared) check_shared(*shared);
  // Largest number of terms, because YAML aliases can repeat a long list of costs in every stage.
  constexpr std::size_t max_terms = 10000;
  std::size_t terms = 0;
  std::vector<std::string> known;
  for (const auto& [name, stage] : top["stages"].items()) {
    spec.stages.push_back(read_stage(name, stage, scope, shared));
    known.push_back(name);
    terms += spec.stages.back().costs.size() + spec.stages.back().constraints.size();
    if (terms > max_terms)
      stage.refuse("the stages up to this one have more than " + std::to_string(max_terms) +
                   " costs and constraints, the maximum number");
  }
  read_horizon(top["horizon"], known, spec.horizon);
  // Terminal terms can use the contact forces of the last stage if the state has filtered torques.
  std::vector<std::string> contacts;
  for (const Stage& stage : spec.stages)
    if (stage.name == spec.horizon.back().stage) contacts = stage.contacts;
  if (const auto terminal = top.find("terminal"))
    spec.terminal = read_costs(scope, shared, contacts, *terminal);
  if (const auto constraints = top.find("terminal_constraints"))
    spec.terminal_constraints = read_constraints(scope, contacts, *constraints);
}

}  // namespace

ProblemFile read_problem(const Reader& top, const std::filesystem::path& folder) {
  top.allow_only({"description", "robot", "payload", "start", "inputs", "torque_bias_input",
                  "contacts", "contact_solver", "actuation", "torque_model", "force_states",
                  "control_bounds", "terms", "stages", "horizon", "terminal",
                  "terminal_constraints", "solver", "guess"});
  ProblemFile result;
  if (const auto text = top.find("description")) result.description = text->text();
  result.robot = read_robot(top["robot"], folder);
  result.robot_name = robot_name(top["robot"], folder);
  if (const auto payload = top.find("payload"))
    result.robot.model = payload->named(
        [&] { return with_payload(std::move(result.robot.model), read_payload(*payload)); });
  result.spec.model = result.robot.model;
  read_scope(top, folder, result);
  ProblemSpec& spec = result.spec;
  const ProblemScope scope{result.robot, spec, spec.initial_state.head(spec.model.nq), folder};
  if (spec.torque_model) {
    spec.initial_state.conservativeResize(spec.model.nq + spec.model.nv + scope.controls());
    spec.initial_state.tail(scope.controls()).setZero();
  }
  const auto start = top.find("start");
  const std::vector<std::string> contacts = first_contacts(top, scope);
  set_torques(start ? start->find("torques") : std::nullopt, contacts, scope, spec);
  set_forces(start, contacts, scope, spec);
  if (const auto bounds = top.find("control_bounds")) read_bounds(*bounds, scope, spec);
  read_stages(top, scope, spec);
  if (const auto solver = top.find("solver")) result.solver = read_solver(*solver);
  if (const auto guess = top.find("guess")) result.guess = read_guess(*guess, folder);
  top.named([&] { Problem{spec}; });
  return result;
}

}  // namespace burnish::files

namespace burnish {

ProblemFile read_problem_file(const std::filesystem::path& file) {
  return files::read_problem(files::Reader::load(file), file.parent_path());
}

}  // namespace burnish
