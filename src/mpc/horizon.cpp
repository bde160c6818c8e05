#include "mpc/horizon.hpp"

#include <algorithm>

namespace burnish {

std::vector<int> contacts_on_surface(const MpcSpec& spec) {
  std::vector<int> result;
  const std::vector<ContactSpec>& contacts = spec.problem.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts[c].reference.quadric && contacts[c].tool == spec.tool &&
        contacts[c].base == "world")
      result.push_back(static_cast<int>(c));
  return result;
}

std::vector<int> contacts_that_rub(const MpcSpec& spec) {
  std::vector<int> result;
  const std::vector<ContactSpec>& contacts = spec.problem.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts[c].friction && contacts[c].tool == spec.tool && contacts[c].base == "world")
      result.push_back(static_cast<int>(c));
  return result;
}

Horizon::Horizon(const MpcSpec& spec, Problem& problem, const Schedule& schedule)
    : problem_(problem),
      schedule_(schedule),
      step_(spec.problem.stages.front().step),
      following_(contacts_on_surface(spec)),
      rubbing_(contacts_that_rub(spec)),
      friction_(spec.friction_estimate.coefficient),
      corrects_force_(spec.model_error.kind == ModelErrorKind::Force),
      force_terms_(spec.problem.stages.size()),
      force_targets_(spec.problem.stages.size()),
      dx_(Eigen::VectorXd::Zero(problem.layout().ndx())),
      one_(Eigen::VectorXd::Zero(1)),
      guess_x_(RowMatrix::Zero(problem.knots() + 1, problem.layout().nx())),
      guess_u_(RowMatrix::Zero(problem.knots(), problem.layout().nu)) {
  for (const SchedulePhase& phase : schedule.phases())
    stage_of_phase_.push_back(problem.stage_index(phase.stage));
  for (std::size_t s = 0; s < spec.problem.stages.size(); ++s) {
    int term = 0;
    const auto note = [&](const auto& terms) {
      for (const auto& given : terms) {
        const auto* force = std::get_if<residual::ContactForce>(&given.residual);
        if (force != nullptr && force->target.size() == 1) {
          force_terms_[s].push_back(term);
          force_targets_[s].push_back(force->target);
        }
        ++term;
      }
    };
    note(spec.problem.stages[s].costs);
    note(spec.problem.stages[s].constraints);
  }
}

int Horizon::stage_at(double schedule_time) const noexcept {
  return stage_of_phase_[static_cast<std::size_t>(schedule_.phase_at(schedule_time))];
}

void Horizon::place_knot(int knot, double schedule_time) {
  const int stage = stage_at(schedule_time);
  problem_.set_knot(knot, stage, schedule_time);
  if (surface_)
    for (const int contact : following_) (void)problem_.set_surface(knot, contact, *surface_);
  for (const int contact : rubbing_) (void)problem_.set_friction(knot, contact, friction_);
  if (!corrects_force_ || knot == problem_.knots()) return;
  const auto& terms = force_terms_[static_cast<std::size_t>(stage)];
  for (std::size_t t = 0; t < terms.size(); ++t) {
    force_targets_[static_cast<std::size_t>(stage)][t].at(schedule_time, one_);
    one_[0] -= force_error_;
    (void)problem_.set_target(knot, terms[t], one_);  // one_ has the term's size
  }
}

void Horizon::place(double schedule_time) {
  for (int k = 0; k <= problem_.knots(); ++k) place_knot(k, schedule_time + k * step_);
}

void Horizon::guess_rest(const Eigen::VectorXd& x, const Eigen::VectorXd& u) noexcept {
  guess_x_.rowwise() = x.transpose();
  guess_u_.rowwise() = u.transpose();
}

void Horizon::guess_shifted(const Eigen::VectorXd& x, const DdpSolver& solver,
                            double schedule_time) noexcept {
  const int N = problem_.knots();
  const auto xs = solver.xs();
  const auto us = solver.us();
  const double elapsed = std::max(0.0, (schedule_time - guess_time_) / step_);
  for (int k = 0; k <= N; ++k) {
    const double at = std::min(k + elapsed, static_cast<double>(N));
    const int i = std::min(static_cast<int>(at), N - 1);
    const double* const here = xs.data() + i * xs.cols();
    problem_.difference(here, here + xs.cols(), dx_.data());
    dx_ *= at - i;
    problem_.integrate(here, dx_.data(), guess_x_.row(k).data());
    if (k < N) guess_u_.row(k) = us.row(i);
  }
  guess_x_.row(0) = x.transpose();
}

int Horizon::knots_since(double schedule_time) const noexcept {
  const double elapsed = std::max(0.0, (schedule_time - guess_time_) / step_);
  return static_cast<int>(std::min(elapsed + 0.5, static_cast<double>(problem_.knots())));
}

}  // namespace burnish
