// The parts of an MpcController and what a tick does with them.
#pragma once

#include <vector>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {

struct MpcController::Impl {
  explicit Impl(MpcSpec given);

  void reset() noexcept;
  const Command& tick(const Measurement& m) noexcept;

 private:
  // Setting up.
  static void check(const MpcSpec& spec);
  void find_stages();
  void find_force_terms();
  void make_history();

  // The steps of a tick.
  bool accept(const Measurement& m) noexcept;
  bool well_formed(const Measurement& m) const noexcept;
  void estimate(const Measurement& m) noexcept;
  void estimate_force() noexcept;
  void watch(double dt) noexcept;
  void watch_motion() noexcept;
  void watch_contact(double dt, double force_normal) noexcept;
  void update(double now, bool jumped) noexcept;
  void place_horizon(double schedule_time) noexcept;
  void predict(double duration) noexcept;
  void shift_guess(double now) noexcept;
  void solve(double now, int iterations) noexcept;
  void apply_policy(double now) noexcept;
  void fall_back() noexcept;
  void raise(FaultKind kind, double value, double limit, int joint = -1) noexcept;
  void record(double now) noexcept;
  void limit_torque() noexcept;
  Eigen::VectorXd& measured_state() noexcept;
  double normal_force() const noexcept { return tool_force.dot(spec.normal_world); }

 public:
  MpcSpec spec;
  Problem problem;
  DdpSolver solver;
  Schedule schedule;
  TorqueErrorObserver observer;
  LinearFeedback policy;
  FaultReport fault;
  double force_error = 0.0;  ///< N

 private:
  FeedbackPlan plan_, next_plan_;
  bool next_ready_ = false;
  double next_time_ = 0.0;  ///< s, when next_plan_ takes over
  RigidBody body_;
  ContactDynamics gravity_;  ///< of the free robot, for the fallback
  ContactDynamics contact_;  ///< of the problem's contacts, for the force estimate
  int tool_;
  double step_;  ///< s, of the knots
  int ticks_per_update_;
  std::vector<int> stage_of_phase_;
  std::vector<char> in_contact_stage_;         ///< per phase: its stage holds a contact
  std::vector<std::vector<int>> force_terms_;  ///< per stage: contact force terms of one row
  std::vector<std::vector<Signal>> force_targets_;

  Command command_;
  Eigen::VectorXd q_, v_, tau_;  ///< of the last good measurement
  Eigen::Vector3d tool_force = Eigen::Vector3d::Zero();
  Eigen::VectorXd x_, u_, dx_, bias_, total_, effort_, one_;
  RowMatrix guess_x_, guess_u_;
  double last_time_ = 0.0, good_time_ = 0.0, lost_for_ = 0.0, guess_time_ = 0.0;
  long tick_ = 0;
  bool started_ = false, solved_ = false, jumped_ = false;
  int failed_ = 0, late_ = 0;
  RowMatrix history_;  ///< a ring of rows of the fault report's trace
  long history_rows_ = 0;
};

}  // namespace burnish
