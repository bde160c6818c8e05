// What every residual must do as a constraint of a solved problem, hard, soft and as an equality:
// be kept, push only where it is at its limit and by what the cost saves, and be differentiated
// right. Residuals are those of residual_cases(); a new one joins there.
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
  /// Of the rows with limits.
  std::vector<double> limited(int knot) {
    const Eigen::VectorXd x = solver.xs().row(knot), u = solver.us().row(std::min(knot, knots - 1));
    return problem.row_values(knot, x.data(), u.data());
  }
  Eigen::VectorXd all_multipliers() const {
    Eigen::VectorXd all(0);
    for (int k = 0; k <= knots; ++k) {
      const VectorView m = solver.multipliers(k);
      all.conservativeResize(all.size() + m.size());
      all.tail(m.size()) = m;
    }
    return all;
  }
  double largest_multiplier() const { return all_multipliers().cwiseAbs().maxCoeff(); }

  Problem problem;
  DdpSolver solver;
};

/// What a residual of this problem cannot be, by its name, and why.
struct Exception {
  std::string residual, why;
};
const std::vector<Exception> no_hard_limit = {};
const std::vector<Exception> no_soft_limit = {
    {"own with jacobian",
     "a limit on a product of two forces has several minima; from the hard one's it falls into "
     "another, where nothing pushes as hard as the price"}};
const std::vector<Exception> no_equality = {};

/// One row of a residual, between what it is at different knots of the solution without limits.
struct MiddleLimit {
  int rows, row;
  double range;  ///< of the row over the knots
  bool above;    ///< the side of the limit: the start is inside
  double limit;
  double at_last;  ///< a value for the last knot that it does not have
};

/// What the state holds beside q and v: nothing, the torques that act, or the torques or the forces
/// of the step before.
enum class Beside { Nothing, Torques, TorquesBefore, ForcesBefore };

