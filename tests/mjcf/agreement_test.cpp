// Tests that compare the MJCF reader with MuJoCo on the same text.
#include <gtest/gtest.h>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/state.hpp"
#include "mjcf/comparison.hpp"
#include "mjcf/joint_map.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

using Eigen::Vector3d;
using namespace std::string_literals;

struct Text {
  std::string name;
  std::string model;  ///< content of <mujoco>
  double tolerance = 1e-10;
};
void PrintTo(const Text& text, std::ostream* out) { *out << text.name; }

class MjcfComparison : public ::testing::TestWithParam<Text> {};

TEST_P(MjcfComparison, MassMatrixBiasAndPlacements_EqualMujocos) {
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
    Joints, MjcfComparison,
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
    Solids, MjcfComparison,
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
        // MuJoCo computes the principal axes of several solids to seven digits.
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
        Text{"lower_bounds",
             "<compiler boundmass='2' boundinertia='0.5'/>" +
                 one_solid("<geom type='box' size='0.1 0.2 0.4' euler='10 20 30' mass='1'/>")},
        Text{"full_inertia",
             one_solid("<inertial pos='0.1 0.2 0.3' mass='2' fullinertia='0.3 0.4 0.5 0.02 -0.03 "
                       "0.01'/>"),
             1e-6}),
    [](const auto& test) { return test.param.name; });

/// Siblings that are not in the alphabetical order of their names or of their joints' names.
const char* const unsorted =
    "<worldbody><body name='zeta'><joint name='z' axis='0 1 0'/><joint name='a' type='slide'/>"
    "<geom size='0.1'/><body name='y' pos='1 0 0'><joint name='q'/><geom size='0.1'/></body><body "
    "name='w' pos='0 1 0'><joint name='c' type='ball'/><geom size='0.1'/></body></body><body "
    "name='alpha' pos='0 1 0'><freejoint name='m'/><geom size='0.1' pos='0.1 0 0'/><body name='l'>"
    "<joint name='k'/><geom size='0.1'/></body></body><body name='last'><joint name='f'/><geom "
    "size='0.1'/></body></worldbody>";

INSTANTIATE_TEST_SUITE_P(
    Orders, MjcfComparison,
    ::testing::Values(
        Text{"siblings", unsorted},
        Text{"two_worlds", two_bodies("<joint/>", "<joint/>") + unsorted},
        Text{"locked_and_coupled",
             std::string(unsorted) +
                 "<equality><joint joint1='z' polycoef='0.3 0 0 0 0'/><joint joint1='q' joint2='k' "
                 "polycoef='0.1 -2 0 0 0'/></equality>"}),
    [](const auto& test) { return test.param.name; });

/// Returns the names of the joints in MuJoCo's order.
std::vector<std::string> joint_names(const mjModel& model) {
  std::vector<std::string> names;
  for (int j = 0; j < model.njnt; ++j) names.push_back(name_in(model, mjOBJ_JOINT, j));
  return names;
}
std::vector<std::string> joint_names(const Model& model) {
  std::vector<std::string> names;
  for (const FileJoint& joint : model.file_joints) names.push_back(joint.name);
  return names;
}

TEST(MjcfJointOrder, UnsortedBodies_HaveMujocosOrder) {
  for (const std::string& text :
       {"<mujoco>" + std::string(unsorted) + "</mujoco>",
        // names whose common prefix sorts before the name in front of them
        "<mujoco><worldbody><body name='zeta'><joint name='first' axis='0 1 0'/><geom "
        "type='capsule' fromto='0 0 0 0.5 0 0' size='0.02'/></body><body name='alpha' pos='0 1 "
        "0'><joint name='afterwards' axis='0 1 0'/><geom type='capsule' fromto='0 0 0 0.2 0 0' "
        "size='0.02'/></body></worldbody></mujoco>"s})
    EXPECT_EQ(joint_names(build_model(parse_mjcf(text))), joint_names(*mujoco::compile(text)));
}

TEST(MjcfJointOrder, CorpusFiles_HaveMujocosOrder) {
  int compared = 0;
  const std::filesystem::path folder = BURNISH_ROBOTS_DIR "/../tests/fuzz/corpus/mjcf";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".xml") continue;
    mujoco::ModelPointer theirs;
    try {
      theirs = load(entry.path());
    } catch (const Error&) {
      continue;  // needs a newer MuJoCo
    }
    EXPECT_LE(compare(read_mjcf(entry.path()), *theirs, 5).coordinates, 1e-12) << entry.path();
    ++compared;
  }
  EXPECT_GE(compared, 1);
}

