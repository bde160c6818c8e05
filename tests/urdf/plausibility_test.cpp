// Valid but implausible numbers in descriptions, as from wrong units, give warnings.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numbers>

#include "burnish/model/model.hpp"
#include "burnish/urdf/urdf.hpp"
#include "model/mass_check.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

TreeSpec robot_of(const std::string& name) {
  return read_urdf(std::string(BURNISH_ROBOTS_DIR "/") + name + "/" + name + ".urdf");
}

TEST(PlausibleRobots, EveryFile_GivesNoWarning) {
  int seen = 0;
  for (const char* folder : {BURNISH_ROBOTS_DIR, BURNISH_SHARED_DIR "/robots"}) {
    if (!std::filesystem::is_directory(folder)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".urdf") continue;
      ++seen;
      const Model model = build_model(read_urdf(entry.path()));
      EXPECT_TRUE(model.warnings.empty()) << model.warnings.front();
    }
  }
  EXPECT_GE(seen, 8);
}

struct DefectCase {
  std::string name;
  std::function<void(TreeSpec&, ModelOptions&)> spoil;
  std::vector<std::string> words;
};
void PrintTo(const DefectCase& defect, std::ostream* out) { *out << defect.name; }

template <class Change>
auto joints(Change change) {
  return [change](TreeSpec& tree, ModelOptions&) {
    for (JointSpec& joint : tree.joints) change(joint);
  };
}
template <class Change>
auto links(Change change) {
  return [change](TreeSpec& tree, ModelOptions&) {
    for (LinkSpec& link : tree.links) change(link.inertia);
  };
}

void lengths_in_mm(TreeSpec& tree, ModelOptions& /*options*/) {
  for (JointSpec& joint : tree.joints) joint.placement.translation() *= 1000.0;
  for (LinkSpec& link : tree.links) link.inertia.com *= 1000.0;
}

/// Defects of a whole robot. Each warning names a joint or a link, the value, and a likely cause.
const std::vector<DefectCase>& defect_cases() {
  static const std::vector<DefectCase> all = {
      {"LimitsInDegrees",
       joints([](JointSpec& j) { j.lower *= degrees, j.upper *= degrees; }),
       {"joint '", "position limits", "degrees?"}},
      {"LimitsInRadiansReadAsDegrees",
       joints([](JointSpec& j) { j.lower /= degrees, j.upper /= degrees; }),
       {"joint '", "position limits", "as if they were degrees?"}},
      {"VelocitiesInDegrees",
       joints([](JointSpec& j) { j.velocity_limit *= degrees; }),
       {"joint '", "velocity limit of", "degrees per second?"}},
      {"MassesInGrams", links([](InertiaSpec& i) { i.mass *= 1e3; }), {"link '", "in g"}},
      {"MassesInTonnes", links([](InertiaSpec& i) { i.mass *= 1e-3; }), {"link '", "in tonnes?"}},
      {"LengthsInMillimetres", lengths_in_mm, {"reach", "in mm"}},
      {"InertiasInKilogramSquareMillimetres",
       links([](InertiaSpec& i) { i.inertia_at_com *= 1e6; }),
       {"link '", "radius of gyration", "kg mm^2"}},
      {"InertiasInGramSquareMillimetres",
       links([](InertiaSpec& i) { i.inertia_at_com *= 1e9; }),
       {"link '", "radius of gyration", "kg mm^2"}},
      {"InertiasThousandTimesTooLarge",
       links([](InertiaSpec& i) { i.inertia_at_com *= 1e3; }),
       {"link '", "radius of gyration", "reach"}},
      {"InertiasThousandTimesTooSmall",
       links([](InertiaSpec& i) { i.inertia_at_com *= 1e-3; }),
       {"link '", "ball with a density of", "too small?"}},
      {"NoMasses",
       links([](InertiaSpec& i) { i.mass = 0.0; }),
       {"links '", "moments of inertia but no mass"}},
      {"EffortsInNewtonMillimetres",
       joints([](JointSpec& j) { j.effort_limit *= 1e3; }),
       {"joint '", "effort limit of", "Nmm?"}},
      {"EffortsInKilonewtonMetres",
       joints([](JointSpec& j) { j.effort_limit *= 1e-3; }),
       {"joint '", "effort limit of", "kNm?"}},
      {"GravityInMillimetres",
       [](TreeSpec&, ModelOptions& o) { o.gravity *= 1e3; },
       {"gravity is 9810"}},
  };
  return all;
}

class ImplausibleRobot : public ::testing::TestWithParam<DefectCase> {};

