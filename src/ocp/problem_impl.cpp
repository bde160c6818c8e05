#include "ocp/problem_impl.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "model/joint_entries.hpp"
#include "ocp/horizon_knots.hpp"

namespace burnish {
namespace ocp {

Worker::Worker(const CompiledProblem& problem)
    : one(problem),
      pack(problem),
      x(to_size(problem.layout.nx()), NativePack(0.0)),
      u(to_size(problem.layout.nu), NativePack(0.0)),
      targets(to_size(problem.largest_targets), NativePack(0.0)),
      next(to_size(problem.layout.nx())) {}

namespace {

/// Row-major matrix of packs. The starts of two consecutive rows are `stride` packs apart.
struct PackMatrix {
  const NativePack* data;
  int rows, columns, stride;
};

/// Implements scatter_rows(). Inlined, so that `lanes` can be a compile-time constant.
BURNISH_INLINE void scatter_lanes(const PackMatrix& from, int lanes, double* const* out,
                                  int out_stride) {
  const int columns = from.columns;
  for (int r = 0; r < from.rows; ++r) {
    const NativePack* const row = from.data + r * from.stride;
    int c = 0;
    for (; c + native_lanes <= columns; c += native_lanes)
      unpack(row + c, lanes, [&](int l) { return out[l] + r * out_stride + c; });
    for (; c < columns; ++c)
      for (int l = 0; l < lanes; ++l) out[l][r * out_stride + c] = row[c].v[l];
  }
}

/// Copies the matrix of each lane l to out[l].
void scatter_rows(const PackMatrix& from, int lanes, double* const* out, int out_stride) {
  if (lanes == native_lanes) {
    scatter_lanes(from, native_lanes, out, out_stride);
  } else {
    scatter_lanes(from, lanes, out, out_stride);
  }
}

std::vector<double> bounds(const Eigen::VectorXd& given, int nu, const char* name) {
  if (given.size() == 0) return {};
  if (given.size() != 1 && given.size() != nu)
    throw Error(std::string(name) + " has " + std::to_string(given.size()) +
                " entries; wanted 1 or " + std::to_string(nu));
  std::vector<double> result(to_size(nu), given[0]);
  if (given.size() == nu) result.assign(given.begin(), given.end());
  if (std::any_of(result.begin(), result.end(), [](double x) { return std::isnan(x); }))
    throw Error(std::string(name) + " holds a NaN");
  return result;
}

/// Throws Error if the horizon needs too much memory: every knot stores its terms' targets.
void check_size(std::size_t knots, const CompiledProblem& problem) {
  constexpr std::size_t max_entries = 10'000'000;
  const auto per_knot =
      to_size(problem.largest_terms + problem.largest_targets + problem.inputs.entries());
  if (per_knot > max_entries / knots)
    throw Error("horizon: each of the " + std::to_string(knots) + " knots has up to " +
                std::to_string(per_knot) + " terms, inputs and target entries; wanted at most " +
                std::to_string(max_entries) + " of these in all knots together");
}

}  // namespace
}  // namespace ocp

Problem::Impl::Impl(const ProblemSpec& given)
    : spec(given),
      compiled(given),
      initial_state(given.initial_state.begin(), given.initial_state.end()),
      lower(ocp::bounds(given.control_lower, compiled.layout.nu, "control_lower")),
      upper(ocp::bounds(given.control_upper, compiled.layout.nu, "control_upper")) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (lower.empty() && !upper.empty()) lower.assign(upper.size(), -infinity);
  if (upper.empty() && !lower.empty()) upper.assign(lower.size(), infinity);
  for (std::size_t i = 0; i < lower.size(); ++i)
    if (lower[i] > upper[i])
      throw Error("control_lower " + number(lower[i]) + " is above control_upper " +
                  number(upper[i]) + " at entry " + std::to_string(i));
  for (const int k : compiled.layout.actuated) {
    const double limit = compiled.model.effort_limit[k];
    control_scale.push_back(limit > 0.0 && std::isfinite(limit) ? limit : 1.0);
  }
  int largest_signal = 4;  // a quaternion
  for (const ocp::CompiledStage& stage : compiled.stages)
    for (const ocp::CompiledTerm& term : stage.terms)
      largest_signal = std::max(largest_signal, term.signal_size);
  signal_scratch.setZero(largest_signal);

