// Closed loop of a controller and an arm, linearized and sampled at the ticks of the controller.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/mpc/loop_chain.hpp"
#include "mpc/plan_slopes.hpp"

namespace burnish {

/// Arm and controller of a SampledLoop.
struct SampledLoopSpec {
  PlanSlopes plan;
  Model model;
  Eigen::VectorXd q;             ///< Configuration about which the loop is linearized.
  std::string tool;              ///< Frame of the tool; used if `presses`.
  bool presses;                  ///< Whether the tool is in contact with the surface.
  Eigen::Vector3d normal_world;  ///< Unit normal of the surface.
  bool observes;                 ///< Whether the torque error is estimated.
  bool feedback;  ///< Whether gains are applied; if false, the planned torque is applied alone.
  double tick_period;    ///< Time between ticks [s].
  double update_period;  ///< Time between new plans [s].
  double solver_delay;   ///< Time from a measurement until its plan comes into use [s].
  double torque_cutoff;  ///< Cut-off of the torque model in plans [rad/s]; 0: none.
};

/// State of the loop between ticks. Each column is one state; all columns are simulated together.
struct LoopState {
  Eigen::MatrixXd q, v;                   ///< State of the plant.
  Eigen::MatrixXd q_before, v_measured;   ///< q at the previous tick, and measured velocity.
  Eigen::MatrixXd force, force_measured;  ///< Contact force along the normal: true, and measured.
  Eigen::MatrixXd v_observed, error;      ///< State of the observer of the model error.
  Eigen::MatrixXd late;        ///< Observer's torque, low-pass filtered with time constant `lag`.
  Eigen::MatrixXd plan_error;  ///< Torque error that the plan in use assumes.
  Eigen::MatrixXd command, motor;
  Eigen::MatrixXd acted, offset;  ///< Filtered command, and estimated offset of the motor torque.
  /// Commands that have not yet arrived, because of the command delay.
  std::vector<Eigen::MatrixXd> queue;

  std::vector<Eigen::MatrixXd*> blocks();
};

class SampledLoop {
 public:
  /// Parameters of one evaluation.
  struct Case {
    double bandwidth = 0.0;   ///< Bandwidth of the observer [rad/s].
    int delay_steps = 0;      ///< Additional delay of commands, in steps of the plant.
    int entry = -1;           ///< Entry of v whose torque is scaled; -1: none.
    double factor = 1.0;      ///< Factor on the torque of `entry`.
    double lag = 0.0;         ///< Lag that the observer assumes [s].
    double force_gain = 0.0;  ///< Gain on the measured force [N/N].
  };

  /// Throws Error if the dynamics cannot be evaluated.
  SampledLoop(const SampledLoopSpec& spec, const LoopChain& chain);

  /// Returns the growth rate of the disturbance that grows fastest [1/s].
  double growth(const Case& with) const;
  double dt() const { return dt_; }  ///< Step of the plant [s].
  int nv() const { return n_; }

 private:
  LoopState identity(const Case& with) const;
  void measure(LoopState& s) const;
  void observe(LoopState& s, const Case& with) const;
  void control(LoopState& s, int tick, double force_gain, Eigen::MatrixXd& start) const;
  void move(LoopState& s, const Case& with) const;
  /// Returns the transition matrix of the loop from the start of one plan to the start of the next.
  Eigen::MatrixXd transition(const Case& with) const;

  LoopChain chain_;
  bool observes_, feeds_back_;
  double tick_;     ///< Tick period [s].
  int ticks_;       ///< Ticks per plan.
  int steps_;       ///< Steps of the plant per tick.
  double dt_;       ///< Step of the plant [s].
  int plan_delay_;  ///< Delay from a measurement until the plan computed from it is used [ticks].
  /// Cut-off frequency of the torque model in plans [rad/s]; 0: no torque model.
  double torque_cutoff_;
  PlanSlopes plan_;
  int n_;
  Eigen::MatrixXd M_, Minv_;
  /// Derivative of the joint accelerations with respect to q, at rest.
  Eigen::MatrixXd gravity_slope_;
  Eigen::RowVectorXd J_;  ///< Jacobian of the tool position along the normal; zero in free air.
};

}  // namespace burnish
