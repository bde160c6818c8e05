// Search for feet in descriptions: shipped robots, and legs modelled like public descriptions.
#include "burnish/tasks/pressing/find_feet.hpp"

#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "pressing/found_standing.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish {
namespace {

using testing::expect_words;

struct LegText {
  std::string foot_name = "ankle";  ///< Name of the last link
  std::string foot_rpy = "0 0 0";   ///< Roll, pitch and yaw of the frame of the last link [rad]
  std::string solid = {};           ///< <collision> elements of the last link
  std::string more = {};  ///< Additional links and joints; %s stands for the name of the leg
  int joints = 6;
  std::string last_type = "revolute";
  std::string type = "revolute";      ///< Type of the other joints
  std::string last_centre = "0 0 0";  ///< Centre of mass of the last link [m]
};

/// Returns the URDF text of a pelvis with a pair of legs, 0.1 m left and right, at each x in
/// `places`.
std::string legs(const LegText& leg, const std::vector<double>& places) {
  const auto inertial_at = [](const std::string& centre) {
    return "<inertial><origin xyz='" + centre +
           "'/><mass value='1'/><inertia ixx='0.001' ixy='0' ixz='0' iyy='0.0042' iyz='0' "
           "izz='0.005'/></inertial>";
  };
  const std::string inertial = inertial_at("0 0 0");
  std::string all = "<robot name='legs'><link name='pelvis'>" + inertial + "</link>";
  int number = 0;
  for (const double x : places)
    for (const double y : {0.1, -0.1}) {
      const std::string side = "leg" + std::to_string(number++);
      std::string parent = "pelvis";
      for (int i = 1; i <= leg.joints; ++i) {
        const bool is_last = i == leg.joints;
        const std::string link = side + "_" + (is_last ? leg.foot_name : std::to_string(i));
        all += "<link name='" + link + "'>" + (is_last ? inertial_at(leg.last_centre) : inertial) +
               (is_last ? leg.solid : "") + "</link><joint name='" + side + "_j" +
               std::to_string(i) + "' type='" + (is_last ? leg.last_type : leg.type) +
               "'><parent link='" + parent + "'/><child link='" + link + "'/><origin xyz='" +
               (i == 1 ? std::to_string(x) + " " + std::to_string(y) + " 0'" : "0 0 -0.15'") +
               (is_last ? " rpy='" + leg.foot_rpy + "'" : "") +
               "/><axis xyz='0 1 0'/><limit lower='-1' upper='1' effort='9' velocity='9'/></joint>";
        parent = link;
      }
      std::string more = leg.more;
      for (std::size_t at = more.find("%s"); at != std::string::npos; at = more.find("%s"))
        more.replace(at, 2, side);
      all += more;
    }
  return all + "</robot>";
}

Robot loaded(const std::string& text) {
  const testing::Scratch scratch;
  RobotOverrides overrides;
  overrides.base = Base::FreeFlyer;
  return load_robot(scratch.write("legs.urdf", text).string(), overrides);
}

/// Returns the position of the first foot in the axes of `frame` [m].
Eigen::Vector3d first_foot_in(const Robot& robot, const Feet& feet, const std::string& frame) {
  const Model model = with_feet(robot, feet).model;
  return frame_placement(model, model.q_neutral, frame).inverse() *
         frame_placement(model, model.q_neutral, feet.frames.front()).translation();
}

using Names = std::vector<std::string>;

TEST(FindFeet, ShippedRobots_FindsTheirFeet) {
  const auto talos = find_feet(load_robot(BURNISH_ROBOTS_DIR "/talos"));
  ASSERT_TRUE(talos);
  EXPECT_EQ(talos->frames, (Names{"left_sole_link", "right_sole_link"}));
  EXPECT_TRUE(talos->added.empty());
  EXPECT_NEAR(talos->half_x, 0.105, 1e-6);
  EXPECT_NEAR(talos->half_y, 0.065, 1e-6);
  expect_words(feet_text(*talos), {"left_sole_link, right_sole_link (found)", "0.21 x 0.13 m"});
  const auto quadruped = find_feet(load_robot(BURNISH_ROBOTS_DIR "/quadruped"));
  ASSERT_TRUE(quadruped);
  EXPECT_EQ(quadruped->frames, (Names{"fl_foot", "fr_foot", "rl_foot", "rr_foot"}));
  EXPECT_FALSE(quadruped->has_soles());
  EXPECT_NEAR(quadruped->radius, 0.018, 1e-9);
  for (const std::string robot : {"arm7", "crane", "pendulum", "gripper"})
    EXPECT_FALSE(find_feet(load_robot(std::string(BURNISH_ROBOTS_DIR) + "/" + robot))) << robot;
}

TEST(FindFeet, TurnedAnkle_SoleFrameIsCentredWithZUp) {
  const std::string box =
      "<collision><origin xyz='0.05 0.03 0.02' rpy='0 0 0'/><geometry><box size='0.04 0.2 "
      "0.1'/></geometry></collision>";
  // The x axis of the foot points up, the y axis forwards.
  const Robot robot =
      loaded(legs({.foot_rpy = "0 -1.5707963267948966 -1.5707963267948966", .solid = box}, {0.0}));
  const Eigen::Isometry3d ankle = frame_placement(robot.model, robot.model.q_neutral, "leg0_ankle");
  ASSERT_NEAR(std::abs(ankle.linear()(2, 0)), 1.0, 1e-9);
  const auto feet = find_feet(robot);
  ASSERT_TRUE(feet);
  EXPECT_EQ(feet->frames, (Names{"leg0_ankle/sole", "leg1_ankle/sole"}));
  EXPECT_EQ(feet->size_from, Feet::Size::Collision);
  const Robot with = with_feet(robot, *feet);
  const Eigen::Isometry3d sole =
      frame_placement(with.model, with.model.q_neutral, feet->frames.front());
  EXPECT_NEAR(sole.linear()(2, 2), 1.0, 1e-9);
  EXPECT_NEAR(sole.linear()(0, 0), 1.0, 1e-9);
  // The sole is the lower face of the box, with its frame at the centre of the face.
  const Eigen::Vector3d centre = ankle * Eigen::Vector3d(0.05, 0.03, 0.02);
  EXPECT_NEAR(sole.translation().z(), centre.z() - 0.02, 1e-9);
  EXPECT_LT((sole.translation() - centre).head<2>().norm(), 1e-9);
  const Eigen::Vector3d sides = (ankle.linear() * Eigen::Vector3d(0.04, 0.2, 0.1)).cwiseAbs();
  EXPECT_NEAR(feet->half_x, 0.5 * sides.x(), 1e-9);
  EXPECT_NEAR(feet->half_y, 0.5 * sides.y(), 1e-9);
  // A second search, with the frames in the model, finds the same feet.
  const auto again = find_feet(with);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->frames, feet->frames);
  EXPECT_TRUE(again->added.empty());
}