  ocp::HorizonKnots knots = ocp::knots_of(given);
  stage_of = std::move(knots.stages);
  own_steps = std::move(knots.own_steps);
  ocp::check_size(stage_of.size(), compiled);
  stage_of.push_back(static_cast<int>(compiled.stages.size()) - 1);
  own_steps.push_back(0.0);
  timing.resize(stage_of.size());
  double time = given.start_time;
  for (std::size_t k = 0; k < stage_of.size(); ++k) {
    const int knot = static_cast<int>(k);
    if (own_steps[k] != 0.0)
      compiled.check_step(
          "horizon: knot " + std::to_string(k) + " of stage " + in_quotes(stage(knot).name),
          own_steps[k]);
    set_timing(knot);
    times.push_back(time);
    time += timing[k].step;
  }
  targets.assign(stage_of.size() * to_size(compiled.largest_targets), 0.0);
  const auto has_uses = [](const ocp::CompiledStage& at) { return !at.uses.empty(); };
  if (std::any_of(compiled.stages.begin(), compiled.stages.end(), has_uses)) signals = targets;
  inputs.assign(stage_of.size() * to_size(compiled.inputs.entries()), 0.0);
  for (int i = 0; i < compiled.inputs.count(); ++i)
    if (compiled.inputs[i].is_bias) load_bias(compiled.inputs[i]);
  for (std::size_t k = 0; k < stage_of.size(); ++k) {
    load_targets(static_cast<int>(k));
    check_rotations(static_cast<int>(k));
    check_inputs(static_cast<int>(k));
  }
  ranges.reserve(stage_of.size());
  cut_ranges();
  prepare(1);
}

void Problem::Impl::prepare(int count) {
  while (static_cast<int>(workers.size()) < count)
    workers.push_back(std::make_unique<ocp::Worker>(compiled));
}

void Problem::Impl::set_body_inertia(int body, const InertiaSpec& inertia) {
  const BodyInertia own = body_inertia(inertia);
  set_inertia_of_body(compiled.model, body, inertia);
  burnish::set_body_inertia(compiled.tree, body, own);
  for (const auto& each : workers) {
    each->one.set_body_inertia(body, own);
    each->pack.set_body_inertia(body, own);
  }
}

Status Problem::Impl::set_initial_state(const ConstVectorRef& x) {
  if (x.size() != static_cast<Eigen::Index>(initial_state.size())) return Status::WrongSize;
  if (!x.allFinite()) return Status::NotFinite;
  for (const TreeJoint& joint : compiled.tree.joints) {
    const int entries = unit_entries(joint.kind);
    if (entries == 0) continue;
    const int first = joint.q + joint_nq(joint.kind) - entries;
    if (std::abs(x.segment(first, entries).squaredNorm() - 1.0) > 2e-6)
      return Status::NotNormalized;
  }
  std::copy_n(x.data(), initial_state.size(), initial_state.data());
  return Status::Ok;
}

void Problem::Impl::check_rotations(int knot) {
  for (const ocp::CompiledTurning& turning : stage(knot).turnings)
    if (!std::isfinite(targets_of(knot)[turning.target]))
      throw Error("stage " + in_quotes(stage(knot).name) + ", knot " + std::to_string(knot) + ": " +
                  turning.of + ": its rotation at " + number(times[to_size(knot)]) +
                  " s is not a quaternion of length 1");
}

void Problem::Impl::set_timing(int knot) {
  const auto k = to_size(knot);
  const ocp::CompiledStage& at = stage(knot);
  timing[k] = compiled.timing(at, own_steps[k] != 0.0 ? own_steps[k] : at.step);
}

