// Tests of the checker of problems: correct problems pass, wrong derivatives are named, and
// problems that cannot be solved get warnings.
#include <gtest/gtest.h>

#include <limits>

#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/check.hpp"
#include "support/ocp_cases.hpp"
#include "support/refusal.hpp"
#include "support/scaled.hpp"

namespace burnish::test {
namespace {

/// Returns a problem with a stage with a force, a free stage, an impact and a custom residual.
ProblemSpec checked_spec(const OcpCase& test, const Model& model) {
  ProblemSpec spec = bare_problem(test, model);
  const std::string tool = test.robot.tool;
  const Eigen::VectorXd inside = Eigen::VectorXd::Constant(1, 0.1);
  spec.stages = {
      {.name = "press",
       .contacts = {"brace", "pad"},
       .costs = {{.residual = residual::ContactForce{"pad", Reference::local()}, .weight = 1e-3},
                 {.residual = residual::FrictionCone{"pad"}, .weight = 1e-3},
                 {.residual = residual::custom(
                      WithJacobian{.frames = {tool}, .contacts = {"pad", "brace"}}),
                  .weight = 1e-4}},
       .constraints = {{"enough", residual::ContactForce{"pad"}, inside, {}}}},
      {.name = "move",
       .costs = {{.residual = residual::State{}},
                 {.residual = residual::JointVelocity{},
                  .penalty = Penalty::barrier(-inside, inside)}},
       .integrator = Integrator::RungeKutta4},
      {.name = "touch",
       .contacts = {"pad"},
       .costs = {{.residual = residual::CentroidalMomentum{}}},
       .impact = true}};
  spec.horizon = {{"press", 3}, {"move", 2}};
  spec.terminal = {{.residual = residual::State{}}};
  return spec;
}

class ProblemCheckCases : public ::testing::TestWithParam<OcpCase> {};

TEST_P(ProblemCheckCases, CorrectProblem_Passes) {
  const Model model = GetParam().robot.model();
  ProblemSpec spec = checked_spec(GetParam(), model);
  spec.contact_solver.mu = 0.05;
  Problem problem(spec);
  const ProblemReport report = check_problem(problem);
  EXPECT_TRUE(report.pass) << report.text();
  std::vector<std::string> rows;
  for (const ProblemCheckRow& row : report.rows) rows.push_back(row.stage + ": " + row.term);
  const std::vector<std::string> wanted{
      "press: next state", "press: contact force", "press: friction cone",
      "press: custom",     "press: enough",        "press: all costs",
      "move: next state",  "move: state",          "move: joint velocity",
      "move: all costs",   "touch: next state",    "touch: centroidal momentum",
      "touch: all costs",  "terminal: state",      "terminal: all costs"};
  EXPECT_EQ(rows, wanted);
  // The check of the stage without knots restores the knot that it uses.
  EXPECT_EQ(problem.stage_of(0), 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, ProblemCheckCases, ::testing::ValuesIn(ocp_cases()),
                         [](const auto& test) { return test.param.label(); });

/// A custom residual with one wrong entry in its Jacobian.
struct WrongJacobian {
  int rows = 2;
  std::string name = "slip";
  void value(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    out << at.q()[0], at.v()[2] * at.v()[2];
  }
  void jacobian(const NodeView& at, Eigen::Ref<RowMatrix> out) const {
    out(0, at.layout().column_q()) = 1.0;
    out(1, at.layout().column_v() + 2) = 2.001 * at.v()[2];
  }
};

TEST(ProblemCheck, WrongJacobian_IsNamedWithItsEntry) {
  const Model model = arm.robot.model();
  ProblemSpec spec = checked_spec(arm, model);
  spec.stages[1].costs.push_back({.residual = residual::custom(WrongJacobian{})});
  Problem problem(spec);
  const ProblemReport report = check_problem(problem);
  EXPECT_FALSE(report.pass);
  int failed = 0;
  for (const ProblemCheckRow& row : report.rows) {
    failed += row.pass ? 0 : 1;
    if (row.term != "slip") continue;
    EXPECT_FALSE(row.pass);
    EXPECT_EQ(row.stage, "move");
    EXPECT_NEAR(row.worst_error, 1e-3 / 2.0, 1e-5);
    EXPECT_EQ(row.worst.column, "v " + model.v_name(2));
    EXPECT_GE(row.worst.state, 0);
  }
  EXPECT_GE(failed, 1);
  EXPECT_LE(failed, 2) << "only the term and the sum of all costs may fail\n" << report.text();
  EXPECT_NE(report.text().find("stage 'move', slip: d"), std::string::npos) << report.text();
  EXPECT_NE(report.text().find("FAIL: "), std::string::npos) << report.text();
}

TEST(ProblemCheck, SameSeed_GivesTheSameReport) {
  Problem problem(checked_spec(arm, arm.robot.model()));
  ProblemCheckOptions options{.states = 1};
  int done = 0;
  options.progress = [&](int stage, int total) {
    EXPECT_EQ(stage, ++done);
    EXPECT_EQ(total, 4);
  };
  const std::string first = check_problem(problem, options).text();
  options.progress = {};
  EXPECT_EQ(check_problem(problem, options).text(), first);
  options.seed = 3;
  EXPECT_NE(check_problem(problem, options).text(), first);
  const auto refused = [&](const ProblemCheckOptions& bad, const std::vector<std::string>& words) {
    testing::expect_words(testing::refusal([&] { check_problem(problem, bad); }), words);
  };
  refused({.states = 0}, {"check: states is 0"});
  refused({.tolerance = 0.0}, {"check: tolerance is 0"});
  refused({.velocity = -1.0}, {"check: velocity is -1"});
  refused({.x = {Eigen::VectorXd::Zero(14)}}, {"1 states and 0 controls", "6 and 5"});
}

TEST(ProblemCheck, Trajectory_IsCheckedAtItsStates) {
  const Model model = arm.robot.model();
  Problem problem(checked_spec(arm, model));
  ProblemCheckOptions options{.states = 2, .position = 0.0, .velocity = 0.0, .torque = 0.0};
  std::mt19937_64 generator(4);
  for (int k = 0; k <= problem.knots(); ++k) {
    const OcpState at = random_ocp_state(problem, generator);
    options.x.push_back(at.x);
    if (k < problem.knots()) options.u.push_back(at.u);
  }
  const ProblemReport report = check_problem(problem, options);
  EXPECT_TRUE(report.pass) << report.text();
}

/// Returns a problem of arm7 at rest at its middle posture, with a position target within reach.
ProblemSpec quiescent_spec(const Model& model) {
  ProblemSpec spec{.model = model};
  spec.initial_state = Eigen::VectorXd::Zero(14);
  spec.initial_state.head(7) = (model.q_lower + model.q_upper).cwiseMax(-1e3).cwiseMin(1e3) / 2.0;
  spec.contacts = ocp_contacts(model, "tool");
  spec.contacts[2].reference = Reference::surface(tilt());  // its target does not matter
  spec.stages = {
      {.name = "go",
       .costs = {{.name = "position",
                  .residual = residual::FramePosition{"tool", Eigen::Vector3d(0.3, 0.1, 0.4)}}}}};
  spec.horizon = {{"go", 4}};
  return spec;
}

std::string only_warning(const ProblemSpec& spec) {
  const std::vector<std::string> found = complaints(Problem(spec));
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? "" : found[0];
}

TEST(ProblemWarnings, SensibleProblem_HasNone) {
  const Model model = arm.robot.model();
  EXPECT_EQ(complaints(Problem(quiescent_spec(model))), std::vector<std::string>{});
}

TEST(ProblemWarnings, InactiveSprings_AreNamed) {
  Model model = arm.robot.model();
  model.stiffness[1] = 5.0;
  ProblemSpec spec = quiescent_spec(model);
  spec.actuation.passive_torques = false;
  testing::expect_words(only_warning(spec), {"springs", "passive_torques"});
  spec.actuation.passive_torques = true;
  spec.actuation.slip_velocity = 0.5;  // [rad/s]; the default is too small for steps of 10 ms
  EXPECT_EQ(complaints(Problem(spec)), std::vector<std::string>{});
}

TEST(ProblemWarnings, TargetBeyondReach_IsNamed) {
  const Model model = arm.robot.model();
  ProblemSpec spec = quiescent_spec(model);
  auto& target = std::get<residual::FramePosition>(spec.stages[0].costs[0].residual).target;
  target = Eigen::Vector3d(30.0, 0.0, 0.0);
  testing::expect_words(only_warning(spec),
                        {"go, knot 0", "term 'position'", "30", "from joint 'joint_1'", "'tool'",
                         "at most", "3 more knots"});
  Eigen::VectorXd far(7);
  far << 0.0, 30.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  spec.stages[0].costs[0].residual = residual::FramePlacement{"tool", far};
  testing::expect_words(only_warning(spec), {"from joint 'joint_1'"});
  // A floating robot reaches every target.
  const Model afloat = TestRobot{"arm7", Base::FreeFlyer, "tool"}.model();
  ProblemSpec flying = spec;
  flying.model = afloat;
  flying.initial_state = Eigen::VectorXd::Zero(27);
  flying.initial_state.head(14) = afloat.q_neutral;
  for (const std::string& sentence : complaints(Problem(flying)))
    EXPECT_EQ(sentence.find("from joint"), std::string::npos) << sentence;
}

TEST(ProblemWarnings, StartOffTheSurface_IsNamedWithItsHeight) {
  const Model model = arm.robot.model();
  ProblemSpec spec = quiescent_spec(model);
  const Eigen::Vector3d tool =
      frame_placement(model, spec.initial_state.head(7), "tool").translation();
  const auto over = [&](double height) {
    const Eigen::Vector3d center = tool - Eigen::Vector3d(0.0, 0.0, 0.3 + height);
    spec.contacts = {contact("tool", "world", Reference::on(Quadric::sphere(center, 0.3), tool),
                             Directions::z())};
    spec.contacts[0].name = "pad";
    spec.stages[0].contacts = {"pad"};
    return spec;
  };
  EXPECT_EQ(complaints(Problem(over(0.0))), std::vector<std::string>{});
  testing::expect_words(only_warning(over(0.02)),
                        {"stage 'go'", "'tool' is about 0.02", "m above the surface", "'pad'",
                         "holds it at that distance"});
  testing::expect_words(only_warning(over(-0.02)), {"m below the surface"});
  spec.contacts[0].directions = Directions::x();  // without the direction of the height
  EXPECT_EQ(complaints(Problem(spec)), std::vector<std::string>{});
}

TEST(ProblemWarnings, ReachableTargets_AreNeverNamed) {
  const Model model = arm.robot.model();
  std::mt19937_64 generator(3);
  ProblemSpec spec = quiescent_spec(model);
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    spec.stages[0].costs[0].residual = residual::FramePosition{
        "tool", Eigen::Vector3d(burnish::frame_placement(model, q, "tool").translation())};
    EXPECT_EQ(complaints(Problem(spec)), std::vector<std::string>{});
  }
}

TEST(ProblemWarnings, BadTargetOverTime_IsNamedWithItsKnot) {
  const Model model = arm.robot.model();
  ProblemSpec spec = quiescent_spec(model);
  spec.stages[0].costs[0].residual = residual::FramePosition{
      "tool", Signal::over_time(3, [](double t, Eigen::Ref<Eigen::VectorXd> p) {
        p << 0.3, 0.1, t > 0.015 ? std::numeric_limits<double>::quiet_NaN() : 0.4;
      })};
  testing::expect_words(only_warning(spec), {"go, knot 2", "'position'", "NaN", "1 more knots"});
  spec.stages[0].costs[0].residual = residual::FrameRotation{
      "tool", Signal::over_time(
                  4, [](double t, Eigen::Ref<Eigen::VectorXd> q) { q << 0.0, 0.0, 0.0, 1.0 + t; })};
  testing::expect_words(only_warning(spec), {"go, knot 1", "quaternion", "length 1.01"});
}

TEST(ProblemWarnings, InitialStateBeyondLimits_IsNamed) {
  const Model model = arm.robot.model();
  ProblemSpec spec = quiescent_spec(model);
  spec.initial_state[1] = model.q_upper[1] + 0.5;
  testing::expect_words(only_warning(spec), {"initial state", "'joint_2'", "limits"});
  spec = quiescent_spec(model);
  spec.initial_state[9] = -2.0 * model.velocity_limit[2];
  testing::expect_words(only_warning(spec), {"initial state", "velocity", "'joint_3'"});
}

TEST(ProblemWarnings, BoundsBelowTheStaticTorque_AreNamed) {
  const Model model = arm.robot.model();
  ProblemSpec spec = quiescent_spec(model);
  spec.initial_state[1] += 0.5;
  const Eigen::VectorXd needed = Problem(spec).quasi_static(0, spec.initial_state).control;
  const double max_torque = needed.cwiseAbs().maxCoeff();
  ASSERT_GT(max_torque, 1.0);
  spec.control_upper = Eigen::VectorXd::Constant(1, 1.01 * max_torque);
  spec.control_lower = -spec.control_upper;
  EXPECT_EQ(complaints(Problem(spec)), std::vector<std::string>{});
  spec.control_upper = Eigen::VectorXd::Constant(1, 0.9 * max_torque);
  spec.control_lower = -spec.control_upper;
  testing::expect_words(only_warning(spec), {"stage 'go'", "bounds", "'joint_", "needs"});
  // A contact of the tool in six directions carries most of the weight.
  spec.contact_solver.mu = 1e-3;
  spec.stages[0].contacts = {"pad"};
  EXPECT_EQ(complaints(Problem(spec)), std::vector<std::string>{});
}

TEST(ProblemWarnings, MasslessJoint_IsNamed) {
  Model model = arm.robot.model();
  Joint& last = model.joints.back();
  last.mass = 0.0;
  last.inertia_at_com.setZero();
  model.armature[last.v_index] = 0.0;
  ProblemSpec spec = quiescent_spec(model);
  spec.stages[0].contacts = {"pad"};
  testing::expect_words(only_warning(spec), {"initial posture", "'" + last.name + "'", "no mass"});
}

TEST(ProblemWarnings, RedundantContacts_AreNamed) {
  const Model model = arm.robot.model();
  ProblemSpec spec = quiescent_spec(model);
  spec.stages[0].contacts = {"pad", "idle"};
  const std::vector<std::string> found = complaints(Problem(spec));
  ASSERT_GE(found.size(), 5U);
  testing::expect_words(found.back(), {"stage 'go'", "initial posture", "contact 'pad'", "mu > 0"});
  spec.contact_solver.mu = 1e-3;
  EXPECT_EQ(complaints(Problem(spec)), std::vector<std::string>{});
}

/// Returns a problem with two contacts of one tool, one of which asks the tool to rise.
ProblemSpec contradicting_spec(const Model& model) {
  ProblemSpec spec = quiescent_spec(model);
  spec.stages[0].contacts = {"pad", "idle"};
  for (ContactSpec& contact : spec.contacts) {
    if (contact.name != "idle") continue;
    contact.kp.setConstant(30.0);
    contact.target.translation().z() += 0.5;
  }
  spec.contact_solver = {.mu = 1e-3, .max_proximal_iterations = 100, .proximal_tolerance = 1e-11};
  return spec;
}

TEST(ProblemWarnings, ContradictoryContacts_AreNamed) {
  ProblemSpec spec = contradicting_spec(arm.robot.model());
  std::vector<std::string> found = complaints(Problem(spec));
  ASSERT_EQ(found.size(), 1U);
  testing::expect_words(found[0], {"stage 'go'", "initial state", "pad/", "idle/", "m/s^2",
                                   "contradict each other", "least-squares"});
  spec.contact_solver.max_proximal_iterations = 0;
  found = complaints(Problem(spec));
  ASSERT_EQ(found.size(), 1U);
  testing::expect_words(found[0], {"without proximal iterations", "opposing forces"});
}

TEST(ProblemCheck, CorrectProblemOfAnyScale_Passes) {
  for (const auto& [length, mass] : {std::pair{100.0, 5000.0}, std::pair{0.02, 1e-3}}) {
    const Model model = scaled(arm.robot.model(), length, mass);
    ProblemSpec spec = checked_spec(arm, model);
    spec.contact_solver.mu = 0.05 / mass;
    Problem problem(spec);
    const ProblemReport report = check_problem(problem, {.states = 1});
    EXPECT_TRUE(report.pass) << length << " m, " << mass << " kg\n" << report.text();
  }
}

TEST(ProblemCheck, ContradictoryContacts_Pass) {
  Problem problem(contradicting_spec(arm.robot.model()));
  const ProblemReport report = check_problem(problem);
  EXPECT_TRUE(report.pass) << report.text();
}

}  // namespace
}  // namespace burnish::test
