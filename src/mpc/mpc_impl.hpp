// The parts of an MpcController and what a tick does with them.
#pragma once

#include <exception>
#include <vector>

#include "base/background_work.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"
#include "mpc/black_box.hpp"
#include "mpc/delayed_state.hpp"
#include "mpc/error_estimate.hpp"
#include "mpc/fault_latch.hpp"
#include "mpc/holding.hpp"
#include "mpc/horizon.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/prediction.hpp"
#include "mpc/support_grip.hpp"
#include "mpc/watch.hpp"

namespace burnish {

struct MpcController::Impl {
  explicit Impl(MpcSpec given);

  void reset() noexcept;
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  const Command& tick(const Measurement& m) noexcept;
  bool carries_payload() const noexcept;
  void expect_estimated_base() noexcept { base_is_estimated_ = true; }

 private:
  // The steps of a tick.
  bool has_settled() noexcept;
  void see() noexcept;
  void turn_normal() noexcept;
  void look_at_surface() noexcept;
  void watch(const TaskView& view) noexcept;
  void explain_lag() noexcept;
  void explain_failure() noexcept;
  void update() noexcept;
  bool prepare_plan() noexcept;
  bool tell_torque_error() noexcept;
  void look_ahead() noexcept;
  void make_plan() noexcept;
  bool replan();
  void finish_plan() noexcept;
  void await_plan() noexcept;
  bool solve(double schedule_time);
  void control() noexcept;
  void fall_back() noexcept;
  void limit_torque(bool controls) noexcept;
  void aim() noexcept;
  void keep_exception() noexcept;
  const Eigen::VectorXd& measured_state() noexcept;
  const Eigen::VectorXd& acting_state() noexcept;
  /// s, when the command of this tick acts; plans are in use by that time.
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
  Policy policy;
  std::exception_ptr thrown;  ///< by a function of the specification, first of all

 private:
  /// A plan that is being made, and what came of it. While it is, the problem, the solver, the
  /// horizon, the prediction and the place of the policy's next plan are its maker's alone, and the
  /// plan in use stays what it is.
  struct Making {
    double now = 0.0, schedule_time = 0.0, delay = 0.0;  ///< s, of the measurement that it is from
    bool first = false, jumped = false;
    bool usable = false;
    double took = 0.0;  ///< s
    std::exception_ptr thrown = {};
  };
  Making making_;
  Policy in_use_;                   ///< as it was when the plan was begun
  std::vector<char> loaded_;        ///< per joint: its body carries a payload
  bool base_is_estimated_ = false;  ///< by an EstimatedBase, at a tick or as was said
  double expected_;                 ///< s that a plan takes, about
  /// s, of measured timing
  double busy_until_ = -std::numeric_limits<double>::infinity();
  bool is_making_ = false;
  std::optional<Quadric> surface_;
  double depth_ = 0.0;
  Prediction prediction_;
  DelayedState ahead_;
  Holding holding_;
  PlanWatch plans_;
  MotorWatch motors_;
  BlackBox black_box_;
  std::vector<WatchedQuantity> watched_;
  std::vector<Reading> readings_;  ///< of watched_
  int tool_;                       ///< frame
  int base_;                       ///< frame that the surface moves with; -1: the world
  Command command_;
  Eigen::VectorXd x_, u_, v_ahead_, passing_;
  Eigen::VectorXd x_plan_, u_plan_;  ///< where the plan begins; at rest
  long tick_ = 0;
  double began_ = 0.0;                       ///< s, the first measurement
  bool due_ = false;                         ///< an update
  bool is_ahead_ = false;                    ///< x_ is the acting state of this tick
  bool solved_ = false;                      ///< there is a plan
  bool warm_ = false;                        ///< the solver's trajectory can be started from
  bool jumped_ = false;                      ///< the schedule's clock, since the last plan
  std::unique_ptr<BackgroundWork> planner_;  ///< of timing by a thread; the last: it ends first
};

}  // namespace burnish
