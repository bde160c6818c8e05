// The parts of an MpcController and what a tick does with them.
#pragma once

#include <exception>
#include <vector>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"
#include "dynamics/tree.hpp"
#include "mpc/contact_detector.hpp"

namespace burnish {

struct MpcController::Impl {
  explicit Impl(MpcSpec given);

  void reset() noexcept;
  const Command& tick(const Measurement& m) noexcept;

 private:
  // Setting up.
  void find_stages();
  void find_force_terms();
  void make_history();

  // The steps of a tick.
  bool accept(const Measurement& m) noexcept;
  bool take_state(const Measurement& m) noexcept;
  void bridge(FaultKind kind, Status status, double limit) noexcept;
  void average_force() noexcept;
  void feel_contact() noexcept;
  void estimate(double dt) noexcept;
  void follow_command(double dt) noexcept;
  void follow_friction(double share) noexcept;
  void estimate_force_error(double share) noexcept;
  bool force_at(const Eigen::VectorXd& tau, Eigen::Vector3d& out) noexcept;
  void watch(double dt) noexcept;
  void watch_motion() noexcept;
  void watch_free_space(Phase phase, double dt) noexcept;
  void watch_approach(double dt) noexcept;
  void update(double now) noexcept;
  bool replan(double now);
  void place_knot(int knot, double schedule_time);
  void place_horizon(double schedule_time);
  void predict(double now, double duration);
  void rest_guess() noexcept;
  void shift_guess(double schedule_time) noexcept;
  void take_over(double now) noexcept;
  void policy_control(double time) noexcept;
  void apply_policy(double now) noexcept;
  void fall_back() noexcept;
  bool hold() noexcept;
  void keep_exception() noexcept;
  void raise(FaultKind kind, double value, double limit, int joint = -1) noexcept;
  void aim() noexcept;
  void record(double now) noexcept;
  void limit_torque() noexcept;
  Eigen::VectorXd& measured_state() noexcept;
  double normal_force() const noexcept { return tool_force.dot(spec.normal_world); }
  bool has_contact(int phase) const noexcept;

 public:
  MpcSpec spec;
  Problem problem;
  DdpSolver solver;
  Schedule schedule;
  TorqueErrorObserver observer;
  LinearFeedback policy;
  FaultReport fault;
  double force_error = 0.0;      ///< N
  Eigen::VectorXd torque_error;  ///< nv, observed and of friction, Nm (N)
  std::exception_ptr thrown;     ///< by a function of the specification, first of all

 private:
  double step_;  ///< s, of the knots
  int ticks_per_update_;
  FeedbackPlan plan_, next_plan_;
  RigidBody body_;           ///< at the last good measurement
  ContactDynamics gravity_;  ///< of the free robot, for the fallback
  ContactDynamics contact_;  ///< of the problem's contacts, for the force estimate
  int tool_;
  ContactDetector touch_;
  std::vector<int> stage_of_phase_;
  std::vector<std::vector<char>> holds_;       ///< per phase and contact: its stage holds it
  std::vector<std::vector<int>> force_terms_;  ///< per stage: contact force terms of one row
  std::vector<std::vector<Signal>> force_targets_;

  Command command_;
  Eigen::VectorXd q_, v_, tau_;  ///< of the last good measurement
  Eigen::Vector3d tool_force = Eigen::Vector3d::Zero();
  Eigen::Matrix3Xd forces_;  ///< a ring of the tool's force
  long forces_count_ = 0;
  Eigen::Vector3d mean_force_ = Eigen::Vector3d::Zero();
  double pressed_ = 0.0;  ///< N, normal force behind the observer's bandwidth
  Eigen::Vector3d friction_force_ = Eigen::Vector3d::Zero();  ///< N, along the surface, alike
  FrameDerivatives tool_motion_;
  Eigen::VectorXd acted_;          ///< nv, torque that the model believes to act
  Eigen::VectorXd torque_offset_;  ///< nv, slow part of measured minus acted torque
  Tree tree_;
  Eigen::VectorXd q_hold_, pull_, stretch_;  ///< of the fallback's spring: nq, nv, nv
  Eigen::VectorXd x_, u_, dx_, bias_, total_, effort_, one_;
  RowMatrix guess_x_, guess_u_;
  double guess_time_ = 0.0;    ///< s of the schedule, of the last solution's first knot
  double good_time_ = 0.0;     ///< s, of the last good measurement
  double last_time_ = 0.0;     ///< s, of the present tick
  double next_time_ = 0.0;     ///< s, when next_plan_ takes over
  double lost_for_ = 0.0;      ///< s without force where it is wanted
  double waits_for_ = 0.0;     ///< s since contact is due
  double due_height_ = 0.0;    ///< m, of the tool along the normal when it became so
  double retreats_for_ = 0.0;  ///< s
  double blind_for_ = 0.0;     ///< s of the fallback without a good measurement
  long tick_ = 0;
  bool released_ = false;    ///< the tool has come off in the retreat, or should have
  bool holding_ = false;     ///< the fallback's spring has its q_hold_
  bool started_ = false;     ///< there was a good measurement
  bool fresh_ = false;       ///< this tick's is one
  bool due_ = false;         ///< an update
  bool solved_ = false;      ///< there is a plan
  bool warm_ = false;        ///< the solver's trajectory can be started from
  bool jumped_ = false;      ///< the schedule's clock, since the last plan
  bool next_ready_ = false;  ///< next_plan_ waits for its time
  int failed_ = 0, late_ = 0;
  RowMatrix history_;  ///< a ring of rows of the fault report's trace
  long history_rows_ = 0;
};

}  // namespace burnish
