// Laws that every residual must satisfy as a constraint of a solved problem: hard, soft, and as an
// equality. The constraint is satisfied, its multiplier vanishes unless it is active and equals the
// marginal saving of the cost, and its derivatives are exact. The residuals are those of
// residual_cases(); a new residual joins there.
#include <gtest/gtest.h>

#include "burnish/ocp/check.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/residual_cases.hpp"

namespace burnish::test {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr int knots = 8;

struct SolvedProblem {
  explicit SolvedProblem(const ProblemSpec& spec, const SolvedProblem* guess = nullptr)
      : problem(spec),
        solver(problem, {.update = StepUpdate::MultipleShooting,
                         .max_iterations = 300,
                         .stop_tolerance = 1e-14,
                         .limits = {.tolerance = 1e-9}}) {
    if (guess != nullptr) solver.set_guess(guess->solver.xs(), guess->solver.us());
    solver.solve();
    EXPECT_EQ(solver.summary().reason, StopReason::Converged) << solver.text();
  }
  Eigen::VectorXd values(int knot, int term) {
    return problem.residual(knot, term, solver.xs().row(knot).transpose(),
                            solver.us().row(knot).transpose());
  }
  /// Values of the constraint rows.
  std::vector<double> limited(int knot) {
    const Eigen::VectorXd x = solver.xs().row(knot), u = solver.us().row(std::min(knot, knots - 1));
    return problem.row_values(knot, x.data(), u.data());
  }
  Eigen::VectorXd all_multipliers() const {
    Eigen::VectorXd result(0);
    for (int k = 0; k <= knots; ++k) {
      const VectorView m = solver.multipliers(k);
      result.conservativeResize(result.size() + m.size());
      result.tail(m.size()) = m;
    }
    return result;
  }
  double largest_multiplier() const { return all_multipliers().cwiseAbs().maxCoeff(); }

  Problem problem;
  DdpSolver solver;
};

/// Residual, by name, that a law exempts, and why.
struct Exception {
  std::string residual, why;
};
const std::vector<Exception> no_hard_limit = {};
const std::vector<Exception> no_soft_limit = {
    {"own with jacobian",
     "a limit on a product of two forces has several minima; from the hard solution the solver "
     "finds another, where all multipliers are below the L1 weight"}};
const std::vector<Exception> no_equality = {};

/// Limit on one row of a residual, between its values at different knots of the solution without
/// limits.
struct MiddleLimit {
  int rows, row;
  double range;  ///< range of the row over the knots
  bool above;    ///< whether the limit is an upper one; the start satisfies it
  double limit;
  double at_last;  ///< a value that differs from the row's at the last knot
};

/// Entries of the state beside q and v: none, filtered torques, torques of the previous step, or
/// contact forces of the previous step.
enum class ExtraState { Nothing, Torques, TorquesBefore, ForcesBefore };

class ConstraintLaw : public ::testing::TestWithParam<ExtraState> {
 protected:
  /// Problem in which an arm with compliant contacts moves to a goal. `residual` is a cost with
  /// negligible weight, to be watched.
  ProblemSpec reaching_problem(const Residual& residual) {
    ProblemSpec spec = bare_problem(ocp_case, model);
    // The surface is a plane: on a curved surface, the product of two forces would be between
    // minima at its limit.
    spec.contacts[2].reference = Reference::surface(tilt());
    const int nv = model.nv;
    const Eigen::VectorXd far = setup.state(ocp_case);
    spec.initial_state.segment(model.nq, nv) *= 0.2;
    Eigen::VectorXd goal = spec.initial_state;
    goal.head(nv) += 0.2 * (far.head(nv) - goal.head(nv));
    goal.segment(nv, nv).setZero();
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(goal.size(), 1e-5);
    weights.head(nv).setConstant(1.0);
    weights.segment(nv, nv).setConstant(0.01);
    const CostTerm arrive{
        .name = "goal", .residual = residual::State{goal}, .weight = 100.0, .weights = weights};
    const CostTerm effort{.name = "effort", .residual = residual::Control{}, .weight = 1e-3};
    const CostTerm watched{.name = "watched", .residual = residual, .weight = 1e-12};
    Stage go{.name = "go", .contacts = {"brace", "pad"}, .costs = {arrive, effort, watched}};
    go.step = 0.02;
    Stage last = go;
    last.name = "last";
    spec.stages = {go, last};
    spec.horizon = {{"go", knots - 1}, {"last", 1}};
    spec.terminal = {arrive};
    return spec;
  }
  static MiddleLimit middle_limit(SolvedProblem& unlimited) {
    const Eigen::Index rows = unlimited.values(0, 2).size();
    Eigen::MatrixXd r(rows, knots);
    for (int k = 0; k < knots; ++k) r.col(k) = unlimited.values(k, 2);
    const Eigen::VectorXd lowest = r.rowwise().minCoeff(), highest = r.rowwise().maxCoeff();
    Eigen::Index row = 0;
    const double range = (highest - lowest).maxCoeff(&row);
    MiddleLimit result{static_cast<int>(rows), static_cast<int>(row), range, false, 0.0, 0.0};
    result.limit = highest[row] - 0.4 * range;
    result.above = r(row, 0) <= result.limit;
    if (!result.above) result.limit = lowest[row] + 0.4 * range;
    const double last = r(row, knots - 1);
    result.at_last = last + (last > 0.5 * (lowest[row] + highest[row]) ? -0.3 : 0.3) * range;
    return result;
  }
  static Constraint constraint(const Residual& residual, const MiddleLimit& of) {
    return {.name = "limit",
            .residual = residual,
            .lower = Eigen::VectorXd::Constant(of.rows, -none),
            .upper = Eigen::VectorXd::Constant(of.rows, none),
            .scale = Eigen::VectorXd::Constant(1, of.range)};
  }
  /// `moved` is the relaxation of the limit, as a fraction of its range.
  static ProblemSpec within(ProblemSpec spec, const MiddleLimit& of, double l1_weight = none,
                            double moved = 0.0) {
    Constraint limit = constraint(spec.stages[0].costs[2].residual, of);
    (of.above ? limit.upper : limit.lower)[of.row] =
        of.limit + (of.above ? moved : -moved) * of.range;
    limit.l1_weight = l1_weight;
    for (Stage& stage : spec.stages) stage.constraints = {limit};
    return spec;
  }
  static ProblemSpec equal_at_the_last_knot(ProblemSpec spec, const MiddleLimit& of,
                                            double moved = 0.0) {
    Constraint equal = constraint(spec.stages[0].costs[2].residual, of);
    equal.lower[of.row] = equal.upper[of.row] = of.at_last + moved * of.range;
    spec.stages[1].constraints = {equal};
    return spec;
  }

