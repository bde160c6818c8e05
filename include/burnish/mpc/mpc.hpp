// Model predictive control of a task: an optimal control problem over a moving horizon is solved
// repeatedly from the measured state. Tasks are defined by mpc/task.hpp.
#pragma once

#include <exception>
#include <memory>
#include <vector>

#include "burnish/mpc/controller.hpp"
#include "burnish/mpc/fault.hpp"
#include "burnish/mpc/feedback.hpp"
#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/ocp/problem.hpp"

namespace burnish {

class DdpSolver;

/// Model predictive controller after section IV of Kleff et al. (see docs/frames.md), with
/// extensions.
///
/// Call tick() once per `tick_period` with the current measurement. reset() restores the state of a
/// new controller, except for payloads. With PlanTiming::Fixed, the same measurements after a
/// reset() give bitwise the same torques. The first measurement may have any time. The schedule's
/// clock starts with this measurement.
///
/// The first solve may take long: it runs until it converges or reaches `first_iterations`. With
/// PlanTiming::Thread, MpcSpec::fallback holds the robot during the first solve, and the schedule's
/// clock stands still. With PlanTiming::Measured and PlanTiming::Thread, an update that is due
/// waits until the previous plan is finished.
///
/// Steps of a tick:
///  1. The measurement is checked.
///  2. The model error is estimated, with the torque commanded at the previous tick. The forces at
///     the tools are estimated from torques, positions and velocities by forward dynamics.
///  3. The schedule's clock advances, with the events that the task detected.
///  4. The limits of the controller are checked, then the limits of the task.
///  5. When an update is due, the stages and targets of the horizon are set, and the problem is
///     solved from the measured state, with the last solution as warm start. With a `solver_delay`,
///     the problem is solved from the state predicted for the end of the delay.
///  6. The policy computes the torque, which is clipped to the torque limits.
/// If commands or measurements have a delay, steps 5 and 6 use the state that is predicted for the
/// time when the torque acts.
///
/// Plans satisfy the constraints of the problem as far as `max_factorizations` recursions suffice.
/// Command::constraint_residual is the remaining residual, and Command::constraint_violation is the
/// violation along the plan. Torques are clipped to `torque_limit` before they are sent. If the
/// hard constraints cannot all be satisfied from the measured state on, their violation is
/// penalized with the L1 penalty weight `solver.limits.l1_weight`. The controller follows the
/// resulting plan and sets Command::constraints_infeasible.
///
/// After an invalid measurement (NaN, wrong size, or a time that does not increase), the policy
/// continues from the last valid measurement until SafetyLimits::bad or SafetyLimits::stale has
/// passed. If an update fails, the previous plan stays in use. The first fault activates the
/// fallback until reset(). fault() then returns the fault with a record of the last second. The
/// fallback also computes the torque before the first plan. The torque is always finite.
///
/// Ticks do not throw. They allocate only if functions in the specification (targets, residuals,
/// the solver's callback) allocate. Exceptions of targets and residuals are caught, in any thread
/// of the solver. The update then counts as failed, and take_exception() returns the exception. If
/// the problem has a torque model, the command is the input of the model's low-pass filter. The
/// actuators must then have the lag of this filter.
class MpcController final : public Controller {
 public:
  /// Creates the controller. Throws Error, whose text names entry, value and requirement, for:
  /// - stages that are impacts or have different steps, a horizon of at most two update periods,
  ///   force_states, and the torque model 'held';
  /// - periods, delays, limits or numbers of iterations out of range;
  /// - frames, supports or resting supports that do not exist, and two touches at one frame;
  /// - a support without a sensor that is not in contact in every stage, a support that holds
  ///   rotations and whose sensor measures only force, and a resting support without a sensor;
  /// - a contact of a stage that is neither a support, nor a loop, nor at a tool;
  /// - two tools at one frame, and an unknown frame of a tool or of its surface;
  /// - a tool without a force sensor, unless it is the only tool and model_error.kind is `torque`;
  /// - anything that Problem, DdpSolver or MpcSpec::task rejects.
  explicit MpcController(MpcSpec spec);
  ~MpcController() override;

