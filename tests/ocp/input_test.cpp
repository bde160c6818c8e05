// Tests of a problem's inputs: a problem with a value set equals one that is built with that value.
#include <gtest/gtest.h>

#include <functional>

#include "support/allocation_guard.hpp"
#include "support/ocp_cases.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

constexpr int knots = native_lanes + 1;

Eigen::VectorXd one(double value) { return Eigen::VectorXd::Constant(1, value); }

Quadric surface_at(double time) {
  return Quadric::osculating(Eigen::Vector3d(0.1, 0.2 * time, -0.4), turned_at(0.2 * time),
                             0.3 + time, -0.1, -0.4 * time);
}

Signal moving(int size) {
  return Signal::over_time(size, [size](double t, Eigen::Ref<Eigen::VectorXd> out) {
    for (int i = 0; i < size; ++i) out[i] = 0.2 * i + std::sin(3.0 * t);
  });
}

/// Problem of one stage with one cost, whose contact "pad" slides on a curved surface.
ProblemSpec problem_with(const Model& model, CostTerm cost, std::vector<InputSpec> inputs = {}) {
  ProblemSpec spec = bare_problem(arm, model);
  for (ContactSpec& contact : spec.contacts) {
    if (contact.name != "pad") continue;
    contact.base = "world";
    contact.reference = Reference::on(surface_at(0.0), {0.3, 0.1, 0.2});
    contact.directions = Directions::z();
    contact.friction = SlidingFriction{0.2, 0.1, 0.02};
  }
  cost.name = "seen";
  spec.inputs = std::move(inputs);
  spec.stages = {{.name = "go", .contacts = {"pad"}, .costs = {std::move(cost)}}};
  spec.horizon = {{"go", knots}};
  return spec;
}

ContactSpec& pad_of(ProblemSpec& spec) {
  return *std::find_if(spec.contacts.begin(), spec.contacts.end(),
                       [](const ContactSpec& contact) { return contact.name == "pad"; });
}

/// Returns the problem with a pad that does not slide.
ProblemSpec held(ProblemSpec spec) {
  pad_of(spec).directions = Directions::linear();
  pad_of(spec).friction.reset();
  return spec;
}

class Input : public ::testing::Test {
 protected:
  /// Expects that costs, gradients and next states of all knots are equal to the last bit.
  void expect_same(Problem& problem, Problem& wanted) {
    std::mt19937_64 generator(7);
    OcpHorizon at(problem, generator);
    OcpHorizon still = at;
    for (std::size_t i = 0; i < still.out.size(); ++i) still.point_at(i);
    at.expand(problem);
    still.expand(wanted);
    EXPECT_EQ(at.next, still.next);
    for (std::size_t k = 0; k < at.values.size(); ++k) {
      EXPECT_EQ(at.values[k].status, Status::Ok) << k;
      EXPECT_EQ(at.values[k].cost, still.values[k].cost) << k;
      const int nz = problem.controls(static_cast<int>(k)) + problem.state().ndx;
      EXPECT_EQ(at.gradient[k].head(nz), still.gradient[k].head(nz)) << k;
    }
  }
  /// Residual of the only cost at a knot, at a fixed state.
  Eigen::VectorXd residual(Problem& problem, int knot) {
    return problem.residual(knot, 0, problem.spec().initial_state,
                            Eigen::VectorXd::Constant(problem.layout().nu, 0.3));
  }

  Model model = arm.robot.model();
};

TEST_F(Input, ScalarOffset_MovesTheTarget) {
  const auto made = [&](const Signal& target, const std::string& input) {
    return problem_with(
        model, {.residual = residual::ContactForce{"pad", {}, target}, .offset_input = input},
        {{.name = "error"}});
  };
  Problem problem(made(2.0, "error")), plain(made(2.0, "")), shifted(made(2.0 + 0.75, ""));
  expect_same(problem, plain);
  ASSERT_EQ(problem.set_input(0, one(0.75)), Status::Ok);
  expect_same(problem, shifted);
  for (int k = 0; k < knots; ++k) problem.set_knot(k, 0, problem.time_of(k));
  expect_same(problem, shifted);
  problem.reset_input(0);
  expect_same(problem, plain);
}

