// Tests of the polishing problem of a published robot against the results of another program.
#include "polishing/reference_problem.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "burnish/urdf/urdf.hpp"

namespace burnish::test {
namespace {

using Json = nlohmann::json;

Eigen::VectorXd vector_of(const Json& numbers) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    v[static_cast<Eigen::Index>(i)] = numbers[i].get<double>();
  return v;
}
Eigen::MatrixXd matrix_of(const Json& rows) {
  Eigen::MatrixXd m(static_cast<Eigen::Index>(rows.size()),
                    static_cast<Eigen::Index>(rows[0].size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    m.row(static_cast<Eigen::Index>(i)) = vector_of(rows[i]).transpose();
  return m;
}

/// Returns the largest difference relative to the largest entry.
double difference_of(const Eigen::MatrixXd& got, const Eigen::MatrixXd& want) {
  return (got - want).cwiseAbs().maxCoeff() / std::max(1.0, want.cwiseAbs().maxCoeff());
}

class ReferenceProblem : public ::testing::Test {
 protected:
  static constexpr int knots = 100, stride = 21;
  const std::string shared = BURNISH_SHARED_DIR;

  void SetUp() override {
    const std::string figures = shared + "/reference/panda_ocp.json";
    const std::string robot = shared + "/robots/panda.urdf";
    if (!std::filesystem::exists(figures) || !std::filesystem::exists(robot))
      GTEST_SKIP() << "the published results are missing: " << figures << ", " << robot;
    std::ifstream(figures) >> data;
    ModelOptions options;
    options.locked = {"panda_finger_joint1", "panda_finger_joint2"};
    const Model model = build_model(read_urdf(robot), options);
    x0 = vector_of(data["x0"]);
    problem.emplace(polishing::reference_problem(model, "panda_hand_tcp", x0.head(7), knots));
    next.resize(14 * (knots + 1));
    values.resize(knots + 1);
  }

  void expand(const RowMatrix& xs, const RowMatrix& us) {
    std::vector<KnotExpansion> out(knots + 1);
    for (int k = 0; k <= knots; ++k) {
      gradient.emplace_back(Eigen::VectorXd::Zero(stride));
      hessian.emplace_back(RowMatrix::Zero(stride, stride));
      dynamics.emplace_back(RowMatrix::Zero(stride, stride));
      const auto at = static_cast<std::size_t>(k);
      out[at].stride = stride;
      out[at].gradient = gradient[at].data();
      out[at].hessian = hessian[at].data();
      out[at].dynamics = dynamics[at].data();
    }
    for (const KnotRange range : problem->ranges())
      problem->expand(0, range, {xs.data(), us.data()}, next.data(), values.data(), out.data());
  }

  Json data;
  Eigen::VectorXd x0;
  std::optional<Problem> problem;
  std::vector<double> next;
  std::vector<KnotValue> values;
  std::vector<Eigen::VectorXd> gradient;
  std::vector<RowMatrix> hessian, dynamics;
};

TEST_F(ReferenceProblem, WarmStart_HasThePublishedCost) {
  const Eigen::VectorXd u0 = polishing::static_control(*problem);
  EXPECT_LT(difference_of(u0, vector_of(data["u_quasistatic"])), 1e-10);
  const RowMatrix xs = x0.transpose().replicate(knots + 1, 1),
                  us = u0.transpose().replicate(knots, 1);
  double rolled = 0.0, evaluated = 0.0;
  for (const KnotRange range : problem->ranges())
    problem->evaluate(0, range, {xs.data(), us.data()}, next.data(), values.data());
  for (const KnotValue& value : values) {
    EXPECT_EQ(value.status, Status::Ok);
    evaluated += value.cost;
  }
  Eigen::VectorXd after(14);
  for (int k = 0; k <= knots; ++k)
    rolled += problem->roll(0, k, x0.data(), u0.data(), after.data()).cost;
  const auto wanted = data["warmstart_cost"].get<double>();
  EXPECT_NEAR(evaluated, wanted, 1e-10 * wanted);
  EXPECT_NEAR(rolled, wanted, 1e-10 * wanted);
}

TEST_F(ReferenceProblem, Solution_HasThePublishedCostsAndStates) {
  const RowMatrix xs = matrix_of(data["xs"]), us = matrix_of(data["us"]);
  expand(xs, us);
  const Eigen::VectorXd costs = vector_of(data["knot_costs"]);
  for (int k = 0; k <= knots; ++k) {
    const auto at = static_cast<std::size_t>(k);
    EXPECT_EQ(values[at].status, Status::Ok);
    EXPECT_NEAR(values[at].cost, costs[k], 1e-10 * std::max(1.0, costs[k])) << "knot " << k;
  }
  const Eigen::Map<const RowMatrix> reached(next.data(), knots, 14);
  EXPECT_LT(difference_of(reached, xs.bottomRows(knots)), 1e-9);
}

TEST_F(ReferenceProblem, Derivatives_EqualThePublishedOnes) {
  expand(matrix_of(data["xs"]), matrix_of(data["us"]));
  for (const int k : {0, 50}) {
    SCOPED_TRACE("knot " + std::to_string(k));
    const Json& want = data["knot" + std::to_string(k)];
    const auto at = static_cast<std::size_t>(k);
    // dq' = dq + step dv': burnish stores only dv'.
    const Eigen::MatrixXd P = dynamics[at].topRows(7);
    EXPECT_LT(difference_of(P.rightCols(14), matrix_of(want["Fx"]).bottomRows(7)), 1e-9);
    EXPECT_LT(difference_of(P.leftCols(7), matrix_of(want["Fu"]).bottomRows(7)), 1e-9);
    Eigen::MatrixXd of_positions = 0.01 * P.rightCols(14);
    of_positions.leftCols(7) += Eigen::MatrixXd::Identity(7, 7);
    EXPECT_LT(difference_of(of_positions, matrix_of(want["Fx"]).topRows(7)), 1e-9);
    EXPECT_LT(difference_of(gradient[at].tail(14), vector_of(want["Lx"])), 1e-9);
    EXPECT_LT(difference_of(gradient[at].head(7), vector_of(want["Lu"])), 1e-9);
    const Eigen::MatrixXd H = Eigen::MatrixXd(hessian[at]).selfadjointView<Eigen::Lower>();
    EXPECT_LT(difference_of(H.bottomRightCorner(14, 14), matrix_of(want["Lxx"])), 1e-9);
    EXPECT_LT(difference_of(H.topLeftCorner(7, 7), matrix_of(want["Luu"])), 1e-9);
    EXPECT_LT(difference_of(H.bottomLeftCorner(14, 7), matrix_of(want["Lxu"])), 1e-9);
  }
}

}  // namespace
}  // namespace burnish::test
