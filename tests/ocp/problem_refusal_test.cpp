// Tests that invalid problems are refused with a sentence that names object, value and place.
#include <gtest/gtest.h>

#include <limits>

#include "support/refusal.hpp"
#include "support/residual_cases.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

struct BadSpec {
  std::string name;
  std::function<void(ProblemSpec&)> spoil;
  std::vector<std::string> words;
};
void PrintTo(const BadSpec& test, std::ostream* out) { *out << test.name; }

/// Returns a valid problem of arm7: stage 'press' with one position cost.
ProblemSpec good_spec() {
  const OcpCase test{{"arm7", Base::Fixed, "tool"}};
  ProblemSpec spec = bare_problem(test, test.robot.model());
  spec.contact_solver.mu = 1e-3;
  spec.stages = {
      {.name = "press",
       .contacts = {"pad"},
       .costs = {{.name = "position",
                  .residual = residual::FramePosition{"tool", Eigen::Vector3d(0.3, 0.0, 0.4)}}}}};
  spec.horizon = {{"press", 3}};
  return spec;
}

CostTerm& term(ProblemSpec& spec) { return spec.stages[0].costs[0]; }
/// Returns a change that replaces the residual of the only term.
auto with(const Residual& residual) {
  return [residual](ProblemSpec& spec) { term(spec).residual = residual; };
}
auto with_penalty(const Penalty& penalty) {
  return [penalty](ProblemSpec& spec) { term(spec).penalty = penalty; };
}

std::vector<BadSpec> bad_targets() {
  namespace R = residual;
  const Eigen::Vector3d p(0.3, 0.0, nan);
  const Eigen::Vector4d long_one(0.0, 0.0, 0.0, 2.0);
  Eigen::VectorXd placement(7), state = Eigen::VectorXd::Zero(14);
  placement << 0.3, 0.0, 0.4, 0.5, 0.5, 0.5, 0.6;
  state[2] = infinity;
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(2, 2) = -1.0;
  return {
      {"target_nan",
       with(R::FramePosition{"tool", p}),
       {"stage 'press'", "term 'position'", "target", "NaN"}},
      {"target_missing", with(R::FramePosition{"tool"}), {"the target is missing", "3 entries"}},
      {"target_size",
       with(R::FramePosition{"tool", Eigen::Vector2d(0.0, 0.0)}),
       {"target has 2 entries", "wanted 3"}},
      {"target_size_over_time",
       with(
           R::FramePosition{"tool", Signal::over_time(2, [](double, auto out) { out.setZero(); })}),
       {"target has 2 entries", "wanted 3"}},
      {"quaternion", with(R::FrameRotation{"tool", long_one}), {"quaternion", "length 2"}},
      {"placement_quaternion",
       with(R::FramePlacement{"tool", placement}),
       {"quaternion", "length"}},
      {"state_infinite", with(R::State{state}), {"target", "infinity"}},
      {"state_size", with(R::State{Eigen::VectorXd::Zero(3)}), {"3 entries", "wanted 14"}},
      {"axes",
       with(R::FramePosition{"tool", 0.0, Reference::world(2.0 * Eigen::Matrix3d::Identity())}),
       {"reference", "rotation"}},
      {"mirrored_axes",
       with(R::FramePosition{"tool", 0.0, Reference::world(mirror)}),
       {"reference", "rotation"}},
      {"position_from_itself",
       with(R::FramePosition{"tool", 0.0, Reference::centered()}),
       {"'position'", "origin is the frame itself", "wanted the world"}},
      {"distance_missing", with(R::FrameDistance{"tool"}), {"the target is missing", "3 entries"}},
      {"distance_from_itself",
       with(R::FrameDistance{"tool", {}, Directions::linear(), Reference::local()}),
       {"'position'", "origin is the frame itself", "wanted the world"}},
      {"distance_along_nothing",
       with(R::FrameDistance{"tool", 0.0, {}}),
       {"directions are ''", "one or more of x, y and z"}},
      {"distance_along_a_turn",
       with(R::FrameDistance{"tool", 0.0, Directions::pad_z()}),
       {"directions are 'z,rx,ry'", "one or more of x, y and z"}},
      {"rotation_against_itself",
       with(R::FrameRotation{"tool", Eigen::Vector4d(0.0, 0.0, 0.0, 1.0), Reference::local()}),
       {"'position'", "the reference's axes are the frame's own"}},
      {"inclination_of_itself",
       with(R::FrameInclination{"tool", Reference::local()}),
       {"'position'", "the reference's axes are the frame's own"}},
      {"inclination_of_no_axis",
       with(R::FrameInclination{"tool", Reference::world(), Eigen::Vector3d::Zero()}),
       {"the axis is not finite or has length 0"}},
      {"inclination_target",
       with(R::FrameInclination{"tool", Reference::world(), Eigen::Vector3d::UnitZ(),
                                Eigen::Vector3d::Zero()}),
       {"target has 3 entries", "wanted 2"}},
      {"height_above_nothing",
       with(R::FrameHeight{"tool", Reference::world()}),
       {"'position'", "has no curved surface", "Reference::on"}},
      {"surface_of_the_tool",
       with(R::FrameHeight{"tool", following(ball(), Anchor::Tool)}),
       {"fixed to the tool itself", "wanted a surface fixed to the base"}},
      {"axes_of_no_frame",
       with(R::FrameVelocity{"tool", Reference{Anchor::Tool, "link_9"}}),
       {"'position'", "reference", "'link_9'", "did you mean"}},
  };
}