ocp::KnotTime<double> Problem::Impl::when(int knot) const {
  const auto k = to_size(knot);
  ocp::KnotTime<double> result = timing[k];
  result.times = &times[k];
  result.decaying = decaying(knot);
  return result;
}

void Problem::Impl::set_knot(int knot, int stage_index, double time) {
  int& stage_here = stage_of[to_size(knot)];
  const bool other = knot < static_cast<int>(stage_of.size()) - 1 && stage_here != stage_index;
  if (other) {
    stage_here = stage_index;
    set_timing(knot);
  }
  times[to_size(knot)] = time;
  load_targets(knot);
  if (other) cut_ranges();
}

void Problem::Impl::advance(int stage_index) {
  const std::size_t last = stage_of.size() - 2;
  std::copy(stage_of.begin() + 1, stage_of.begin() + static_cast<std::ptrdiff_t>(last) + 1,
            stage_of.begin());
  std::copy(times.begin() + 1, times.begin() + static_cast<std::ptrdiff_t>(last) + 1,
            times.begin());
  const std::size_t width = to_size(compiled.largest_targets);
  std::copy_n(targets_of(1), last * width, targets_of(0));
  if (!signals.empty()) std::copy_n(signals_of(1), last * width, signals_of(0));
  std::copy_n(inputs_of(1), last * to_size(compiled.inputs.entries()), inputs_of(0));
  // The last knot keeps its own step, if it has one.
  std::copy(own_steps.begin() + 1, own_steps.begin() + static_cast<std::ptrdiff_t>(last) + 1,
            own_steps.begin());
  std::copy(timing.begin() + 1, timing.begin() + static_cast<std::ptrdiff_t>(last) + 1,
            timing.begin());
  stage_of[last] = stage_index;
  set_timing(static_cast<int>(last));
  times[last] = times[last + 1];
  times[last + 1] += timing[last].step;
  load_targets(static_cast<int>(last));
  load_targets(static_cast<int>(last) + 1);
  for (int i = 0; i < compiled.inputs.count(); ++i)
    if (compiled.inputs[i].decay_time > 0.0) load_input(i);
  cut_ranges();
}

void Problem::Impl::cut_ranges() {
  ranges.clear();
  const int count = static_cast<int>(stage_of.size());
  for (int begin = 0; begin < count;) {
    int end = begin + 1;
    while (end < count && end - begin < native_lanes &&
           stage_of[to_size(end)] == stage_of[to_size(begin)])
      ++end;
    ranges.push_back({begin, end});
    begin = end;
  }
}

std::vector<ContactSpec> Problem::Impl::contacts_of(int stage) const {
  const auto first = std::find(stage_of.begin(), stage_of.end(), stage);
  const auto knot = first == stage_of.end() ? 0 : first - stage_of.begin();
  return contacts_at(spec.contacts, times[to_size(knot)]);
}

const CompiledContact& Problem::Impl::contact_at(const char* call, int knot, int contact) const {
  if (knot < 0 || knot >= static_cast<int>(stage_of.size()))
    throw Error(std::string(call) + ": knot " + std::to_string(knot) +
                " does not exist; wanted 0 to " + std::to_string(stage_of.size() - 1));
  const ContactSet& contacts = compiled.contacts;
  if (contact < 0 || contact >= contacts.size())
    throw Error(std::string(call) + ": contact " + std::to_string(contact) + " does not exist" +
                (contacts.size() == 0 ? "; wanted a problem with contacts"
                                      : "; wanted 0 to " + std::to_string(contacts.size() - 1)));
  return contacts.contacts()[to_size(contact)];
}