TEST_F(Input, VectorOffset_MovesATargetOverTime) {
  const Eigen::Vector3d offset(0.1, -0.2, 0.3);
  CostTerm cost{.residual = residual::FramePosition{"tool", moving(3)}, .offset_input = "shift"};
  Problem problem(problem_with(
      model, cost,
      {{.name = "shift", .kind = InputKind::Vector, .value = Eigen::Vector3d::Zero().eval()}}));
  const auto at = [&](int k) { return residual(problem, k); };
  const Eigen::VectorXd first = at(0), last = at(knots - 1);
  ASSERT_EQ(problem.set_input(0, offset), Status::Ok);
  EXPECT_LT((at(0) - (first - offset)).norm(), 1e-15);
  EXPECT_LT((at(knots - 1) - (last - offset)).norm(), 1e-15);
  EXPECT_EQ(problem.set_input(0, one(1.0)), Status::WrongSize);
  EXPECT_EQ(problem.set_input(0, Eigen::Vector3d(0.0, NAN, 0.0)), Status::NotFinite);
  EXPECT_LT((at(0) - (first - offset)).norm(), 1e-15);
}

TEST_F(Input, Rotation_TurnsTheTargetInItsOwnAxes) {
  const Eigen::Quaterniond target(turned_at(0.3)), turn(turned_at(0.1));
  const auto made = [&](const Eigen::Quaterniond& R, const std::string& input) {
    return problem_with(model,
                        {.residual = residual::FrameRotation{"tool", Eigen::Vector4d(R.coeffs())},
                         .offset_input = input},
                        {{.name = "turn", .kind = InputKind::Rotation}});
  };
  Problem problem(made(target, "turn")), wanted(made(target * turn, ""));
  ASSERT_EQ(problem.set_input(0, turn.coeffs()), Status::Ok);
  EXPECT_LT((residual(problem, 1) - residual(wanted, 1)).norm(), 1e-14);
  EXPECT_EQ(problem.set_input(0, Eigen::Vector4d::Ones()), Status::NotNormalized);
}

TEST_F(Input, Placement_HasAnOffsetAndARotation) {
  Eigen::VectorXd target(7);
  target << 0.1, 0.2, 0.3, Eigen::Quaterniond(turned_at(0.3)).coeffs();
  for (const InputKind kind : {InputKind::Vector, InputKind::Rotation}) {
    InputSpec input{.name = "move", .kind = kind};
    if (kind == InputKind::Vector) input.value = Eigen::Vector3d::Zero().eval();
    Problem problem(problem_with(
        model, {.residual = residual::FramePlacement{"tool", target}, .offset_input = "move"},
        {input}));
    const Eigen::VectorXd before = residual(problem, 0);
    const Eigen::VectorXd value =
        kind == InputKind::Vector ? Eigen::VectorXd(Eigen::Vector3d(0.1, 0.0, 0.0))
                                  : Eigen::VectorXd(Eigen::Quaterniond(turned_at(0.1)).coeffs());
    ASSERT_EQ(problem.set_input(0, value), Status::Ok);
    EXPECT_GT((residual(problem, 0) - before).norm(), 1e-3);
  }
}

