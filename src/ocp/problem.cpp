#include "burnish/ocp/problem.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish {

Problem::Problem(const ProblemSpec& spec)
    : impl_(std::make_unique<Impl>(with_fade_speeds(with_loops(spec)))) {}
Problem::~Problem() = default;
Problem::Problem(Problem&&) noexcept = default;
Problem& Problem::operator=(Problem&&) noexcept = default;

const ProblemSpec& Problem::spec() const { return impl_->spec; }
const Model& Problem::model() const { return impl_->compiled.model; }
const StateLayout& Problem::layout() const { return impl_->compiled.layout; }

std::vector<std::string> Problem::stage_names() const {
  std::vector<std::string> names;
  for (const ocp::CompiledStage& stage : impl_->compiled.stages) names.push_back(stage.name);
  return names;
}
int Problem::stage_of(int knot) const { return impl_->stage_of.at(to_size(knot)); }
double Problem::time_of(int knot) const { return impl_->times.at(to_size(knot)); }
double Problem::step_of(int knot) const { return impl_->timing.at(to_size(knot)).step; }

int Problem::stage_index(const std::string& name) const {
  const std::vector<std::string> names = stage_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error("unknown stage " + in_quotes(name) + did_you_mean(name, names));
  return static_cast<int>(found - names.begin());
}