class ConstraintLaw : public ::testing::TestWithParam<Beside> {
 protected:
  /// An arm whose contacts give way goes somewhere, and what is `limited` is seen as a cost that
  /// weighs nothing.
  ProblemSpec going(const Residual& residual) {
    ProblemSpec spec = bare_problem(given, model);
    // Flat: on a curved one the product of two forces is between minima at its limit.
    spec.contacts[2].reference = Reference::surface(tilt());
    const int nv = model.nv;
    const Eigen::VectorXd far = setup.state(given);
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
  static MiddleLimit middle_limit(SolvedProblem& free) {
    const Eigen::Index rows = free.values(0, 2).size();
    Eigen::MatrixXd r(rows, knots);
    for (int k = 0; k < knots; ++k) r.col(k) = free.values(k, 2);
    const Eigen::VectorXd least = r.rowwise().minCoeff(), most = r.rowwise().maxCoeff();
    Eigen::Index row = 0;
    const double range = (most - least).maxCoeff(&row);
    MiddleLimit result{static_cast<int>(rows), static_cast<int>(row), range, false, 0.0, 0.0};
    result.limit = most[row] - 0.4 * range;
    result.above = r(row, 0) <= result.limit;
    if (!result.above) result.limit = least[row] + 0.4 * range;
    const double last = r(row, knots - 1);
    result.at_last = last + (last > 0.5 * (least[row] + most[row]) ? -0.3 : 0.3) * range;
    return result;
  }
  static Constraint constraint(const Residual& residual, const MiddleLimit& of) {
    return {.name = "limit",
            .residual = residual,
            .lower = Eigen::VectorXd::Constant(of.rows, -none),
            .upper = Eigen::VectorXd::Constant(of.rows, none),
            .scale = Eigen::VectorXd::Constant(1, of.range)};
  }
  /// `moved` is how far the limit is out, in ranges.
  static ProblemSpec within(ProblemSpec spec, const MiddleLimit& of, double price = none,
                            double moved = 0.0) {
    Constraint limit = constraint(spec.stages[0].costs[2].residual, of);
    (of.above ? limit.upper : limit.lower)[of.row] =
        of.limit + (of.above ? moved : -moved) * of.range;
    limit.price = price;
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

  /// Rows are kept, but for a price; multipliers are zero inside, of the sign of the limit that
  /// pushes, and the price where that is broken.
  static void expect_kept(SolvedProblem& solved, double price = none) {
    const double largest = solved.largest_multiplier();
    EXPECT_GT(largest, 0.0) << "no limit pushes";
    EXPECT_LT(solved.solver.optimality_error(), 1e-5);
    int broken = 0;
    for (int k = 0; k <= knots; ++k) {
      const std::vector<double> values = solved.limited(k);
      const VectorView m = solved.solver.multipliers(k);
      ASSERT_EQ(m.size(), static_cast<Eigen::Index>(values.size()));
      for (int i = 0; i < m.size(); ++i) {
        SCOPED_TRACE(solved.problem.knot_name(k) + ", row " + std::to_string(i));
        const double y = values[static_cast<std::size_t>(i)];
        const double lower = solved.problem.row_lower(k)[i], upper = solved.problem.row_upper(k)[i];
        const double scale = solved.problem.row_scale(k)[i];
        const double outside = std::max(y - upper, lower - y) / scale;
        EXPECT_LE(std::abs(m[i]), price * (1.0 + 1e-9));
        if (std::isinf(price)) {
          EXPECT_LE(outside, 1e-8);
        } else if (outside > 1e-6) {
          EXPECT_NEAR(m[i], y > upper ? price : -price, 1e-6 * price);
          ++broken;
        }
        if (outside < -1e-6) {
          EXPECT_EQ(m[i], 0.0) << "inside by " << -outside;
        }
        if (m[i] > 1e-6 * largest) {
          EXPECT_GE(y, upper - 1e-6 * scale);
        }
        if (m[i] < -1e-6 * largest) {
          EXPECT_LE(y, lower + 1e-6 * scale);
        }
      }
    }
    if (std::isfinite(price)) {
      EXPECT_GT(broken, 0) << "the price keeps the limit";
    }
  }
  /// The sum of multipliers is what the cost goes down by per unit that the limit is further up.
  static void expect_what_the_cost_saves(const SolvedProblem& solved, const ProblemSpec& up,
                                         const ProblemSpec& down, double moved) {
    const double saved =
        SolvedProblem(down).solver.summary().cost - SolvedProblem(up).solver.summary().cost;
    const Eigen::VectorXd m = solved.all_multipliers();
    EXPECT_NEAR(saved / (2.0 * moved), m.sum(), 1e-3 * m.cwiseAbs().sum());
  }

  void of_each_residual(const std::vector<Exception>& exceptions,
                        const std::function<void(const ProblemSpec&, const MiddleLimit&)>& law) {
    for (const ResidualCase& residual : residual_cases(given)) {
      if (std::any_of(exceptions.begin(), exceptions.end(),
                      [&](const Exception& other) { return other.residual == residual.name; }))
        continue;
      SCOPED_TRACE(residual.name);
      generator.seed(12);  // whatever the others draw
      const ProblemSpec spec = going(residual.make(setup));
      SolvedProblem free(spec);
      law(spec, middle_limit(free));
    }
  }

  OcpCase given{arm.robot, GetParam() == Beside::Torques || GetParam() == Beside::TorquesBefore,
                GetParam() == Beside::TorquesBefore, GetParam() == Beside::ForcesBefore};
  Model model = given.robot.model();
  std::mt19937_64 generator{12};
  OcpSetup setup{model, given.robot.tool, generator};
};

TEST_P(ConstraintLaw, AHardLimitIsKept) {
  of_each_residual(no_hard_limit, [](const ProblemSpec& spec, const MiddleLimit& of) {
    SolvedProblem solved(within(spec, of));
    expect_kept(solved);
    const double d = of.above ? 1e-4 : -1e-4;
    expect_what_the_cost_saves(solved, within(spec, of, none, d), within(spec, of, none, -d),
                               1e-4 * of.range);
  });
}

TEST_P(ConstraintLaw, AnEqualityIsKept) {
  of_each_residual(no_equality, [](const ProblemSpec& spec, const MiddleLimit& of) {
    SolvedProblem solved(equal_at_the_last_knot(spec, of));
    expect_kept(solved);
    expect_what_the_cost_saves(solved, equal_at_the_last_knot(spec, of, 1e-4),
                               equal_at_the_last_knot(spec, of, -1e-4), 1e-4 * of.range);
  });
}

TEST_P(ConstraintLaw, ASoftLimitIsBrokenAtItsPriceAndKeptAboveIt) {
  of_each_residual(no_soft_limit, [](const ProblemSpec& spec, const MiddleLimit& of) {
    const SolvedProblem hard(within(spec, of));
    const double price = hard.largest_multiplier();
    // From there: there may be other minima.
    SolvedProblem cheap(within(spec, of, 0.9 * price), &hard);
    expect_kept(cheap, 0.9 * price);
    EXPECT_LT(cheap.solver.summary().cost, hard.solver.summary().cost);
    const SolvedProblem dear(within(spec, of, 2.0 * price), &hard);
    EXPECT_NEAR(dear.solver.summary().cost, hard.solver.summary().cost,
                1e-8 * hard.solver.summary().cost);
    EXPECT_LT((dear.all_multipliers() - hard.all_multipliers()).cwiseAbs().maxCoeff(),
              1e-4 * price);
  });
}

TEST_P(ConstraintLaw, DerivativesOfItsRowsPassTheCheck) {
  of_each_residual(no_hard_limit, [](const ProblemSpec& spec, const MiddleLimit& of) {
    Problem problem(within(spec, of));
    ProblemCheckOptions options{.states = 1};
    const ProblemReport report = check_problem(problem, options);
    EXPECT_TRUE(report.pass) << report.text();
  });
}

INSTANTIATE_TEST_SUITE_P(TorqueModel, ConstraintLaw,
                         ::testing::Values(Beside::Nothing, Beside::Torques, Beside::TorquesBefore,
                                           Beside::ForcesBefore),
                         [](const auto& law) {
                           switch (law.param) {
                             case Beside::Torques:
                               return "torques_in_the_state";
                             case Beside::TorquesBefore:
                               return "torques_of_the_step_before";
                             case Beside::ForcesBefore:
                               return "forces_of_the_step_before";
                             case Beside::Nothing:
                               break;
                           }
                           return "torques_at_once";
                         });

}  // namespace
}  // namespace burnish::test
