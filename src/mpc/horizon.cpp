#include "mpc/horizon.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "mpc/closed_dynamics.hpp"

namespace burnish {

namespace {

/// Returns the target of a one-dimensional contact force; null for other residuals.
template <class Residual>
const Signal* one_force(const Residual& given) {
  const auto* force = std::get_if<residual::ContactForce>(&given);
  return force != nullptr && force->target.size() == 1 ? &force->target : nullptr;
}

/// Returns the target of the tool's position relative to MpcSpec::base; null for other residuals.
template <class Residual>
const Signal* place_of(const Residual& given, const MpcSpec& spec) {
  const Anchor from = spec.base.empty() ? Anchor(Anchor::World) : Anchor(spec.base);
  const auto* place = std::get_if<residual::FramePosition>(&given);
  return place != nullptr && place->frame == spec.tool && place->target.size() == 3 &&
                 place->reference.origin == from && !place->reference.quadric
             ? &place->target
             : nullptr;
}

/// Returns the frame of the surface as in ContactSpec::base; "world" for a fixed surface.
const std::string& base_of(const MpcSpec& spec) {
  static const std::string world = "world";
  return spec.base.empty() ? world : spec.base;
}

}  // namespace

std::vector<int> contacts_on_surface(const MpcSpec& spec) {
  std::vector<int> result;
  const std::vector<ContactSpec>& contacts = spec.problem.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts[c].reference.quadric && contacts[c].tool == spec.tool &&
        contacts[c].base == base_of(spec))
      result.push_back(static_cast<int>(c));
  return result;
}

std::vector<int> contacts_with_friction(const MpcSpec& spec) {
  std::vector<int> result;
  const std::vector<ContactSpec>& contacts = spec.problem.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts[c].friction && contacts[c].tool == spec.tool && contacts[c].base == base_of(spec))
      result.push_back(static_cast<int>(c));
  return result;
}

Horizon::Horizon(const MpcSpec& spec, Problem& problem, const Schedule& schedule)
    : problem_(problem),
      schedule_(schedule),
      given_(knot_steps(spec.problem)),
      times_(given_),
      solved_(given_),
      begins_(to_size(problem.knots()) + 1),
      nearest_(to_size(problem.knots())),
      following_(contacts_on_surface(spec)),
      with_friction_(contacts_with_friction(spec)),
      friction_(spec.friction_estimate.coefficient),
      grounds_(ground_terms(spec)),
      corrects_force_(spec.model_error.kind == ModelErrorKind::Force),
      forces_(spec.problem.stages.size()),
      places_(spec.problem.stages.size()),
      dx_(Eigen::VectorXd::Zero(problem.layout().ndx())),
      one_(Eigen::VectorXd::Zero(1)),
      three_(Eigen::VectorXd::Zero(3)),
      guess_x_(RowMatrix::Zero(problem.knots() + 1, problem.layout().nx())),
      guess_u_(RowMatrix::Zero(problem.knots(), problem.layout().nu)) {
  for (const SchedulePhase& phase : schedule.phases())
    stage_of_phase_.push_back(problem.stage_index(phase.stage));
  const auto note = [&](const auto& terms, int term, std::vector<Target>* forces,
                        std::vector<Target>& places) {
    for (const auto& given : terms) {
      if (const Signal* force = one_force(given.residual); force != nullptr && forces != nullptr)
        forces->push_back({term, *force});
      if (const Signal* place = place_of(given.residual, spec); place != nullptr)
        places.push_back({term, *place});
      ++term;
    }
  };
  for (std::size_t s = 0; s < spec.problem.stages.size(); ++s) {
    const Stage& stage = spec.problem.stages[s];
    note(stage.costs, 0, &forces_[s], places_[s]);
    note(stage.constraints, static_cast<int>(stage.costs.size()), &forces_[s], places_[s]);
  }
  note(spec.problem.terminal, 0, nullptr, places_at_end_);
  const std::vector<ContactSpec> supports = supports_of(spec);
  cones_.resize(static_cast<Eigen::Index>(supports.size()));
  for (std::size_t i = 0; i < supports.size(); ++i)
    cones_[static_cast<Eigen::Index>(i)] = ground_figures(spec.problem, supports[i].name).friction;
  support_friction_ = cones_;
}

int Horizon::stage_at(double schedule_time) const noexcept {
  return stage_of_phase_[to_size(schedule_.phase_at(schedule_time))];
}

void Horizon::place_knot(int knot, double schedule_time) {
  const int stage = stage_at(schedule_time);
  problem_.set_knot(knot, stage, schedule_time);
  if (surface_)
    for (const int contact : following_) (void)problem_.set_surface(knot, contact, *surface_);
  for (const int contact : with_friction_) (void)problem_.set_friction(knot, contact, friction_);
  if (knot < problem_.knots()) set_ground_friction(knot, stage);
  if (surface_ && depth_ > 0.0) shift_places(knot, schedule_time);
  if (corrects_force_ && knot < problem_.knots()) lower_forces(knot, schedule_time);
}