  /// Expects satisfied rows, except for an L1 penalty. A multiplier is zero for an inactive row,
  /// has the sign of the active limit, and equals the L1 weight where the limit is violated.
  static void expect_satisfied(SolvedProblem& solved, double l1_weight = none) {
    const double largest = solved.largest_multiplier();
    EXPECT_GT(largest, 0.0) << "no constraint is active";
    EXPECT_LT(solved.solver.optimality_error(), 1e-5);
    int violated = 0;
    for (int k = 0; k <= knots; ++k) {
      const std::vector<double> values = solved.limited(k);
      const VectorView m = solved.solver.multipliers(k);
      ASSERT_EQ(m.size(), static_cast<Eigen::Index>(values.size()));
      for (int i = 0; i < m.size(); ++i) {
        SCOPED_TRACE(solved.problem.knot_name(k) + ", row " + std::to_string(i));
        const double y = values[static_cast<std::size_t>(i)];
        const double lower = solved.problem.row_lower(k)[i], upper = solved.problem.row_upper(k)[i];
        const double scale = solved.problem.row_scale(k)[i];
        const double violation = std::max(y - upper, lower - y) / scale;
        EXPECT_LE(std::abs(m[i]), l1_weight * (1.0 + 1e-9));
        if (std::isinf(l1_weight)) {
          EXPECT_LE(violation, 1e-8);
        } else if (violation > 1e-6) {
          EXPECT_NEAR(m[i], y > upper ? l1_weight : -l1_weight, 1e-6 * l1_weight);
          ++violated;
        }
        if (violation < -1e-6) {
          EXPECT_EQ(m[i], 0.0) << "inactive by " << -violation;
        }
        if (m[i] > 1e-6 * largest) {
          EXPECT_GE(y, upper - 1e-6 * scale);
        }
        if (m[i] < -1e-6 * largest) {
          EXPECT_LE(y, lower + 1e-6 * scale);
        }
      }
    }
    if (std::isfinite(l1_weight)) {
      EXPECT_GT(violated, 0) << "the L1 weight is too large: no limit is violated";
    }
  }
  /// The sum of the multipliers must equal the decrease of the cost per unit of relaxation.
  static void expect_multipliers_equal_savings(const SolvedProblem& solved, const ProblemSpec& up,
                                               const ProblemSpec& down, double moved) {
    const double saved =
        SolvedProblem(down).solver.summary().cost - SolvedProblem(up).solver.summary().cost;
    const Eigen::VectorXd m = solved.all_multipliers();
    EXPECT_NEAR(saved / (2.0 * moved), m.sum(), 1e-3 * m.cwiseAbs().sum());
  }