TEST_F(Input, FrictionRatio_ScalesConesByAtMostOne) {
  const auto made = [&](double friction, const std::string& input) {
    return held(
        problem_with(model,
                     {.residual = residual::FrictionCone{.contact = "pad", .friction = friction},
                      .friction_ratio_input = input},
                     {{.name = "ratio"}}));
  };
  Problem problem(made(0.6, "ratio")), half(made(0.3, "")), whole(made(0.6, ""));
  expect_same(problem, whole);
  ASSERT_EQ(problem.set_input(0, one(0.5)), Status::Ok);
  expect_same(problem, half);
  ASSERT_EQ(problem.set_input(0, one(2.0)), Status::Ok);
  expect_same(problem, whole);
  EXPECT_EQ(problem.set_input(0, one(-0.1)), Status::NotFinite);
  EXPECT_EQ(problem.set_input(0, one(0.1), one(-0.5), 0.1), Status::NotFinite);
}

TEST_F(Input, Coefficient_ReplacesTheFrictionOfAContact) {
  const CostTerm cost{.residual = residual::ContactForce{"pad", {}, 1.0}};
  ProblemSpec spec = problem_with(model, cost, {{.name = "mu"}}), other = spec;
  pad_of(spec).friction->coefficient_input = "mu";
  pad_of(other).friction->coefficient = 0.45;
  Problem problem(spec), wanted(other);
  ASSERT_EQ(problem.set_input(0, one(0.45)), Status::Ok);
  expect_same(problem, wanted);
}

TEST_F(Input, Surface_IsFollowedByContactsAndTerms) {
  const auto made = [&](const Quadric& surface, const std::string& input) {
    Reference reference = Reference::on(surface_at(0.0), {0.3, 0.1, 0.2});
    reference.quadric = surface;
    ProblemSpec spec = problem_with(
        model, {.residual = residual::FrameHeight{"tool", reference}, .surface_input = input},
        {{.name = "surface", .kind = InputKind::Surface}});
    pad_of(spec).reference.quadric = surface;
    pad_of(spec).surface_input = input;
    return spec;
  };
  Problem problem(made(surface_at(0.0), "surface")), wanted(made(surface_at(0.7), ""));
  ASSERT_EQ(problem.set_input(0, surface_at(0.7)), Status::Ok);
  expect_same(problem, wanted);
  Quadric bad = surface_at(0.7);
  bad.c = NAN;
  EXPECT_EQ(problem.set_input(0, bad), Status::NotFinite);
  EXPECT_EQ(problem.set_input(0, surface_at(0.7), -1.0), Status::NotFinite);
}

TEST_F(Input, Depth_MovesATargetIntoTheSurface) {
  const Eigen::Vector3d p(0.3, 0.1, 0.2);
  const Eigen::VectorXd none = Eigen::Vector3d::Zero();
  Problem problem(problem_with(model,
                               {.residual = residual::FramePosition{"tool", p},
                                .offset_input = "shift",
                                .surface_input = "surface"},
                               {{.name = "surface", .kind = InputKind::Surface},
                                {.name = "shift", .kind = InputKind::Vector, .value = none}}));
  const Eigen::VectorXd before = residual(problem, 2);
  const Eigen::Vector3d shift(0.01, 0.02, 0.03);
  ASSERT_EQ(problem.set_input(0, surface_at(0.7), 0.004), Status::Ok);
  ASSERT_EQ(problem.set_input(1, shift), Status::Ok);
  const Eigen::Vector3d normal = surface_at(0.7).gradient(p + shift).normalized();
  EXPECT_LT((residual(problem, 2) - (before - shift + 0.004 * normal)).norm(), 1e-14);
  ASSERT_EQ(problem.set_input(0, surface_at(0.7), 0.0), Status::Ok);
  EXPECT_LT((residual(problem, 2) - (before - shift)).norm(), 1e-14);
}

