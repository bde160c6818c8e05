// Tests that every residual passes on every robot, with and without a torque model: derivatives
// equal differences and automatic differentiation, costs follow the penalty, residuals work as
// constraints, and every lane of a pack equals a single knot.
#include <gtest/gtest.h>

#include "derivatives/check_differences.hpp"
#include "ocp/penalty_kernel.hpp"
#include "support/ocp_autodiff.hpp"
#include "support/residual_cases.hpp"

namespace burnish::test {
namespace {

class ResidualLaw : public ::testing::TestWithParam<OcpCase> {
 protected:
  const ocp::CompiledProblem& compiled() { return ocp::ProblemInside::of(problem).compiled; }
  const StateLayout& layout() const { return problem.layout(); }
  bool is_own(const std::string& name) const { return name.starts_with("own"); }

  /// Returns z moved along entry k by h.
  OcpState moved(const OcpState& at, int k, double h) const {
    OcpState result = at;
    if (k < layout().nu) {
      result.u[k] += h;
    } else {
      const Eigen::VectorXd dx = h * Eigen::VectorXd::Unit(layout().ndx(), k - layout().nu);
      problem.integrate(at.x.data(), dx.data(), result.x.data());
    }
    return result;
  }
  Eigen::MatrixXd by_differences(int knot, int term, const OcpState& at) {
    return extrapolated_differences(
        [&](int k, double h) {
          const OcpState there = moved(at, k, h);
          return problem.residual(knot, term, there.x, there.u);
        },
        layout().nz(), problem.residual(knot, term, at.x, at.u).size());
  }
  /// Compares blocks of columns one by one, as they have different units.
  void expect_close(const Eigen::MatrixXd& got, const Eigen::MatrixXd& want, double tolerance,
                    double floor) {
    const StateLayout& l = layout();
    int first = 0;
    for (const int count : {l.nu, l.nv, l.nv, l.filtered, l.force_states}) {
      EXPECT_LT(relative_error(got.middleCols(first, count), want.middleCols(first, count), floor),
                tolerance)
          << "columns from " << first << "\ngot\n"
          << got.middleCols(first, count) << "\nwanted\n"
          << want.middleCols(first, count);
      first += count;
    }
  }

