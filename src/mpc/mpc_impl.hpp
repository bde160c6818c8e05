// Implementation of MpcController: its parts, and the steps of a tick.
#pragma once

#include <exception>
#include <vector>

#include "base/background_work.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"
#include "dynamics/payloads.hpp"
#include "estimate/error_estimate.hpp"
#include "estimate/support_grip.hpp"
#include "mpc/black_box.hpp"
#include "mpc/delayed_state.hpp"
#include "mpc/fault_latch.hpp"
#include "mpc/holding.hpp"
#include "mpc/horizon.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/plan_inputs.hpp"
#include "mpc/plan_life.hpp"
#include "mpc/prediction.hpp"
#include "mpc/watch.hpp"

namespace burnish {

struct MpcController::Impl {
  explicit Impl(MpcSpec given);

  void reset() noexcept;
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  double payload_mass() const noexcept { return payloads_.mass(); }
  const Command& tick(const Measurement& m) noexcept;
  std::vector<TraceColumn> signals() const;
  void write_signals(std::span<double> values) const noexcept;

 private:
  template <class See>
  void each_signal(const See& see) const;
  void reset_inputs() noexcept;
  // Steps of a tick.
  bool has_settled() const noexcept;
  void process_measurement() noexcept;
  void reset_tools() noexcept;
  void rotate_normals() noexcept;
  void update_surface(std::size_t tool) noexcept;
  void watch(const TaskView& view) noexcept;
  void explain_lag() noexcept;
  void explain_failure() noexcept;
  void update() noexcept;
  bool prepare_plan() noexcept;
  bool set_torque_error() noexcept;
  void compute_rest_control() noexcept;
  void make_plan() noexcept;
  bool replan();
  void finish_plan() noexcept;
  void await_plan() noexcept;
  bool solve(double schedule_time);
  void control() noexcept;
  void fall_back() noexcept;
  void limit_torque(bool controls) noexcept;
  void set_targets() noexcept;
  void keep_exception() noexcept;
  const Eigen::VectorXd& measured_state() noexcept;
  const Eigen::VectorXd& acting_state() noexcept;
  /// Returns the time at which the command of this tick acts [s]. A plan that starts at or before
  /// this time can come into use.
  double acting_time() const noexcept { return gate.now() + ahead_.lead(); }

  int ticks_per_update_;

 public:
  MpcSpec spec;
  std::unique_ptr<MpcTask> task;
  Problem problem;
  DdpSolver solver;
  Schedule schedule;
  FaultLatch fault;
  MeasurementGate gate;
  ErrorEstimate error;
  SupportGrip grip;
  Horizon horizon;
  PlanInputs inputs;
  Policy policy;
  std::exception_ptr thrown;  ///< First exception thrown by a function of the specification.

 private:
  /// Request of a plan. Ticks set `due` and `jumped`, the previous result sets `warm`, and
  /// prepare_plan() sets the rest.
  struct PlanRequest {
    bool due = false;
    bool jumped = false;  ///< True if the schedule's clock jumped since the last usable plan.
    bool warm = false;    ///< True if the solver's last trajectory can be the initial guess.
    bool first = false;   ///< True if no plan is followed yet.
    /// Time of the measurement from which the plan is computed, time of the schedule when the
    /// command acts, and assumed delay of the plan [s].
    double now = 0.0, schedule_time = 0.0, delay = 0.0;
  };
  /// Result of a request.
  struct PlanResult {
    bool usable = false;
    bool warm = false;  ///< Value of PlanRequest::warm for the next plan.
    double took = 0.0;  ///< Duration of the computation [s].
    std::exception_ptr thrown = {};
  };
  PlanLife life_;
  PlanRequest next_;  ///< Request of the next plan, filled in by ticks.
  /// Request and result of the last plan that was begun. During the computation, only the computing
  /// thread may use result_, the problem, the solver, the horizon, the prediction and the policy's
  /// next plan. request_ and the plan in use stay unchanged.
  PlanRequest request_;
  PlanResult result_;
  Policy in_use_;  ///< Copy of the policy in use when the computation started.
  Payloads payloads_;
  double expected_;  ///< Expected duration of the computation of a plan [s].
  /// With PlanTiming::Measured: simulated time at which the computation of the previous plan ends
  /// [s].
  double busy_until_ = -std::numeric_limits<double>::infinity();
  /// Tool, with the surface that the task last returned.
  struct Tool {
    int frame;
    int base;  ///< Frame of the robot that carries the surface; -1: the world.
    std::optional<Quadric> surface = {};
    double depth = 0.0;  ///< Depth by which the surface yields [m].
  };
  std::vector<Tool> tools_;
  Prediction prediction_;
  DelayedState ahead_;
  Holding holding_;
  PlanWatch plans_;
  MotorWatch motors_;
  BlackBox black_box_;
  std::vector<WatchedQuantity> watched_;
  std::size_t task_signals_;       ///< Number of signals of the task.
  std::vector<Reading> readings_;  ///< Present values of the quantities in watched_.
  Command command_;
  Eigen::VectorXd target_forces_;  ///< ToolCommand::target_force of each tool [N].
  std::vector<DelayedState::PredictionTool> predicted_tools_;
  Eigen::VectorXd x_, u_, v_ahead_, decaying_;
  /// First state of the plan (x_plan_), and control that holds the robot at rest (u_plan_).
  Eigen::VectorXd x_plan_, u_plan_;
  long tick_ = 0;
  double began_ = 0.0;     ///< Time of the first measurement [s].
  bool is_ahead_ = false;  ///< True if x_ is the predicted state in which this tick's command acts.
  /// Thread for PlanTiming::Thread. It is the last member, so that it ends before the others are
  /// destroyed.
  std::unique_ptr<BackgroundWork> planner_;
};

}  // namespace burnish