std::vector<BadSpec> bad_residuals() {
  namespace R = residual;
  const auto own = [](int rows, bool with_value) {
    R::Custom custom{.name = "mine", .rows = rows};
    if (with_value)
      custom.value = [](const NodeView&, Eigen::Ref<Eigen::VectorXd> out) { out.setZero(); };
    return custom;
  };
  const Reference stretched = Reference::surface(2.0 * Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d mirrored = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
  const auto cone_of = [](int sides) { return R::FrictionCone{.contact = "pad", .sides = sides}; };
  const auto at_the_end = [](const Residual& residual) {
    return
        [residual](ProblemSpec& spec) { spec.terminal = {{.name = "last", .residual = residual}}; };
  };
  const auto at_an_impact = [](const Residual& residual) {
    return [residual](ProblemSpec& spec) {
      spec.stages[0].impact = true;
      term(spec).residual = residual;
    };
  };
  return {
      {"frame", with(R::FramePosition{"tol", 0.0}), {"'tol'", "did you mean 'tool'?"}},
      {"joint", with(R::JointPosition{{"joint_9"}}), {"'joint_9'", "did you mean"}},
      {"contact", with(R::ContactForce{"pads"}), {"'pads'", "did you mean 'pad'?"}},
      {"inactive_contact", with(R::ContactForce{"brace"}), {"'brace'", "is not active"}},
      {"cone_of_a_line",
       [](ProblemSpec& spec) {
         spec.stages[0].contacts = {"brace"};
         term(spec).residual = R::FrictionCone{"brace"};
       },
       {"'brace'", "holds z", "wanted directions that include x,y,z"}},
      {"pressure_of_a_line",
       [](ProblemSpec& spec) {
         spec.stages[0].contacts = {"brace"};
         term(spec).residual = R::CenterOfPressure{"brace"};
       },
       {"'brace'", "holds z", "wanted directions that include z,rx,ry"}},
      {"friction", with(R::FrictionCone{"pad", -0.1}), {"friction is -0.1"}},
      {"friction_infinite", with(R::FrictionCone{"pad", infinity}), {"friction is inf"}},
      {"normal", with(R::FrictionCone{"pad", 0.5, 3}), {"normal is 3", "0, 1 or 2"}},
      {"cone_of_two_sides", with(cone_of(2)), {"sides is 2", "wanted 3 to 32", "0 for the cone"}},
      {"cone_of_fewer_than_no_sides", with(cone_of(-4)), {"sides is -4", "wanted 3 to 32"}},
      {"cone_of_too_many_sides", with(cone_of(33)), {"sides is 33", "wanted 3 to 32"}},
      {"half_length", with(R::CenterOfPressure{"pad", 0.0, 0.1}), {"half lengths", "positive"}},
      {"force_in_a_stretched_reference",
       with(R::ContactForce{"pad", stretched}),
       {"'position'", "reference's rotation is not a rotation"}},
      {"force_in_axes_of_no_frame",
       with(R::ContactForce{"pad", Reference{"link_9", Anchor::Base}}),
       {"'position'", "reference", "'link_9'", "did you mean"}},
      {"cone_in_a_stretched_reference",
       with(R::FrictionCone{.contact = "pad", .friction = 0.5, .reference = stretched}),
       {"'position'", "reference's rotation is not a rotation"}},
      {"velocity_in_mirrored_axes",
       with(R::FrameVelocity{"tool", Reference::local(mirrored)}),
       {"'position'", "rotation is not a rotation"}},
      {"support_of_a_line",
       with(R::SupportMargin{{{0.0, 0.0}, {1.0, 0.0}}}),
       {"2 points", "support polygon", "at least 3"}},
      {"support_nan",
       with(R::SupportMargin{{{0.0, 0.0}, {1.0, nan}, {0.0, 1.0}}}),
       {"point 1 [1, nan]", "not finite"}},
      {"support_clockwise",
       with(R::SupportMargin{{{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}}}),
       {"point 2 [1, 0]", "not to the left", "counter-clockwise"}},
      {"support_dented",
       with(R::SupportMargin{{{0.0, 0.0}, {1.0, 0.0}, {0.4, 0.4}, {0.0, 1.0}}}),
       {"point 3 [0, 1]", "from point 1 [1, 0] to 2 [0.4, 0.4]", "convex"}},
      {"support_star",
       with(R::SupportMargin{{{1.0, 0.0}, {-0.8, 0.6}, {0.3, -0.95}, {0.3, 0.95}, {-0.8, -0.6}}}),
       {"not to the left", "convex"}},
      {"support_point_twice",
       with(R::SupportMargin{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}}),
       {"not to the left", "convex"}},
      {"support_on_an_edge",
       with(R::SupportMargin{{{0.0, 0.0}, {0.5, 0.0}, {1.0, 0.0}, {0.0, 1.0}}}),
       {"point 2 [1, 0] is not to the left of the edge from point 0 [0, 0] to 1 [0.5, 0]"}},
      {"own_rows", with(own(0, true)), {"0 rows", "at least 1"}},
      {"own_value", with(own(2, false)), {"no value function"}},
      {"control_at_the_end", at_the_end(R::Control{}), {"terminal", "'last'", "no control"}},
      {"force_at_the_end", at_the_end(R::ContactForce{"pad"}), {"terminal", "'last'"}},
      {"torque_at_the_end", at_the_end(R::JointTorque{}), {"terminal", "no control"}},
      {"torque_rate_without_a_torque_model",
       with(R::JointTorqueRate{}),
       {"'position'", "no rate", "wanted a torque model", "per driven joint"}},
      {"torque_rate_at_the_end",
       [](ProblemSpec& spec) {
         spec.torque_model = TorqueModel{.cutoff = 30.0};
         spec.initial_state = Eigen::VectorXd::Zero(21);
         spec.terminal = {{.name = "last", .residual = R::JointTorqueRate{}}};
       },
       {"terminal", "no control", "no rate"}},
      {"force_rate_without_force_states",
       with(R::ContactForceRate{"pad"}),
       {"'position'", "force of the previous step", "'pad' in the problem's force_states",
        "entries to the state"}},
      {"force_rate_at_the_end",
       [](ProblemSpec& spec) {
         spec.torque_model = TorqueModel{.cutoff = 30.0};
         spec.force_states = {"pad"};
         spec.initial_state = Eigen::VectorXd::Zero(27);
         spec.terminal = {{.name = "last", .residual = R::ContactForceRate{"pad"}}};
       },
       {"terminal", "has no step", "no rate"}},
      {"control_at_an_impact", at_an_impact(R::Control{}), {"no control"}},
      {"force_at_an_impact", at_an_impact(R::ContactForce{"pad"}), {"impact", "impulses"}},
  };
}

