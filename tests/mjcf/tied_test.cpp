// Tests of forward dynamics under equalities against MuJoCo: loops, followers, locked joints.
#include <gtest/gtest.h>

#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/model.hpp"
#include "mjcf/comparison.hpp"
#include "mjcf/tied_comparison.hpp"

namespace burnish::testing {
namespace {

struct Mechanism {
  std::string name;
  std::string model;  ///< content of <mujoco>
  int rows;           ///< rows of MuJoCo's equalities
  int loops, nv;      ///< loops and velocities of the tree
};
void PrintTo(const Mechanism& mechanism, std::ostream* out) { *out << mechanism.name; }

class MjcfEqualities : public ::testing::TestWithParam<Mechanism> {};

TEST_P(MjcfEqualities, Accelerations_EqualMujocos) {
  const Mechanism& mechanism = GetParam();
  const std::string text = "<mujoco>" + mechanism.model + "</mujoco>";
  const TreeSpec tree = parse_mjcf(text);
  EXPECT_EQ(static_cast<int>(tree.loops.size()), mechanism.loops);
  EXPECT_EQ(build_model(tree).nv, mechanism.nv);
  const TiedAgreement agreement = compare_tied(tree, *mujoco::compile(text), 20);
  EXPECT_EQ(agreement.rows, mechanism.rows);
  EXPECT_EQ(agreement.left_out, 0);
  EXPECT_GE(agreement.states, 10);
  EXPECT_LE(agreement.rest, 1e-9);
  EXPECT_LE(agreement.moving, 1e-9);
}

std::string bar(const std::string& name, const std::string& pos, const std::string& inside) {
  return "<body name='" + name + "' pos='" + pos +
         "'><inertial pos='0.1 0.02 0.05' quat='0.9 0.1 -0.3 0.2' mass='1.5' diaginertia='0.03 "
         "0.025 0.02'/>" +
         inside + "</body>";
}
const std::string hinge = "' axis='0 1 0' damping='0.3' armature='0.01'/>";

/// Returns a crank, a coupler and a rocker in the x-z plane; `last` is added to the rocker.
std::string bars(const std::string& last, const std::string& equality) {
  return "<worldbody>" +
         bar("crank", "0 0 0",
             "<joint name='drive" + hinge +
                 bar("coupler", "0.2 0 0.1", "<joint name='knee" + hinge)) +
         bar("rocker", "0.5 0 0", "<joint name='pivot" + hinge + last) + "</worldbody><equality>" +
         equality + "</equality>";
}
const std::string ball = "<joint type='ball' armature='0.02'/>";

/// A foot on two hinges, driven by two motors with rods.
const std::string ankle =
    "<worldbody>" +
    bar("foot", "0 0 0",
        "<joint name='pitch' axis='0 1 0' stiffness='3' springref='20'/><joint name='roll' axis='1 "
        "0 0' ref='10'/>") +
    bar("left", "0.02 0.05 0.2",
        "<joint name='left_motor' axis='0 1 0'/>" + bar("left_rod", "0.05 0 0", ball)) +
    bar("right", "0.02 -0.05 0.2",
        "<joint name='right_motor' axis='0 1 0'/>" + bar("right_rod", "0.05 0 0", ball)) +
    "</worldbody><equality><connect body1='left_rod' body2='foot' anchor='0 0 -0.2'/><connect "
    "body1='right_rod' body2='foot' anchor='0 0 -0.2'/></equality>";

/// A floating hand: one finger follows the other, a tip follows by a tendon, and a cover is locked.
const std::string gripper =
    "<worldbody>" +
    bar("hand", "0 0 1",
        "<freejoint/>" +
            bar("left", "0 0.05 0.1",
                "<joint name='left' type='slide' axis='0 1 0' ref='0.02'/>" +
                    bar("tip", "0 0 0.05", "<joint name='tip' stiffness='2' armature='0.1'/>")) +
            bar("right", "0 -0.05 0.1", "<joint name='right' type='slide' axis='0 -1 0.2'/>") +
            bar("cover", "0.1 0 0", "<joint name='cover' axis='1 0 0' ref='5'/>")) +
    "</worldbody><tendon><fixed name='t'><joint joint='right' coef='2'/><joint joint='tip' "
    "coef='-0.5'/></fixed></tendon><equality><joint joint1='left' joint2='right' polycoef='0.01 "
    "0.8 0 0 0'/><tendon tendon1='t' polycoef='0.2 0 0 0 0'/><joint joint1='cover' polycoef='0.3 0 "
    "0 0 0'/></equality>";

/// An arm with its end welded to a floating box.
const std::string welded =
    "<option gravity='1 -2 -7'/><worldbody>" +
    bar("upper", "0 0 1",
        "<joint axis='0 1 0'/><joint axis='1 0 0' pos='0.01 0 0'/>" +
            bar("fore", "0 0.1 0.3", "<joint axis='0 1 1'/>" + ball)) +
    bar("box", "0.2 0.1 1.3", "<freejoint/>") +
    "</worldbody><equality><weld body1='fore' body2='box' relpose='0.1 0 0.2 0.9 0.1 0.2 0.3' "
    "anchor='0.05 0 0'/></equality>";

INSTANTIATE_TEST_SUITE_P(
    Mechanisms, MjcfEqualities,
    ::testing::Values(
        // In a plane, one of the three rows is redundant.
        Mechanism{"four_bar",
                  bars("", "<connect body1='coupler' body2='rocker' anchor='0.3 0 0.05'/>"), 3, 1,
                  3},
        Mechanism{"geared_five_bar",
                  bars(bar("rod", "0.1 0 0.2", "<joint name='wrist" + hinge),
                       "<connect body1='coupler' body2='rod' anchor='0.2 0 0.05'/><joint "
                       "joint1='pivot' joint2='drive' polycoef='0.2 -0.7 0 0 0'/>"),
                  4, 1, 3},
        Mechanism{"ankle", ankle, 6, 2, 10}, Mechanism{"gripper", gripper, 3, 0, 7},
        Mechanism{"weld", welded, 6, 1, 12},
        Mechanism{
            "weld_to_the_world",
            "<worldbody>" +
                bar("a", "0 0 0", ball + bar("b", "0.3 0 0", ball + bar("c", "0 0 0.3", ball))) +
                "</worldbody><equality><weld body1='c'/></equality>",
            6, 1, 9}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish::testing
