// What is read beside what MuJoCo reads from the same text.
#include <gtest/gtest.h>

#include "burnish/mjcf/mjcf.hpp"
#include "mjcf/comparison.hpp"

namespace burnish::testing {
namespace {

struct Text {
  std::string name;
  std::string model;  ///< what stands in <mujoco>
  double tolerance = 1e-10;
};
void PrintTo(const Text& text, std::ostream* out) { *out << text.name; }

class MjcfAgreement : public ::testing::TestWithParam<Text> {};

TEST_P(MjcfAgreement, WithMujocoOnMassesBiasAndPlacements) {
  const std::string text = "<mujoco>" + GetParam().model + "</mujoco>";
  const TreeSpec tree = parse_mjcf(text, "model.xml");
  const Agreement agreement = compare(tree, *mujoco::compile(text), 50);
  EXPECT_LE(agreement.mass_matrix, GetParam().tolerance);
  EXPECT_LE(agreement.bias, GetParam().tolerance);
  EXPECT_LE(agreement.placement, 1e-12);
}

const char* const inertial =
    "<inertial pos='0.1 -0.2 0.3' quat='0.9 0.1 -0.3 0.2' mass='1.5' diaginertia='0.3 0.25 0.2'/>";

std::string two_bodies(const std::string& first, const std::string& second) {
  return "<worldbody><body name='a' pos='0.1 0.2 0.3' euler='10 20 30'>" + first + inertial +
         "<body name='b' pos='0.3 0.1 -0.2' axisangle='1 2 3 40'>" + second + inertial +
         "</body></body></worldbody>";
}
std::string one_solid(const std::string& geom) {
  return "<worldbody><body name='a'><joint name='j' axis='1 2 3'/><body name='b' pos='1 0 "
         "0'><joint "
         "name='k' type='slide' axis='0 1 1'/><joint name='l' axis='0 1 0' pos='0.1 0 0.2'/>" +
         geom + "</body><geom size='0.1'/></body></worldbody>";
}

INSTANTIATE_TEST_SUITE_P(
    Joints, MjcfAgreement,
    ::testing::Values(
        Text{"hinges", two_bodies("<joint name='j'/>", "<joint name='k' axis='1 1 0'/>")},
        Text{"anchors", two_bodies("<joint name='j' pos='0.1 0.2 0.3' axis='0 1 1'/>",
                                   "<joint name='k' pos='-0.2 0.1 0' axis='1 1 0'/>")},
        Text{"references", two_bodies("<joint name='j' pos='0.1 0.2 0.3' axis='0 1 1' ref='30'/>",
                                      "<joint name='k' type='slide' axis='1 1 0' ref='0.4'/>")},
        Text{"chains",
             two_bodies("<joint name='x' type='slide' axis='1 0 0' pos='1 2 3'/><joint name='y' "
                        "type='slide' axis='0 1 0' ref='0.2'/><joint name='turn' pos='0.3 0.1 0' "
                        "ref='-20' axis='0 0.5 1'/>",
                        "<joint name='r' axis='1 0 0' pos='0 0 0.1'/><joint name='p' axis='0 1 0' "
                        "pos='0.2 0 0'/><joint name='w' pos='0 0.1 0'/>")},
        Text{"unnamed_joints",
             two_bodies("<joint/><joint axis='1 0 0'/>", "<joint axis='0 1 0'/>")},
        Text{"free", two_bodies("<freejoint name='f'/>", "<joint name='k' axis='1 1 0'/>")},
        Text{"armature", "<default><joint armature='0.2'/></default>" +
                             two_bodies("<joint type='free'/>", "<joint armature='0.3'/>")},
        Text{"gravity", "<option gravity='1 -2 3'/>" + two_bodies("<joint/>", "<joint/>")},
        Text{"radians", "<compiler angle='radian' eulerseq='ZyX'/>" +
                            two_bodies("<joint ref='0.4' axis='0 1 0'/>", "<joint/>")},
        Text{"classes",
             "<default><joint axis='1 0 0' pos='0 0.1 0'/><default class='y'><joint axis='0 1 "
             "0'/><default class='ref'><joint ref='25'/></default></default></default>" +
                 two_bodies("<joint class='ref'/>", "<joint class='y'/><joint/>")}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Solids, MjcfAgreement,
    ::testing::Values(
        Text{"sphere", one_solid("<geom type='sphere' size='0.2' pos='0.1 0.2 0.3'/>")},
        Text{"capsule", one_solid("<geom type='capsule' size='0.1 0.4' euler='20 30 40'/>")},
        Text{"capsule_between",
             one_solid("<geom type='capsule' size='0.1' fromto='0 0 0 1 2 3'/>")},
        Text{"cylinder", one_solid("<geom type='cylinder' size='0.1 0.4' zaxis='1 1 1'/>")},
        Text{"cylinder_between",
             one_solid("<geom type='cylinder' size='0.1' fromto='0.1 0 0 -1 2 3' mass='2'/>")},
        Text{"ellipsoid", one_solid("<geom type='ellipsoid' size='0.1 0.2 0.4' density='400'/>")},
        Text{"ellipsoid_between",
             one_solid("<geom type='ellipsoid' size='0.1 0.2' fromto='0 0 0.1 -1 2 3'/>")},
        Text{"box",
             one_solid("<geom type='box' size='0.1 0.2 0.4' xyaxes='1 1 0 0 1 1' mass='3'/>")},
        Text{"box_between", one_solid("<geom type='box' size='0.1' fromto='0 0 0.1 -1 2 3'/>")},
        // MuJoCo finds principal axes of several solids to seven digits.
        Text{"several",
             one_solid("<geom type='box' size='0.1 0.2 0.4' pos='0.1 0 0'/><geom size='0.3' "
                       "pos='0 0.5 0'/><geom type='capsule' size='0.1' fromto='0 0 0 1 0 1'/>"),
             1e-6},
        Text{"groups",
             "<compiler inertiagrouprange='1 2'/>" +
                 one_solid("<geom size='0.3' group='2' pos='1 0 0'/><geom size='1'/><geom "
                           "type='box' size='1 2 3' group='3'/>") +
                 "<default><geom group='1'/></default>"},
        Text{"from_geoms_alone",
             "<compiler inertiafromgeom='true'/>" +
                 one_solid(std::string("<geom size='0.3' pos='1 0 0'/>") + inertial)},
        Text{"of_given_total_mass",
             "<compiler settotalmass='5'/>" + one_solid("<geom size='0.3' pos='1 0 0'/>")},
        Text{"least",
             "<compiler boundmass='2' boundinertia='0.5'/>" +
                 one_solid("<geom type='box' size='0.1 0.2 0.4' euler='10 20 30' mass='1'/>")},
        Text{"full_inertia",
             one_solid("<inertial pos='0.1 0.2 0.3' mass='2' fullinertia='0.3 0.4 0.5 0.02 -0.03 "
                       "0.01'/>"),
             1e-6}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish::testing