TEST_F(Input, DecayingValue_FallsFromTheFirstKnotOn) {
  const CostTerm cost{.residual = residual::ContactForce{"pad", {}, 2.0}, .offset_input = "error"};
  Problem problem(problem_with(model, cost, {{.name = "error"}}));
  ASSERT_EQ(problem.set_input(0, one(1.0), one(4.0), 0.05), Status::Ok);
  const auto expected = [&](int k) {
    return 1.0 + 4.0 * std::exp(-(problem.time_of(k) - problem.time_of(0)) / 0.05);
  };
  for (int k = 0; k <= knots; ++k) EXPECT_NEAR(problem.input_at(0, k)[0], expected(k), 1e-14) << k;
  problem.advance(0);
  for (int k = 0; k <= knots; ++k) EXPECT_NEAR(problem.input_at(0, k)[0], expected(k), 1e-14) << k;
  EXPECT_EQ(problem.set_input(0, one(1.0), one(4.0), 0.0), Status::NotFinite);
  EXPECT_EQ(problem.set_input(0, one(1.0), Eigen::Vector2d(1.0, 1.0), 0.1), Status::WrongSize);
}

TEST_F(Input, ValueOverTime_HoldsUntilOneIsSet) {
  const CostTerm cost{.residual = residual::ContactForce{"pad", {}, 2.0}, .offset_input = "ramp"};
  Problem problem(problem_with(model, cost, {{.name = "ramp", .value = moving(1)}}));
  const auto ramp = [&](int k) { return std::sin(3.0 * problem.time_of(k)); };
  for (int k = 0; k <= knots; ++k) EXPECT_EQ(problem.input_at(0, k)[0], ramp(k)) << k;
  ASSERT_EQ(problem.set_input(0, one(0.5)), Status::Ok);
  EXPECT_EQ(problem.input_at(0, 3)[0], 0.5);
  problem.reset_input(0);
  EXPECT_EQ(problem.input_at(0, 3)[0], ramp(3));
}

TEST_F(Input, TorqueBias_EqualsSetTorqueBias) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(model.nv);
  const Eigen::VectorXd torque = Eigen::VectorXd::LinSpaced(model.nv, -1.0, 2.0);
  const CostTerm cost{.residual = residual::ContactForce{"pad", {}, 2.0}};
  ProblemSpec spec =
      problem_with(model, cost, {{.name = "bias", .kind = InputKind::Vector, .value = torque}});
  Problem plain(spec);
  spec.torque_bias_input = "bias";
  Problem problem(spec);
  ASSERT_EQ(plain.set_torque_bias(torque), Status::Ok);
  expect_same(problem, plain);
  ASSERT_EQ(problem.set_input(0, none, torque, 0.2), Status::Ok);
  ASSERT_EQ(plain.set_torque_bias(none, torque, 0.2), Status::Ok);
  expect_same(problem, plain);
  problem.reset_input(0);
  ASSERT_EQ(plain.set_torque_bias(torque), Status::Ok);
  expect_same(problem, plain);
}

TEST_F(Input, Inertia_EqualsSetPayload) {
  const CostTerm cost{.residual = residual::ContactForce{"pad", {}, 2.0}};
  const InertiaSpec load{.mass = 2.0, .com = {0.0, 0.1, 0.2}};
  ProblemSpec spec =
      problem_with(model, cost, {{.name = "load", .kind = InputKind::Inertia, .frame = "tool"}});
  Problem problem(spec), plain(spec), empty(spec);
  ASSERT_EQ(problem.set_input(0, load), Status::Ok);
  ASSERT_EQ(plain.set_payload("tool", load), Status::Ok);
  expect_same(problem, plain);
  problem.reset_input(0);
  expect_same(problem, empty);
}

TEST_F(Input, SignalOfInputs_FollowsTheInput) {
  const Signal target = Signal::of_inputs(
      1, [](double t, const InputValues& inputs, Eigen::Ref<Eigen::VectorXd> out) {
        out[0] = std::min(t, inputs.scalar(1)) + inputs.scalar(2);
      });
  Problem problem(problem_with(model, {.residual = residual::ContactForce{"pad", {}, target}},
                               {{.name = "surface", .kind = InputKind::Surface},
                                {.name = "until", .value = 10.0},
                                {.name = "level"}}));
  const double first = residual(problem, 2)[0];
  ASSERT_EQ(problem.set_input(1, one(0.705)), Status::Ok);
  ASSERT_EQ(problem.set_input(2, one(0.5)), Status::Ok);
  for (int k = 0; k <= knots; ++k) problem.set_knot(k, 0, problem.time_of(k));
  EXPECT_NEAR(residual(problem, 2)[0], first + problem.time_of(2) - 0.705 - 0.5, 1e-13);
  EXPECT_TRUE(std::isnan(InputValues().scalar(0)));
}