TEST(FindFeet, FourSpheresUnderEachFoot_SoleSpansThem) {
  std::string spheres;
  for (const std::string x : {"-0.05", "0.12"})
    for (const std::string y : {"-0.03", "0.03"})
      spheres += "<collision><origin xyz='" + x + " " + y +
                 " -0.03'/><geometry><sphere radius='0.005'/></geometry></collision>";
  const Robot robot = loaded(legs({.solid = spheres}, {0.0}));
  const auto feet = find_feet(robot);
  ASSERT_TRUE(feet);
  EXPECT_NEAR(feet->half_x, 0.085, 1e-9);
  EXPECT_NEAR(feet->half_y, 0.03, 1e-9);
  EXPECT_LT((first_foot_in(robot, *feet, "leg0_ankle") - Eigen::Vector3d(0.035, 0, -0.035)).norm(),
            1e-9);
}

TEST(FindFeet, SoleWithoutPrimitives_SizeComesFromTheInertia) {
  const std::string mesh =
      "<collision><geometry><mesh filename='package://foot.stl'/></geometry></collision>";
  const auto feet = find_feet(loaded(legs({.foot_name = "sole", .solid = mesh}, {0.0})));
  ASSERT_TRUE(feet);
  EXPECT_EQ(feet->frames, (Names{"leg0_sole", "leg1_sole"}));
  EXPECT_EQ(feet->size_from, Feet::Size::Inertia);
  // A box of 1 kg with this inertia is 0.22 m long and 0.1 m wide.
  EXPECT_NEAR(feet->half_x, 0.125 * 0.75, 1e-9) << "the length is at most a quarter of the height";
  EXPECT_NEAR(feet->half_y, 0.5 * std::sqrt(6.0 * (0.001 + 0.005 - 0.0042)), 1e-9);
  expect_words(feet_text(*feet), {"from the inertia of the foot"});
}

