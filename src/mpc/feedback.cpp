#include "burnish/mpc/feedback.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/solver/ddp.hpp"

namespace burnish {
namespace {

int checked_knots(int knots, double step, int horizon) {
  if (knots < 1)
    throw Error("feedback plan: the capacity is " + std::to_string(knots) +
                " knots; wanted at least 1");
  if (!(step > 0.0) || !std::isfinite(step))
    throw Error("feedback plan: the step is " + number(step) + " s; wanted a positive time");
  return std::min(knots, horizon);
}

std::span<const double> first_steps(const ShootingProblem& problem, std::span<const double> steps) {
  return steps.first(std::min(steps.size(), to_size(problem.knots())));
}

}  // namespace

FeedbackPlan::FeedbackPlan(const ShootingProblem& problem, int knots, double step)
    : FeedbackPlan(problem, std::vector<double>(
                                to_size(checked_knots(knots, step, problem.knots())), step)) {}

FeedbackPlan::FeedbackPlan(const ShootingProblem& problem, std::span<const double> steps)
    : problem_(&problem),
      knots_(static_cast<int>(first_steps(problem, steps).size())),
      times_(first_steps(problem, steps)),
      x_(RowMatrix::Zero(knots_ + 1, problem.state().nx)),
      u_(RowMatrix::Zero(knots_, problem.max_controls())),
      gain_(to_size(knots_), Eigen::MatrixXd::Zero(problem.max_controls(), problem.state().ndx)),
      dx_(Eigen::VectorXd::Zero(problem.state().ndx)) {}

void FeedbackPlan::load(const DdpSolver& solver, double time) noexcept {
  x_ = solver.xs().topRows(knots_ + 1);
  u_ = solver.us().topRows(knots_);
  for (int k = 0; k < knots_; ++k) {
    const int nu = problem_->controls(k);
    Eigen::MatrixXd& gain = gain_[to_size(k)];
    gain.topRows(nu) = solver.gain(k);
    gain.bottomRows(gain.rows() - nu).setZero();
    u_.row(k).tail(u_.cols() - nu).setZero();
  }
  start_ = time;
  loaded_ = true;
}

void FeedbackPlan::load(const DdpSolver& solver, double time, const KnotTimes& times) noexcept {
  times_.copy_first(times);
  load(solver, time);
}

void FeedbackPlan::follow(const FeedbackPlan& other) noexcept {
  times_.copy_first(other.times_);
  x_ = other.x_;
  u_ = other.u_;
  gain_ = other.gain_;
  start_ = other.start_;
  loaded_ = other.loaded_;
}

LinearFeedback FeedbackPlan::make_feedback() const {
  return {Eigen::VectorXd::Zero(u_.cols()), Eigen::MatrixXd::Zero(u_.cols(), dx_.size()),
          Eigen::VectorXd::Zero(x_.cols())};
}

void FeedbackPlan::at(double time, LinearFeedback& out) noexcept {
  if (!loaded_) return;
  const double place = times_.place(time - start_);
  const int k = std::min(static_cast<int>(place), knots_ - 1);
  const double fraction = place - k;
  out.feedforward = u_.row(k).transpose();
  out.gain = gain_[to_size(k)];
  const double* const here = x_.data() + k * x_.cols();
  problem_->difference(here, here + x_.cols(), dx_.data());
  dx_ *= fraction;
  problem_->integrate(here, dx_.data(), out.state.data());
}

void FeedbackPlan::control(const LinearFeedback& feedback, const Eigen::VectorXd& x,
                           Eigen::VectorXd& u) noexcept {
  problem_->difference(feedback.state.data(), x.data(), dx_.data());
  u = feedback.feedforward;
  u.noalias() += feedback.gain * dx_;
}

}  // namespace burnish