TEST_F(Input, Advance_EqualsANewHorizon) {
  const auto made = [&](double start) {
    ProblemSpec spec = problem_with(
        model, {.residual = residual::FramePosition{"tool", moving(3)}, .offset_input = "shift"},
        {{.name = "shift", .kind = InputKind::Vector, .value = moving(3)}});
    spec.start_time = start;
    return spec;
  };
  Problem problem(made(0.5)), later(made(0.51));
  problem.advance(0);
  for (int k = 0; k <= knots; ++k) {
    EXPECT_LT((problem.input_at(0, k) - later.input_at(0, k)).norm(), 1e-12) << k;
    if (k < knots) {
      EXPECT_LT((residual(problem, k) - residual(later, k)).norm(), 1e-12) << k;
    }
  }
}

TEST_F(Input, SetTarget_StaysUntilAnInputOfTheTermIsSet) {
  CostTerm cost{.residual = residual::ContactForce{"pad", {}, 2.0}, .offset_input = "error"};
  Problem problem(problem_with(model, cost, {{.name = "error"}, {.name = "unused"}}));
  const double before = residual(problem, 1)[0];
  ASSERT_EQ(problem.set_target(1, 0, one(5.0)), Status::Ok);
  ASSERT_EQ(problem.set_input(1, one(7.0)), Status::Ok);
  EXPECT_NEAR(residual(problem, 1)[0], before - 3.0, 1e-14);
  ASSERT_EQ(problem.set_input(0, one(1.0)), Status::Ok);
  EXPECT_NEAR(residual(problem, 1)[0], before - 1.0, 1e-14);
}

TEST_F(Input, SetInput_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  CostTerm cost{.residual = residual::ContactForce{"pad", {}, 2.0}, .offset_input = "error"};
  ProblemSpec spec = problem_with(
      model, cost, {{.name = "error"}, {.name = "surface", .kind = InputKind::Surface}});
  pad_of(spec).surface_input = "surface";
  Problem problem(spec);
  const Eigen::VectorXd value = one(1.0);
  const Quadric surface = surface_at(0.7);
  const AllocationGuard guard;
  ASSERT_EQ(problem.set_input(0, value), Status::Ok);
  ASSERT_EQ(problem.set_input(0, value, value, 0.1), Status::Ok);
  ASSERT_EQ(problem.set_input(1, surface, 0.01), Status::Ok);
  problem.reset_input(1);
  problem.advance(0);
  EXPECT_EQ(guard.count(), 0);
}