std::vector<BadSpec> bad_costs() {
  const auto one = [](double x) { return Eigen::VectorXd::Constant(1, x); };
  return {
      {"weight_negative", [](ProblemSpec& s) { term(s).weight = -1.0; }, {"weight is -1"}},
      {"weight_nan", [](ProblemSpec& s) { term(s).weight = nan; }, {"weight is nan"}},
      {"weights_zero",
       [](ProblemSpec& s) { term(s).weight = 0.0; },
       {"all weights", "zero", "at least one positive"}},
      {"row_weights_size",
       [](ProblemSpec& s) { term(s).weights = Eigen::Vector2d(1.0, 1.0); },
       {"2 row weights", "wanted 3"}},
      {"row_weight_nan",
       [](ProblemSpec& s) { term(s).weights = Eigen::Vector3d(1.0, nan, 1.0); },
       {"row weight 1 is nan"}},
      {"limits_size",
       with_penalty(Penalty::barrier(Eigen::Vector2d(0.0, 0.0), {})),
       {"lower limit has 2 entries", "wanted 1 or 3"}},
      {"limit_nan", with_penalty(Penalty::at_least(nan)), {"lower limit", "NaN"}},
      {"limits_crossed",
       with_penalty(Penalty::barrier(one(1.0), one(0.0))),
       {"lower limit 1", "above the upper limit 0"}},
      {"limit_infinite", with_penalty(Penalty::at_least(infinity)), {"exclude every number"}},
      {"width", with_penalty(Penalty::smooth_absolute(0.0)), {"width is 0"}},
      {"width_nan", with_penalty(Penalty::log_barrier(one(0.0), {}, nan)), {"width is nan"}},
      {"term_twice",
       [](ProblemSpec& s) { s.stages[0].costs.push_back(s.stages[0].costs[0]); },
       {"'position'", "used twice"}},
      {"no_terms", [](ProblemSpec& s) { s.stages[0].costs.clear(); }, {"no cost terms"}},
  };
}

