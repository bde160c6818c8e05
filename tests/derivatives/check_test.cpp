// The public derivative checker passes correct derivatives and names wrong entries.
#include "burnish/derivatives/check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "derivatives/check_differences.hpp"
#include "derivatives/check_run.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"
#include "support/scaled.hpp"

namespace burnish {
namespace {

Model model_of(const std::string& name) { return test::named_robot(name); }

/// Options for one quick row.
CheckOptions quick() {
  CheckOptions options;
  options.references = {Reference::centered()};
  options.surfaces = {};
  options.directions = {Directions::pad_z()};
  options.gains = {default_check_gains()[1]};
  options.states = 2;
  return options;
}

DerivativeBlock& block_named(std::vector<DerivativeBlock>& blocks, const std::string& name) {
  for (DerivativeBlock& block : blocks)
    if (block.name == name) return block;
  throw Error("no block " + name);
}

const std::vector<std::string> all_blocks{
    "da_dq",   "dlambda_dq", "da_dv",        "dlambda_dv", "da_dtau",   "dlambda_dtau", "dtau_dq",
    "dtau_dv", "dtau_da",    "dtau_dlambda", "dalpha_dq",  "dalpha_dv", "dalpha_da"};

class RobotDerivativeCheck : public ::testing::TestWithParam<std::string> {};

TEST_P(RobotDerivativeCheck, EveryRow_PassesWithMargin) {
  CheckOptions options;
  options.states = 3;
  const CheckReport report = check_derivatives(model_of(GetParam()), options);
  EXPECT_TRUE(report.pass) << report.text();
  EXPECT_EQ(report.rows.size(), 5U * 8U * 3U);
  for (const CheckRow& row : report.rows) EXPECT_LT(row.worst_error, 2e-7) << report.text();
}

INSTANTIATE_TEST_SUITE_P(Robots, RobotDerivativeCheck,
                         ::testing::ValuesIn(test::available(
                             std::vector<std::string>{"arm7", "arm7:six", "arm7:floating", "crane",
                                                      "crane:left_only", "talos:right_arm"},
                             [](const std::string& name) { return name; })));

/// A robot scaled to another size and mass.
struct OtherSize {
  std::string robot;
  double length, mass;
};

class ScaledRobotCheck : public ::testing::TestWithParam<OtherSize> {};

TEST_P(ScaledRobotCheck, EveryRow_PassesWithMargin) {
  const auto& [robot, length, mass] = GetParam();
  CheckOptions options;
  options.states = 1;
  const CheckReport report =
      check_derivatives(test::scaled(model_of(robot), length, mass), options);
  EXPECT_TRUE(report.pass) << report.text();
  for (const CheckRow& row : report.rows) EXPECT_LT(row.worst_error, 2e-7) << report.text();
}

/// A wrong entry is found on robots of every size, not only on robots of 1 m.
TEST_P(ScaledRobotCheck, WrongEntryOfAnyBlock_IsFound) {
  const auto& [robot, length, mass] = GetParam();
  for (const std::string& name : all_blocks) {
    const auto spoil = [&](std::vector<DerivativeBlock>& blocks) {
      DerivativeBlock& block = block_named(blocks, name);
      Eigen::Index row = 0, column = 0;
      block.value.cwiseAbs().maxCoeff(&row, &column);
      block.value(row, column) *= 1.001;
    };
    EXPECT_FALSE(run_check(test::scaled(model_of(robot), length, mass), quick(), spoil).pass)
        << name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Robots, ScaledRobotCheck,
    ::testing::ValuesIn(test::available(std::vector<OtherSize>{{"arm7", 100.0, 5000.0},
                                                               {"arm7", 1e-3, 1e-4},
                                                               {"arm7:floating", 100.0, 1.0},
                                                               {"arm7:floating", 1e-3, 1e-5},
                                                               {"every_joint", 50.0, 1e4},
                                                               {"every_joint", 1e-3, 1e-3}},
                                        [](const OtherSize& other) { return other.robot; })),
    [](const auto& test) { return "n" + std::to_string(test.index); });

/// A robot with two tips.
struct TwoTips {
  std::string robot, tip, other_tip;
};
TwoTips two_tips() {
  if (test::has_robot_files) return {"crane", "left_tip", "right_tip"};
  return {"every_joint", "tip", "d_side"};
}

TEST(DerivativeCheck, AllAccelerationsBetweenTwoBodies_Pass) {
  CheckOptions options;
  options.tool = two_tips().tip;
  options.base = two_tips().other_tip;
  options.accelerations = {Acceleration::TimeDerivative, Acceleration::Spatial,
                           Acceleration::Classical};
  options.states = 2;
  const CheckReport report = check_derivatives(model_of(two_tips().robot), options);
  EXPECT_TRUE(report.pass) << report.text();
  EXPECT_EQ(report.rows.front().bodies, options.tool + " on " + options.base);
}

std::vector<SurfaceShape> every_shape() {
  std::vector<SurfaceShape> all;
  for (const char* text : {"plane", "sphere:0.3", "sphere:0.1:hollow", "cylinder:0.2",
                           "cylinder:0.05:hollow", "cone:0.2:0.4", "torus:0.1:0.5",
                           "torus:0.2:0.4:hollow", "ellipsoid:0.4:0.3:0.2", "saddle:3:-2"})
    all.push_back(SurfaceShape::parse(text));
  return all;
}

TEST(DerivativeCheck, CurvedSurfacesOnFixedAndMovingBase_Pass) {
  for (const std::string& base : {std::string("world"), two_tips().other_tip}) {
    CheckOptions options;
    options.tool = two_tips().tip;
    options.base = base;
    options.references = {};
    options.surfaces = every_shape();
    options.directions = {Directions::z(), Directions::parse("x,z,ry")};
    options.gains = {default_check_gains()[1]};
    options.accelerations = {Acceleration::TimeDerivative, Acceleration::Spatial};
    options.states = 2;
    const CheckReport report = check_derivatives(model_of(two_tips().robot), options);
    EXPECT_TRUE(report.pass) << report.text();
    ASSERT_EQ(report.rows.size(), every_shape().size() * 4U);
    for (const CheckRow& row : report.rows) EXPECT_LT(row.worst_error, 2e-7) << report.text();
    EXPECT_EQ(report.rows[8].reference, "hollow sphere of radius 0.1 m");
  }
}

/// On a curved surface, the force and the constraint turn with the normal. Derivatives differ from
/// those on a flat surface with the same normal.
TEST(DerivativeCheck, CurvedSurface_DiffersFromAFlatOne) {
  CheckOptions options = quick();
  options.references = {};
  options.surfaces = {SurfaceShape::parse("sphere:0.3")};
  const Model model = model_of("arm7");
  std::vector<Eigen::MatrixXd> curved, flat;
  const auto keep = [](std::vector<Eigen::MatrixXd>& to) {
    return [&to](std::vector<DerivativeBlock>& blocks) {
      to.push_back(block_named(blocks, "dlambda_dq").expected);
    };
  };
  EXPECT_TRUE(run_check(model, options, keep(curved)).pass);
  options.surfaces = {SurfaceShape::parse("plane")};
  EXPECT_TRUE(run_check(model, options, keep(flat)).pass);
  EXPECT_GT((curved[0] - flat[0]).norm(), 0.1 * flat[0].norm());
}

TEST(DerivativeCheck, GivenContactOnASurface_Passes) {
  CheckOptions options;
  ContactSpec pad{.tool = "tool", .directions = Directions::pad_z()};
  pad.reference = Reference::on(Quadric::sphere({0.4, 0.1, 0.0}, 0.3), {0.4, 0.1, 0.3});
  options.contacts = {pad};
  options.states = 3;
  const CheckReport report = check_derivatives(model_of("arm7"), options);
  EXPECT_TRUE(report.pass) << report.text();
  EXPECT_EQ(report.rows[0].reference, "curved surface");
}

TEST(DerivativeCheck, GivenContacts_AreCheckedTogether) {
  CheckOptions options;
  ContactSpec left{.tool = "left_sole_link"}, right{.tool = "right_sole_link"};
  ContactSpec pad{.tool = "tool",
                  .reference = Reference::surface_with_normal({0.0, 0.2, 1.0}),
                  .directions = Directions::pad_z()};
  pad.with_gains(0.0, 50.0);
  options.contacts = {left, right, pad};
  options.states = 2;
  const CheckReport report = check_derivatives(test::humanoid().model(), options);
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_TRUE(report.pass) << report.text();
  EXPECT_EQ(report.rows[0].reference, "centered + centered + surface");
  EXPECT_EQ(report.rows[0].acceleration, "time_derivative");
}

TEST(DerivativeCheck, TooFewJoints_AreCheckedWithComplianceAndReported) {
  CheckOptions options = quick();
  options.directions = {Directions::all(), Directions::z()};
  options.tool = "tool";
  ModelOptions four = test::arm7::options(Base::Fixed);
  four.free = {"joint_1", "joint_2", "joint_3", "joint_4"};
  const CheckReport report = check_derivatives(build_model(test::arm7::tree(), four), options);
  EXPECT_TRUE(report.pass) << report.text();
  EXPECT_GT(report.rows[0].mu, 0.0);
  EXPECT_EQ(report.rows[1].mu, 0.0);
  EXPECT_NE(report.text().find("1 row checked with a compliance mu"), std::string::npos);
}

/// A box on two wheels whose axles are turned by a quarter turn, rounded as in files.
TreeSpec wheels() {
  TreeSpec tree;
  tree.name = "wheels";
  tree.links = {testing::link("box", 300.0), testing::link("left", 2.0), testing::link("right")};
  const double signs[] = {1.0, -1.0};
  for (const int i : {0, 1}) {
    JointSpec joint = testing::joint("spin " + tree.links[i + 1].name, JointType::Continuous, "box",
                                     tree.links[i + 1].name);
    joint.placement.translation() = Eigen::Vector3d(40.0, signs[i] * 0.3, 0.1);
    joint.placement.linear() =
        Eigen::AngleAxisd(signs[i] * (i == 0 ? 1.5707963267948966 : 1.5707963),
                          Eigen::Vector3d::UnitX())
            .toRotationMatrix();
    tree.joints.push_back(joint);
  }
  return tree;
}

TEST(DerivativeCheck, RoundingNoise_IsNotAnError) {
  // Only rounding errors move the hub of a wheel, and the torques are rounding errors, too.
  for (const char* tool : {"left", "right"}) {
    CheckOptions options;
    options.tool = tool;
    options.states = 5;
    const CheckReport report = check_derivatives(build_model(wheels()), options);
    EXPECT_TRUE(report.pass) << report.text();
    for (const CheckRow& row : report.rows) EXPECT_LT(row.worst_error, 2e-7) << report.text();
  }
}

TEST(DerivativeCheck, UnreachableLimits_AreIgnored) {
  TreeSpec tree = wheels();
  for (JointSpec& joint : tree.joints) {
    joint.type = JointType::Revolute;
    joint.lower = -1e16;
    joint.upper = 1e16;
  }
  CheckOptions options;
  options.states = 3;
  const CheckReport report = check_derivatives(build_model(tree), options);
  EXPECT_TRUE(report.pass) << report.text();
}

TEST(DerivativeCheck, DirectionMovedOnlyByRounding_IsCheckedWithCompliance) {
  // An arm in the xz plane, turned about x by a quarter turn.
  TreeSpec tree;
  tree.name = "turned";
  for (const char* name : {"root", "upper", "tip"}) tree.links.push_back(testing::link(name));
  for (const int i : {0, 1}) {
    tree.joints.push_back(testing::joint("hinge " + std::to_string(i), JointType::Revolute,
                                         tree.links[i].name, tree.links[i + 1].name));
    tree.joints.back().placement.translation() = Eigen::Vector3d(1.0, 0.0, 0.0);
  }
  ModelOptions turned;
  turned.base_placement.linear() =
      Eigen::AngleAxisd(1.5707963267948966, Eigen::Vector3d::UnitX()).toRotationMatrix();
  turned.frames = {{"tool", "tip", Eigen::Isometry3d(Eigen::Translation3d(1.0, 0.0, 0.0))}};
  CheckOptions options;
  options.references = {Reference::centered()};
  options.surfaces = {};
  options.directions = {Directions::y(), Directions::x()};
  const CheckReport report = check_derivatives(build_model(tree, turned), options);
  EXPECT_TRUE(report.pass) << report.text();
  for (const CheckRow& row : report.rows) EXPECT_EQ(row.mu > 1e-6, row.directions == "y");
}

TEST(DerivativeCheck, MasslessJoint_IsNamedAndTheRestIsChecked) {
  Model model = model_of("arm7");
  Joint& last = model.joints.back();
  last.mass = 0.0;
  last.inertia_at_com.setZero();
  model.armature[last.v_index] = 0.0;
  std::vector<std::string> seen;
  const CheckReport report = run_check(model, quick(), [&](std::vector<DerivativeBlock>& blocks) {
    for (const DerivativeBlock& block : blocks) seen.push_back(block.name);
  });
  EXPECT_FALSE(report.pass);
  EXPECT_TRUE(report.rows[0].pass) << report.text();
  EXPECT_EQ(seen.front(), "dtau_dq");
  EXPECT_EQ(seen.size(), 2U * 7U);
  testing::expect_words(report.singular_mass, {"'" + last.name + "'", "no mass"});
  EXPECT_NE(report.text().find("FAIL: the model has no forward dynamics: joint"),
            std::string::npos);
}

class CorruptedBlock : public ::testing::TestWithParam<std::string> {};

TEST_P(CorruptedBlock, WrongEntry_IsReportedWithItsRowAndColumn) {
  const Model model = model_of("arm7");
  std::string row, column;
  const CheckReport report = run_check(model, quick(), [&](std::vector<DerivativeBlock>& blocks) {
    DerivativeBlock& block = block_named(blocks, GetParam());
    const Eigen::Index i = block.value.rows() - 1, j = block.value.cols() / 2;
    block.value(i, j) += 1e-4 * block.expected.cwiseAbs().maxCoeff();
    row = block.rows[static_cast<std::size_t>(i)];
    column = block.columns[static_cast<std::size_t>(j)];
  });
  EXPECT_FALSE(report.pass);
  ASSERT_EQ(report.rows.size(), 1U);
  const CheckRow& found = report.rows[0];
  EXPECT_FALSE(found.pass);
  EXPECT_NEAR(found.worst_error, 1e-4, 1e-6);
  EXPECT_EQ(found.worst.block, GetParam());
  EXPECT_EQ(found.worst.row, row);
  EXPECT_EQ(found.worst.column, column);
  EXPECT_NE(found.worst.value, found.worst.expected);
  EXPECT_GE(found.worst.state, 0);
  const std::string where = GetParam() + "(" + row + ", " + column + ") is ";
  EXPECT_NE(report.text().find(where), std::string::npos) << report.text();
  EXPECT_NE(report.text().find("FAIL: 1 of 1 row"), std::string::npos) << report.text();
}

TEST_P(CorruptedBlock, Nan_Fails) {
  for (const bool analytic : {true, false}) {
    const CheckReport report =
        run_check(model_of("arm7"), quick(), [&](std::vector<DerivativeBlock>& blocks) {
          DerivativeBlock& block = block_named(blocks, GetParam());
          (analytic ? block.value : block.expected)(0, 0) =
              std::numeric_limits<double>::quiet_NaN();
        });
    EXPECT_FALSE(report.pass);
    EXPECT_TRUE(std::isinf(report.rows[0].worst_error));
    EXPECT_EQ(report.rows[0].worst.block, GetParam());
  }
}

TEST_P(CorruptedBlock, WrongSignOrMissingTerm_Fails) {
  const CheckReport negated = run_check(
      model_of("arm7"), quick(),
      [](std::vector<DerivativeBlock>& blocks) { block_named(blocks, GetParam()).value *= -1.0; });
  EXPECT_NEAR(negated.rows[0].worst_error, 2.0, 1e-6);
  const CheckReport missing =
      run_check(model_of("arm7"), quick(), [](std::vector<DerivativeBlock>& blocks) {
        block_named(blocks, GetParam()).value.setZero();
      });
  EXPECT_NEAR(missing.rows[0].worst_error, 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Blocks, CorruptedBlock, ::testing::ValuesIn(all_blocks),
                         [](const auto& test) { return test.param; });

TEST(DerivativeCheck, EveryBlock_IsCompared) {
  std::vector<std::string> seen;
  CheckOptions options = quick();
  options.states = 1;
  run_check(model_of("arm7"), options, [&](std::vector<DerivativeBlock>& blocks) {
    for (const DerivativeBlock& block : blocks) seen.push_back(block.name);
  });
  EXPECT_EQ(seen, all_blocks);
}

TEST(DerivativeCheck, SameSeed_GivesTheSameReport) {
  const Model model = model_of(two_tips().robot);
  CheckOptions options = quick();
  EXPECT_EQ(check_derivatives(model, options).text(), check_derivatives(model, options).text());
  CheckOptions other = options;
  other.seed = 7;
  EXPECT_NE(check_derivatives(model, options).rows[0].worst_error,
            check_derivatives(model, other).rows[0].worst_error);
}

TEST(DerivativeCheck, DefaultTool_IsNamedToolOrTheLastLeaf) {
  EXPECT_EQ(check_derivatives(test::humanoid().model(), quick()).rows[0].bodies, "tool on world");
  const std::string last_leaf = test::has_robot_files ? "right_tip" : "root_ball";
  EXPECT_EQ(check_derivatives(model_of(two_tips().robot), quick()).rows[0].bodies,
            last_leaf + " on world");
}

TEST(DerivativeCheck, Progress_CountsRows) {
  CheckOptions options = quick();
  options.references = default_check_references();
  std::vector<int> seen;
  options.progress = [&](int done, int total) {
    EXPECT_EQ(total, 4);
    seen.push_back(done);
  };
  check_derivatives(model_of("arm7"), options);
  EXPECT_EQ(seen, (std::vector<int>{1, 2, 3, 4}));
}

TEST(DerivativeCheck, InvalidOption_IsRefused) {
  const Model model = model_of("arm7");
  const auto sentence = [&](auto&& change) {
    CheckOptions options = quick();
    change(options);
    return testing::refusal([&] { check_derivatives(model, options); });
  };
  EXPECT_EQ(sentence([](auto& o) { o.states = 0; }), "check: states is 0; wanted at least 1");
  EXPECT_EQ(sentence([](auto& o) { o.tolerance = std::nan(""); }),
            "check: tolerance is nan; wanted a positive number");
  EXPECT_EQ(
      sentence([](auto& o) { o.references.clear(); }),
      "check: one of these lists is empty: references and surfaces, directions, accelerations, "
      "gains; wanted at least one entry in each list");
  EXPECT_NE(sentence([](auto& o) { o.tool = "tol"; }).find("did you mean 'tool'?"),
            std::string::npos);
  EXPECT_NE(sentence([](auto& o) { o.base = "wrld"; }).find("'wrld'"), std::string::npos);
  const auto shaped = [&](const SurfaceShape& shape) {
    return sentence([&](auto& o) { o.surfaces = {shape}; });
  };
  EXPECT_EQ(shaped({.kind = SurfaceShape::Kind::Sphere, .radius = -1.0}),
            "the surface: sphere: its radius is -1 m; wanted a positive number");
}

TEST(ExtrapolatedDifferences, SmoothFunction_IsExactToRounding) {
  const auto values = [](int, double h) {
    Eigen::VectorXd result(2);
    result << std::sin(0.3 + h), 1e3 * std::exp(20.0 * h);
    return result;
  };
  const Eigen::MatrixXd d = extrapolated_differences(values, 1, 1);
  EXPECT_NEAR(d(0, 0), std::cos(0.3), 1e-12);
  EXPECT_NEAR(d(1, 0) / 2e4, 1.0, 1e-9);
}

TEST(ExtrapolatedDifferences, StronglyCurvedFunction_UsesSmallerSteps) {
  const auto values = [](int, double h) {
    return Eigen::VectorXd::Constant(1, 1.0 / (0.003 + h * h + h));
  };
  EXPECT_NEAR(extrapolated_differences(values, 1, 1)(0, 0) * 0.003 * 0.003, -1.0, 1e-8);
}

TEST(ExtrapolatedDifferences, Nan_StaysNan) {
  const auto values = [](int, double) {
    return Eigen::VectorXd::Constant(1, std::numeric_limits<double>::quiet_NaN());
  };
  EXPECT_TRUE(std::isnan(extrapolated_differences(values, 1, 1)(0, 0)));
}

}  // namespace
}  // namespace burnish
