// Construction of an MpcController, and the order of steps in a tick.
#include "mpc/mpc_impl.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "mpc/mpc_check.hpp"
#include "mpc/part_specs.hpp"

namespace burnish {
namespace {

/// Task for specifications that have none.
struct NoTask final : MpcTask {};

/// Returns the task that MpcSpec::task made. Throws Error if it is null.
std::unique_ptr<MpcTask> checked_task(std::unique_ptr<MpcTask> made) {
  if (!made)
    throw Error("MPC: the specification's function `task` returned no task; wanted a task");
  return made;
}

/// Returns `options` with memory for solves of up to `iterations`. L1 penalty weights are never
/// raised, because there is no time for further solves. A constraint whose weight is too small is
/// violated.
DdpOptions solver_options(DdpOptions options, int iterations) {
  options.limits.max_l1_weight = 0.0;
  options.max_iterations = std::max(options.max_iterations, iterations);
  return options;
}

}  // namespace

MpcController::Impl::Impl(MpcSpec given)
    : ticks_per_update_(checked_ticks_per_update(given)),
      spec(completed(std::move(given))),
      task(spec.task ? checked_task(spec.task(spec)) : std::make_unique<NoTask>()),
      problem(spec.problem),
      solver(problem,
             solver_options(spec.solver, std::max(spec.first_iterations, spec.jump_iterations))),
      schedule(spec.schedule, task->events()),
      fault(spec.problem.model),
      gate(gate_spec(spec)),
      error(error_estimate_spec(spec), gate.state()),
      grip(spec.problem.model, grip_specs(spec), spec.slip),
      horizon(problem, schedule),
      inputs(spec),
      policy(policy_spec(spec), problem),
      in_use_(policy),
      payloads_(spec.problem.model),
      expected_(spec.solver_delay),
      prediction_(problem),
      ahead_(spec.problem, loop_times(spec), spec.limits.stale, spec.tools.size()),
      holding_(holding_spec(spec),
               {problem.layout().actuated.begin(), problem.layout().actuated.end()}),
      plans_(spec.limits),
      motors_(spec.problem.model, spec.limits, spec.tick_period),
      black_box_(spec.problem.model, spec.tools, spec.tick_period, fault),
      watched_(task->watched()),
      task_signals_(task->signals().size()),
      readings_(watched_.size()),
      target_forces_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(spec.tools.size()))),
      predicted_tools_(spec.tools.size()),
      x_(spec.problem.initial_state),
      u_(Eigen::VectorXd::Zero(problem.layout().nu)),
      v_ahead_(Eigen::VectorXd::Zero(problem.layout().nv)),
      decaying_(v_ahead_),
      x_plan_(x_),
      u_plan_(u_) {
  command_.tau = Eigen::VectorXd::Zero(problem.layout().nv);
  if (!spec.tools.empty()) command_.tools.resize(spec.tools.size());
  const RigidBody& body = gate.body();
  for (std::size_t i = 0; i < spec.tools.size(); ++i) {
    const ToolSpec& tool = spec.tools[i];
    tools_.push_back({body.frame(tool.frame), tool.base.empty() ? -1 : body.frame(tool.base)});
    predicted_tools_[i] = {tool.contact_threshold, error.models_friction(i), tool.normal_base};
  }
  reset_tools();
  std::size_t max_length = 0;
  for (const SupportGrip::Support& support : grip.supports())
    max_length = std::max(max_length, support.name.size());
  for (WatchedQuantity& quantity : watched_) {
    if (!quantity.unit.empty()) quantity.name += ", " + quantity.unit;
    max_length = std::max({max_length, quantity.name.size(), quantity.part.size()});
  }
  fault.make_room(max_length);
  if (spec.timing == PlanTiming::Thread)
    planner_ = std::make_unique<BackgroundWork>([this] { make_plan(); });
}

Status MpcController::Impl::set_payload(std::string_view frame, const InertiaSpec& payload) {
  const LoadedBody loaded = loaded_body("set_payload", problem.model(), frame, payload);
  if (loaded.status != Status::Ok) return loaded.status;
  payloads_.set(frame, payload);  // for the next plan
  (void)gate.state().set_payload(frame, payload);
  holding_.set_payload(frame, payload, loaded);
  return Status::Ok;
}

