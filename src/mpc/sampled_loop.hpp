// The loop that a controller closes around an arm, linear and sampled at the controller's ticks.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "burnish/mpc/margins.hpp"
#include "mpc/plan_slopes.hpp"

namespace burnish {

/// Whether a contact holds the tool in the stage of a phase, an index of `spec.schedule`.
bool presses_in(const MpcSpec& spec, int phase);

/// What the loop remembers from tick to tick, a row per entry. The columns are as many states at
/// once.
struct LoopState {
  Eigen::MatrixXd q, v;                   ///< Of the plant.
  Eigen::MatrixXd q_before, v_measured;   ///< Of the velocity's difference and filter.
  Eigen::MatrixXd force, force_measured;  ///< Along the normal.
  Eigen::MatrixXd v_observed, error;      ///< Of the model-error observer.
  Eigen::MatrixXd late;                   ///< Torques beyond gravity, behind the observer's lag.
  Eigen::MatrixXd told;                   ///< Torque error that the plan in use was told.
  Eigen::MatrixXd command, motor;
  Eigen::MatrixXd acted, offset;       ///< Of a torque model.
  std::vector<Eigen::MatrixXd> queue;  ///< Commands on their way to the motors.

  std::vector<Eigen::MatrixXd*> blocks();
};

class SampledLoop {
 public:
  /// What differs from one evaluation to the next.
  struct Case {
    double bandwidth = 0.0;   ///< Of the observer [rad/s].
    int delay_steps = 0;      ///< Extra delay, in steps of the plant.
    int entry = -1;           ///< Of v, whose torque is wrong; -1: none.
    double factor = 1.0;      ///< By which it is.
    double lag = 0.0;         ///< Of the observer [s].
    double force_gain = 0.0;  ///< Of the measured force, at once [N/N].
  };

  /// Throws Error as LoopAnalysis does.
  SampledLoop(const MpcSpec& spec, const LoopChain& chain, int phase);

  /// Rate at which the fastest disturbance grows [1/s].
  double growth(const Case& with) const;
  double dt() const { return dt_; }  ///< Step of the plant [s].
  int nv() const { return n_; }

 private:
  LoopState identity(const Case& with) const;
  void measure(LoopState& s) const;
  void observe(LoopState& s, const Case& with) const;
  void control(LoopState& s, int tick, double force_gain, Eigen::MatrixXd& start) const;
  void move(LoopState& s, const Case& with) const;
  /// From the start of one plan to the start of the next.
  Eigen::MatrixXd transition(const Case& with) const;

  LoopChain chain_;
  bool observes_, feeds_back_;
  double tick_;           ///< [s]
  int ticks_;             ///< Per plan.
  int steps_;             ///< Of the plant per tick.
  double dt_;             ///< [s]
  int plan_delay_;        ///< From a measurement to the use of its plan, in ticks.
  double torque_cutoff_;  ///< That plans know of [rad/s].
  PlanSlopes plan_;
  int n_;
  Eigen::MatrixXd M_, Minv_;
  Eigen::MatrixXd pull_;  ///< Acceleration by gravity, by q.
  Eigen::RowVectorXd J_;  ///< Of the tool along the normal; zero in free air.
};

}  // namespace burnish
