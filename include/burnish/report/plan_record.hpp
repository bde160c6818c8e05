// Record of a model predictive controller's plans, sampled during a run.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace burnish {

class MpcController;
struct Command;

/// Values at the first knot of each recorded plan. The Riccati gains and the derivatives of the
/// value function come from the solver's last backward pass.
struct PlanStart {
  int nx = 0, ndx = 0, nu = 0;
  /// State at the first knot, plans x nx
  std::vector<double> x = {};
  /// Control at the first knot, plans x nu
  std::vector<double> u = {};
  /// Riccati gains at the first knot, plans x nu x ndx
  std::vector<double> K = {};
  /// Gradient of the value function at the first knot, plans x ndx
  std::vector<double> Vx = {};
  /// Hessian of the value function at the first knot, plans x ndx x ndx
  std::vector<double> Vxx = {};
};

/// Plans that a PlanRecorder copied from a controller; empty if there were no plans.
struct PlanRecord {
  /// Time of each plan's first knot [s]
  std::vector<double> time = {};
  /// Names of the cost terms of all stages that occur in the plans
  std::vector<std::string> terms = {};
  /// Cost of each term in each plan, terms x plans. Each cost is a sum over all knots of the plan,
  /// including the terminal knot.
  std::vector<std::vector<double>> costs = {};
  int knots = 0;  ///< Number of recorded knots per plan
  int nq = 0;
  double step = 0.0;          ///< Time between recorded knots [s]
  std::vector<float> q = {};  ///< Configurations, plans x knots x nq
  PlanStart start = {};
};

/// Copies plans from a controller at a limited rate. The recording does not change the controller's
/// behaviour.
class PlanRecorder {
 public:
  /// Creates a recorder for `controller`. The controller must outlive the recorder.
  /// - `step` is the time between the plan's knots [s]. If the knots are not evenly spaced, `step`
  ///   is not used, and states are interpolated at even times.
  /// - `solver_delay` is the time from a measurement to the first knot of its plan [s]. For the
  ///   first plan this time is zero.
  /// - `rate` is the largest rate of recorded plans [Hz]. If it is 0, nothing is recorded.
  PlanRecorder(MpcController& controller, double step, double solver_delay, double rate);
  /// Copies the controller's plan if the plan is new and the recording rate permits another record.
  /// Call look() after each tick. `time` is the time of the measurement [s], and `command` is the
  /// command from the tick.
  void look(double time, const Command& command);
  PlanRecord take() { return std::move(record_); }

 private:
  void add_states();
  void add_start();
  void add_costs();
  void find_terms(std::size_t stage, int knot);

  MpcController& controller_;
  double delay_, period_;
  /// Number of plan knots per recorded knot; 0 if the plan's knots are not evenly spaced
  int stride_ = 0;
  /// Earliest time at which the next plan is recorded [s]
  double next_ = 0.0;
  /// Time of the last call of look() [s]
  double last_ = -1.0;
  /// Indices of each stage's cost terms in record_.terms
  std::vector<std::vector<std::size_t>> term_of_;
  PlanRecord record_;
};

}  // namespace burnish