void MpcController::Impl::reset() noexcept {
  await_plan();
  life_.reset();
  next_ = {};
  expected_ = spec.solver_delay;
  busy_until_ = -std::numeric_limits<double>::infinity();
  task->reset();
  schedule.reset();
  fault.reset();
  gate.reset();
  error.reset();
  ahead_.reset();
  grip.reset();
  policy.reset();
  holding_.reset();
  plans_.reset();
  motors_.reset();
  black_box_.reset();
  thrown = nullptr;
  reset_inputs();
  solver.forget_limits();
  tick_ = 0;
  command_ = Command{.tau = std::move(command_.tau), .tools = std::move(command_.tools)};
  command_.tau.setZero();
  reset_tools();
}

void MpcController::Impl::reset_tools() noexcept {
  std::fill(command_.tools.begin(), command_.tools.end(), ToolCommand{});
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    tools_[i].surface.reset();
    tools_[i].depth = 0.0;
    command_.tools[i].normal_world = spec.tools[i].normal_base;
  }
}

/// Resets the inputs of the problem, except payloads.
void MpcController::Impl::reset_inputs() noexcept {
  try {  // functions of the specification may throw
    for (int i = 0; i < static_cast<int>(problem.spec().inputs.size()); ++i)
      if (problem.spec().inputs[to_size(i)].kind != InputKind::Inertia) problem.reset_input(i);
  } catch (...) {
    keep_exception();
  }
}

const Command& MpcController::Impl::tick(const Measurement& m) noexcept {
  command_.solve_time = 0.0;
  command_.iterations = 0;
  command_.missed_deadline = false;
  command_.clipped_torques = 0;
  command_.status = Status::Ok;
  next_.due = next_.due || tick_ % ticks_per_update_ == 0;
  gate.take(m, fault, command_.status);
  if (fault.is_set()) life_.raise_fault();
  constexpr double rounding = 1e-9;  // rounding error of sums of masses [kg]
  const bool payload_conflict =
      m.base_is_estimated && !(std::abs(m.base_payload - payloads_.mass()) <= rounding);
  if (payload_conflict) command_.status = worst(command_.status, Status::NotPhysical);
  is_ahead_ = false;
  if (gate.is_fresh() && gate.is_first()) began_ = gate.now();
  if (gate.is_fresh()) motors_.look(gate, ahead_.sent());
  if (gate.is_fresh() && !fault.is_set() && !payload_conflict && has_settled())
    process_measurement();
  const bool controls = life_.follows() && !payload_conflict;
  if (controls) {
    control();
  } else {
    fall_back();
  }
  limit_torque(controls);
  ahead_.send(command_.tau, error.joint_friction().torque());
  set_targets();
  black_box_.record(gate, schedule.time(), command_, fault);
  ++tick_;
  return command_;
}

bool MpcController::Impl::has_settled() const noexcept {
  return gate.now() - began_ >= spec.settle - 0.01 * spec.tick_period;
}

/// Processes a valid measurement: updates estimates, clock and monitors, and begins a due plan.
void MpcController::Impl::process_measurement() noexcept {
  const TaskView view{.measurement = gate.last(),
                      .body = gate.body(),
                      .schedule = schedule,
                      .command = command_,
                      .dt = gate.dt(),
                      .tool_forces_world = gate.tool_forces_world()};
  for (std::size_t i = 0; i < tools_.size(); ++i)
    target_forces_[static_cast<Eigen::Index>(i)] = command_.tools[i].target_force;
  const ErrorInput input{.measurement = gate.last(),
                         .tool_forces_world = gate.tool_forces_world(),
                         .wrenches = gate.wrenches(),
                         .dt = gate.dt(),
                         .target_forces = target_forces_,
                         .sent = ahead_.acted(),
                         .stage = horizon.stage_of(schedule.phase()),
                         .schedule_time = schedule.time(),
                         .waits = schedule.waits()};
  if (error.feels()) gate.feel(error.feel(gate.state(), input));
  rotate_normals();
  const unsigned happened = task->sense(view);
  for (std::size_t i = 0; i < tools_.size(); ++i) update_surface(i);
  error.update(gate.state(), input);
  grip.update(gate.body(), gate.wrenches(), gate.dt());
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    command_.tools[i].force_estimate_world = error.forces_world().col(static_cast<Eigen::Index>(i));
    command_.tools[i].friction = error.friction(i);
  }
  // Until a thread has computed the first plan, the fallback holds the robot, and the clock of the
  // schedule stands still.
  const bool clock_runs = life_.state() != PlanLife::State::FirstPlan;
  if (!gate.is_first() && clock_runs && schedule.advance(gate.dt(), happened)) next_.jumped = true;
  watch(view);
  if (life_.is_making() && !planner_->is_busy()) finish_plan();
  policy.take_over(acting_time());
  // Starts no plan while a finished plan waits to come into use. A new plan would replace the
  // waiting one, which would then never be used.
  const bool is_free =
      gate.now() >= busy_until_ && (spec.timing == PlanTiming::Fixed || !policy.waits());
  if (life_.can_begin() && next_.due && is_free) update();
}