std::vector<BadSpec> bad_constraints() {
  const auto with = [](const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                       const std::string& name) {
    return [=](ProblemSpec& s) {
      s.stages[0].constraints = {
          {name, residual::FramePosition{"tool", Eigen::Vector3d(0.3, 0.0, 0.4)}, lower, upper}};
    };
  };
  const auto with_weights = [](const Eigen::VectorXd& scale, double l1_weight, double quadratic) {
    return [=](ProblemSpec& s) {
      s.stages[0].constraints = {{"slow",
                                  residual::JointVelocity{},
                                  {},
                                  Eigen::VectorXd::Constant(1, 0.5),
                                  scale,
                                  l1_weight,
                                  quadratic}};
    };
  };
  const auto one = [](double x) { return Eigen::VectorXd::Constant(1, x); };
  const Eigen::VectorXd none;
  return {
      {"constraint_without_a_scale",
       with(one(0.0), none, "box"),
       {"constraint 'box'", "row 'x'", "needs a scale", "wanted a scale", "in the row's unit"}},
      {"distance_without_a_scale",
       [one, none](ProblemSpec& s) {
         s.stages[0].constraints = {{"far", residual::FrameDistance{"tool", 0.0}, one(0.0), none}};
       },
       {"constraint 'far'", "row 'distance'", "wanted a scale"}},
      {"constraint_scales",
       with_weights(Eigen::Vector2d(1.0, 1.0), 1.0, 0.0),
       {"scale has 2 entries"}},
      {"constraint_scale_zero", with_weights(one(0.0), 1.0, 0.0), {"scale is 0", "positive"}},
      {"constraint_l1_weight", with_weights(none, -1.0, 0.0), {"l1_weight is -1", "at least 0"}},
      {"constraint_l1_weight_nan",
       with_weights(none, nan, 0.0),
       {"l1_weight is nan", "at least 0"}},
      {"constraint_for_nothing",
       with_weights(none, 0.0, 0.0),
       {"l1_weight and quadratic_weight are 0"}},
      {"constraint_quadratic_weight",
       with_weights(none, 1.0, -1.0),
       {"quadratic_weight is -1", "at least 0"}},
      {"constraint_hard_and_quadratic",
       with_weights(none, std::numeric_limits<double>::infinity(), 2.0),
       {"l1_weight is infinite", "quadratic_weight of 2", "no effect"}},
      {"constraint_without_limits",
       with(none, none, "box"),
       {"stage 'press'", "constraint 'box'", "no limits", "lower or an upper"}},
      {"constraint_limits_size",
       with(Eigen::Vector2d(0.0, 0.0), none, "box"),
       {"the lower limit has 2 entries", "wanted 1 or 3"}},
      {"constraint_limit_nan", with(none, one(nan), "box"), {"the upper limit holds a NaN"}},
      {"constraint_crossed",
       with(one(1.0), one(0.0), "box"),
       {"lower limit 1", "above the upper limit 0"}},
      {"constraint_named_as_a_cost",
       with(one(0.0), none, "position"),
       {"constraint 'position'", "used twice"}},
  };
}