TEST_F(Input, InvalidSpecifications_AreRefused) {
  const residual::ContactForce force{"pad", {}, Eigen::Vector3d(0.0, 0.0, 2.0)};
  const auto refused = [&](const CostTerm& cost, const std::vector<InputSpec>& inputs,
                           const std::vector<std::string>& words) {
    testing::expect_words(
        testing::refusal([&] { Problem problem(held(problem_with(model, cost, inputs))); }), words);
  };
  const CostTerm offset{.residual = residual::JointPosition{{"joint_1"}}, .offset_input = "error"};
  const InputSpec scalar{.name = "error"};
  refused(offset, {}, {"'seen'", "'error'", "the problem has no inputs"});
  refused(offset, {{.name = "errors"}}, {"unknown input 'error'", "'errors'"});
  refused(offset, {scalar, scalar}, {"'error'", "used twice"});
  refused(offset, {{.name = "error", .kind = InputKind::Surface}},
          {"offset_input", "is a surface", "wanted a scalar"});
  refused(offset, {{.name = "error", .kind = InputKind::Vector}}, {"has no value"});
  refused(offset, {{.name = "error", .value = Eigen::Vector2d(1.0, 2.0)}},
          {"2 entries", "wanted 1"});
  refused(offset, {{.name = "error", .value = NAN}}, {"NaN"});
  refused(offset, {{.name = "error", .frame = "tool"}}, {"cannot have a frame"});
  refused(offset, {{.name = ""}}, {"an input has no name"});
  refused({.residual = residual::State{}, .offset_input = "error"}, {scalar},
          {"cannot change the target"});
  refused({.residual = force, .friction_ratio_input = "error"}, {scalar},
          {"no coefficient of friction"});
  refused({.residual = residual::FrictionCone{.contact = "pad"}, .offset_input = "error"}, {scalar},
          {"cannot change the target"});
  refused(offset,
          {{.name = "error",
            .value = Signal::of_inputs(
                1, [](double, const InputValues&, Eigen::Ref<Eigen::VectorXd>) {})}},
          {"'error'", "depends on inputs"});
  refused({.residual = residual::FrictionCone{.contact = "pad"}, .friction_ratio_input = "error"},
          {{.name = "error",
            .value = Signal::over_time(
                1, [](double t, Eigen::Ref<Eigen::VectorXd> out) { out[0] = 0.7 - t; })}},
          {"'error'", "value at 0.71 s", "at least 0"});
  refused({.residual = force, .surface_input = "s"}, {{.name = "s", .kind = InputKind::Surface}},
          {"neither a curved reference nor a target position"});
  refused({.residual = residual::FramePosition{"tool", moving(3)}, .surface_input = "error"},
          {scalar}, {"'error' is a scalar", "wanted a surface"});
  refused({.residual = force}, {{.name = "load", .kind = InputKind::Inertia, .frame = "toll"}},
          {"'load'", "'toll'", "'tool'"});
  refused({.residual = force}, {{.name = "load", .kind = InputKind::Inertia}}, {"'load'"});
  refused({.residual = force}, {{.name = "load", .kind = InputKind::Inertia, .frame = "base"}},
          {"'load'", "fixed to the world"});
  const InputSpec load{.name = "load", .kind = InputKind::Inertia, .frame = "tool"};
  InputSpec second = load;
  second.name = "second";
  refused({.residual = force}, {load, second},
          {"'second'", "frame of input 'load' are on one body"});
  refused({.residual = residual::FrictionCone{.contact = "pad"}, .friction_ratio_input = "error"},
          {{.name = "error", .value = -0.5}},
          {"'error'", "the value is -0.5", "a friction coefficient"});
}

TEST_F(Input, InvalidCalls_AreRefused) {
  const CostTerm cost{.residual = residual::ContactForce{"pad", {}, 2.0}, .offset_input = "error"};
  Problem problem(problem_with(model, cost, {{.name = "error"}}));
  const auto refused = [](auto&& call, const std::vector<std::string>& words) {
    testing::expect_words(testing::refusal(call), words);
  };
  EXPECT_EQ(problem.input_names(), std::vector<std::string>{"error"});
  EXPECT_EQ(problem.input_index("error"), 0);
  refused([&] { (void)problem.input_index("eror"); }, {"'eror'", "'error'"});
  refused([&] { (void)problem.set_input(1, one(1.0)); }, {"set_input", "input 1", "0 to 0"});
  refused([&] { (void)problem.set_input(0, surface_at(0.0)); },
          {"set_input", "'error' is a scalar", "wanted a surface"});
  refused([&] { (void)problem.set_input(0, InertiaSpec{}); }, {"wanted an inertia"});
  refused([&] { (void)problem.input_at(0, knots + 1); }, {"input_at", "knot"});
  refused([&] { problem.reset_input(-1); }, {"reset_input", "input -1"});
}

}  // namespace
}  // namespace burnish::test