/// Rotates the normals of surfaces that frames of the robot carry.
void MpcController::Impl::rotate_normals() noexcept {
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    if (tools_[i].base < 0) continue;
    command_.tools[i].normal_world =
        gate.body().placement(tools_[i].base).linear() * spec.tools[i].normal_base;
    error.set_normal(i, command_.tools[i].normal_world);
  }
}

void MpcController::Impl::update_surface(std::size_t tool) noexcept {
  Tool& at = tools_[tool];
  const int index = static_cast<int>(tool);
  const Quadric* const surface = task->surface(index);
  if (surface == nullptr || !surface->is_finite()) return;
  const Eigen::Vector3d p_tool_world = gate.body().placement(at.frame).translation();
  Eigen::Vector3d gradient;
  if (at.base < 0) {
    gradient = surface->gradient(p_tool_world);
  } else {  // the surface is in the axes of `base`
    const Eigen::Isometry3d base_world = gate.body().placement(at.base);
    gradient = base_world.linear() * surface->gradient(base_world.inverse() * p_tool_world);
  }
  const double length = gradient.norm();
  // Keeps the previous normal if the surface has none at this position.
  if (!(length > 1e-9)) return;
  command_.tools[tool].normal_world = gradient / length;
  error.set_surface(tool, *surface, command_.tools[tool].normal_world);
  const double depth = task->surface_depth(index);
  at.surface = *surface;
  at.depth = std::isfinite(depth) ? std::max(0.0, depth) : 0.0;
}

void MpcController::Impl::update() noexcept {
  const bool is_ready = prepare_plan();
  life_.begin();
  if (is_ready && planner_) {
    planner_->start();
    return;
  }
  if (is_ready) make_plan();
  finish_plan();
}

/// Sets the request and the inputs of a plan. Returns false if the problem rejects the torque
/// error.
bool MpcController::Impl::prepare_plan() noexcept {
  // Rounds delays to ticks, because a plan that is computed within a tick comes into use at a tick.
  // A plan that a thread finishes late comes into use at once: plans lose accuracy with age.
  const double exact = expected_ / spec.tick_period;
  const double ticks = spec.timing == PlanTiming::Thread ? std::max(1.0, std::round(exact))
                                                         : std::ceil(exact - 0.01);
  const double expected =
      spec.timing == PlanTiming::Fixed ? spec.solver_delay : ticks * spec.tick_period;
  request_ = std::exchange(next_, {});
  request_.first = !life_.follows();
  request_.now = gate.now();
  request_.schedule_time = schedule.time() + ahead_.lead();
  request_.delay = request_.first ? 0.0 : expected;
  result_ = {.warm = request_.warm};
  // The payloads were accepted by set_payload().
  payloads_.hand_over([&](std::string_view frame, const InertiaSpec& payload) {
    (void)problem.set_payload(frame, payload);
  });
  horizon.follow(schedule);
  inputs.set_support_friction(problem, grip.friction());
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    inputs.set_friction(problem, i, command_.tools[i].friction);
    inputs.set_force_error(problem, i, error.force_error()[static_cast<Eigen::Index>(i)]);
    if (tools_[i].surface) inputs.set_surface(problem, i, *tools_[i].surface, tools_[i].depth);
  }
  const bool is_ready = spec.model_error.kind != ModelErrorKind::Torque || set_torque_error();
  task->set_inputs(problem);
  x_plan_ = acting_state();
  if (!request_.warm) compute_rest_control();
  return is_ready;
}

/// Computes the controls that hold the robot in its present configuration.
void MpcController::Impl::compute_rest_control() noexcept {
  const Eigen::VectorXd* const rest = holding_.at_rest(gate.last().q);
  for (int i = 0; i < problem.layout().nu; ++i)
    u_plan_[i] = rest == nullptr ? 0.0 : (*rest)[problem.layout().actuated[to_size(i)]];
}