TEST_P(ImplausibleRobot, WrongUnit_GivesAWarningThatStrictRefuses) {
  for (const char* name : {"arm7", "talos", "quadruped"}) {
    SCOPED_TRACE(name);
    TreeSpec tree = robot_of(name);
    ModelOptions options;
    options.base = std::string(name) == "arm7" ? Base::Fixed : Base::FreeFlyer;
    ASSERT_TRUE(build_model(tree, options).warnings.empty());
    GetParam().spoil(tree, options);
    const Model model = build_model(tree, options);
    std::string text;
    for (const std::string& warning : model.warnings) text += warning + " | ";
    expect_words(text, GetParam().words);
    options.strict = true;
    expect_words(refusal([&] { build_model(tree, options); }), {"strict"});
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ImplausibleRobot, ::testing::ValuesIn(defect_cases()),
                         [](const auto& test) { return test.param.name; });

LinkSpec& link_of(TreeSpec& tree, const std::string& name) {
  return *std::find_if(tree.links.begin(), tree.links.end(),
                       [&](const LinkSpec& link) { return link.name == name; });
}
JointSpec& joint_of(TreeSpec& tree, const std::string& name) {
  return *std::find_if(tree.joints.begin(), tree.joints.end(),
                       [&](const JointSpec& joint) { return joint.name == name; });
}

/// The only warning of the arm after a change.
std::string warning_after(const std::function<void(TreeSpec&)>& change) {
  TreeSpec tree = robot_of("arm7");
  change(tree);
  const std::vector<std::string> warnings = build_model(tree).warnings;
  EXPECT_EQ(warnings.size(), 1u);
  return warnings.empty() ? "" : warnings[0];
}

TEST(ImplausibleLink, WrongNumber_IsNamedWithItsValue) {
  expect_words(warning_after([](TreeSpec& t) { link_of(t, "link_3").inertia.mass *= 1e3; }),
               {"line ", "link 'link_3'", "2600 kg", "in g"});
  expect_words(warning_after([](TreeSpec& t) { link_of(t, "link_2").inertia.mass *= 1e-3; }),
               {"link 'link_2'", "0.0036 kg", "in tonnes?"});
  expect_words(warning_after([](TreeSpec& t) { link_of(t, "link_2").inertia.com *= 1e3; }),
               {"link 'link_2'", "centre of mass", "m from its origin", "in mm?"});
}

TEST(ImplausibleJoint, WrongNumber_IsNamedWithItsValue) {
  expect_words(warning_after([](TreeSpec& t) { joint_of(t, "joint_2").armature *= 1e4; }),
               {"joint 'joint_2'", "armature of 4200 kg m^2", "kg cm^2?"});
  expect_words(warning_after([](TreeSpec& t) { joint_of(t, "joint_2").velocity_limit = 0.0; }),
               {"joint 'joint_2'", "velocity limit of 0", "cannot move"});
}

TEST(ImplausibleJoint, OneWideRange_GivesNoWarning) {
  TreeSpec tree = robot_of("arm7");
  joint_of(tree, "joint_1").lower *= degrees;
  EXPECT_TRUE(build_model(tree).warnings.empty());
}

TEST(ImplausibleMasses, ArmaturesWithoutAnyMass_GiveAWarning) {
  expect_words(warning_after([](TreeSpec& tree) {
                 for (LinkSpec& link : tree.links) link.inertia = {};
               }),
               {"no moving link has a mass", "'link_1'", "kg"});
}

TEST(SimulationProblem, MasslessJoints_AreNamed) {
  TreeSpec tree = robot_of("arm7");
  EXPECT_EQ(simulation_problem(build_model(tree)), "");
  TreeSpec weightless = tree;
  for (LinkSpec& link : weightless.links) link.inertia.mass = 0.0;
  expect_words(simulation_problem(build_model(weightless)),
               {"joints 'joint_1', 'joint_2'", "move no mass", "cannot be simulated"});
  expect_words(refusal([&] { require_simulable(build_model(weightless)); }),
               {"robot 'arm7'", "'joint_1'", "no mass"});
  link_of(tree, "link_7").inertia = link_of(tree, "flange").inertia = {};
  joint_of(tree, "joint_7").armature = 0.0;
  expect_words(simulation_problem(build_model(tree)),
               {"joint 'joint_7' moves no mass", "singular"});
}

TEST(SlideLimits, WideRange_IsComparedWithTheReach) {
  TreeSpec tree = robot_of("arm7");
  JointSpec& last = joint_of(tree, "joint_7");
  last.type = JointType::Prismatic;
  last.lower = 0.0;
  last.upper = 0.04;
  EXPECT_TRUE(build_model(tree).warnings.empty());
  last.upper = 40.0;
  ASSERT_EQ(build_model(tree).warnings.size(), 1u);
  expect_words(build_model(tree).warnings[0], {"joint 'joint_7'", "40 m", "in mm?"});
}

TEST(PlaceholderLimits, RoundNumbers_GiveNoWarning) {
  TreeSpec tree = robot_of("arm7");
  for (JointSpec& joint : tree.joints) joint.velocity_limit = 100.0, joint.effort_limit = 1e4;
  EXPECT_TRUE(build_model(tree).warnings.empty());
}

}  // namespace
}  // namespace burnish::testing