const ocp::CompiledTerm& Problem::Impl::term(const char* call, int knot, int term) const {
  if (knot < 0 || knot >= static_cast<int>(stage_of.size()))
    throw Error(std::string(call) + ": knot " + std::to_string(knot) +
                " does not exist; wanted 0 to " + std::to_string(stage_of.size() - 1));
  const std::vector<ocp::CompiledTerm>& terms = stage(knot).terms;
  if (term < 0 || term >= static_cast<int>(terms.size()))
    throw Error(std::string(call) + ": term " + std::to_string(term) + " of knot " +
                std::to_string(knot) + " does not exist" +
                (terms.empty() ? "; wanted a knot with terms"
                               : "; wanted 0 to " + std::to_string(terms.size() - 1)));
  return terms[to_size(term)];
}

void Problem::Impl::check_point(int knot, const ConstVectorRef& x, const ConstVectorRef& u) const {
  if (x.size() != compiled.layout.nx())
    throw Error("x has " + std::to_string(x.size()) + " entries; wanted " +
                std::to_string(compiled.layout.nx()));
  if (stage(knot).nu > 0 && u.size() != compiled.layout.nu)
    throw Error("u has " + std::to_string(u.size()) + " entries; wanted " +
                std::to_string(compiled.layout.nu));
}

const ocp::StageDynamics<double>& Problem::Impl::evaluate_one(int knot, const ConstVectorRef& x,
                                                              const ConstVectorRef& u) {
  check_point(knot, x, u);
  // Avoids values(), which would leave the dynamics at the last point of a Runge-Kutta step.
  ocp::NodeKernel<double>& kernel = worker(0).one;
  kernel.evaluate_dynamics(stage(knot), x.data(), u.data(), targets_of(knot), when(knot));
  return kernel.dynamics();
}

KnotValue Problem::Impl::roll(int index, int knot, const double* x, const double* u, double* next,
                              double* rows) {
  ocp::NodeKernel<double>& kernel = worker(index).one;
  const ocp::CompiledStage& at = stage(knot);
  kernel.values(at, x, u, targets_of(knot), when(knot));
  if (!at.terminal) std::copy(kernel.next.begin(), kernel.next.end(), next);
  if (rows != nullptr) std::copy_n(kernel.row_values.begin(), at.rows(), rows);
  return kernel.outcome(at, 0);
}

void Problem::Impl::gather(ocp::Worker& worker, KnotRange range, TrajectoryView at,
                           ocp::KnotTime<NativePack>& time) const {
  const int nx = compiled.layout.nx(), nu = compiled.layout.nu;
  const int target_count = stage(range.begin).targets;
  for (int l = 0; l < native_lanes; ++l) {
    const auto knot = static_cast<std::ptrdiff_t>(std::min(range.begin + l, range.end - 1));
    const double* const x = at.x + knot * nx;
    for (int i = 0; i < nx; ++i) worker.x[to_size(i)].v[l] = x[i];
    if (stage(range.begin).nu > 0) {
      const double* const u = at.u + knot * nu;
      for (int i = 0; i < nu; ++i) worker.u[to_size(i)].v[l] = u[i];
    }
    const double* const target = targets_of(static_cast<int>(knot));
    for (int i = 0; i < target_count; ++i) worker.targets[to_size(i)].v[l] = target[i];
    const ocp::KnotTime<double>& own = timing[to_size(knot)];
    time.step.v[l] = own.step;
    time.weight.v[l] = own.weight;
    time.per_second.v[l] = own.per_second;
    time.decay.v[l] = own.decay;
    time.half_decay.v[l] = own.half_decay;
    time.step_ratio.v[l] = own.step_ratio;
    time.decaying.v[l] = decaying(static_cast<int>(knot));
  }
}

