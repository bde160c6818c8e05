#include "burnish/ocp/check.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/model/state.hpp"
#include "ocp/check_point.hpp"

namespace burnish {
namespace {

/// Largest condition number of J M^-1 J^T at checked states, for contacts without compliance. J is
/// the contact Jacobian, M the mass matrix; the product is scaled to a unit diagonal. Chosen by
/// hand.
constexpr double max_condition = 1e5;
/// Largest number of random states that are drawn to find one checkable state; chosen by hand.
constexpr int tries_per_state = 20;

void check_options(const Problem& problem, const ProblemCheckOptions& options) {
  const auto refuse = [](const std::string& what) { throw Error("check: " + what); };
  if (options.states < 1)
    refuse("states is " + std::to_string(options.states) + "; wanted at least 1");
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance))
    refuse("tolerance is " + number(options.tolerance) + "; wanted a positive number");
  const auto check_spread = [&](const char* name, double spread) {
    if (!(spread >= 0.0) || !std::isfinite(spread))
      refuse(std::string(name) + " is " + number(spread) + "; wanted a number of at least 0");
  };
  check_spread("position", options.position);
  check_spread("velocity", options.velocity);
  check_spread("torque", options.torque);
  if (options.x.empty() && options.u.empty()) return;
  const auto knots = to_size(problem.knots());
  if (options.x.size() != knots + 1 || options.u.size() != knots)
    refuse("the trajectory has " + std::to_string(options.x.size()) + " states and " +
           std::to_string(options.u.size()) + " controls; wanted " + std::to_string(knots + 1) +
           " and " + std::to_string(knots));
  for (const Eigen::VectorXd& x : options.x)
    if (x.size() != problem.state().nx)
      refuse("a state of the trajectory has " + std::to_string(x.size()) + " entries; wanted " +
             std::to_string(problem.state().nx));
  for (std::size_t k = 0; k < knots; ++k)
    if (problem.controls(static_cast<int>(k)) > 0 && options.u[k].size() != problem.max_controls())
      refuse("a control of the trajectory has " + std::to_string(options.u[k].size()) +
             " entries; wanted " + std::to_string(problem.max_controls()));
}

/// Compares derivatives with finite differences at random states of a problem.
class ProblemCheck {
 public:
  ProblemCheck(Problem& problem, const ProblemCheckOptions& options)
      : problem_(problem), options_(options), generator_(options.seed) {
    const Eigen::Map<const Eigen::VectorXd> x(problem.initial_state(), problem.state().nx);
    initial_ = x;
  }

  /// Returns the report's rows for a stage.
  std::vector<ProblemCheckRow> stage(int index) {
    std::vector<int> knots;
    for (int k = 0; k <= problem_.knots(); ++k)
      if (problem_.stage_of(k) == index) knots.push_back(k);
    const bool borrowed = knots.empty();
    const int stage_before = problem_.stage_of(0);
    if (borrowed) {
      problem_.set_knot(0, index, problem_.time_of(0));
      knots.push_back(0);
    }
    rows_.clear();
    for (int i = 0; i < options_.states; ++i) {
      const auto place = to_size(i) * knots.size() / to_size(options_.states);
      compare_at(index, knots[place], i);
    }
    if (borrowed) problem_.set_knot(0, stage_before, problem_.time_of(0));
    for (ProblemCheckRow& row : rows_) row.pass = row.worst_error <= options_.tolerance;
    return rows_;
  }

 private:
  double uniform() {
    // std::uniform_real_distribution differs between standard libraries.
    return 2.0 * static_cast<double>(generator_() >> 11) * 0x1.0p-53 - 1.0;
  }

  /// Returns a random state and control, around the given trajectory or the initial state.
  ocp::CheckPoint draw(int knot) {
    const StateLayout& l = problem_.layout();
    const auto place = to_size(knot);
    const bool given = !options_.x.empty();
    const Eigen::VectorXd from = given ? options_.x[place] : initial_;
    Eigen::VectorXd dx(l.ndx()), x(l.nx()), u;
    const Eigen::VectorXd units = ocp::check_units(problem_, l.nu);
    for (int i = 0; i < l.ndx(); ++i)
      dx[i] = units[l.nu + i] * uniform() *
              (i < l.nv       ? options_.position
               : i < 2 * l.nv ? options_.velocity
                              : options_.torque);
    problem_.integrate(from.data(), dx.data(), x.data());
    if (given && place < options_.u.size()) u = options_.u[place];
    if (u.size() == 0) u = problem_.quasi_static(problem_.stage_of(knot), x).control;
    if (!given) x.segment(l.nq + l.nv, l.filtered) += u.head(l.filtered);
    for (Eigen::Index i = 0; i < u.size(); ++i) u[i] += units[i] * uniform() * options_.torque;
    return {problem_, knot, x, u};
  }