  int nv() const override;
  /// Returns the result of touch_sensors() for the specification.
  std::optional<std::vector<TouchSensor>> touches() const override;
  std::vector<std::string> tools() const override;
  /// Returns names and units of estimates, followed by the signals of the task. The estimates are
  /// those that change plans and have no entry in Command:
  /// - torque_error(), as `torque_error_<joint>` of actuated joints, with ModelErrorKind::Torque;
  /// - force_error(), as `force_error_<tool>`, with ModelErrorKind::Force;
  /// - support_friction(), as `friction_<support>`, for supports with a friction cone.
  std::vector<TraceColumn> signals() const override;
  void write_signals(std::span<double> values) const noexcept override;
  void reset() noexcept override;
  const Command& tick(const Measurement& measurement) noexcept override;

  /// Sets the payload that the robot carries from the next tick on. `payload`: inertia in the axes
  /// of `frame`. A previous payload of the same body is replaced, and reset() keeps the payload.
  /// Estimators and the fallback use the new payload from the next tick on. Plans use the new
  /// payload from the next plan on. Call set_payload() between ticks. The call does not allocate.
  ///
  /// If check_inertia() reports NotFinite or NotPhysical, returns that status and changes nothing;
  /// otherwise returns Ok. Throws Error for an unknown frame, with the nearest name, and for a
  /// frame that is fixed to the world.
  ///
  /// If an EstimatedBase estimates the base, call its set_payload(), too; ClosedLoop::set_payload()
  /// makes both calls. While the payload masses of estimator and controller differ, Command::status
  /// is NotPhysical and the fallback holds the robot.
  Status set_payload(std::string_view frame, const InertiaSpec& payload) override;
  double payload_mass() const noexcept override;

  /// Returns the first fault since reset(). FaultReport::kind is None if there was no fault.
  const FaultReport& fault() const;
  /// Returns and clears the first exception that a function of the specification threw since
  /// reset() or since the previous call of take_exception(); null if there was none.
  std::exception_ptr take_exception() noexcept;
  /// Returns the feedback policy of the last tick: feedforward torque, gains, and the state at
  /// which the policy is linearized.
  const LinearFeedback& feedback() const;
  /// Returns the estimated torque error, nv entries [Nm, or N]. The torque error is the sum of the
  /// observer's estimate and the joint torques due to friction along the surfaces. The friction of
  /// a tool is the estimated ratio of friction to normal force, times the target force.
  const Eigen::VectorXd& torque_error() const;
  /// Returns the estimated error of the normal force at each tool [N]. This error is estimated only
  /// with ModelErrorKind::Force.
  const Eigen::VectorXd& force_error() const;
  /// Returns the coefficients of friction that plans use for supports (see SlipOptions). Only
  /// supports in contact in every stage have an entry, in the order of ProblemSpec::contacts. If a
  /// support has no friction cone, its entry is infinite.
  const Eigen::VectorXd& support_friction() const;
  const Schedule& schedule() const;
  /// Returns the time since the measurement from which the plan in use was computed [s]; infinite
  /// if there is no plan.
  double plan_age() const;
  const Problem& problem() const;
  /// Returns the states of the most recent plan, (N + 1) x nx for N knots. With a solver delay, the
  /// most recent plan may not be in use yet. Do not call this function while a thread computes a
  /// plan (PlanTiming::Thread).
  MatrixView plan() const;
  /// Returns the solver, which contains the trajectory, gains and value function of the most recent
  /// plan. Do not call this function while a thread computes a plan (PlanTiming::Thread).
  const DdpSolver& solver() const;
  /// Returns the cost of each term at `knot` of the most recent plan, in the order of
  /// problem().term_names(knot). Costs are multiplied by the knot's step. Throws Error for a knot
  /// out of range. Allocates, so do not call this function in ticks or while a thread computes a
  /// plan.
  std::vector<double> plan_costs(int knot);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