void Problem::Impl::run(int index, KnotRange range, TrajectoryView at, const RangeOutput& out) {
  ocp::Worker& w = worker(index);
  const ocp::CompiledStage& at_stage = stage(range.begin);
  ocp::KnotTime<NativePack> time;
  gather(w, range, at, time);
  double lane_times[native_lanes];
  for (int l = 0; l < native_lanes; ++l)
    lane_times[l] = times[to_size(std::min(range.begin + l, range.end - 1))];
  time.times = lane_times;
  if (out.expansions != nullptr) {
    w.pack.expand(at_stage, w.x.data(), w.u.data(), w.targets.data(), time);
    store_expansion(w, at_stage, range, out.expansions);
  } else {
    w.pack.values(at_stage, w.x.data(), w.u.data(), w.targets.data(), time);
  }
  const int nx = compiled.layout.nx();
  for (int k = range.begin; k < range.end; ++k) {
    const int l = k - range.begin;
    if (!at_stage.terminal)
      for (int i = 0; i < nx; ++i)
        out.next[static_cast<std::ptrdiff_t>(k) * nx + i] = w.pack.next[to_size(i)].v[l];
    out.values[k] = w.pack.outcome(at_stage, l);
    if (out.rows == nullptr) continue;
    for (int r = 0; r < at_stage.rows(); ++r)
      out.rows[k * compiled.largest_limited_rows + r] = w.pack.row_values[to_size(r)].v[l];
  }
}

void Problem::Impl::store_expansion(const ocp::Worker& w, const ocp::CompiledStage& at_stage,
                                    KnotRange range, KnotExpansion* out) const {
  const StateLayout& layout = compiled.layout;
  const int lanes = range.end - range.begin;
  const int nz = layout.nz();
  const int skip = at_stage.nu == 0 ? layout.nu : 0;  // without controls, z begins with dx
  double* to[native_lanes];
  const auto collect = [&](auto member) {
    for (int l = 0; l < lanes; ++l) to[l] = out[range.begin + l].*member;
  };
  const int stride = out[range.begin].stride;
  collect(&KnotExpansion::gradient);
  ocp::scatter_rows({w.pack.gradient.data() + skip, 1, nz - skip, nz}, lanes, to, stride);
  collect(&KnotExpansion::hessian);
  ocp::scatter_rows({w.pack.hessian.data() + skip * nz + skip, nz - skip, nz - skip, nz}, lanes, to,
                    stride);
  if (const int rows = at_stage.rows(); rows > 0 && out[range.begin].rows != nullptr) {
    collect(&KnotExpansion::row_values);
    ocp::scatter_rows({w.pack.row_values.data(), 1, rows, rows}, lanes, to, rows);
    collect(&KnotExpansion::rows);
    ocp::scatter_rows({w.pack.rows.data() + skip, at_stage.coefficient_rows, nz - skip, nz}, lanes,
                      to, stride);
    if (at_stage.curvature_rows > 0 && out[range.begin].curvatures != nullptr) {
      collect(&KnotExpansion::curvatures);
      ocp::scatter_rows({w.pack.curvatures.data() + skip, at_stage.curvature_rows, nz - skip, nz},
                        lanes, to, stride);
    }
  }
  if (at_stage.terminal) return;
  const bool dense = at_stage.dense;
  collect(&KnotExpansion::dynamics);
  ocp::scatter_rows(
      {w.pack.dynamics_by_z.data() + skip, dense ? layout.ndx() : layout.nv, nz - skip, nz}, lanes,
      to, stride);
  const int tangent_blocks =
      compiled.blocks.empty() ? 0 : static_cast<int>(w.pack.tangent_blocks.size());
  collect(&KnotExpansion::tangent_blocks);
  if (tangent_blocks > 0 && !dense)
    ocp::scatter_rows({w.pack.tangent_blocks.data(), 1, tangent_blocks, tangent_blocks}, lanes, to,
                      tangent_blocks);
  for (int l = 0; l < lanes; ++l) {
    KnotExpansion& knot = out[range.begin + l];
    knot.form = dense ? DynamicsForm::Dense : DynamicsForm::SecondOrder;
    const ocp::KnotTime<double>& own = timing[to_size(range.begin + l)];
    knot.step = own.step;
    std::fill_n(knot.decay, compiled.shape.filtered, own.decay);
  }
}

}  // namespace burnish