std::vector<BadSpec> bad_stages() {
  return {
      {"stage_contact",
       [](ProblemSpec& s) { s.stages[0].contacts = {"pat"}; },
       {"stage 'press'", "'pat'", "did you mean 'pad'?"}},
      {"stage_twice",
       [](ProblemSpec& s) { s.stages.push_back(s.stages[0]); },
       {"'press'", "used twice"}},
      {"stage_nameless", [](ProblemSpec& s) { s.stages[0].name.clear(); }, {"no name"}},
      {"stage_terminal",
       [](ProblemSpec& s) { s.stages[0].name = "terminal"; },
       {"'terminal'", "end of the horizon"}},
      {"step_zero", [](ProblemSpec& s) { s.stages[0].step = 0.0; }, {"step is 0 s", "positive"}},
      {"step_nan", [](ProblemSpec& s) { s.stages[0].step = nan; }, {"step is nan s"}},
      {"impact_of_nothing",
       [](ProblemSpec& s) {
         s.stages[0].impact = true;
         s.stages[0].contacts.clear();
       },
       {"impact", "no contact"}},
      {"horizon_stage",
       [](ProblemSpec& s) {
         s.horizon = {{"pres", 2}};
       },
       {"horizon", "'pres'", "did you mean 'press'?"}},
      {"horizon_knots",
       [](ProblemSpec& s) {
         s.horizon = {{"press", 0}};
       },
       {"0 knots"}},
      {"horizon_empty", [](ProblemSpec& s) { s.horizon.clear(); }, {"horizon", "no knots"}},
      {"start_time", [](ProblemSpec& s) { s.start_time = infinity; }, {"start_time is inf"}},
  };
}

std::vector<BadSpec> bad_robots() {
  return {
      {"contact_without_directions",
       [](ProblemSpec& s) { s.contacts[2].directions = {}; },
       {"contact 'pad'", "directions is empty"}},
      {"contact_gain_nan", [](ProblemSpec& s) { s.contacts[2].kd[1] = nan; }, {"'pad'", "gain"}},
      {"compliance", [](ProblemSpec& s) { s.contact_solver.mu = -1.0; }, {"mu", "-1"}},
      {"initial_state_size",
       [](ProblemSpec& s) { s.initial_state = Eigen::VectorXd::Zero(7); },
       {"initial_state has 7", "wanted 14", "q: 7", "v: 7"}},
      {"initial_state_nan", [](ProblemSpec& s) { s.initial_state[9] = nan; }, {"initial_state"}},
      {"actuation_unknown",
       [](ProblemSpec& s) { s.actuation.joints = {"joint_x"}; },
       {"'joint_x'", "did you mean"}},
      {"actuation_twice",
       [](ProblemSpec& s) {
         s.actuation.joints = {"joint_1", "joint_1"};
       },
       {"actuation", "'joint_1'", "twice"}},
      {"slip", [](ProblemSpec& s) { s.actuation.slip_velocity = 0.0; }, {"slip_velocity is 0"}},
      {"cutoff",
       [](ProblemSpec& s) {
         s.torque_model = TorqueModel{.cutoff = 0.0};
         s.initial_state = Eigen::VectorXd::Zero(21);
       },
       {"torque_model", "cut-off is 0"}},
      {"torque_states_with_a_cutoff",
       [](ProblemSpec& s) {
         s.torque_model = TorqueModel{30.0, TorqueModel::Discretization::Held};
         s.initial_state = Eigen::VectorXd::Zero(21);
       },
       {"torque_model", "held", "cut-off of 30"}},
      {"force_states_unknown",
       [](ProblemSpec& s) { s.force_states = {"pads"}; },
       {"force_states", "'pads'", "did you mean 'pad'?"}},
      {"force_states_twice",
       [](ProblemSpec& s) {
         s.force_states = {"pad", "pad"};
       },
       {"force_states", "'pad'", "twice"}},
      {"force_states_without_initial_forces",
       [](ProblemSpec& s) { s.force_states = {"pad"}; },
       {"initial_state has 14", "forces of the previous step: "}},
      {"unstable_filter",
       [](ProblemSpec& s) {
         s.torque_model = TorqueModel{300.0, TorqueModel::Discretization::Euler};
         s.initial_state = Eigen::VectorXd::Zero(21);
       },
       {"stage 'press'", "unstable", "exact"}},
      {"bounds_size",
       [](ProblemSpec& s) { s.control_lower = Eigen::Vector3d::Zero(); },
       {"control_lower has 3", "wanted 1 or 7"}},
      {"bounds_nan",
       [](ProblemSpec& s) { s.control_upper = Eigen::VectorXd::Constant(1, nan); },
       {"control_upper", "NaN"}},
      {"bounds_crossed",
       [](ProblemSpec& s) {
         s.control_lower = Eigen::VectorXd::Constant(1, 2.0);
         s.control_upper = Eigen::VectorXd::Constant(1, 1.0);
       },
       {"control_lower 2", "above", "1"}},
  };
}