/// Sets the estimated friction under supports. Before this, set_knot() has set the friction of the
/// specification.
void Horizon::set_ground_friction(int knot, int stage) {
  for (const GroundTerm& ground : grounds_[to_size(stage)]) {
    const double estimated = support_friction_[ground.support], cone = cones_[ground.support];
    if (!(estimated < cone)) continue;
    one_[0] = ground.friction * estimated / cone;
    (void)problem_.set_target(knot, ground.term, one_);  // one_ has the size of the target
  }
}

/// Moves the position targets of the tool into the surface, by depth_ along the normal.
void Horizon::shift_places(int knot, double schedule_time) {
  const bool ends = knot == problem_.knots();
  for (const Target& place : ends ? places_at_end_ : places_[to_size(stage_at(schedule_time))]) {
    place.signal.at(schedule_time, three_);
    const Eigen::Vector3d gradient = surface_->gradient(three_.head<3>());
    const double length = gradient.norm();
    if (!(length > 1e-9)) continue;
    three_ -= depth_ / length * gradient;
    (void)problem_.set_target(knot, place.term, three_);  // three_ has the size of the target
  }
}

void Horizon::lower_forces(int knot, double schedule_time) {
  for (const Target& force : forces_[to_size(stage_at(schedule_time))]) {
    force.signal.at(schedule_time, one_);
    one_[0] -= force_error_;
    (void)problem_.set_target(knot, force.term, one_);  // one_ has the size of the target
  }
}

void Horizon::place(double schedule_time) {
  const int N = problem_.knots();
  if (given_.is_even()) {
    for (int k = 0; k <= N; ++k) place_knot(k, schedule_time + given_.after(k));
    return;
  }
  begin_at_phases(schedule_time);
  for (int k = 0; k < N; ++k) problem_.set_step(k, times_.step(k));
  for (int k = 0; k <= N; ++k) place_knot(k, begins_[to_size(k)]);
}

/// Moves the knot nearest to each change of phase to that change. Skips a change if this knot has
/// already moved or is an end of the horizon, or if a step would become shorter than min_step.
void Horizon::begin_at_phases(double schedule_time) noexcept {
  const int N = problem_.knots();
  times_.copy_first(given_);
  for (int k = 0; k <= N; ++k) begins_[to_size(k)] = schedule_time + given_.after(k);
  constexpr double min_step = 0.2;  // shortest allowed step, as a fraction of the nominal step
  int last = 0;
  for (int phase = 1; phase < static_cast<int>(schedule_.phases().size()); ++phase) {
    const double begin = schedule_.start_of(phase), ahead = begin - schedule_time;
    const double place = given_.place(ahead);
    const int k = static_cast<int>(std::lround(place));
    if (k <= last || k >= N) continue;
    if (ahead - times_.after(k - 1) < min_step * given_.step(k - 1)) continue;
    times_.move(k, ahead);
    begins_[to_size(k)] = begin;
    last = k;
  }
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
  const double elapsed = std::max(0.0, schedule_time - guess_time_);
  for (int k = 0; k <= N; ++k) {
    const double at = place_in_solution(k, elapsed);
    const int i = std::min(static_cast<int>(at), N - 1);
    const double* const here = xs.data() + i * xs.cols();
    problem_.difference(here, here + xs.cols(), dx_.data());
    dx_ *= at - i;
    problem_.integrate(here, dx_.data(), guess_x_.row(k).data());
    if (k == N) break;
    guess_u_.row(k) = us.row(i);
    if (!given_.is_even()) guess_mean_control(k, elapsed, solver);
  }
  guess_x_.row(0) = x.transpose();
}

/// Returns the position of a knot in the last solution, as a fractional knot number. The horizon
/// now begins `elapsed` [s] later than the last solution.
double Horizon::place_in_solution(int knot, double elapsed) const noexcept {
  if (given_.is_even())
    return std::min(knot + elapsed / given_.step(0), static_cast<double>(given_.knots()));
  return solved_.place(times_.after(knot) + elapsed);
}

void Horizon::guess_mean_control(int knot, double elapsed, const DdpSolver& solver) noexcept {
  const auto us = solver.us();
  const int N = problem_.knots();
  const double begin = times_.after(knot) + elapsed, end = times_.after(knot + 1) + elapsed;
  const int first = std::min(static_cast<int>(solved_.place(begin)), N - 1);
  // Only one control of the solution applies.
  if (first == N - 1 || end <= solved_.after(first + 1)) return;
  guess_u_.row(knot).setZero();
  double from = begin;
  for (int i = first; i < N && from < end; ++i) {
    const double until = i == N - 1 ? end : std::min(end, solved_.after(i + 1));
    guess_u_.row(knot) += (until - from) / (end - begin) * us.row(i);
    from = until;
  }
}

void Horizon::shift_limits(DdpSolver& solver, double schedule_time) noexcept {
  const int N = problem_.knots();
  const double elapsed = std::max(0.0, schedule_time - guess_time_);
  if (given_.is_even()) {
    const double knots = elapsed / given_.step(0) + 0.5;
    solver.shift_limits(static_cast<int>(std::min(knots, static_cast<double>(N))));
    return;
  }
  for (int k = 0; k < N; ++k)
    nearest_[to_size(k)] = static_cast<int>(std::lround(place_in_solution(k, elapsed)));
  solver.shift_limits(nearest_);
}

}  // namespace burnish