TEST(FindFeet, LegsOfThreeJoints_PointFeetAreAtTheirSpheres) {
  const std::string sphere =
      "<collision><origin xyz='0 0 -0.2'/><geometry><sphere radius='0.02'/></geometry></collision>";
  for (const std::vector<double>& places :
       {std::vector<double>{0.2, -0.2}, std::vector<double>{0.3, 0.0, -0.3}}) {
    const Robot robot = loaded(legs({.solid = sphere, .joints = 3}, places));
    const auto feet = find_feet(robot);
    ASSERT_TRUE(feet);
    EXPECT_EQ(feet->frames.size(), 2 * places.size());
    EXPECT_EQ(feet->frames.front(), "leg0_ankle/ball") << "the front left foot comes first";
    EXPECT_EQ(feet->radius, 0.02);
    EXPECT_LT((first_foot_in(robot, *feet, "leg0_ankle") - Eigen::Vector3d(0, 0, -0.2)).norm(),
              1e-9);
  }
}

TEST(FindFeet, FootWithToes_FrameIsOnTheFoot) {
  const std::string toe =
      "<link name='%s_toe'><inertial><mass value='0.1'/><inertia ixx='1e-4' ixy='0' ixz='0' "
      "iyy='1e-4' iyz='0' izz='1e-4'/></inertial></link><joint name='%s_toe_joint' "
      "type='revolute'><parent link='%s_foot'/><child link='%s_toe'/><origin xyz='0.1 0 0'/><axis "
      "xyz='0 1 0'/><limit lower='-1' upper='1' effort='9' velocity='9'/></joint>";
  const auto feet = find_feet(loaded(legs({.foot_name = "foot", .more = toe}, {0.0})));
  ASSERT_TRUE(feet);
  EXPECT_TRUE(feet->frames.front().starts_with("leg0_foot")) << feet->frames.front();
}

/// Returns link and joint of a rotor, mounted on the link `parent` of each leg.
std::string rotor(const std::string& parent, const std::string& place) {
  return "<link name='%s_" + parent +
         "_rotor'><inertial><mass value='0'/><inertia ixx='1e-5' ixy='0' ixz='0' iyy='1e-5' "
         "iyz='0' izz='1e-5'/></inertial></link><joint name='%s_" +
         parent + "_rotor_joint' type='continuous'><parent link='%s_" + parent +
         "'/><child link='%s_" + parent + "_rotor'/><origin xyz='" + place +
         "'/><axis xyz='0 1 0'/></joint>";
}

TEST(FindFeet, RotorsAndNoGeometry_FindsSolesOrPointFeet) {
  // One rotor at the height of the foot, and one on the link of the foot.
  const std::string rotors = rotor("5", "0 0.05 -0.15") + rotor("ankle", "0 0.05 0");
  const auto biped = find_feet(
      loaded(legs({.more = rotors, .last_type = "continuous", .type = "continuous"}, {0.0})));
  ASSERT_TRUE(biped);
  EXPECT_EQ(biped->frames.size(), 2U);
  EXPECT_TRUE(biped->has_soles());
  EXPECT_TRUE(biped->frames.front().starts_with("leg0_ankle"));
  EXPECT_TRUE(biped->notes.empty()) << biped->notes.front();

  LegText shank{.foot_name = "knee",
                .more = rotor("2", "0 0.05 -0.15"),
                .joints = 3,
                .last_type = "continuous",
                .type = "continuous",
                .last_centre = "0 0 -0.08"};
  const Robot robot = loaded(legs(shank, {0.2, -0.2}));
  const auto feet = find_feet(robot);
  ASSERT_TRUE(feet);
  EXPECT_EQ(feet->frames.front(), "leg0_knee/ball");
  EXPECT_EQ(feet->size_from, Feet::Size::Height);
  // A rod of 1 kg with 0.005 kg m^2 is 0.245 m long; the knee is 0.3 m below the base.
  const double tip = 0.08 + std::sqrt(3.0 * 0.005);
  EXPECT_NEAR(feet->radius, 0.05 * (0.3 + tip), 1e-9);
  EXPECT_NEAR(first_foot_in(robot, *feet, "leg0_knee").z(), feet->radius - tip, 1e-9);
  ASSERT_EQ(feet->notes.size(), 1U);
  expect_words(feet->notes.front(), {"leg0_knee", "mass and inertia"});
  expect_words(feet_text(*feet), {"assumed"});

  // A frame whose name contains "foot" takes precedence over the inertia.
  shank.more +=
      "<link name='%s_foot'/><joint name='%s_foot_joint' type='fixed'><parent "
      "link='%s_knee'/><child link='%s_foot'/><origin xyz='0 0 -0.19'/></joint>";
  const auto named = find_feet(loaded(legs(shank, {0.2, -0.2})));
  ASSERT_TRUE(named);
  EXPECT_EQ(named->frames.front(), "leg0_foot");
  EXPECT_TRUE(named->notes.empty());
}