int Problem::term_index(int stage, const std::string& name) const {
  std::vector<std::string> names;
  for (const ocp::CompiledTerm& term : impl_->compiled.stages.at(to_size(stage)).terms)
    names.push_back(term.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error("unknown term " + in_quotes(name) + did_you_mean(name, names));
  return static_cast<int>(found - names.begin());
}

int Problem::terms(int knot) const { return static_cast<int>(impl_->stage(knot).terms.size()); }

Status Problem::set_initial_state(const ConstVectorRef& x) { return impl_->set_initial_state(x); }

namespace {
void check_stage(const char* call, int stage, std::size_t stages) {
  // The last stage is the terminal stage, which only the terminal knot can have.
  if (stage < 0 || stage >= static_cast<int>(stages) - 1)
    throw Error(std::string(call) + ": stage " + std::to_string(stage) +
                " does not exist; wanted 0 to " + std::to_string(stages - 2));
}
}  // namespace

void Problem::set_knot(int knot, int stage, double time) {
  if (knot < 0 || knot > knots())
    throw Error("set_knot: knot " + std::to_string(knot) + " does not exist; wanted 0 to " +
                std::to_string(knots()));
  if (knot < knots()) check_stage("set_knot", stage, impl_->compiled.stages.size());
  impl_->set_knot(knot, stage, time);
}

void Problem::set_step(int knot, double step) {
  if (knot < 0 || knot >= knots())
    throw Error("set_step: knot " + std::to_string(knot) + " does not exist; wanted 0 to " +
                std::to_string(knots() - 1));
  if (step > 0.0 && impl_->own_steps[to_size(knot)] == step) return;
  const ocp::CompiledStage& stage = impl_->stage(knot);
  if (stage.impact)
    throw Error("set_step: knot " + std::to_string(knot) +
                " is an impact, where no time passes; wanted a knot of another stage");
  impl_->compiled.check_step("set_step", step);
  impl_->own_steps[to_size(knot)] = step;
  impl_->set_timing(knot);
}

void Problem::advance(int stage) {
  check_stage("advance", stage, impl_->compiled.stages.size());
  impl_->advance(stage);
}

Status Problem::set_target(int knot, int term, const ConstVectorRef& target) {
  const ocp::CompiledTerm& compiled = impl_->term("set_target", knot, term);
  if (target.size() != compiled.signal_size) return Status::WrongSize;
  ocp::store_target(compiled, target, impl_->targets_of(knot) + compiled.target);
  return Status::Ok;
}

Status Problem::set_surface(int knot, int contact, const Quadric& surface) {
  const CompiledContact& given = impl_->contact_at("set_surface", knot, contact);
  if (!given.reference.is_curved)
    throw Error("set_surface: the reference of contact " + in_quotes(given.spec.name) +
                " has no curved surface; wanted a reference from Reference::on");
  if (!surface.is_finite()) return Status::NotFinite;
  for (const ocp::CompiledSurface& followed : impl_->stage(knot).surfaces)
    if (followed.contact == contact)
      ocp::store_surface(surface, impl_->targets_of(knot) + followed.target);
  return Status::Ok;
}

Status Problem::set_friction(int knot, int contact, double coefficient) {
  check_has_friction("set_friction", impl_->contact_at("set_friction", knot, contact));
  if (!std::isfinite(coefficient) || coefficient < 0.0) return Status::NotFinite;
  for (const ocp::CompiledFriction& friction : impl_->stage(knot).frictions)
    if (friction.contact == contact) impl_->targets_of(knot)[friction.target] = coefficient;
  return Status::Ok;
}

Status Problem::set_term_surface(int knot, int term, const Quadric& surface) {
  const ocp::CompiledTerm& compiled = impl_->term("set_term_surface", knot, term);
  const std::vector<ocp::CompiledSurface>& followed = impl_->stage(knot).surfaces;
  const auto found = std::find_if(followed.begin(), followed.end(),
                                  [&](const auto& of) { return of.term == term; });
  if (found == followed.end())
    throw Error("set_term_surface: the reference of term " + in_quotes(compiled.name) +
                " has no curved surface; wanted a reference from Reference::on");
  if (!surface.is_finite()) return Status::NotFinite;
  ocp::store_surface(surface, impl_->targets_of(knot) + found->target);
  return Status::Ok;
}

Status Problem::set_payload(std::string_view frame, const InertiaSpec& payload) {
  const LoadedBody loaded = loaded_body("set_payload", impl_->spec.model, frame, payload);
  if (loaded.status == Status::Ok) impl_->set_body_inertia(loaded.body, loaded.inertia);
  return loaded.status;
}

Status Problem::set_torque_bias(const ConstVectorRef& torque) {
  std::vector<double>& bias = impl_->compiled.torque_bias;
  if (torque.size() != static_cast<Eigen::Index>(bias.size())) return Status::WrongSize;
  if (!torque.allFinite()) return Status::NotFinite;
  std::copy_n(torque.data(), bias.size(), bias.data());
  impl_->decay_time = 0.0;
  return Status::Ok;
}

Status Problem::set_torque_bias(const ConstVectorRef& torque, const ConstVectorRef& decaying,
                                double decay_time) {
  std::vector<double>& kept = impl_->compiled.decaying_torque;
  if (decaying.size() != static_cast<Eigen::Index>(kept.size())) return Status::WrongSize;
  if (!decaying.allFinite() || !(decay_time > 0.0)) return Status::NotFinite;
  const Status status = set_torque_bias(torque);
  if (status != Status::Ok) return status;
  std::copy_n(decaying.data(), kept.size(), kept.data());
  impl_->decay_time = decay_time;
  return Status::Ok;
}

Eigen::VectorXd Problem::residual(int knot, int term, const ConstVectorRef& x,
                                  const ConstVectorRef& u) {
  const ocp::CompiledTerm& compiled = impl_->term("residual", knot, term);
  Eigen::VectorXd r(compiled.rows);
  impl_->evaluate_one(knot, x, u);
  impl_->worker(0).one.residual_at(impl_->stage(knot), compiled, impl_->targets_of(knot),
                                   impl_->when(knot).times, {.r = r.data()});
  return r;
}

RowMatrix Problem::residual_derivative(int knot, int term, const ConstVectorRef& x,
                                       const ConstVectorRef& u) {
  const ocp::CompiledTerm& compiled = impl_->term("residual_derivative", knot, term);
  std::vector<double> r(to_size(compiled.rows));
  std::vector<double> blocks(to_size(compiled.jacobian_size) + 1);
  impl_->evaluate_one(knot, x, u);
  impl_->worker(0).one.residual_at(impl_->stage(knot), compiled, impl_->targets_of(knot),
                                   impl_->when(knot).times, {.r = r.data(), .J = blocks.data()});
  RowMatrix J = RowMatrix::Zero(compiled.rows, layout().nz());
  const double* from = blocks.data();
  for (const ocp::JacobianBlock& block : compiled.blocks) {
    for (int i = 0; i < block.rows; ++i)
      for (std::size_t c = 0; c < block.columns.size(); ++c) {
        if (block.diagonal && static_cast<int>(c) != i) continue;
        J(block.row + i, block.columns[c]) =
            block.diagonal ? from[i]
                           : from[i * static_cast<int>(block.columns.size()) + static_cast<int>(c)];
      }
    from += block.size();
  }
  return J;
}

Eigen::VectorXd Problem::forces(int knot, const ConstVectorRef& x, const ConstVectorRef& u) {
  const ocp::CompiledStage& stage = impl_->stage(knot);
  if (!stage.solves_contacts) return {};
  const auto& dynamics = impl_->evaluate_one(knot, x, u).contact_dynamics();
  return Eigen::Map<const Eigen::VectorXd>(dynamics.lambda.data(), dynamics.rows());
}

Eigen::VectorXd Problem::acceleration(int knot, const ConstVectorRef& x, const ConstVectorRef& u) {
  if (!impl_->stage(knot).solves_contacts) return {};
  return Eigen::Map<const Eigen::VectorXd>(
      impl_->evaluate_one(knot, x, u).contact_dynamics().a.data(), layout().nv);
}

namespace {
void add_force_names(const CompiledContact& contact, std::vector<std::string>& names) {
  for (const int d : contact.directions)
    names.push_back(contact.spec.name + "/" + std::string(direction_names[to_size(d)]));
}
}  // namespace

std::vector<std::string> Problem::force_names(int knot) const {
  std::vector<std::string> names;
  const ocp::CompiledStage& stage = impl_->stage(knot);
  for (int c = 0; c < impl_->compiled.contacts.size(); ++c)
    if (stage.active[to_size(c)] != 0)
      add_force_names(impl_->compiled.contacts.contacts()[to_size(c)], names);
  return names;
}

std::vector<std::string> Problem::force_state_names() const {
  std::vector<std::string> names;
  for (const ocp::ForceState& force : impl_->compiled.force_states)
    add_force_names(impl_->compiled.contacts.contacts()[to_size(force.contact)], names);
  return names;
}

const StateShape& Problem::state() const { return impl_->compiled.shape; }
int Problem::knots() const { return static_cast<int>(impl_->stage_of.size()) - 1; }
int Problem::controls(int knot) const { return impl_->stage(knot).nu; }
int Problem::max_controls() const { return layout().nu; }
const double* Problem::initial_state() const { return impl_->initial_state.data(); }

void Problem::integrate(const double* x, const double* dx, double* out) const {
  const StateLayout& l = layout();
  for (int i = 0; i < l.ndx() - l.nv; ++i) out[l.nq + i] = x[l.nq + i] + dx[l.nv + i];
  integrate_configuration(impl_->compiled.tree, x, dx, out);
}
void Problem::difference(const double* x0, const double* x1, double* dx) const {
  const StateLayout& l = layout();
  difference_configuration(impl_->compiled.tree, x0, x1, dx);
  for (int i = 0; i < l.ndx() - l.nv; ++i) dx[l.nv + i] = x1[l.nq + i] - x0[l.nq + i];
}

const double* Problem::control_lower(int knot) const {
  return controls(knot) == 0 || impl_->lower.empty() ? nullptr : impl_->lower.data();
}
const double* Problem::control_upper(int knot) const {
  return controls(knot) == 0 || impl_->upper.empty() ? nullptr : impl_->upper.data();
}
const double* Problem::control_scale(int knot) const {
  return controls(knot) == 0 ? nullptr : impl_->control_scale.data();
}

int Problem::rows(int knot) const { return impl_->stage(knot).rows(); }
std::span<const RowCurvature> Problem::row_curvatures(int knot) const {
  return impl_->stage(knot).curvatures;
}
int Problem::max_curvatures() const { return impl_->compiled.largest_curvatures; }
int Problem::max_rows() const { return impl_->compiled.largest_limited_rows; }
const double* Problem::row_lower(int knot) const {
  return rows(knot) == 0 ? nullptr : impl_->stage(knot).row_lower.data();
}
const double* Problem::row_upper(int knot) const {
  return rows(knot) == 0 ? nullptr : impl_->stage(knot).row_upper.data();
}
const int* Problem::row_entry(int knot) const {
  return rows(knot) == 0 ? nullptr : impl_->stage(knot).row_entry.data();
}
const double* Problem::row_scale(int knot) const {
  return rows(knot) == 0 ? nullptr : impl_->stage(knot).row_scale.data();
}
const double* Problem::row_l1_weight(int knot) const {
  return rows(knot) == 0 ? nullptr : impl_->stage(knot).row_l1_weight.data();
}
const double* Problem::row_quadratic_weight(int knot) const {
  return rows(knot) == 0 ? nullptr : impl_->stage(knot).row_quadratic_weight.data();
}

void Problem::prepare(int workers) { impl_->prepare(workers); }
std::span<const KnotRange> Problem::ranges() const { return impl_->ranges; }

KnotValue Problem::roll(int worker, int knot, const double* x, const double* u, double* next,
                        double* rows) {
  return impl_->roll(worker, knot, x, u, next, rows);
}
void Problem::evaluate(int worker, KnotRange range, TrajectoryView at, double* next,
                       KnotValue* values, double* rows) {
  impl_->run(worker, range, at, {.next = next, .values = values, .rows = rows});
}
void Problem::expand(int worker, KnotRange range, TrajectoryView at, double* next,
                     KnotValue* values, KnotExpansion* out) {
  impl_->run(worker, range, at, {.next = next, .values = values, .expansions = out});
}

std::vector<std::string> Problem::state_names() const {
  const StateLayout& l = layout();
  std::vector<std::string> names;
  for (const char* part : {"q ", "v "})
    for (int k = 0; k < l.nv; ++k) names.push_back(part + model().v_name(k));
  for (int i = 0; i < l.filtered; ++i) names.push_back("tau " + model().v_name(l.actuated[i]));
  for (const std::string& row : force_state_names()) names.push_back("force " + row);
  return names;
}
std::vector<std::string> Problem::control_names() const {
  std::vector<std::string> names;
  for (const int k : layout().actuated) names.push_back(model().v_name(k));
  return names;
}
std::vector<std::string> Problem::term_names(int knot) const {
  std::vector<std::string> names;
  for (const ocp::CompiledTerm& term : impl_->stage(knot).cost_terms()) names.push_back(term.name);
  return names;
}
std::vector<std::string> Problem::row_names(int knot) const {
  std::vector<std::string> names;
  for (const ocp::CompiledTerm& term : impl_->stage(knot).constraints())
    for (const std::string& row : ocp::row_names(*this, term))
      names.push_back(term.name + "/" + row);
  return names;
}
std::vector<double> Problem::term_costs(int knot, const double* x, const double* u) {
  ocp::NodeKernel<double>& kernel = impl_->worker(0).one;
  const ocp::CompiledStage& stage = impl_->stage(knot);
  kernel.values(stage, x, u, impl_->targets_of(knot), impl_->when(knot));
  return {kernel.term_costs.begin(),
          kernel.term_costs.begin() + static_cast<std::ptrdiff_t>(stage.costs)};
}
std::vector<double> Problem::row_values(int knot, const double* x, const double* u) {
  ocp::NodeKernel<double>& kernel = impl_->worker(0).one;
  const ocp::CompiledStage& stage = impl_->stage(knot);
  kernel.values(stage, x, u, impl_->targets_of(knot), impl_->when(knot));
  return {kernel.row_values.begin(), kernel.row_values.begin() + stage.rows()};
}
std::string Problem::knot_name(int knot) const {
  return impl_->stage(knot).terminal ? "the terminal state"
                                     : impl_->stage(knot).name + ", knot " + std::to_string(knot);
}

}  // namespace burnish