TEST(MjcfJointOrder, IncludedFiles_HaveMujocosOrder) {
  const Scratch scratch;
  const std::string body = "<body name='%'><joint name='%_joint'/><geom size='0.1'/></body>";
  const auto named = [&](const std::string& name) {
    std::string text = body;
    for (std::size_t at; (at = text.find('%')) != text.npos;) text.replace(at, 1, name);
    return text;
  };
  scratch.write("part.xml",
                "<mujoco><worldbody>" + named("m") + named("b") + "</worldbody></mujoco>");
  const auto file = scratch.write("all.xml", "<mujoco><worldbody>" + named("z") +
                                                 "</worldbody><include file='part.xml'/>"
                                                 "<worldbody>" +
                                                 named("a") + "</worldbody></mujoco>");
  EXPECT_EQ(joint_names(build_model(read_mjcf(file))), joint_names(*load(file)));
}

/// Returns three branches for loops and couplings, with references other than zero.
const std::string& branches() {
  static const std::string world =
      "<compiler angle='radian'/><worldbody><body name='a' pos='0.2 0 0.1' euler='0.1 0.2 "
      "0.3'><joint name='x' axis='0 1 1' ref='0.3' pos='0 0.1 0'/>" +
      std::string(inertial) +
      "<body name='c' pos='0.4 0 0' euler='0.3 0 0'><joint name='z' axis='1 0 0'/>" + inertial +
      "</body></body><body name='b' pos='0 0.3 0' euler='0 0.4 0'><joint name='y' "
      "type='slide' axis='1 1 0' ref='-0.2'/><joint name='w' springref='0.4' stiffness='2'/>" +
      inertial + "</body></worldbody>";
  return world;
}

/// Returns the vector between the origins of a loop's frames, in world axes [m].
Vector3d gap(const RigidBody& body, const LoopSpec& loop) {
  return body.placement(body.frame(loop.first_link)) * loop.first.translation() -
         body.placement(body.frame(loop.second_link)) * loop.second.translation();
}

TEST(MjcfLoops, PositionErrors_EqualMujocos) {
  const std::string text =
      "<mujoco>" + branches() +
      "<equality><connect body1='c' body2='b' anchor='0.1 0.2 0.3'/><connect "
      "body1='b' anchor='0.3 0 0'/><weld body1='c' body2='b'/><weld body1='a' "
      "body2='b' relpose='0.1 0.2 0.3 0.9 0.1 0.2 0.3' anchor='0.3 0.1 0.2'/></equality></mujoco>";
  const TreeSpec tree = parse_mjcf(text);
  ASSERT_EQ(tree.loops.size(), 4u);
  TreeSpec open = tree;
  open.loops.clear();
  const Model model = build_model(open);
  RigidBody body(model);
  const auto theirs = mujoco::compile(text);
  const mujoco::DataPointer data(mj_makeData(theirs.get()));
  std::mt19937_64 generator(5);
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    ASSERT_EQ(body.update(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    for (int j = 0; j < theirs->njnt; ++j) {
      const char* name = mj_id2name(theirs.get(), mjOBJ_JOINT, j);
      data->qpos[j] = q[model.joints[static_cast<std::size_t>(model.joint_index(name))].q_index];
    }
    mj_fwdPosition(theirs.get(), data.get());
    ASSERT_EQ(data->nefc, 3 + 3 + 6 + 6);
    for (const auto& [loop, row] : {std::pair<std::size_t, int>{0, 0}, {1, 3}, {2, 6}, {3, 12}}) {
      const Vector3d want = Eigen::Map<const Vector3d>(data->efc_pos + row);
      EXPECT_LE((gap(body, tree.loops[loop]) - want).norm(), 1e-12) << "loop " << loop;
      if (loop < 2) continue;
      // MuJoCo's error is the vector part of a quaternion: the sine of half the angle.
      const LoopSpec& weld = tree.loops[loop];
      const Eigen::Matrix3d first =
          body.placement(body.frame(weld.first_link)).linear() * weld.first.linear();
      const Eigen::Matrix3d second =
          body.placement(body.frame(weld.second_link)).linear() * weld.second.linear();
      const double angle = Eigen::AngleAxisd(first.transpose() * second).angle();
      EXPECT_NEAR(Eigen::Map<const Vector3d>(data->efc_pos + row + 3).norm(), std::sin(0.5 * angle),
                  1e-12)
          << "loop " << loop;
    }
  }
}

TEST(MjcfCouplings, Followers_HaveNoErrorInMujoco) {
  const std::string text = "<mujoco>" + branches() +
                           "<equality><joint joint1='x' joint2='y' polycoef='0.3 -2 0 0 0'/><joint "
                           "joint1='x' joint2='z' "
                           "polycoef='0.1 0.5 0 0 0'/></equality></mujoco>";
  const Model model = build_model(parse_mjcf(text));
  ASSERT_EQ(model.nv, 2);  // y and w are the leaders
  const auto theirs = mujoco::compile(text);
  const mujoco::DataPointer data(mj_makeData(theirs.get()));
  std::mt19937_64 generator(6);
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    for (int j = 0; j < theirs->njnt; ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(
          model.joint_index(mj_id2name(theirs.get(), mjOBJ_JOINT, j)))];
      data->qpos[j] = joint.follows
                          ? joint.follows->multiplier * q[joint.q_index] + joint.follows->offset
                          : q[joint.q_index];
    }
    mj_fwdPosition(theirs.get(), data.get());
    ASSERT_EQ(data->nefc, 2);
    EXPECT_LE(std::abs(data->efc_pos[0]) + std::abs(data->efc_pos[1]), 1e-13);
  }
}