  /// Returns whether the contacts of a knot are far from singular.
  bool regular(int knot, const Eigen::VectorXd& q) const {
    const ocp::CompiledProblem& compiled = ocp::ProblemInside::of(problem_).compiled;
    if (compiled.contact_solver.mu > 0.0) return true;
    std::vector<int> active;
    const ocp::CompiledStage& at = ocp::ProblemInside::of(problem_).stage(knot);
    for (int c = 0; c < compiled.contacts.size(); ++c)
      if (at.active[to_size(c)] != 0) active.push_back(c);
    if (active.empty()) return true;
    const ContactSet contacts(compiled.model,
                              contacts_at(problem_.spec().contacts, problem_.time_of(knot)));
    return diagnose(compiled.model, contacts, q, active).condition < max_condition;
  }

  void compare_at(int index, int knot, int state) {
    for (int tries = 0; tries < tries_per_state; ++tries) {
      ocp::CheckPoint point = draw(knot);
      if (!is_usable(point.status()) || point.near_half_turn()) continue;
      if (!regular(knot, point.x().head(problem_.layout().nq))) continue;
      std::size_t row = 0;
      if (knot < problem_.knots()) add(row++, index, "next state", state, point.next_state());
      const ocp::CompiledStage& stage = ocp::ProblemInside::of(problem_).stage(knot);
      for (std::size_t t = 0; t < stage.terms.size(); ++t) {
        const int term = static_cast<int>(t);
        std::vector<DerivativeBlock> blocks = point.residual(term);
        for (DerivativeBlock& block : t < stage.costs ? point.cost(term) : point.constraint(term))
          blocks.push_back(std::move(block));
        add(row++, index, stage.terms[t].name, state, blocks);
      }
      if (stage.costs > 0) add(row, index, "all costs", state, point.all_costs());
      return;
    }
    throw Error("check: " + problem_.knot_name(knot) +
                " cannot be evaluated near its state, or has contacts that are close to singular "
                "there; wanted another trajectory, or a compliance mu > 0");
  }

  void add(std::size_t place, int index, const std::string& term, int state,
           const std::vector<DerivativeBlock>& blocks) {
    if (place == rows_.size())
      rows_.push_back({.stage = problem_.stage_names()[to_size(index)], .term = term});
    ProblemCheckRow& row = rows_[place];
    if (!blocks.empty()) ++row.states;
    for (const DerivativeBlock& block : blocks) {
      const BlockMismatch mismatch = compare(block);
      if (!row.worst.block.empty() && !(mismatch.error > row.worst_error)) continue;
      row.worst_error = mismatch.error;
      row.worst = mismatch.entry;
      row.worst.state = state;
    }
  }

  Problem& problem_;
  const ProblemCheckOptions& options_;
  std::mt19937_64 generator_;
  Eigen::VectorXd initial_;
  std::vector<ProblemCheckRow> rows_;
};

}  // namespace

ProblemReport check_problem(Problem& problem, const ProblemCheckOptions& options) {
  check_options(problem, options);
  ProblemReport report;
  report.robot = problem.model().name;
  report.tolerance = options.tolerance;
  ProblemCheck check(problem, options);
  const int stages = static_cast<int>(problem.stage_names().size());
  for (int s = 0; s < stages; ++s) {
    for (ProblemCheckRow& row : check.stage(s)) report.rows.push_back(std::move(row));
    if (options.progress) options.progress(s + 1, stages);
  }
  report.pass =
      !report.rows.empty() && std::all_of(report.rows.begin(), report.rows.end(),
                                          [](const ProblemCheckRow& row) { return row.pass; });
  return report;
}

}  // namespace burnish
