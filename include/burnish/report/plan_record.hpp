// The plans of model predictive control, now and then along a run.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace burnish {

class MpcController;
struct Command;

/// Where plans start, per plan, and what the solver's last backward pass says there.
struct PlanStart {
  int nx = 0, ndx = 0, nu = 0;
  std::vector<double> x = {};    ///< plans x nx: the state that the plan was made for
  std::vector<double> u = {};    ///< plans x nu, of the first knot
  std::vector<double> K = {};    ///< plans x nu x ndx: Riccati gains of the first knot
  std::vector<double> Vx = {};   ///< plans x ndx: gradient of the value function there
  std::vector<double> Vxx = {};  ///< plans x ndx x ndx: its Hessian
};

/// Empty without plans.
struct PlanRecord {
  std::vector<double> time = {};        ///< s, of each plan's first knot
  std::vector<std::string> terms = {};  ///< of the costs of all stages that were planned with
  /// Per term and plan: summed over the plan, terminal costs included.
  std::vector<std::vector<double>> costs = {};
  int knots = 0;  ///< of a plan that are kept
  int nq = 0;
  double step = 0.0;          ///< s between the knots that are kept
  std::vector<float> q = {};  ///< plans x knots x nq
  PlanStart start = {};
};

/// Copies plans out of a controller, without changing what it does.
class PlanRecorder {
 public:
  /// step: s, of a plan's knots where they are all as long; where they are not, states between them
  /// are kept, evenly in time. rate: Hz, at most; 0: nothing is recorded. The controller must
  /// outlive the recorder.
  PlanRecorder(MpcController& controller, double step, double solver_delay, double rate);
  /// To be called behind ticks, with the measurement's time (s) and the command. Where a plan was
  /// made and one is due it is copied.
  void look(double time, const Command& command);
  PlanRecord take() { return std::move(record_); }

 private:
  void add_states();
  void add_start();
  void add_costs();
  void find_terms(std::size_t stage, int knot);

  MpcController& controller_;
  double delay_, period_;
  int stride_ = 0;     ///< knots of the plan per one that is kept; 0: they are of different lengths
  double next_ = 0.0;  ///< s, when the next one is due
  double last_ = -1.0;                             ///< s, of the last tick that was looked at
  std::vector<std::vector<std::size_t>> term_of_;  ///< per stage: its terms among the record's
  PlanRecord record_;
};

}  // namespace burnish