  void for_each_residual(const std::vector<Exception>& exceptions,
                         const std::function<void(const ProblemSpec&, const MiddleLimit&)>& law) {
    for (const ResidualCase& residual : residual_cases(ocp_case)) {
      if (std::any_of(exceptions.begin(), exceptions.end(),
                      [&](const Exception& other) { return other.residual == residual.name; }))
        continue;
      SCOPED_TRACE(residual.name);
      generator.seed(12);  // independent of the other residuals
      const ProblemSpec spec = reaching_problem(residual.make(setup));
      SolvedProblem unlimited(spec);
      law(spec, middle_limit(unlimited));
    }
  }

  OcpCase ocp_case{arm.robot,
                   GetParam() == ExtraState::Torques || GetParam() == ExtraState::TorquesBefore,
                   GetParam() == ExtraState::TorquesBefore, GetParam() == ExtraState::ForcesBefore};
  Model model = ocp_case.robot.model();
  std::mt19937_64 generator{12};
  OcpSetup setup{model, ocp_case.robot.tool, generator};
};

TEST_P(ConstraintLaw, HardLimit_IsSatisfied) {
  for_each_residual(no_hard_limit, [](const ProblemSpec& spec, const MiddleLimit& of) {
    SolvedProblem solved(within(spec, of));
    expect_satisfied(solved);
    const double d = of.above ? 1e-4 : -1e-4;
    expect_multipliers_equal_savings(solved, within(spec, of, none, d), within(spec, of, none, -d),
                                     1e-4 * of.range);
  });
}

TEST_P(ConstraintLaw, Equality_IsSatisfied) {
  for_each_residual(no_equality, [](const ProblemSpec& spec, const MiddleLimit& of) {
    SolvedProblem solved(equal_at_the_last_knot(spec, of));
    expect_satisfied(solved);
    expect_multipliers_equal_savings(solved, equal_at_the_last_knot(spec, of, 1e-4),
                                     equal_at_the_last_knot(spec, of, -1e-4), 1e-4 * of.range);
  });
}

TEST_P(ConstraintLaw, SoftLimit_IsViolatedOnlyBelowTheMultiplier) {
  for_each_residual(no_soft_limit, [](const ProblemSpec& spec, const MiddleLimit& of) {
    const SolvedProblem hard(within(spec, of));
    const double l1_weight = hard.largest_multiplier();
    // Starts from the hard solution, because there may be other minima.
    SolvedProblem small_weight(within(spec, of, 0.9 * l1_weight), &hard);
    expect_satisfied(small_weight, 0.9 * l1_weight);
    EXPECT_LT(small_weight.solver.summary().cost, hard.solver.summary().cost);
    const SolvedProblem large_weight(within(spec, of, 2.0 * l1_weight), &hard);
    EXPECT_NEAR(large_weight.solver.summary().cost, hard.solver.summary().cost,
                1e-8 * hard.solver.summary().cost);
    EXPECT_LT((large_weight.all_multipliers() - hard.all_multipliers()).cwiseAbs().maxCoeff(),
              1e-4 * l1_weight);
  });
}

TEST_P(ConstraintLaw, RowDerivatives_PassTheCheck) {
  for_each_residual(no_hard_limit, [](const ProblemSpec& spec, const MiddleLimit& of) {
    Problem problem(within(spec, of));
    ProblemCheckOptions options{.states = 1};
    const ProblemReport report = check_problem(problem, options);
    EXPECT_TRUE(report.pass) << report.text();
  });
}

INSTANTIATE_TEST_SUITE_P(TorqueModel, ConstraintLaw,
                         ::testing::Values(ExtraState::Nothing, ExtraState::Torques,
                                           ExtraState::TorquesBefore, ExtraState::ForcesBefore),
                         [](const auto& law) {
                           switch (law.param) {
                             case ExtraState::Torques:
                               return "torques_in_the_state";
                             case ExtraState::TorquesBefore:
                               return "torques_of_the_step_before";
                             case ExtraState::ForcesBefore:
                               return "forces_of_the_step_before";
                             case ExtraState::Nothing:
                               break;
                           }
                           return "torques_at_once";
                         });

}  // namespace
}  // namespace burnish::test