class InvalidProblem : public ::testing::TestWithParam<BadSpec> {};

TEST_P(InvalidProblem, BadEntry_IsRefusedWithItsReason) {
  ProblemSpec spec = good_spec();
  ASSERT_NO_THROW(Problem{spec});
  GetParam().spoil(spec);
  testing::expect_words(testing::refusal([&] { const Problem problem(spec); }), GetParam().words);
}

const auto name_of_case = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Targets, InvalidProblem, ::testing::ValuesIn(bad_targets()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Residuals, InvalidProblem, ::testing::ValuesIn(bad_residuals()),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Costs, InvalidProblem, ::testing::ValuesIn(bad_costs()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Constraints, InvalidProblem, ::testing::ValuesIn(bad_constraints()),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Stages, InvalidProblem, ::testing::ValuesIn(bad_stages()), name_of_case);
INSTANTIATE_TEST_SUITE_P(Robots, InvalidProblem, ::testing::ValuesIn(bad_robots()), name_of_case);

TEST(ProblemArguments, BadNamesKnotsAndSizes_AreRefused) {
  Problem problem(good_spec());
  const auto words = [](auto&& call, const std::vector<std::string>& wanted) {
    testing::expect_words(testing::refusal(call), wanted);
  };
  words([&] { problem.stage_index("pres"); }, {"'pres'", "did you mean 'press'?"});
  words([&] { problem.term_index(0, "positon"); }, {"'positon'", "did you mean 'position'?"});
  words([&] { problem.set_knot(4, 0, 0.0); }, {"set_knot", "knot 4", "0 to 3"});
  words([&] { problem.set_knot(1, 1, 0.0); }, {"set_knot", "stage 1", "0 to 0"});
  words([&] { problem.advance(1); }, {"advance", "stage 1", "0 to 0"});
  const Eigen::VectorXd x = Eigen::VectorXd::Zero(3), u = Eigen::VectorXd::Zero(7);
  words([&] { problem.residual(0, 0, x, u); }, {"x has 3 entries", "wanted 14"});
  words([&] { problem.set_target(-1, 0, x); }, {"set_target", "knot -1", "0 to 3"});
  words([&] { problem.set_target(4, 0, x); }, {"set_target", "knot 4", "0 to 3"});
  words([&] { problem.set_target(0, 1, x); },
        {"set_target", "term 1 of knot 0 does not exist", "0 to 0"});
  words([&] { problem.residual(0, -1, x, u); }, {"residual", "term -1 of knot 0 does not exist"});
  words([&] { problem.residual_derivative(-2, 0, x, u); }, {"residual_derivative", "knot -2"});
  words([&] { problem.forces(0, Eigen::VectorXd::Zero(14), x); }, {"u has 3 entries", "wanted 7"});
  words([&] { problem.quasi_static(0, x); }, {"quasi_static", "3 entries"});
  words([&] { problem.quasi_static(0, Eigen::VectorXd::Zero(14), x); },
        {"force has 3", "wanted 6"});
}

TEST(ProblemArguments, BadStatesAndTargets_GiveAStatus) {
  const OcpCase test{{"arm7", Base::FreeFlyer, "tool"}};
  ProblemSpec spec = bare_problem(test, test.robot.model());
  spec.stages = {{.name = "go", .costs = {{.residual = residual::State{}}}}};
  spec.horizon = {{"go", 1}};
  Problem problem(spec);
  const Eigen::VectorXd before = spec.initial_state;
  Eigen::VectorXd x = before;
  x[4] += 0.1;
  EXPECT_EQ(problem.set_initial_state(x), Status::NotNormalized);
  EXPECT_EQ(problem.set_initial_state(x.head(5)), Status::WrongSize);
  x[0] = nan;
  EXPECT_EQ(problem.set_initial_state(x), Status::NotFinite);
  const Eigen::Map<const Eigen::VectorXd> kept(problem.initial_state(), before.size());
  EXPECT_EQ(kept, before);
  EXPECT_EQ(problem.set_target(0, 0, before.head(3)), Status::WrongSize);
  EXPECT_EQ(problem.set_torque_bias(before.head(3)), Status::WrongSize);
  EXPECT_EQ(problem.set_torque_bias(Eigen::VectorXd::Constant(13, nan)), Status::NotFinite);
}

}  // namespace
}  // namespace burnish::test