  Model model = GetParam().robot.model();
  Problem problem{residual_problem(GetParam(), model)};
  std::mt19937_64 generator{5};
};

TEST_P(ResidualLaw, Derivatives_EqualDifferences) {
  const int last = problem.knots();
  for (int s = 0; s + 1 < static_cast<int>(problem.stage_names().size()); ++s) {
    const int knot = s * native_lanes;
    SCOPED_TRACE(problem.knot_name(knot));
    const Residual& residual = problem.spec().stages[static_cast<std::size_t>(s)].costs[0].residual;
    const OcpState at = state_off_cuts(problem, knot, 0, residual, generator);
    const double floor = 1e-3 * problem.residual(knot, 0, at.x, at.u).cwiseAbs().maxCoeff() + 1e-3;
    expect_close(problem.residual_derivative(knot, 0, at.x, at.u), by_differences(knot, 0, at),
                 1e-6, floor);
  }
  for (std::size_t t = 0; t < problem.term_names(last).size(); ++t) {
    const int term = static_cast<int>(t);
    SCOPED_TRACE("terminal, " + problem.term_names(last)[t]);
    const OcpState at =
        state_off_cuts(problem, last, term, problem.spec().terminal[t].residual, generator);
    const double floor =
        1e-3 * problem.residual(last, term, at.x, at.u).cwiseAbs().maxCoeff() + 1e-3;
    const RowMatrix J = problem.residual_derivative(last, term, at.x, at.u);
    expect_close(J, by_differences(last, term, at), 1e-6, floor);
    EXPECT_EQ(J.leftCols(layout().nu).cwiseAbs().maxCoeff(), 0.0) << "the end has no control";
  }
}

TEST_P(ResidualLaw, Derivatives_EqualAutomaticDifferentiation) {
  for (int knot = 0; knot <= problem.knots(); knot += native_lanes) {
    const std::vector<std::string> names = problem.term_names(knot);
    for (std::size_t t = 0; t < names.size(); ++t) {
      if (is_own(names[t])) continue;
      SCOPED_TRACE(problem.knot_name(knot) + ", " + names[t]);
      const OcpState at = random_ocp_state(problem, generator);
      const int term = static_cast<int>(t), stage = problem.stage_of(knot);
      const Eigen::MatrixXd wanted = residual_by_autodiff(
          compiled(),
          {stage, at.x, at.u, targets_of(compiled(), stage, problem.time_of(knot)),
           problem.step_of(knot)},
          term);
      expect_close(problem.residual_derivative(knot, term, at.x, at.u), wanted, 1e-9, 1e-3);
    }
  }
}

TEST_P(ResidualLaw, CostGradientAndHessian_FollowFromTheResidual) {
  OcpHorizon horizon(problem, generator);
  horizon.expand(problem);
  for (int knot = 0; knot < problem.knots(); ++knot) {
    SCOPED_TRACE(problem.knot_name(knot));
    const Eigen::VectorXd x = horizon.x_of(problem, knot), u = horizon.u_of(problem, knot);
    const auto at = static_cast<std::size_t>(knot);
    ASSERT_EQ(horizon.values[at].status, Status::Ok);
    const Eigen::VectorXd r = problem.residual(knot, 0, x, u);
    const RowMatrix J = problem.residual_derivative(knot, 0, x, u);
    const ocp::CompiledTerm& term = ocp::ProblemInside::of(problem).stage(knot).terms[0];
    Eigen::VectorXd slope(r.size()), curvature(r.size());
    const double weight = 0.7 * problem.step_of(knot);
    double cost = 0.0;
    for (Eigen::Index i = 0; i < r.size(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const auto phi =
          evaluate_penalty(term.penalty, term.lower[row], term.upper[row], term.width, r[i]);
      cost += weight * phi.value;
      slope[i] = weight * phi.slope;
      curvature[i] = weight * phi.curvature;
    }
    EXPECT_NEAR(horizon.values[at].cost, cost, 1e-10 * std::max(1.0, std::abs(cost)));
    EXPECT_LT(relative_error(horizon.gradient[at], J.transpose() * slope), 1e-9);
    const Eigen::MatrixXd wanted = J.transpose() * curvature.asDiagonal() * J;
    const Eigen::MatrixXd got =
        Eigen::MatrixXd(horizon.hessian[at]).selfadjointView<Eigen::Lower>();
    EXPECT_LT(relative_error(got, wanted), 1e-9);
  }
}

TEST_P(ResidualLaw, EveryLane_EqualsASingleKnot) {
  OcpHorizon horizon(problem, generator);
  horizon.expand(problem);
  ocp::Worker alone(compiled());
  ocp::NodeKernel<double>& kernel = alone.one;
  const auto compare = [](const double* got, const std::vector<double>& want, Eigen::Index count,
                          const char* what) {
    const Eigen::Map<const Eigen::VectorXd> a(got, count), b(want.data(), count);
    EXPECT_LT(relative_error(a, b), 1e-9) << what;
  };
  for (int knot = 0; knot < problem.knots(); ++knot) {
    SCOPED_TRACE(problem.knot_name(knot));
    const auto at = static_cast<std::size_t>(knot);
    kernel.expand(ocp::ProblemInside::of(problem).stage(knot), horizon.x_of(problem, knot).data(),
                  horizon.u_of(problem, knot).data(),
                  ocp::ProblemInside::of(problem).targets_of(knot),
                  ocp::ProblemInside::of(problem).when(knot));
    EXPECT_NEAR(horizon.values[at].cost, kernel.cost, 1e-10 * std::max(1.0, std::abs(kernel.cost)));
    compare(horizon.next_of(problem, knot).data(), kernel.next, layout().nx(), "next state");
    compare(horizon.gradient[at].data(), kernel.gradient, layout().nz(), "gradient");
    const bool dense = horizon.out[at].form == DynamicsForm::Dense;
    compare(horizon.dynamics[at].data(), kernel.dynamics_by_z,
            (dense ? layout().ndx() : layout().nv) * layout().nz(), "dynamics");
    if (!dense)
      compare(horizon.tangent_blocks[at].data(), kernel.tangent_blocks,
              horizon.tangent_blocks[at].size(), "tangent blocks");
    const Eigen::Map<const RowMatrix> full(kernel.hessian.data(), layout().nz(), layout().nz());
    const Eigen::MatrixXd want = full.triangularView<Eigen::Lower>();
    const Eigen::MatrixXd got = horizon.hessian[at].triangularView<Eigen::Lower>();
    EXPECT_LT(relative_error(got, want), 1e-9);
  }
}

TEST_P(ResidualLaw, RollAndEvaluate_EqualExpand) {
  OcpHorizon horizon(problem, generator);
  horizon.expand(problem);
  const std::vector<double> next = horizon.next;
  const std::vector<KnotValue> values = horizon.values;
  horizon.evaluate(problem);
  for (int knot = 0; knot <= problem.knots(); ++knot) {
    const auto at = static_cast<std::size_t>(knot);
    EXPECT_EQ(horizon.values[at].cost, values[at].cost) << problem.knot_name(knot);
    Eigen::VectorXd rolled = Eigen::VectorXd::Zero(layout().nx());
    const KnotValue value = problem.roll(0, knot, horizon.x_of(problem, knot).data(),
                                         horizon.u_of(problem, knot).data(), rolled.data());
    EXPECT_NEAR(value.cost, values[at].cost, 1e-10 * std::max(1.0, std::abs(value.cost)));
    if (knot == problem.knots()) continue;
    EXPECT_LT(relative_error(rolled, horizon.next_of(problem, knot)), 1e-9);
  }
  EXPECT_EQ(horizon.next, next);
}

TEST_P(ResidualLaw, Residual_WorksAsAConstraint) {
  ProblemSpec spec = problem.spec();
  const auto limited = [](const CostTerm& cost, const std::string& name) {
    return Constraint{
        name, cost.residual, Eigen::VectorXd::Constant(1, -0.2), {}, Eigen::VectorXd::Ones(1)};
  };
  for (Stage& stage : spec.stages) {
    stage.constraints = {limited(stage.costs[0], "alone"), limited(stage.costs[0], "again")};
    stage.costs = {{.residual = residual::JointVelocity{}}};
  }
  for (const CostTerm& cost : std::exchange(spec.terminal, {}))
    spec.terminal_constraints.push_back(limited(cost, cost.name));
  Problem constrained(spec);
  OcpHorizon horizon(constrained, generator);
  horizon.expand(constrained);
  for (int knot = 0; knot <= constrained.knots(); ++knot) {
    SCOPED_TRACE(constrained.knot_name(knot));
    const Eigen::VectorXd x = horizon.x_of(constrained, knot), u = horizon.u_of(constrained, knot);
    const auto at = static_cast<std::size_t>(knot);
    ASSERT_EQ(horizon.values[at].status, Status::Ok);
    const int costs = static_cast<int>(constrained.term_names(knot).size());
    int row = 0, coefficients = 0;
    for (int term = costs; term < constrained.terms(knot); ++term) {
      const Eigen::VectorXd r = constrained.residual(knot, term, x, u);
      const int skip = layout().nz() - layout().ndx() - constrained.controls(knot);
      const Eigen::MatrixXd J =
          constrained.residual_derivative(knot, term, x, u).rightCols(layout().nz() - skip);
      EXPECT_LT(relative_error(horizon.row_values[at].segment(row, r.size()), r, 1e-3), 1e-9);
      // Rows that equal an entry of z have no coefficients.
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(J.rows(), J.cols());
      for (Eigen::Index i = 0; i < r.size(); ++i) {
        if (const int entry = constrained.row_entry(knot)[row + i]; entry >= 0)
          rows(i, entry) = 1.0;
        else
          rows.row(i) = horizon.rows[at].row(coefficients++).head(J.cols());
      }
      EXPECT_LT(relative_error(rows, J, 1e-3), 1e-9);
      row += static_cast<int>(r.size());
    }
    EXPECT_EQ(row, constrained.rows(knot));
    EXPECT_EQ(constrained.row_names(knot).size(), static_cast<std::size_t>(row));
    EXPECT_EQ(constrained.row_values(knot, x.data(), u.data()).size(),
              static_cast<std::size_t>(row));
    for (int i = 0; i < row; ++i) EXPECT_EQ(constrained.row_lower(knot)[i], -0.2);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, ResidualLaw, ::testing::ValuesIn(ocp_cases()),
                         [](const auto& test) { return test.param.label(); });

}  // namespace
}  // namespace burnish::test