TEST(FindFeet, FootOnAJointWithoutLimits_NoteNamesTheJoint) {
  const Robot robot =
      loaded(legs({.foot_name = "foot", .joints = 4, .last_type = "continuous"}, {0.2, -0.2}));
  Standing standing;
  const auto notes_on = [&](const Names& feet) {
    standing.feet = feet;
    Robot with_standing = robot;
    Names notes;
    pressing::standing_on(with_standing, standing, notes);
    return notes;
  };
  const std::string note =
      "leg0_foot turns freely about leg0_j4: lock this joint to stand on the foot";
  const Names found = notes_on({"auto"});
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[1], note);
  EXPECT_EQ(notes_on({"leg0_foot"}), Names{note});
  EXPECT_EQ(notes_on({"leg0_3"}), Names{});
}

TEST(FindFeet, LockedWheel_PointFootHasItsRadius) {
  const std::string motor =
      "<collision><origin rpy='1.5707963267948966 0 0'/><geometry><cylinder length='0.05' "
      "radius='0.05'/></geometry></collision>";
  const auto feet =
      find_feet(loaded(legs({.foot_name = "foot", .solid = motor, .joints = 3}, {0.2, -0.2})));
  ASSERT_TRUE(feet);
  EXPECT_EQ(feet->frames.front(), "leg0_foot");
  EXPECT_NEAR(feet->radius, 0.05, 1e-9);
  EXPECT_EQ(feet->size_from, Feet::Size::Collision);
}

TEST(FindFeet, NoFeet_ReasonIsGiven) {
  std::string reason;
  EXPECT_FALSE(find_feet(loaded(legs({.last_type = "continuous"}, {0.0})), &reason));
  expect_words(reason, {"'leg0_ankle' is a wheel", "'leg0_j6'"});
  EXPECT_FALSE(find_feet(loaded(legs({}, {0.4, 0.2, 0.0, -0.2})), &reason));
  expect_words(reason, {"8 branches end low", "'leg7_ankle'", "two, four or six"});
  std::string asymmetric = legs({}, {0.0});
  const std::string place = "0.000000 -0.100000 0";
  asymmetric.replace(asymmetric.find(place), place.size(), "0.3 -0.1 0");
  EXPECT_FALSE(find_feet(loaded(asymmetric), &reason));
  expect_words(reason,
               {"'leg1_ankle' and 'leg0_ankle'", "0.3 m away from mirror-symmetric positions"});
}

TEST(FindFeet, WheelsOrUnpairedLeg_FindsNoFeet) {
  EXPECT_FALSE(find_feet(loaded(legs({.joints = 4, .last_type = "continuous"}, {0.2, -0.2}))));
  std::string text = legs({}, {0.0});
  // A third leg without a counterpart.
  const std::string third =
      "<link name='third_foot'><inertial><mass value='1'/><inertia ixx='0.01' ixy='0' ixz='0' "
      "iyy='0.01' iyz='0' izz='0.01'/></inertial></link><joint name='third' "
      "type='revolute'><parent "
      "link='pelvis'/><child link='third_foot'/><origin xyz='0.5 0 -0.75'/><axis xyz='0 1 "
      "0'/><limit lower='-1' upper='1' effort='9' velocity='9'/></joint>";
  text.insert(text.rfind("</robot>"), third);
  EXPECT_FALSE(find_feet(loaded(text)));
}

}  // namespace
}  // namespace burnish