void MpcController::Impl::make_plan() noexcept {
  const auto began = std::chrono::steady_clock::now();
  try {
    if (planner_ && request_.delay > 0.0) in_use_.follow(policy);
    result_.usable = replan();
    if (result_.usable) policy.fill(solver, horizon.times());
  } catch (...) {
    // A function of the specification threw an exception, so this tick gives no plan.
    result_.thrown = std::current_exception();
    result_.warm = false;
  }
  result_.took = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Computes a plan that starts at the measured state, or at a state predicted from it. Returns
/// false if the plan is not usable.
bool MpcController::Impl::replan() {
  const double delay = request_.delay;
  // If the prediction fails, the plan starts at the measured state.
  if (delay > 0.0)
    (void)prediction_.advance(problem, horizon, planner_ ? in_use_ : policy,
                              {.start = request_.now + ahead_.lead(),
                               .schedule_start = request_.schedule_time,
                               .duration = delay},
                              x_plan_);
  if (!solve(request_.schedule_time + delay)) return false;
  const StateLayout& layout = problem.layout();
  const double at =
      std::min(horizon.times().place(error.joint_friction().lead()), problem.knots() - 1e-9);
  const int k = static_cast<int>(at);
  const auto xs = solver.xs();
  v_ahead_ = (xs.row(k) + (at - k) * (xs.row(k + 1) - xs.row(k))).segment(layout.nq, layout.nv);
  return true;
}

/// Accepts the result of a computed plan, in the first tick after the computation.
void MpcController::Impl::finish_plan() noexcept {
  life_.finish(result_.usable);
  next_.warm = result_.warm;
  const double took = result_.took * (spec.timing == PlanTiming::Measured ? spec.slowdown : 1.0);
  command_.solve_time = took;
  if (result_.thrown && !thrown) thrown = result_.thrown;
  if (result_.usable) {
    const DdpSummary& summary = solver.summary();
    command_.iterations = summary.iterations;
    command_.constraint_violation = summary.violation;
    command_.constraint_residual = summary.constraint_residual;
    command_.active_constraints = summary.active_constraints;
    command_.constraints_infeasible =
        summary.unsatisfiable_rows > 0 || summary.reason == StopReason::Infeasible;
    // The computation of the first plan takes no simulated time, because the robot is held.
    const bool takes_time = spec.timing == PlanTiming::Measured && !request_.first;
    const double done = request_.now + (takes_time ? took : 0.0);
    const double begin = request_.first ? gate.now() : request_.now + request_.delay;
    policy.offer(begin + ahead_.lead(), done + ahead_.lead(), request_.now);
    error.foresee(v_ahead_);
    if (takes_time) busy_until_ = done - 0.01 * spec.tick_period;
  } else {
    command_.status = worst(command_.status, Status::NotConverged);
    next_.jumped = next_.jumped || request_.jumped;
  }
  if (!request_.first) {
    constexpr double forgetting = 0.05;  // weight of a new duration in the moving average
    const bool in_thread = spec.timing == PlanTiming::Thread;
    const double seen = in_thread ? gate.now() - request_.now : took;
    const double mean = expected_ + forgetting * (seen - expected_);
    expected_ = in_thread ? mean : std::max(seen, mean);
  }
  const bool was_well = !fault.is_set();
  command_.missed_deadline = plans_.judge(gate.now(), result_.usable, request_.first, took, fault);
  if (!was_well || !fault.is_set()) return;
  life_.raise_fault();
  explain_failure();
}

void MpcController::Impl::await_plan() noexcept {
  if (planner_) planner_->wait();
}

bool MpcController::Impl::set_torque_error() noexcept {
  const double decay_time = spec.model_error.decay_time;
  if (std::isinf(decay_time))
    return inputs.set_torque_error(problem, error.torque_error(), decaying_, decay_time);
  decaying_ = error.torque_error() - error.lasting_error();
  return inputs.set_torque_error(problem, error.lasting_error(), decaying_, decay_time);
}

bool MpcController::Impl::solve(double schedule_time) {
  horizon.place(schedule_time);
  if (problem.set_initial_state(x_plan_) != Status::Ok) return false;
  int iterations = spec.solver.max_iterations;
  const bool plain = !request_.first && !request_.jumped && request_.warm;
  if (!plain) iterations = request_.first ? spec.first_iterations : spec.jump_iterations;
  if (request_.warm) {
    horizon.guess_shifted(x_plan_, solver, schedule_time);
    horizon.shift_limits(solver, schedule_time);
  } else {
    horizon.guess_rest(x_plan_, u_plan_);
  }
  result_.warm = false;
  solver.set_max_iterations(iterations);
  const int max_factorizations = plain ? spec.max_factorizations : spec.first_max_factorizations;
  solver.set_limit_budget(max_factorizations, max_factorizations);
  solver.set_guess({horizon.guess_x().data(), horizon.guess_u().data()});
  const DdpSummary& summary = solver.solve();
  if (!solver.us().allFinite() || !solver.xs().allFinite()) return false;
  result_.warm = true;
  horizon.solved_from(schedule_time);
  return summary.reason == StopReason::Converged || summary.reason == StopReason::Infeasible ||
         summary.reason == StopReason::MaxIterations ||
         (summary.reason == StopReason::NoStep && summary.unsatisfiable_rows > 0 &&
          summary.largest_gap <= solver.options().gap_tolerance) ||
         (summary.reason == StopReason::TimeBudget && summary.iterations > 0);
}

/// Sets x_ to the measured state and returns it.
const Eigen::VectorXd& MpcController::Impl::measured_state() noexcept {
  const StateLayout& layout = problem.layout();
  const Measurement& m = gate.last();
  x_.head(layout.nq) = m.q;
  x_.segment(layout.nq, layout.nv) = m.v;
  // Subtracts the torque offset, which the torque error already contains, from the measured
  // torques. The differences are the torques that the filter computes from the command alone.
  for (int i = 0; i < layout.filtered; ++i) {
    const int k = layout.actuated[to_size(i)];
    x_[layout.nq + layout.nv + i] = m.tau[k] - error.torque_offset()[k];
  }
  return x_;
}

/// Sets x_ to the state in which the command of this tick will act. It is the measured state,
/// integrated with the torques already sent.
const Eigen::VectorXd& MpcController::Impl::acting_state() noexcept {
  if (ahead_.ticks() == 0) return measured_state();
  if (is_ahead_) return x_;
  (void)measured_state();
  const double time = schedule.time() + ahead_.lead();
  const int stage = horizon.stage_of(schedule.phase_at(time));
  for (std::size_t i = 0; i < tools_.size(); ++i)
    predicted_tools_[i].normal_world = command_.tools[i].normal_world;
  // If the prediction fails, x_ stays at the measured state.
  (void)ahead_.predict(error.contacts(), gate,
                       {.stage = stage,
                        .schedule_time = time,
                        .torque_error = error.modelled_error(),
                        .tools = predicted_tools_},
                       x_);
  is_ahead_ = true;
  return x_;
}

void MpcController::Impl::control() noexcept {
  policy.take_over(acting_time());
  policy.control(acting_time(), acting_state(), u_);
  if (!u_.allFinite()) {
    command_.status = worst(command_.status, Status::NotFinite);
    fall_back();
    return;
  }
  command_.tau.setZero();
  error.joint_friction().advance(spec.tick_period);
  for (int i = 0; i < problem.layout().nu; ++i) {
    const int k = problem.layout().actuated[to_size(i)];
    const double friction = error.joint_friction().torque()[k];
    policy.add_feedforward(i, friction);
    command_.tau[k] = u_[i] + friction + error.force_feedback()[k];
  }
  holding_.soles().keep(gate.wrenches(), command_.tau);
  holding_.release();
}

void MpcController::Impl::fall_back() noexcept {
  holding_.set_failed_motor(motors_.lost());
  if (!gate.is_fresh()) gate.fade_velocity(std::exp(-spec.fallback.damping * spec.tick_period));
  holding_.torque(gate.last().q, gate.last().v, gate.is_fresh(), gate.wrenches(), command_.tau);
  error.joint_friction().rest();
}

/// Clips the torque to the effort limits. `controls`: true for a torque by the policy, to which the
/// additional limits MpcSpec::torque_limit apply; false for a torque by the fallback.
void MpcController::Impl::limit_torque(bool controls) noexcept {
  const Eigen::VectorXd& effort = spec.problem.model.effort_limit;
  const bool is_cut = controls && spec.torque_limit.size() > 0;
  for (Eigen::Index k = 0; k < command_.tau.size(); ++k) {
    const double wanted = std::isfinite(command_.tau[k]) ? command_.tau[k] : 0.0;
    const double max_torque = is_cut ? std::min(effort[k], spec.torque_limit[k]) : effort[k];
    command_.tau[k] = std::clamp(wanted, -max_torque, max_torque);
    command_.clipped_torques += command_.tau[k] != wanted;
  }
}

void MpcController::Impl::set_targets() noexcept {
  command_.phase = schedule.phase();
  if (fault.is_set()) {
    for (ToolCommand& tool : command_.tools) tool.target_force = 0.0;
    return;
  }
  try {
    task->aim(schedule.time(), command_);
  } catch (...) {
    keep_exception();
    command_.status = worst(command_.status, Status::NotEvaluated);
  }
}

/// Keeps an exception, unless one was kept before. Must be called within an exception handler.
void MpcController::Impl::keep_exception() noexcept {
  if (!thrown) thrown = std::current_exception();
}

}  // namespace burnish
