// Comparison with the published solution of the polishing problem, from the same warm start.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "burnish/solver/ddp.hpp"
#include "burnish/urdf/urdf.hpp"
#include "polishing/reference_problem.hpp"

namespace burnish {
namespace {

using Json = nlohmann::json;

Eigen::VectorXd vector_of(const Json& list) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    result[static_cast<Eigen::Index>(i)] = list[i].get<double>();
  return result;
}
RowMatrix matrix_of(const Json& rows) {
  RowMatrix result(static_cast<Eigen::Index>(rows.size()),
                   static_cast<Eigen::Index>(rows[0].size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = vector_of(rows[i]).transpose();
  return result;
}

double relative(const Eigen::MatrixXd& got, const Eigen::MatrixXd& want) {
  return (got - want).cwiseAbs().maxCoeff() / std::max(1e-3, want.cwiseAbs().maxCoeff());
}

class ReferenceSolution : public ::testing::TestWithParam<StepUpdate> {
 protected:
  void SetUp() override {
    const std::filesystem::path shared(BURNISH_SHARED_DIR);
    const auto file = shared / "reference" / "panda_ocp.json";
    const auto robot = shared / "robots" / "panda.urdf";
    if (!std::filesystem::exists(file) || !std::filesystem::exists(robot))
      GTEST_SKIP() << "the published solution is not at " << file;
    std::ifstream(file) >> published_;
    ModelOptions options;
    options.locked = {"panda_finger_joint1", "panda_finger_joint2"};
    model_ = build_model(read_urdf(robot.string()), options);
  }
  Json published_;
  Model model_;
};

TEST_P(ReferenceSolution, SameWarmStart_ReachesThePublishedSolution) {
  const Eigen::VectorXd x0 = vector_of(published_["x0"]);
  Problem problem(polishing::reference_problem(model_, "panda_hand_tcp", x0.head(7), 100));
  // The published solution was regularized with 1e-9 throughout, a thousandth of the control
  // weight, which affects its gains. Its last step was made after the step that satisfied 1e-9.
  DdpSolver solver(problem, {.update = GetParam(),
                             .stop_tolerance = 1e-13,
                             .regularization = {.initial = 1e-9, .decrease_above = 1.0}});
  const Eigen::VectorXd u0 = polishing::static_control(problem);
  solver.set_guess(x0.transpose().replicate(101, 1), u0.transpose().replicate(100, 1));
  const DdpSummary& summary = solver.solve();
  ASSERT_EQ(summary.reason, StopReason::Converged) << solver.text();
  EXPECT_LE(summary.iterations, published_["iterations"].get<int>() + 2);
  RecordProperty("iterations", summary.iterations);
  const double cost = published_["cost"].get<double>();
  EXPECT_NEAR(summary.cost, cost, 1e-6 * cost);
  EXPECT_LT(relative(solver.xs(), matrix_of(published_["xs"])), 1e-5);
  EXPECT_LT(relative(solver.us(), matrix_of(published_["us"])), 1e-5);
  Eigen::MatrixXd forces(100, 1);
  for (int k = 0; k < 100; ++k)
    forces.row(k) = problem.forces(k, solver.xs().row(k), solver.us().row(k));
  EXPECT_LT(relative(forces, matrix_of(published_["lambda"])), 1e-5);
  // The published gain has the opposite sign: u = u_k - K (x (-) x_k).
  EXPECT_LT(relative(-solver.gain(0), matrix_of(published_["K0"])), 1e-5);
  EXPECT_LT(relative(solver.value_hessian(0), matrix_of(published_["Vxx0"])), 1e-5);
  EXPECT_LT(solver.optimality_error(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(updates, ReferenceSolution,
                         ::testing::Values(StepUpdate::Rollout, StepUpdate::MultipleShooting),
                         [](const auto& update) {
                           return update.param == StepUpdate::Rollout ? "rollout" : "shooting";
                         });

}  // namespace
}  // namespace burnish
