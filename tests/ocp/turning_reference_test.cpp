// Tests of references that turn from knot to knot: each knot equals that of a problem with constant
// references. Bad rotations are refused, or reported with their knot.
#include <gtest/gtest.h>

#include "support/ocp_cases.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using ReferenceMaker = std::function<Reference(const Anchor& origin, const Anchor& axes)>;

/// Returns references that are constant, with the rotation of a time.
ReferenceMaker constant(double time) {
  return [time](const Anchor& origin, const Anchor& axes) {
    return Reference{origin, axes, turned_at(time)};
  };
}

/// Returns a problem in which every reference turns: contacts, costs and a constraint, with both
/// integrators, an impact and the end.
ProblemSpec all_turned(const OcpCase& test, const Model& model, const ReferenceMaker& turned) {
  namespace R = residual;
  ProblemSpec spec = bare_problem(test, model);
  const std::string tool = test.robot.tool, other = far_frame(model, {tool});
  for (ContactSpec& contact : spec.contacts) {
    const auto [origin, axes] = std::pair(contact.reference.origin, contact.reference.axes);
    contact.reference = turned(origin, contact.name == "pad" ? Anchor(other) : axes);
    contact.with_gains(3.0, 2.0);
  }
  Stage go{.name = "go", .contacts = {"brace", "pad"}};
  go.costs = {{.residual = R::FramePosition{tool, Eigen::Vector3d(1, 2, 3), turned(other, other)}},
              {.residual = R::FrameVelocity{tool, turned(Anchor::World, Anchor::World)}},
              {.name = "own", .residual = R::ContactForce{"pad", {}, 1.0}},
              {.residual = R::ContactForce{"brace", turned(other, Anchor::World)}},
              {.residual = R::FrictionCone{"pad", 0.5, 2, turned(Anchor::Tool, Anchor::Tool)}},
              {.residual = R::custom(WithoutJacobian{.frames = {tool}, .contacts = {"pad"}})}};
  go.constraints = {{"slow",
                     R::FrameVelocity{tool, turned(Anchor::Tool, other)},
                     Eigen::VectorXd::Zero(1),
                     {},
                     Eigen::VectorXd::Ones(1)}};
  Stage precise = go, touch = go;
  precise.name = "precise";
  precise.integrator = Integrator::RungeKutta4;
  touch.name = "touch";
  touch.impact = true;
  touch.costs.resize(2);
  spec.stages = {go, precise, touch};
  spec.horizon = {{"go", native_lanes + 1}, {"touch", 1}, {"precise", 2}};
  spec.terminal = {go.costs[0], go.costs[1]};
  if (test.acts_from_state()) spec.terminal.push_back(go.costs[2]);
  return spec;
}

class TurningReference : public ::testing::TestWithParam<OcpCase> {
 protected:
  /// Compares every knot to that of a problem with constant references, at random states.
  void expect_knots_of_constants(Problem& problem) {
    std::mt19937_64 generator(31);
    OcpHorizon horizon(problem, generator);
    horizon.expand(problem);
    for (int k = 0; k <= problem.knots(); ++k) {
      SCOPED_TRACE(problem.knot_name(k));
      Problem still(all_turned(GetParam(), model, constant(problem.time_of(k))));
      for (int i = 0; i <= still.knots(); ++i)
        still.set_knot(i, i < still.knots() ? problem.stage_of(i) : 0, problem.time_of(i));
      OcpHorizon wanted = horizon;
      for (std::size_t i = 0; i < wanted.out.size(); ++i) wanted.point_at(i);
      wanted.expand(still);
      expect_same_knot(problem, k, horizon, wanted);
      const Eigen::VectorXd x = horizon.x_of(problem, k), u = horizon.u_of(problem, k);
      expect_close(problem.forces(k, x, u), still.forces(k, x, u), "forces");
      if (problem.controls(k) > 0)
        expect_close(problem.acceleration(k, x, u), still.acceleration(k, x, u), "acceleration");
    }
  }
  static void expect_close(const Eigen::MatrixXd& got, const Eigen::MatrixXd& want,
                           const char* what) {
    EXPECT_LT(relative_error(got, want, 1e-3), 1e-9) << what;
  }
  void expect_same_knot(const Problem& problem, int k, const OcpHorizon& got,
                        const OcpHorizon& want) {
    const auto at = static_cast<std::size_t>(k);
    ASSERT_EQ(got.values[at].status, Status::Ok);
    EXPECT_NEAR(got.values[at].cost, want.values[at].cost,
                1e-10 * std::max(1.0, std::abs(want.values[at].cost)));
    const int nz = problem.controls(k) + problem.state().ndx;
    expect_close(got.gradient[at].head(nz), want.gradient[at].head(nz), "gradient");
    expect_close(got.hessian[at].topLeftCorner(nz, nz).triangularView<Eigen::Lower>(),
                 want.hessian[at].topLeftCorner(nz, nz).triangularView<Eigen::Lower>(), "Hessian");
    expect_close(got.row_values[at], want.row_values[at], "rows");
    if (problem.rows(k) > 0)
      expect_close(got.rows[at].leftCols(nz), want.rows[at].leftCols(nz), "derivative of the rows");
    if (k == problem.knots()) return;
    expect_close(got.next_of(problem, k), want.next_of(problem, k), "next state");
    const bool dense =
        problem.spec().stages[static_cast<std::size_t>(problem.stage_of(k))].integrator ==
        Integrator::RungeKutta4;
    const int rows = dense ? problem.state().ndx : problem.state().nv;
    expect_close(got.dynamics[at].topLeftCorner(rows, nz),
                 want.dynamics[at].topLeftCorner(rows, nz), "derivative of the next state");
  }
  Model model = GetParam().robot.model();
};

