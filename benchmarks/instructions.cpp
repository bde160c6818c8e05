// Fixed work between marks for valgrind's callgrind. scripts/instructions counts the instructions
// of this work and compares the counts with instruction_budgets.txt. The program itself measures
// nothing.
#include <valgrind/callgrind.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/estimate/estimated_base.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/sim/sensing.hpp"
#include "burnish/solver/ddp.hpp"
#include "burnish/tasks/polishing/stages.hpp"
#include "burnish/tasks/stand/stand.hpp"
#include "cases.hpp"
#include "chain.hpp"
#include "polishing/reference_problem.hpp"
#include "pressing/standing_terms.hpp"
#include "support/standing_problem.hpp"

namespace burnish::bench {
namespace {

constexpr int knots = 100;

/// Counts the instructions of the second execution of `work`, when caches and memory are set up.
void count(const std::string& name, const std::function<void()>& work) {
  work();
  CALLGRIND_ZERO_STATS;
  CALLGRIND_TOGGLE_COLLECT;
  work();
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  std::printf("%s\n", name.c_str());
}

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(what + ": the counted work failed");
}

/// Counts the instructions for 64 states in packs, and for one state alone.
void count_kernels(const Case& what) {
  const std::string name = what.label + "/" + what.contact;
  const Model& model = model_of(what.robot);
  const States states = states_near_reference(what.robot, 64);
  ContactDynamicsBatch batch(model, what.specs("centered"), 64);
  count("derivatives of 64 states/" + name, [&] {
    require(batch.forward_with_derivatives(states.q, states.v, states.tau) == Status::Ok, name);
  });
  ContactDynamics single(model, what.specs("centered"));
  count("derivatives of one state/" + name, [&] {
    require(single.forward(states.q.col(0), states.v.col(0), states.tau.col(0)) == Status::Ok &&
                single.forward_derivatives() == Status::Ok,
            name);
  });
}

/// Counts the instructions for 64 states of a chain that is long enough for the articulated-body
/// algorithm.
void count_chain(int joints) {
  const std::string name = "derivatives of 64 states/chain of " + std::to_string(joints);
  const Model model = chain(joints);
  const Eigen::MatrixXd q = chain_configurations(model, 64);
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(model.nv, 64);
  ContactDynamicsBatch batch(model, {chain_tip(joints)}, 64);
  count(name, [&] { require(batch.forward_with_derivatives(q, zero, zero) == Status::Ok, name); });
}

/// Counts the instructions of one solver iteration, as at each step of a controller. Every
/// execution starts from the same guess.
void count_iteration(const std::string& name, const ProblemSpec& spec, StepUpdate update) {
  Problem problem(spec);
  DdpSolver solver(problem, {.update = update, .max_iterations = 1});
  const Eigen::Map<const Eigen::VectorXd> x0(problem.initial_state(), problem.state().nx);
  const RowMatrix xs = x0.transpose().replicate(knots + 1, 1);
  const RowMatrix us = problem.quasi_static(0, x0).control.transpose().replicate(knots, 1);
  count(name, [&] {
    solver.set_guess({xs.data(), us.data()});
    require(solver.solve().iterations == 1, name);
  });
}

ProblemSpec polishing(bool filter) {
  const Robot robot = load_robot("talos:right_arm");
  ProblemSpec spec =
      polishing::reference_problem(robot.model, "tool", robot.posture("table"), knots);
  if (!filter) return spec;
  spec.torque_model = TorqueModel{.cutoff = 100.0};
  const Eigen::Index nx = spec.initial_state.size();
  spec.initial_state.conservativeResize(nx + robot.model.nv);
  spec.initial_state.tail(robot.model.nv).setZero();
  return spec;
}

/// Returns the polishing problem with limits on range, speed and torque of every joint, and on the
/// sign of the force. `effort_fraction`: fraction of the effort limits; many limits are active if
/// it is too small to hold the posture.
ProblemSpec limited_polishing(double effort_fraction) {
  ProblemSpec spec = polishing(false);
  const auto is_barrier = [](const CostTerm& term) { return term.name.ends_with(" limits"); };
  Stage& press = spec.stages.front();
  std::erase_if(press.costs, is_barrier);
  std::erase_if(spec.terminal, is_barrier);
  const Model& model = spec.model;
  const Eigen::VectorXd max_torque = effort_fraction * model.effort_limit;
  spec.terminal_constraints = {{.name = "range",
                                .residual = residual::JointPosition{},
                                .lower = model.q_lower,
                                .upper = model.q_upper},
                               {.name = "speed",
                                .residual = residual::JointVelocity{},
                                .lower = -model.velocity_limit,
                                .upper = model.velocity_limit}};
  press.constraints = spec.terminal_constraints;
  press.constraints.push_back({.name = "torque",
                               .residual = residual::Control{},
                               .lower = -max_torque,
                               .upper = max_torque});
  press.constraints.push_back({.name = "pull",
                               .residual = residual::ContactForce{"surface"},
                               .lower = Eigen::VectorXd::Zero(1)});
  return spec;
}

/// Counts the instructions of one tick that starts no plan: of the controller and, if `base` is
/// set, of the estimate of the base. Before this tick, the controller follows plans in `phase` for
/// 50 ticks. `sense`: returns the measurement after a tick with the torques `tau`.
void count_tick(const std::string& name, const MpcSpec& spec, int phase,
                std::optional<EstimatedBase> base,
                const std::function<const Measurement&(const Eigen::VectorXd& tau)>& sense) {
  MpcController controller(spec);
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(spec.problem.model.nv);
  const auto tick = [&](const Measurement& measured) {
    tau = controller.tick(base ? base->update(measured) : measured).tau;
  };
  for (int in_phase = 0, ticks = 0; in_phase < 50; ++ticks) {
    tick(sense(tau));
    const bool has_plan = std::isfinite(controller.plan_age());
    in_phase += has_plan && controller.schedule().phase() == phase ? 1 : 0;
    require(controller.fault().kind == FaultKind::None && ticks < 10000, name);
  }
  Measurement measured = sense(tau);
  count(name, [&] {
    tick(measured);
    measured.time += spec.tick_period;
  });
}

/// Counts the instructions of a tick of an arm that polishes. Plans are short and rare, because
/// their instructions are not counted.
void count_arm_tick() {
  polishing::Task task;
  task.reach_duration = task.ramp_duration = 0.1;
  task.clearance = 2e-3;
  task.horizon = 0.1;
  task.update_rate = 25.0;
  const polishing::Setting setting = polishing::make_setting(task);
  const MpcSpec spec = polishing::make_mpc(task, setting);
  constexpr int steps = 2;  // steps of the plant per tick
  const std::unique_ptr<Plant> plant =
      make_ideal_plant(spec.problem.model, setting.scene, {.dt = spec.tick_period / steps});
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(spec.problem.model.nv);
  require(plant->reset(setting.q_start, rest) == Status::Ok, "arm");
  Sensing sensing(spec.problem.model, {}, setting.scene, touches_of(spec), spec.tick_period);
  count_tick("tick without a plan/arm", spec, number_of(Phase::Track), std::nullopt,
             [&](const Eigen::VectorXd& tau) -> const Measurement& {
               for (int k = 0; k < steps; ++k) require(is_usable(plant->step(tau)), "arm");
               return sensing.measure(*plant, tau);
             });
}

/// Counts the instructions of a tick of Talos, which stands on its feet and whose base is
/// estimated. The robot stands still in all measurements, and each foot carries half of its weight.
void count_standing_tick() {
  stand::Task task;
  task.robot = "talos";
  task.posture = "standing_board";
  task.standing.feet = {"left_sole_link", "right_sole_link"};
  task.standing.half_x = 0.1;
  task.standing.half_y = 0.065;
  task.horizon = 0.2;
  task.knots = 8;
  task.update_rate = 25.0;
  const stand::Setting setting = stand::make_setting(task);
  MpcSpec spec = stand::make_mpc(task, setting);
  spec.settle = 0.01;
  const Model& model = spec.problem.model;
  const auto estimator = pressing::base_estimator(setting.standing);
  require(estimator.has_value(), "standing Talos");
  EstimatedBase base(model, *estimator, pressing::foot_contact_options(model));
  Measurement measured;
  measured.q = setting.q_start;
  measured.v = measured.tau = Eigen::VectorXd::Zero(model.nv);
  measured.imu = ImuReading{Eigen::Vector3d::Zero(), -model.gravity};
  measured.wrenches.setZero(6, 2);
  measured.wrenches.row(2).setConstant(0.5 * model.total_mass() * model.gravity.norm());
  require(base.reset(measured.q, measured.v) == Status::Ok, "standing Talos");
  count_tick("tick without a plan/standing Talos", spec, 0, std::move(base),
             [&](const Eigen::VectorXd& tau) -> const Measurement& {
               measured.tau = tau;
               measured.time += spec.tick_period;
               return measured;
             });
}

void count_all() {
  count_arm_tick();
  count_standing_tick();
  for (const Case& what : cases()) {
    const bool arm = what.label == "talos_right_arm" && what.contact == "1D";
    if (arm || (what.label == "arm7" && what.contact == "6D") || what.label == "talos")
      count_kernels(what);
  }
  count_chain(50);
  count_iteration("iteration/polishing/shooting", polishing(false), StepUpdate::MultipleShooting);
  count_iteration("iteration/polishing/rollout", polishing(false), StepUpdate::Rollout);
  count_iteration("iteration/limits far away/shooting", limited_polishing(1.0),
                  StepUpdate::MultipleShooting);
  count_iteration("iteration/limits that push/shooting", limited_polishing(0.1),
                  StepUpdate::MultipleShooting);
  count_iteration("iteration/torque filter/shooting", polishing(true),
                  StepUpdate::MultipleShooting);
  const Robot talos = load_robot("talos");
  const ProblemSpec standing = test::standing_problem(
      talos.model, {"left_sole_link", "right_sole_link"}, talos.posture("half_sitting"), knots);
  count_iteration("iteration/whole body/rollout", standing, StepUpdate::Rollout);
}

}  // namespace
}  // namespace burnish::bench

int main() {
  try {
    burnish::bench::count_all();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "instructions: %s\n", error.what());
    return 1;
  }
}