TEST(MjcfTendons, RestLengths_EqualMujocos) {
  const std::string text =
      "<mujoco>" + branches() +
      "<tendon><fixed name='t' stiffness='3'><joint joint='x' coef='0.5'/><joint joint='w' "
      "coef='-2'/></fixed><fixed name='u'><joint joint='x' coef='2'/><joint joint='y' "
      "coef='3'/></fixed></tendon><equality><tendon tendon1='u' polycoef='0.1 0 0 0 0'/></equality>"
      "</mujoco>";
  const TreeSpec tree = parse_mjcf(text);
  const auto theirs = mujoco::compile(text);
  ASSERT_EQ(tree.tendons.size(), 2u);
  EXPECT_NEAR(tree.tendons[0].rest, theirs->tendon_lengthspring[0], 1e-15);
  EXPECT_NEAR(tree.tendons[1].rest, theirs->tendon_length0[1] + 0.1, 1e-15);
}

TEST(MjcfPassiveTorques, SpringsAndDampers_EqualMujocos) {
  const std::string text =
      "<mujoco><default><joint damping='0.3'/></default>" + branches() +
      "<worldbody><body pos='0 0 1'><joint name='f' type='free' damping='0.2'/>" + inertial +
      "<body euler='0.1 0.2 0.3'><joint name='o' type='ball' stiffness='3' pos='0 0.1 0'/>" +
      inertial +
      "</body></body></worldbody><tendon><fixed name='t' stiffness='3' damping='0.5'><joint "
      "joint='x' "
      "coef='0.5'/><joint joint='w' coef='-2'/></fixed><fixed name='u' stiffness='2' "
      "springlength='0.4'><joint joint='x' coef='2'/><joint joint='y' coef='3'/></fixed></tendon>"
      "</mujoco>";
  const Agreement agreement = compare(parse_mjcf(text), *mujoco::compile(text), 50);
  EXPECT_LE(agreement.worst(), 1e-10);
  EXPECT_LE(agreement.passive, 1e-10);
}

TEST(MjcfSprings, StiffnessAndRest_EqualMujocos) {
  const std::string text = "<mujoco>" + branches() + "</mujoco>";
  const TreeSpec tree = parse_mjcf(text);
  const auto theirs = mujoco::compile(text);
  for (const JointSpec& joint : tree.joints) {
    const int j = mj_name2id(theirs.get(), mjOBJ_JOINT, joint.name.c_str());
    if (j < 0) continue;
    EXPECT_EQ(joint.stiffness, theirs->jnt_stiffness[j]);
    if (joint.stiffness > 0.0) {
      EXPECT_EQ(joint.rest, theirs->qpos_spring[theirs->jnt_qposadr[j]]);
    }
  }
}

TEST(MjcfMeshes, StatedMass_GivesMujocosInertia) {
  const Scratch scratch;
  // The mesh is not convex, so that MuJoCo's legacy sum differs from the volume.
  scratch.write(
      "l.obj",
      "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\n"
      "v 1 1 1\nv 1 2 1\nv 0 2 1\nf 4 3 2\nf 4 2 1\nf 6 4 1\nf 6 5 4\nf 8 9 10\nf 7 8 10\n"
      "f 7 10 12\nf 10 11 12\nf 1 2 8\nf 1 8 7\nf 2 3 9\nf 2 9 8\nf 3 4 10\nf 3 10 9\n"
      "f 4 5 11\nf 4 11 10\nf 5 6 12\nf 5 12 11\nf 6 1 7\nf 6 7 12\n");
  for (const char* exact : {"false", "true"}) {
    const auto file = scratch.write(
        "m.xml", "<mujoco><compiler exactmeshinertia='" + std::string(exact) +
                     "'/><asset><mesh name='l' file='l.obj' scale='0.1 0.2 0.3' refpos='0.1 0 0.2' "
                     "refquat='0.9 0.1 0.2 0.3'/></asset>" +
                     one_solid("<geom type='mesh' mesh='l' mass='2' pos='0.1 0.2 0.3' euler='10 20 "
                               "30'/>") +
                     "</mujoco>");
    EXPECT_LE(compare(read_mjcf(file), *load(file), 20).worst(), 1e-6) << exact;
  }
}

}  // namespace
}  // namespace burnish::testing