TEST_P(TurningReference, EachKnot_EqualsAConstantReference) {
  Problem problem(all_turned(GetParam(), model, turning_reference));
  expect_knots_of_constants(problem);
}

TEST_P(TurningReference, AdvancedHorizon_EqualsConstantReferences) {
  Problem problem(all_turned(GetParam(), model, turning_reference));
  problem.advance(0);
  problem.set_knot(2, 1, 3.3);
  expect_knots_of_constants(problem);
}

INSTANTIATE_TEST_SUITE_P(Robots, TurningReference,
                         ::testing::Values(arm, OcpCase{arm.robot, true}, OcpCase{humanoid()}),
                         [](const auto& test) { return test.param.label(); });

std::string refusal_of(const Signal& rotation, bool of_contact) {
  const Model model = arm.robot.model();
  const ReferenceMaker turned = [&](const Anchor& origin, const Anchor& axes) {
    return Reference{.origin = origin, .axes = axes, .rotation_over_time = rotation};
  };
  ProblemSpec spec = bare_problem(arm, model);
  if (of_contact) spec.contacts[2].reference = turned(Anchor::Tool, Anchor::Base);
  const Reference seen = turned(Anchor::World, Anchor::World);
  spec.stages = {{.name = "go",
                  .contacts = {"pad"},
                  .costs = {{.residual = residual::FrameVelocity{
                                 "tool", of_contact ? Reference::centered() : seen}}}}};
  spec.horizon = {{"go", 3}};
  return testing::refusal([&] { Problem{spec}; });
}

TEST(TurningReferenceRefusal, BadRotation_IsRefusedWithItsPlace) {
  const Signal fades = Signal::over_time(4, [](double t, Eigen::Ref<Eigen::VectorXd> xyzw) {
    xyzw << 0.0, 0.0, 0.0, t < 0.715 ? 1.0 : 0.0;
  });
  using testing::expect_words;
  expect_words(refusal_of(Eigen::VectorXd::Zero(4), true),
               {"contact 'pad'", "length 0", "at 0.7 s", "length 1"});
  expect_words(refusal_of(Eigen::Vector4d(0.0, 0.0, 0.0, 1.1), false),
               {"stage 'go'", "'frame velocity'", "length 1.1", "length 1"});
  expect_words(refusal_of(Eigen::Vector3d(0.0, 0.0, 1.0), true),
               {"contact 'pad'", "3 entries", "x, y, z, w"});
  expect_words(refusal_of(fades, true), {"stage 'go', knot 2", "contact 'pad'", "at 0.72 s"});
  expect_words(refusal_of(fades, false), {"stage 'go', knot 2", "reference", "at 0.72 s"});
  Reference both = turning_reference(Anchor::Tool, Anchor::World);
  both.rotation = tilt();
  expect_words(testing::refusal([&] { both.check("this"); }), {"this", "one of them"});
}

TEST(TurningReferenceRefusal, RotationOverTimeOutsideProblems_IsRefused) {
  const Model model = arm.robot.model();
  const Reference turns = turning_reference(Anchor::Tool, Anchor::World);
  testing::expect_words(testing::refusal([&] {
                          ContactDynamics{model, {contact("tool", "world", turns)}};
                        }),
                        {"contact 'tool'", "over time", "Reference::at"});
}

TEST(TurningReferenceStatus, BadRotationAtAKnot_IsReportedAtThatKnot) {
  const Model model = arm.robot.model();
  const ReferenceMaker fades = [](const Anchor& origin, const Anchor& axes) {
    return Reference{
        .origin = origin,
        .axes = axes,
        .rotation_over_time = Signal::over_time(4, [](double t, Eigen::Ref<Eigen::VectorXd> q) {
          q << 0.0, 0.0, 0.0, t < 2.0 ? 1.0 : 0.5;
        })};
  };
  Problem problem(all_turned(arm, model, fades));
  problem.set_knot(1, 0, 2.1);
  std::mt19937_64 generator(5);
  OcpHorizon horizon(problem, generator);
  horizon.expand(problem);
  for (int k = 0; k <= problem.knots(); ++k) {
    const Status status = horizon.values[static_cast<std::size_t>(k)].status;
    EXPECT_EQ(status == Status::Ok, k != 1) << problem.knot_name(k) << ": " << describe(status);
  }
}

}  // namespace
}  // namespace burnish::test
