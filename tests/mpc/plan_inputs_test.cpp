// Tests of the inputs through which a controller changes its plans.
#include "mpc/plan_inputs.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

/// Toy task that presses with friction on a curved surface, with one force target.
MpcSpec pressing_toy(const residual::ContactForce& force) {
  MpcSpec spec = toy_spec();
  ContactSpec touch{.name = "touch", .tool = "tool", .directions = Directions::z()};
  touch.reference = Reference::on(Quadric::plane(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()),
                                  Eigen::Vector3d::Zero());
  touch.friction = SlidingFriction{0.2, 0.1};
  spec.tools[0].friction.coefficient = 0.2;
  spec.problem.contacts = {touch};
  for (Stage& stage : spec.problem.stages) {
    stage.contacts = {"touch"};
    stage.costs.push_back({.name = "force", .residual = force});
  }
  return spec;
}

const CostTerm& force_of(const MpcSpec& spec) { return spec.problem.stages[0].costs.back(); }

TEST(PlanInputs, UndeclaredInputs_AreAddedAndNamed) {
  MpcSpec spec = pressing_toy({"touch", {}, 5.0});
  spec.model_error.kind = ModelErrorKind::Force;
  const MpcSpec made = completed(spec);
  const Problem problem(made.problem);
  for (const char* name : {"tool/surface", "tool/friction", "tool/force_error"})
    EXPECT_GE(problem.input_index(name), 0) << name;
  EXPECT_EQ(made.problem.contacts[0].surface_input, "tool/surface");
  EXPECT_EQ(made.problem.contacts[0].friction->coefficient_input, "tool/friction");
  EXPECT_EQ(force_of(made).offset_input, "tool/force_error");
  EXPECT_EQ(tools_of_surfaces(made), std::vector<int>{0});
  EXPECT_EQ(tools_of_friction(made), std::vector<int>{0});
}

TEST(PlanInputs, SeveralTools_HaveInputsOfTheirOwn) {
  MpcSpec spec = pressing_toy({"touch", {}, 5.0});
  spec.model_error.kind = ModelErrorKind::Force;
  spec.tools.insert(spec.tools.begin(), {.frame = "elbow"});
  spec.tools[0].friction.coefficient = 0.7;
  spec.problem.model.frames.push_back(spec.problem.model.frames.back());
  spec.problem.model.frames.back().name = "elbow";
  ContactSpec pad{.name = "pad", .tool = "elbow", .directions = Directions::z()};
  pad.friction = SlidingFriction{0.7, 0.1};
  spec.problem.contacts.push_back(pad);
  spec.problem.stages[0].contacts.push_back("pad");
  spec.problem.stages[0].costs.push_back(
      {.name = "pad", .residual = residual::ContactForce{"pad", {}, 3.0}});
  const MpcSpec made = completed(spec);
  EXPECT_EQ(tools_of_surfaces(made), (std::vector<int>{1, -1})) << "the pad's surface is plane";
  EXPECT_EQ(tools_of_friction(made), (std::vector<int>{1, 0}));
  const std::vector<CostTerm>& costs = made.problem.stages[0].costs;
  EXPECT_EQ(costs[costs.size() - 2].offset_input, "tool/force_error");
  EXPECT_EQ(costs.back().offset_input, "elbow/force_error");
  Problem problem(made.problem);
  EXPECT_EQ(problem.input_at(problem.input_index("elbow/friction"), 0)[0], 0.7);
  PlanInputs(made).set_friction(problem, 0, 0.4);
  EXPECT_EQ(problem.input_at(problem.input_index("elbow/friction"), 0)[0], 0.4);
  EXPECT_EQ(problem.input_at(problem.input_index("tool/friction"), 0)[0], 0.2);
}

TEST(PlanInputs, ForceErrorOfThePlan_LowersTheTarget) {
  MpcSpec spec = pressing_toy({"touch", {}, 5.0});
  spec.model_error.kind = ModelErrorKind::Force;
  const MpcSpec made = completed(spec);
  Problem problem(made.problem);
  const int term = problem.term_index(0, "force");
  const Eigen::VectorXd x = made.problem.initial_state;
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(problem.layout().nu);
  const double before = problem.residual(0, term, x, u)[0];
  PlanInputs(made).set_force_error(problem, 0, 1.5);
  EXPECT_NEAR(problem.residual(0, term, x, u)[0], before + 1.5, 1e-12);
}

/// One number stands for all entries of a target, which a scalar cannot change.
TEST(PlanInputs, ForceWithSeveralRows_IsLeftAlone) {
  MpcSpec spec = pressing_toy({"touch", Reference::centered(), 0.0});
  spec.model_error.kind = ModelErrorKind::Force;
  const MpcSpec made = completed(spec);
  EXPECT_EQ(force_of(made).offset_input, "");
  EXPECT_NO_THROW(Problem{made.problem});
}

TEST(PlanInputs, DeclaredInput_IsUsedAsTheSpecificationSays) {
  MpcSpec spec = pressing_toy({"touch", {}, 5.0});
  spec.model_error.kind = ModelErrorKind::Torque;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(spec.problem.model.nv);
  spec.problem.inputs = {{.name = "tool/surface", .kind = InputKind::Surface},
                         {.name = "bias", .kind = InputKind::Vector, .value = none}};
  spec.problem.torque_bias_input = "bias";
  const MpcSpec made = completed(spec);
  EXPECT_EQ(made.problem.contacts[0].surface_input, "");
  EXPECT_EQ(made.problem.torque_bias_input, "bias");
  Problem problem(made.problem);
  const Eigen::VectorXd error = Eigen::VectorXd::LinSpaced(none.size(), 1.0, 2.0);
  EXPECT_TRUE(PlanInputs(made).set_torque_error(problem, error, none, INFINITY));
  EXPECT_EQ(problem.input_at(1, 0), error);
}

TEST(PlanInputs, InputsThatCannotWork_AreRefused) {
  MpcSpec spec = pressing_toy({"touch", {}, 5.0});
  spec.model_error.kind = ModelErrorKind::Torque;
  spec.problem.inputs = {{.name = "tool/surface"}};
  const auto refused = [&](const std::vector<std::string>& words) {
    testing::expect_words(testing::refusal([&] { (void)completed(spec); }), words);
  };
  refused({"input 'tool/surface'", "another kind"});
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(spec.problem.model.nv);
  spec.problem.inputs = {{.name = "torque_error", .kind = InputKind::Vector, .value = none}};
  refused({"'torque_error'", "torque_bias_input is empty"});
}

}  // namespace
}  // namespace burnish::test
