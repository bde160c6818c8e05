// Tests of the MJCF reader: bodies, defaults, masses, visuals, actuators, equalities, keyframes.
#include "burnish/mjcf/mjcf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burnish/model/model.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double infinity = std::numeric_limits<double>::infinity();

TreeSpec parse(const std::string& inside) {
  return parse_mjcf("<mujoco model='m'>" + inside + "</mujoco>", "m.xml");
}
std::string refused(const std::string& inside) {
  return refusal([&] { parse(inside); });
}
/// Returns a world with one body.
std::string body(const std::string& inside, const std::string& attributes = "") {
  return "<worldbody><body name='b' " + attributes + ">" + inside + "</body></worldbody>";
}
const std::string mass = "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";
/// Returns a chain of two bodies with a hinge each.
std::string two_hinges(const std::string& x = "", const std::string& y = "") {
  return "<worldbody><body name='a'><joint name='x' " + x + "/>" + mass +
         "<body name='b' pos='1 0 0'><joint name='y' " + y + "/>" + mass +
         "</body></body></worldbody>";
}

const LinkSpec& link_of(const TreeSpec& tree, const std::string& name) {
  for (const LinkSpec& link : tree.links)
    if (link.name == name) return link;
  throw Error("no link " + name);
}
const JointSpec& joint_of(const TreeSpec& tree, const std::string& name) {
  for (const JointSpec& joint : tree.joints)
    if (joint.name == name) return joint;
  throw Error("no joint " + name);
}
/// Returns the warning that contains a word, or "".
std::string warning_of(const TreeSpec& tree, const std::string& word) {
  for (const std::string& warning : tree.warnings)
    if (warning.find(word) != std::string::npos) return warning;
  return "";
}
/// Returns the note that contains a word, or "".
std::string note_of(const TreeSpec& tree, const std::string& word) {
  for (const std::string& note : tree.notes)
    if (note.find(word) != std::string::npos) return note;
  return "";
}
Eigen::Matrix3d rotation_of(const std::string& attributes, const std::string& compiler = "") {
  const TreeSpec tree = parse("<compiler " + compiler + "/>" + body(mass, attributes));
  return joint_of(tree, "b_fixed").placement.linear();
}
Eigen::Matrix3d turn(double angle, const Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// ---- Bodies and joints

TEST(Mjcf, TwoHinges_AreReadBelowTheWorld) {
  const TreeSpec tree = parse(two_hinges());
  EXPECT_EQ(tree.name, "m");
  EXPECT_EQ(tree.source, "m.xml");
  ASSERT_EQ(tree.links.size(), 3u);
  EXPECT_EQ(tree.links[0].name, "world");
  EXPECT_EQ(joint_of(tree, "x").parent_link, "world");
  EXPECT_EQ(joint_of(tree, "y").parent_link, "a");
  EXPECT_EQ(joint_of(tree, "y").child_link, "b");
  EXPECT_EQ(joint_of(tree, "y").type, JointType::Revolute);
  EXPECT_EQ(joint_of(tree, "y").upper, infinity);
  EXPECT_EQ(tree.warnings.size(), 0u);
  EXPECT_EQ(build_model(tree).nv, 2);
}

TEST(Mjcf, NamelessModel_HasTheNameOfItsFile) {
  EXPECT_EQ(parse_mjcf("<mujoco>" + body(mass) + "</mujoco>", "dir/go.xml").name, "go");
  EXPECT_EQ(parse_mjcf("<mujoco>" + body(mass) + "</mujoco>", "/dev/fd/3").name, "robot");
}

TEST(Mjcf, EveryFormOfOrientation_IsRead) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  EXPECT_TRUE(rotation_of("").isIdentity(0.0));
  EXPECT_TRUE(rotation_of("quat='2 0 0 2'").isApprox(turn(0.5 * pi, z), 1e-15));
  EXPECT_TRUE(rotation_of("axisangle='0 2 0 90'").isApprox(turn(0.5 * pi, y), 1e-15));
  EXPECT_TRUE(rotation_of("axisangle='0 2 0 0.5'", "angle='radian'").isApprox(turn(0.5, y), 1e-15));
  EXPECT_TRUE(rotation_of("xyaxes='0 2 0 -3 1 0'").isApprox(turn(0.5 * pi, z), 1e-15));
  EXPECT_TRUE((rotation_of("zaxis='1 2 3'") * z).isApprox(Vector3d(1, 2, 3).normalized(), 1e-14));
  EXPECT_TRUE((rotation_of("zaxis='0 0 -1'") * z).isApprox(-z, 1e-14));
  EXPECT_TRUE(rotation_of("euler='10 20 30'")
                  .isApprox(turn(pi / 18, x) * turn(pi / 9, y) * turn(pi / 6, z), 1e-14));
  EXPECT_TRUE(rotation_of("euler='0.1 0.2 0.3'", "angle='radian' eulerseq='XYZ'")
                  .isApprox(turn(0.3, z) * turn(0.2, y) * turn(0.1, x), 1e-14));
  EXPECT_TRUE(rotation_of("euler='0.1 0.2 0.3'", "angle='radian' eulerseq='zYx'")
                  .isApprox(turn(0.2, y) * turn(0.1, z) * turn(0.3, x), 1e-14));
}

TEST(Mjcf, AnglesInDegrees_AreConvertedExceptOfSlides) {
  const std::string joints = body(
      "<joint name='h' range='-90 180' ref='90' springref='45' stiffness='2'/>"
      "<joint name='s' type='slide' range='-1 2' ref='0.5' springref='0.25' stiffness='3'/>" +
      mass);
  const TreeSpec degrees = parse(joints), radians = parse("<compiler angle='radian'/>" + joints);
  const JointSpec& hinge = joint_of(degrees, "h");
  EXPECT_DOUBLE_EQ(hinge.lower, -0.5 * pi);
  EXPECT_DOUBLE_EQ(hinge.upper, pi);
  EXPECT_DOUBLE_EQ(hinge.rest, 0.25 * pi);
  EXPECT_EQ(hinge.stiffness, 2.0);
  EXPECT_EQ(joint_of(radians, "h").upper, 180.0);
  for (const TreeSpec* tree : {&degrees, &radians}) {
    const JointSpec& slide = joint_of(*tree, "s");
    EXPECT_EQ(slide.lower, -1.0);
    EXPECT_EQ(slide.upper, 2.0);
    EXPECT_EQ(slide.rest, 0.25);
  }
}

TEST(Mjcf, JointLimits_FollowLimitedAndAutolimits) {
  const auto limit = [](const std::string& attributes, const std::string& compiler) {
    return joint_of(parse("<compiler angle='radian' " + compiler + "/>" +
                          body("<joint name='j' " + attributes + "/>" + mass)),
                    "j")
        .upper;
  };
  EXPECT_EQ(limit("range='-1 1'", ""), 1.0);
  EXPECT_EQ(limit("range='-1 1' limited='auto'", ""), 1.0);
  EXPECT_EQ(limit("range='-1 1' limited='false'", ""), infinity);
  EXPECT_EQ(limit("range='-1 1'", "autolimits='false'"), infinity);
  EXPECT_EQ(limit("range='-1 1' limited='true'", "autolimits='false'"), 1.0);
  EXPECT_EQ(limit("range='0 0'", ""), infinity);
  expect_words(refused(body("<joint name='j' limited='true'/>" + mass)),
               {"line 1", "'j'", "range"});
}

TEST(Mjcf, DampingFrictionAndArmature_AreRead) {
  const JointSpec joint = joint_of(
      parse(body("<joint name='j' damping='0.1' frictionloss='0.2' armature='0.3'/>" + mass)), "j");
  EXPECT_EQ(joint.damping, 0.1);
  EXPECT_EQ(joint.friction, 0.2);
  EXPECT_EQ(joint.armature, 0.3);
}

TEST(Mjcf, SeveralJointsOfABody_BecomeAChain) {
  const TreeSpec tree =
      parse(body("<joint name='z'/><joint name='a' axis='0 2 0'/><joint axis='1 0 0'/>" + mass,
                 "pos='1 2 3'"));
  ASSERT_EQ(tree.joints.size(), 3u);
  EXPECT_EQ(tree.joints[0].child_link, tree.joints[1].parent_link);
  EXPECT_EQ(tree.joints[1].child_link, tree.joints[2].parent_link);
  EXPECT_EQ(tree.joints[2].child_link, "b");
  EXPECT_EQ(tree.joints[2].name, "b_joint");
  EXPECT_EQ(tree.joints[0].placement.translation(), Vector3d(1, 2, 3));
  EXPECT_TRUE(tree.joints[1].placement.matrix().isIdentity(0.0));
  EXPECT_EQ(tree.joints[1].axis, Vector3d::UnitY());
  EXPECT_EQ(link_of(tree, tree.joints[0].child_link).inertia.mass, 0.0);
  EXPECT_EQ(link_of(tree, "b").inertia.mass, 1.0);
}

TEST(Mjcf, JointOffTheBodyOrigin_KeepsTheBodyFrame) {
  const Model model =
      build_model(parse(body("<joint name='j' pos='1 0 0'/>" + mass, "pos='5 0 0'")));
  const int frame = model.frame_index("b");
  // A quarter turn about the point (6, 0, 0) moves the body from (5, 0, 0) to (6, -1, 0).
  const Joint& joint = model.joints[0];
  const Isometry3d at = joint.placement * Eigen::AngleAxisd(0.5 * pi, Vector3d::UnitZ()) *
                        model.frames[static_cast<std::size_t>(frame)].placement;
  EXPECT_TRUE(at.translation().isApprox(Vector3d(6, -1, 0), 1e-14));
}

TEST(Mjcf, ReferencePosition_IsThePoseOfTheFile) {
  const TreeSpec tree = parse("<compiler angle='radian'/>" + two_hinges("ref='0.5'"));
  // At q = ref the robot has the pose of the file.
  const JointSpec& joint = joint_of(tree, "x");
  EXPECT_TRUE((joint.placement.linear() * turn(0.5, Vector3d::UnitZ())).isIdentity(1e-15));
  ASSERT_TRUE(tree.postures.contains("qpos0"));
  EXPECT_EQ(tree.postures.at("qpos0").at("x"), std::vector<double>{0.5});
  EXPECT_FALSE(parse(two_hinges()).postures.contains("qpos0"));
}

TEST(Mjcf, FreeJoint_BecomesTheFloatingBase) {
  for (const char* joint : {"<freejoint/>", "<joint type='free'/>"}) {
    const TreeSpec tree = parse(body(joint + mass, "pos='1 2 3' quat='0 1 0 0'"));
    const JointSpec& root = joint_of(tree, "root_joint");
    EXPECT_EQ(root.type, JointType::Floating);
    EXPECT_TRUE(root.placement.matrix().isIdentity(0.0));
    EXPECT_EQ(tree.postures.at("qpos0").at("root_joint"),
              (std::vector<double>{1, 2, 3, 1, 0, 0, 0}));
    EXPECT_EQ(build_model(tree).nv, 6);
  }
  expect_words(refused(body("<joint/>" + mass + "<body>" + mass + "<freejoint/></body>")),
               {"line 1", "world"});
  expect_words(refused(body("<joint/><freejoint/>" + mass)), {"only joint", "2 joints"});
}

TEST(Mjcf, BallJoint_IsReadWithAWarningOfItsRange) {
  const TreeSpec tree =
      parse(body("<joint name='j' type='ball' pos='0 0 1' range='0 60'/>" + mass));
  EXPECT_EQ(joint_of(tree, "j").type, JointType::Ball);
  EXPECT_EQ(joint_of(tree, "j").placement.translation(), Vector3d(0, 0, 1));
  EXPECT_EQ(joint_of(tree, "b_fixed").placement.translation(), Vector3d(0, 0, -1));
  expect_words(warning_of(tree, "ball"), {"range", "'j'"});
}

TEST(Mjcf, NestedFrames_AreComposed) {
  const TreeSpec tree = parse(
      "<default><default class='c'><joint armature='3'/></default></default><worldbody>"
      "<frame pos='1 0 0' euler='0 0 90' childclass='c'><frame pos='1 0 0'><body name='b' pos='0 1 "
      "0'>"
      "<frame euler='90 0 0' pos='0 0 2'><joint name='j' pos='0 0 1' axis='0 1 0'/><site name='s' "
      "pos='0 0 1'/></frame>" +
      mass + "</body></frame></frame></worldbody>");
  const JointSpec& joint = joint_of(tree, "j");
  EXPECT_EQ(joint.armature, 3.0);
  EXPECT_TRUE(joint.axis.isApprox(Vector3d::UnitZ(), 1e-15));
  // The point (0, 0, 1) of the inner frame is (0, -1, 2) in the body.
  EXPECT_TRUE(joint.placement.translation().isApprox(Vector3d(0 + 1, 1, 2), 1e-14));
  ASSERT_EQ(tree.frames.size(), 1u);
  EXPECT_TRUE(tree.frames[0].placement.translation().isApprox(Vector3d(0, -1, 2), 1e-14));
}

TEST(Mjcf, NamelessBodies_GetUnusedNames) {
  const TreeSpec tree = parse("<worldbody><body>" + mass + "</body><body>" + mass +
                              "</body><body name='body'>" + mass + "</body></worldbody>");
  EXPECT_EQ(tree.links[1].name, "body_1");
  EXPECT_EQ(tree.links[2].name, "body_2");
  EXPECT_EQ(tree.links[3].name, "body");
}

// ---- Defaults

TEST(Mjcf, Defaults_AreInheritedFromEnclosingClasses) {
  const TreeSpec tree = parse(
      "<default><joint damping='1' armature='1'/><default class='arm'><joint damping='2'/><default "
      "class='wrist'><joint axis='1 0 0'/></default></default></default><worldbody>"
      "<body name='a' childclass='arm'><joint name='x'/>" +
      mass + "<body><joint name='y' class='wrist'/>" + mass +
      "<body><joint name='z' damping='3'/>" + mass +
      "</body></body></body><body><joint name='w'/>" + mass + "</body></worldbody>");
  EXPECT_EQ(joint_of(tree, "x").damping, 2.0);
  EXPECT_EQ(joint_of(tree, "x").armature, 1.0);
  EXPECT_EQ(joint_of(tree, "y").damping, 2.0);
  EXPECT_EQ(joint_of(tree, "y").axis, Vector3d::UnitX());
  EXPECT_EQ(joint_of(tree, "z").damping, 3.0);
  EXPECT_EQ(joint_of(tree, "w").damping, 1.0);
}

TEST(Mjcf, PartialSize_OverridesOnlyItsNumbers) {
  const TreeSpec tree = parse("<default><geom type='box' size='0.1 0.2 0.3'/></default>" +
                              body("<geom size='0.5'/>"));
  EXPECT_NEAR(link_of(tree, "b").inertia.mass, 1000.0 * 8 * 0.5 * 0.2 * 0.3, 1e-12);
}

TEST(Mjcf, FreejointElement_HasNoDefaults) {
  const std::string defaults = "<default><joint armature='1' damping='2'/></default>";
  EXPECT_EQ(joint_of(parse(defaults + body("<freejoint name='f'/>" + mass)), "f").armature, 0.0);
  EXPECT_EQ(joint_of(parse(defaults + body("<joint type='free' name='f'/>" + mass)), "f").damping,
            2.0);
}

// ---- Masses

TEST(Mjcf, Inertials_AreReadInBothForms) {
  const InertiaSpec full =
      link_of(parse(body("<inertial pos='1 2 3' mass='2' fullinertia='4 5 6 0.1 0.2 0.3'/>")), "b")
          .inertia;
  Eigen::Matrix3d wanted;
  wanted << 4, 0.1, 0.2, 0.1, 5, 0.3, 0.2, 0.3, 6;
  EXPECT_EQ(full.mass, 2.0);
  EXPECT_EQ(full.com, Vector3d(1, 2, 3));
  EXPECT_EQ(full.inertia_at_com, wanted);
  const InertiaSpec diagonal =
      link_of(parse(body("<inertial pos='0 0 0' euler='0 0 90' mass='1' diaginertia='1 2 2.5'/>")),
              "b")
          .inertia;
  EXPECT_TRUE(
      diagonal.inertia_at_com.isApprox(Eigen::Matrix3d(Vector3d(2, 1, 2.5).asDiagonal()), 1e-15));
}

/// Returns the inertia of a body with one geom at its origin.
InertiaSpec of_geom(const std::string& attributes) {
  return link_of(parse(body("<geom " + attributes + "/>")), "b").inertia;
}
void expect_solid(const std::string& attributes, double kg, const Vector3d& moments) {
  const InertiaSpec solid = of_geom(attributes);
  EXPECT_NEAR(solid.mass, kg, 1e-12 * kg) << attributes;
  EXPECT_TRUE(solid.inertia_at_com.isApprox(Eigen::Matrix3d(moments.asDiagonal()), 1e-5))
      << attributes << "\n"
      << solid.inertia_at_com << "\n"
      << moments.transpose();
}

/// Returns the principal moments of a surface of revolution about z, summed over rings. `curve`
/// returns r and z for t in 0..1.
template <class Curve>
Vector3d turned_shell(double kg, Curve&& curve) {
  constexpr int rings = 24000;
  double area = 0.0, across = 0.0, along = 0.0;
  for (int i = 0; i < rings; ++i) {
    const auto [r0, z0] = curve(static_cast<double>(i) / rings);
    const auto [r1, z1] = curve(static_cast<double>(i + 1) / rings);
    const double r = 0.5 * (r0 + r1), z = 0.5 * (z0 + z1), da = r * std::hypot(r1 - r0, z1 - z0);
    area += da, across += da * (0.5 * r * r + z * z), along += da * r * r;
  }
  return kg / area * Vector3d(across, across, along);
}

TEST(Mjcf, PrimitiveGeoms_HaveTheirSolidInertia) {
  expect_solid("size='0.5'", 1000 * pi / 6, Vector3d::Constant(0.4 * 1000 * pi / 6 * 0.25));
  expect_solid("type='box' size='0.5 1 1.5' mass='12'", 12, Vector3d(13, 10, 5));
  expect_solid("type='ellipsoid' size='1 2 3' density='3'", 24 * pi,
               24 * pi / 5 * Vector3d(13, 10, 5));
  expect_solid("type='cylinder' size='1 3' mass='12'", 12, Vector3d(39, 39, 6));
  // A capsule without length is a sphere, and a capsule without radius is a rod.
  expect_solid("type='capsule' size='1 1e-9' mass='5'", 5, Vector3d(2, 2, 2));
  EXPECT_NEAR(of_geom("type='capsule' size='1e-6 1.5' mass='4'").inertia_at_com(0, 0), 3.0, 1e-5);
  EXPECT_NEAR(of_geom("type='capsule' size='1 0.5' density='1'").mass, pi + 4 * pi / 3, 1e-12);
}

TEST(Mjcf, ShellGeoms_HaveTheirShellInertia) {
  expect_solid("size='0.5' shellinertia='true' density='1'", pi, Vector3d::Constant(pi / 6));
  const auto mean = [](const std::string& attributes) { return of_geom(attributes).mass; };
  EXPECT_NEAR(mean("type='capsule' size='1 2' shellinertia='true' density='1'"), 12 * pi, 1e-12);
  EXPECT_NEAR(mean("type='cylinder' size='1 2' shellinertia='true' density='1'"), 10 * pi, 1e-12);
  EXPECT_NEAR(mean("type='box' size='1 2 3' shellinertia='true' density='1'"), 88, 1e-12);
  expect_solid(
      "type='cylinder' size='1 2' shellinertia='true' mass='3'", 3, turned_shell(3, [](double t) {
        // The curve is a lid, the side and a lid, with lengths 1, 4 and 1.
        const double s = 6 * t;
        return s < 1 ? std::pair(s, -2.0) : s < 5 ? std::pair(1.0, s - 3) : std::pair(6 - s, 2.0);
      }));
  expect_solid("type='capsule' size='1 2' shellinertia='true' mass='3'", 3,
               turned_shell(3, [](double t) {
                 const double s = t * (pi + 4), quarter = 0.5 * pi;
                 if (s < quarter) return std::pair(std::sin(s), -2 - std::cos(s));
                 if (s < quarter + 4) return std::pair(1.0, s - quarter - 2);
                 return std::pair(std::cos(s - quarter - 4), 2 + std::sin(s - quarter - 4));
               }));
  // A cubic shell of edge a has moments of 5/18 m a^2.
  expect_solid("type='box' size='1 1 1' shellinertia='true' mass='3'", 3,
               Vector3d::Constant(10.0 / 3));
  expect_solid("type='ellipsoid' size='1 1 1' shellinertia='true' mass='3'", 3,
               Vector3d::Constant(2));
}

TEST(Mjcf, MassesFromGeoms_FollowTheCompilerOptions) {
  const std::string geoms = body("<geom size='0.5' group='2'/>" + mass);
  const auto weight = [](const std::string& compiler, const std::string& world) {
    return link_of(parse("<compiler " + compiler + "/>" + world), "b").inertia.mass;
  };
  EXPECT_EQ(weight("", geoms), 1.0);
  EXPECT_NEAR(weight("inertiafromgeom='true'", geoms), 1000 * pi / 6, 1e-9);
  EXPECT_EQ(weight("inertiafromgeom='true' inertiagrouprange='3 5'", geoms), 1.0);
  EXPECT_EQ(weight("inertiafromgeom='false'", body("<geom size='1'/>")), 0.0);
  EXPECT_EQ(weight("boundmass='0.3'", body("")), 0.3);
  EXPECT_EQ(weight("settotalmass='7'", geoms), 7.0);
}

TEST(Mjcf, BalanceInertia_ReplacesAnImpossibleInertia) {
  const std::string world = body("<inertial pos='0 0 0' mass='1' diaginertia='1 1 4'/>");
  EXPECT_EQ(link_of(parse(world), "b").inertia.inertia_at_com(2, 2), 4.0);
  EXPECT_TRUE(link_of(parse("<compiler balanceinertia='true'/>" + world), "b")
                  .inertia.inertia_at_com.isApprox(2.0 * Eigen::Matrix3d::Identity(), 1e-14));
}

/// Returns a cube of edge 2 about the point (1, 0, 0), as triangles with outward normals.
std::string cube_obj() {
  return "v 0 -1 -1\nv 2 -1 -1\nv 2 1 -1\nv 0 1 -1\nv 0 -1 1\nv 2 -1 1\nv 2 1 1\nv 0 1 1\n"
         "f 4 3 2 1\nf 5/1 6/2 7/3 8\nf 1//1 2//1 6//1 5//1\nf 2 3 7 6\nf -6 -5 -1 -2\nf 4 1 5 8\n";
}

TEST(Mjcf, MeshGeoms_HaveTheInertiaOfTheirMesh) {
  const Scratch scratch;
  scratch.write("meshes/cube.obj", cube_obj());
  const auto read = [&](const std::string& mesh, const std::string& geom = "") {
    return read_mjcf(scratch.write(
        "m.xml", "<mujoco><compiler meshdir='meshes'/><asset><mesh name='c' file='cube.obj' " +
                     mesh + "/></asset>" + body("<geom type='mesh' mesh='c' " + geom + "/>") +
                     "</mujoco>"));
  };
  for (const char* how : {"legacy", "exact", "convex"}) {
    const InertiaSpec cube =
        link_of(read("inertia='" + std::string(how) + "'", "density='3' pos='0 0 1'"), "b").inertia;
    EXPECT_NEAR(cube.mass, 24.0, 1e-12) << how;
    EXPECT_TRUE(cube.com.isApprox(Vector3d(1, 0, 1), 1e-14)) << how;
    EXPECT_TRUE(cube.inertia_at_com.isApprox(16.0 * Eigen::Matrix3d::Identity(), 1e-13)) << how;
  }
  const InertiaSpec shell = link_of(read("inertia='shell'", "mass='3'"), "b").inertia;
  EXPECT_TRUE(shell.inertia_at_com.isApprox(10.0 / 3 * Eigen::Matrix3d::Identity(), 1e-13));
  // The reference pose comes before the scale. A mirrored mesh reverses its triangles.
  const InertiaSpec scaled =
      link_of(read("scale='-1 2 1' refpos='1 0 5' inertia='exact'"), "b").inertia;
  EXPECT_NEAR(scaled.mass, 16000.0, 1e-9);
  EXPECT_TRUE(scaled.com.isApprox(Vector3d(0, 0, -5), 1e-14));
  const TreeSpec drawn = read("scale='2 2 2' refpos='1 0 5'");
  ASSERT_EQ(link_of(drawn, "b").visuals.size(), 1u);
  const VisualSpec& visual = link_of(drawn, "b").visuals[0];
  EXPECT_EQ(std::get<MeshShape>(visual.shape).uri, "meshes/cube.obj");
  EXPECT_TRUE(visual.placement.translation().isApprox(Vector3d(-2, 0, -10), 1e-14));
}

TEST(Mjcf, MeshesInStlAndMsh_AreRead) {
  const Scratch scratch;
  std::string ascii = "solid a tetrahedron\n", facets, msh;
  const std::vector<Vector3d> v = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<int, 3>> faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const auto append = [](std::string& to, auto value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  const auto append_vector = [&](std::string& to, const Vector3d& x) {
    for (const double c : x) append(to, static_cast<float>(c));
  };
  for (const int count : {4, 0, 0, 4}) append(msh, count);
  for (const Vector3d& x : v) append_vector(msh, x);
  for (const auto& face : faces) {
    ascii += " facet normal 0 0 0\n  outer loop\n";
    append_vector(facets, Vector3d::Zero());
    for (const int i : face) {
      const Vector3d& x = v[static_cast<std::size_t>(i)];
      ascii += "   vertex " + std::to_string(x[0]) + " " + std::to_string(x[1]) + " " +
               std::to_string(x[2]) + "\r\n";
      append_vector(facets, x);
      append(msh, i);
    }
    ascii += "  endloop\n endfacet\n";
    append(facets, std::uint16_t{0});
  }
  std::string binary = "solid but binary";
  binary.resize(80);
  append(binary, std::uint32_t{4});
  scratch.write("a.stl", ascii + "endsolid\n");
  scratch.write("b.STL", binary + facets);
  scratch.write("c.msh", msh);
  for (const char* file : {"a.stl", "b.STL", "c.msh"}) {
    const TreeSpec tree = read_mjcf(scratch.write(
        "m.xml", std::string("<mujoco><asset><mesh name='t' inertia='exact' file='") + file +
                     "'/></asset>" + body("<geom type='mesh' mesh='t'/>") + "</mujoco>"));
    EXPECT_NEAR(link_of(tree, "b").inertia.mass, 1000.0 / 6, 1e-10) << file;
    EXPECT_TRUE(link_of(tree, "b").inertia.com.isApprox(Vector3d::Constant(0.25), 1e-14)) << file;
  }
  binary[0] = 'S';
  scratch.write("a.stl", binary + facets.substr(7));
  const TreeSpec cut =
      read_mjcf(scratch.write("m.xml", "<mujoco><asset><mesh file='a.stl'/></asset>" +
                                           body("<geom type='mesh' mesh='a'/>") + "</mujoco>"));
  expect_words(warning_of(cut, "ends too early"), {"a.stl"});
}

TEST(Mjcf, AbsentMeshes_AreNamedInOneWarning) {
  const TreeSpec tree = parse(
      "<asset><mesh file='a.stl'/></asset><worldbody><body name='b'>" + mass +
      "<geom type='mesh' mesh='a'/></body><body><joint/><geom type='mesh' mesh='a'/><body><geom "
      "type='mesh' mesh='a'/></body></body><body name='fixed'><geom type='mesh' "
      "mesh='a'/></body></worldbody>");
  ASSERT_EQ(tree.warnings.size(), 1u);
  expect_words(tree.warnings[0], {"m.xml", "2 of them", "absent", "'a.stl'"});
  expect_words(refused("<asset><mesh name='arm' file='a.stl'/></asset>" +
                       body("<geom type='mesh' mesh='arn'/>")),
               {"'arn'", "did you mean 'arm'"});
}

// ---- Visuals

TEST(Mjcf, VisualGeoms_AreDrawnElseCollisionGeoms) {
  const std::string geoms =
      "<geom type='capsule' size='0.1 0.2' rgba='1 0 0 1'/><geom type='box' size='1 2 3' "
      "material='m'/>"
      "<geom type='cylinder' size='1 2' rgba='1 1 1 0'/><geom size='1' group='3'/>";
  const TreeSpec tree =
      parse("<asset><material name='m' rgba='0 1 0 1'/></asset>" + body(geoms + mass));
  const std::vector<VisualSpec>& visuals = link_of(tree, "b").visuals;
  ASSERT_EQ(visuals.size(), 4u);  // a capsule is drawn as three solids
  EXPECT_EQ(std::get<CylinderShape>(visuals[0].shape).length, 0.4);
  EXPECT_EQ(visuals[2].placement.translation(), Vector3d(0, 0, 0.2));
  EXPECT_EQ(std::get<BoxShape>(visuals[3].shape).size, Vector3d(2, 4, 6));
  EXPECT_EQ(visuals[3].rgba, Eigen::Vector4d(0, 1, 0, 1));
  // Collision geoms are drawn if there are no others.
  EXPECT_EQ(link_of(parse(body("<geom size='1' group='3'/>" + mass)), "b").visuals.size(), 1u);
}

TEST(Mjcf, Sites_BecomeFrames) {
  const TreeSpec tree =
      parse(body("<site name='tip' pos='1 2 3' euler='0 0 90'/><site/><site name='b'/>" + mass));
  ASSERT_EQ(tree.frames.size(), 2u);
  EXPECT_EQ(tree.frames[0].name, "tip");
  EXPECT_EQ(tree.frames[0].parent, "b");
  EXPECT_EQ(tree.frames[0].placement.translation(), Vector3d(1, 2, 3));
  EXPECT_EQ(tree.frames[1].name, "b_site");
  EXPECT_TRUE(build_model(tree).has_frame("tip"));
}

// ---- Actuators

double effort(const std::string& actuators, const std::string& joint = "x",
              const std::string& hinge = "") {
  return joint_of(parse(two_hinges(hinge) +
                        "<tendon><fixed name='t'><joint joint='x' coef='2'/><joint "
                        "joint='y' coef='-3'/></fixed></tendon><actuator>" +
                        actuators + "</actuator>"),
                  joint)
      .effort_limit;
}

TEST(Mjcf, Actuators_SetEffortLimits) {
  EXPECT_EQ(effort(""), infinity);
  EXPECT_EQ(effort("<motor joint='x' gear='50' ctrlrange='-1 1'/>"), 50.0);
  EXPECT_EQ(effort("<motor joint='x' gear='50' ctrlrange='-1 1'/>", "y"), 0.0);
  EXPECT_EQ(effort("<motor joint='x'/>"), infinity);
  EXPECT_EQ(effort("<motor joint='x' gear='-5' ctrlrange='-2 1' forcerange='-1 1'/>"), 5.0);
  EXPECT_EQ(effort("<motor joint='x' ctrlrange='-2 2' ctrllimited='false'/>"), infinity);
  EXPECT_EQ(effort("<position joint='x' kp='9' ctrlrange='-2 2'/>"), infinity);
  EXPECT_EQ(effort("<position joint='x' kp='9' forcerange='-7 7'/>"), 7.0);
  EXPECT_EQ(effort("<general joint='x' gainprm='3' ctrlrange='-2 2'/>"), 6.0);
  EXPECT_EQ(effort("<general joint='x' gainprm='3' biastype='affine' ctrlrange='-2 2'/>"),
            infinity);
  EXPECT_EQ(
      effort("<motor joint='x' ctrlrange='-2 2'/><motor jointinparent='x' ctrlrange='-3 3'/>"),
      5.0);
  EXPECT_EQ(effort("<motor tendon='t' ctrlrange='-2 2'/>", "x"), 4.0);
  EXPECT_EQ(effort("<motor tendon='t' ctrlrange='-2 2'/>", "y"), 6.0);
  EXPECT_EQ(effort("<motor joint='x'/>", "x", "actuatorfrcrange='-4 4'"), 4.0);
  EXPECT_EQ(effort("<motor site='tip'/>"), infinity);
  expect_words(refusal([] { effort("<motor joint='z'/>"); }), {"line 1", "motor", "'z'"});
}

TEST(Mjcf, ActuatorDefaults_ApplyToEveryKind) {
  const TreeSpec tree = parse(
      "<default><general forcerange='-3 3'/><default class='big'><motor "
      "gear='10'/></default></default>" +
      two_hinges() + "<actuator><position joint='x'/><motor joint='y' class='big'/></actuator>");
  EXPECT_EQ(joint_of(tree, "x").effort_limit, 3.0);
  EXPECT_EQ(joint_of(tree, "y").effort_limit, 30.0);
}

// ---- Equalities and tendons

TEST(Mjcf, LinearJointEquality_MakesAFollower) {
  const TreeSpec tree =
      parse("<compiler angle='radian'/>" + two_hinges("ref='0.5'", "ref='0.25'") +
            "<equality><joint joint1='y' joint2='x' polycoef='0.1 2 0 0 0'/></equality>");
  const auto& mimic = joint_of(tree, "y").mimic;
  ASSERT_TRUE(mimic.has_value());
  EXPECT_EQ(mimic->leader, "x");
  EXPECT_EQ(mimic->multiplier, 2.0);
  EXPECT_DOUBLE_EQ(mimic->offset, 0.1 + 0.25 - 2 * 0.5);
  EXPECT_EQ(build_model(tree).nv, 1);
  // The first equality makes y a follower; the second one makes z a follower of y.
  const std::string three = "<worldbody><body name='a'><joint name='x'/>" + mass +
                            "</body><body><joint name='y'/>" + mass +
                            "</body><body><joint name='z'/>" + mass + "</body></worldbody>";
  const TreeSpec turned = parse(three +
                                "<equality><joint joint1='y' joint2='x'/><joint joint1='y' "
                                "joint2='z' polycoef='1 2 0 0 0'/></equality>");
  ASSERT_TRUE(joint_of(turned, "z").mimic.has_value());
  EXPECT_EQ(joint_of(turned, "z").mimic->leader, "y");
  EXPECT_EQ(joint_of(turned, "z").mimic->multiplier, 0.5);
  EXPECT_EQ(joint_of(turned, "z").mimic->offset, -0.5);
  const TreeSpec twice = parse(two_hinges() +
                               "<equality><joint joint1='y' joint2='x'/><joint joint1='x' "
                               "joint2='y'/></equality>");
  expect_words(warning_of(twice, "coupled already"), {"line 1"});
  const TreeSpec quadratic = parse(
      two_hinges() + "<equality><joint joint1='y' joint2='x' polycoef='0 1 1 0 0'/></equality>");
  EXPECT_FALSE(joint_of(quadratic, "y").mimic.has_value());
  EXPECT_NE(warning_of(quadratic, "nonlinear"), "");
}

TEST(Mjcf, EqualityOfOneJoint_LocksTheJoint) {
  const TreeSpec tree = parse("<compiler angle='radian'/>" + two_hinges("", "ref='0.5'") +
                              "<equality><joint joint1='y' polycoef='0.25 0 0 0 0'/></equality>"
                              "<keyframe><key name='k' qpos='1 0.75'/></keyframe>");
  EXPECT_EQ(joint_of(tree, "y").type, JointType::Fixed);
  EXPECT_TRUE(
      joint_of(tree, "y").placement.linear().isApprox(turn(0.25, Vector3d::UnitZ()), 1e-15));
  EXPECT_EQ(tree.postures.at("k").size(), 1u);
  EXPECT_NE(note_of(tree, "fixed at that value"), "");
}

TEST(Mjcf, LockedJoint_LocksFollowersAndShortensTendons) {
  const TreeSpec tree = parse(
      "<compiler angle='radian'/><worldbody><body name='a'><joint name='x'/>" + mass +
      "</body><body><joint name='y'/>" + mass + "</body><body><joint name='z'/>" + mass +
      "</body></worldbody><tendon><fixed name='t' stiffness='1' springlength='3'><joint joint='x' "
      "coef='2'/><joint joint='z' coef='1'/></fixed><fixed name='u'><joint joint='x' "
      "coef='4'/></fixed></tendon><equality><joint joint1='y' joint2='x' polycoef='0.5 2 0 0 "
      "0'/><tendon "
      "tendon1='u' polycoef='1'/></equality>");
  // Tendon u locks x at 0.25, which locks y at 1. Tendon t loses x; its rest becomes 2.5.
  EXPECT_EQ(joint_of(tree, "x").type, JointType::Fixed);
  EXPECT_EQ(joint_of(tree, "y").type, JointType::Fixed);
  EXPECT_TRUE(joint_of(tree, "y").placement.linear().isApprox(turn(1.0, Vector3d::UnitZ()), 1e-14));
  ASSERT_EQ(tree.tendons.size(), 1u);
  ASSERT_EQ(tree.tendons[0].parts.size(), 1u);
  EXPECT_EQ(tree.tendons[0].parts[0].joint, "z");
  EXPECT_DOUBLE_EQ(tree.tendons[0].rest, 2.5);
  EXPECT_EQ(build_model(tree).nv, 1);
}

TEST(Mjcf, ConnectAndWeld_BecomeLoops) {
  const std::string world =
      "<worldbody><body name='a' pos='1 0 0' euler='0 0 90'><joint name='x'/>" + mass +
      "<site name='s' pos='0 0 1'/><body name='c' pos='0 0 2'><joint name='z'/>" + mass +
      "</body></body><body name='b' pos='0 1 0'><joint name='y'/>" + mass +
      "<site name='t' pos='0 0 3'/></body></worldbody><equality>";
  const auto loop = [&](const std::string& equality) {
    const TreeSpec tree = parse(world + equality + "</equality>");
    if (tree.loops.size() != 1) throw Error("no loop");
    return tree.loops[0];
  };
  const LoopSpec connect = loop("<connect name='l' body1='a' body2='b' anchor='1 0 0'/>");
  EXPECT_EQ(connect.name, "l");
  EXPECT_EQ(connect.first_link, "a");
  EXPECT_EQ(connect.second_link, "b");
  EXPECT_EQ(connect.directions, Directions::linear());
  EXPECT_EQ(connect.first.translation(), Vector3d(1, 0, 0));
  EXPECT_TRUE(
      connect.second.translation().isApprox(Vector3d(1, 0, 0), 1e-15));  // (1, 1, 0) in the world
  const LoopSpec ground = loop("<connect body1='c' anchor='0 0 1'/>");
  EXPECT_EQ(ground.second_link, "world");
  EXPECT_TRUE(ground.second.translation().isApprox(Vector3d(1, 0, 3), 1e-15));
  const LoopSpec sites = loop("<connect site1='s' site2='t'/>");
  EXPECT_EQ(sites.first.translation(), Vector3d(0, 0, 1));
  EXPECT_EQ(sites.second.translation(), Vector3d(0, 0, 3));
  const LoopSpec weld = loop("<weld body1='a' body2='b' anchor='0 0 1'/>");
  EXPECT_EQ(weld.directions, Directions::all());
  EXPECT_TRUE(weld.first.linear().isApprox(turn(-0.5 * pi, Vector3d::UnitZ()), 1e-15));
  EXPECT_TRUE(weld.first.translation().isApprox(Vector3d(1, 1, 1), 1e-15));
  EXPECT_EQ(weld.second.translation(), Vector3d(0, 0, 1));
  const LoopSpec posed = loop("<weld body1='a' body2='b' relpose='1 2 3 2 0 0 0' anchor='0 0 1'/>");
  EXPECT_EQ(posed.first.translation(), Vector3d(1, 2, 3));  // pose of the anchor
  EXPECT_TRUE(posed.first.linear().isIdentity(0.0));
  const TreeSpec idle = parse(world + "<weld body1='a' active='false'/></equality>");
  EXPECT_TRUE(idle.loops.empty());
  EXPECT_NE(note_of(idle, "not active"), "");
  expect_words(refused(world + "<connect body1='aa' anchor='0 0 0'/></equality>"),
               {"'aa'", "did you mean 'a'"});
  expect_words(refused(world + "<connect body1='a' body2='b'/></equality>"), {"anchor"});
}

TEST(Mjcf, FixedTendons_AreReadAndSpatialOnesReported) {
  const std::string parts =
      "<joint joint='x' coef='2'/><joint joint='y' coef='-3'/></fixed></tendon>";
  const auto tendon = [&](const std::string& attributes, const std::string& more = "") {
    const TreeSpec tree = parse("<compiler angle='radian'/>" +
                                two_hinges("ref='0.5'", "springref='0.25' stiffness='1'") +
                                "<tendon><fixed name='t' " + attributes + ">" + parts + more);
    return tree.tendons.at(0);
  };
  const TendonSpec plain = tendon("stiffness='4' damping='5'");
  ASSERT_EQ(plain.parts.size(), 2u);
  EXPECT_EQ(plain.parts[1].joint, "y");
  EXPECT_EQ(plain.parts[1].coefficient, -3.0);
  EXPECT_EQ(plain.stiffness, 4.0);
  EXPECT_EQ(plain.damping, 5.0);
  EXPECT_FALSE(plain.held);
  EXPECT_DOUBLE_EQ(plain.rest, -0.75);  // length at the rest of the joints' springs
  EXPECT_EQ(tendon("stiffness='4' springlength='0.1'").rest, 0.1);
  const TendonSpec held = tendon("", "<equality><tendon tendon1='t' polycoef='0.125'/></equality>");
  EXPECT_TRUE(held.held);
  EXPECT_DOUBLE_EQ(held.rest, 2 * 0.5 + 0.125);  // polycoef adds to the length at the reference
  const TreeSpec three = parse(
      two_hinges() + "<worldbody><body><joint name='z'/>" + mass +
      "</body></worldbody><tendon><fixed name='t'><joint joint='x' coef='1'/><joint joint='z' "
      "coef='1'/><joint joint='y' coef='1'/></fixed></tendon><equality><tendon "
      "tendon1='t'/></equality>");
  EXPECT_FALSE(three.tendons.at(0).held);
  EXPECT_NE(warning_of(three, "more than two joints"), "");
  const TreeSpec spatial =
      parse(two_hinges() + "<tendon><spatial name='s'><site site='a'/></spatial></tendon>");
  EXPECT_TRUE(spatial.tendons.empty());
  EXPECT_TRUE(spatial.warnings.empty());
  expect_words(note_of(spatial, "spatial"), {"'s'"});
  const TreeSpec pulls = parse(two_hinges() +
                               "<tendon><spatial name='s' stiffness='3'/><spatial name='t' "
                               "damping='1' range='0 1'/></tendon>");
  expect_words(warning_of(pulls, "springs"), {"spatial 's'", "spatial 't'"});
  expect_words(warning_of(pulls, "limits of spatial"), {"spatial 't'"});
}

// ---- Keyframes

TEST(Mjcf, Keyframes_BecomePostures) {
  const std::string world = "<worldbody><body name='base'><freejoint/>" + mass +
                            "<body name='leg'><joint name='hip' "
                            "type='ball'/>" +
                            mass + "<body name='foot'><joint name='z'/><joint name='a'/>" + mass +
                            "</body></body></body></worldbody><keyframe>";
  const TreeSpec tree = parse(world +
                              "<key name='home' qpos='1 2 3 2 0 0 0  0 0 2 0  7 8'/><key "
                              "qpos='1 2'/><key name='vel' qvel='1'/></keyframe>");
  EXPECT_EQ(tree.postures.size(), 1u);
  const Posture& home = tree.postures.at("home");
  EXPECT_EQ(home.at("root_joint"), (std::vector<double>{1, 2, 3, 0, 0, 0, 1}));
  EXPECT_EQ(home.at("hip"), (std::vector<double>{0, 1, 0, 0}));
  EXPECT_EQ(home.at("z"), std::vector<double>{7});
  EXPECT_EQ(home.at("a"), std::vector<double>{8});
  expect_words(warning_of(tree, "qpos"), {"line 1", "2 numbers", "13", "left out"});
}

// ---- Gravity, includes, errors and notes

TEST(Mjcf, GravityOption_IsRead) {
  EXPECT_FALSE(parse(two_hinges()).gravity.has_value());
  EXPECT_EQ(parse("<option gravity='0 0 -1.6'/>" + two_hinges()).gravity, Vector3d(0, 0, -1.6));
  EXPECT_EQ(parse("<option><flag gravity='disable'/></option>" + two_hinges()).gravity,
            Vector3d(0, 0, 0));
}

TEST(Mjcf, IncludedFiles_AreReadAndTheirErrorsNamed) {
  const Scratch scratch;
  scratch.write("parts/joints.xml", "<mujocoinclude><joint name='j'/></mujocoinclude>");
  scratch.write("defaults.xml", "<mujoco><default><joint damping='3'/></default></mujoco>");
  const TreeSpec tree = read_mjcf(
      scratch.write("m.xml", "<mujoco><include file='defaults.xml'/>" +
                                 body("<include file='parts/joints.xml'/>" + mass) + "</mujoco>"));
  EXPECT_EQ(joint_of(tree, "j").damping, 3.0);
  const auto read = [&](const std::string& text) {
    return refusal([&] { read_mjcf(scratch.write("m.xml", "<mujoco>" + text + "</mujoco>")); });
  };
  expect_words(read("<include file='none.xml'/>" + body(mass)), {"m.xml", "line 1", "'none.xml'"});
  expect_words(read("<include file='m.xml'/>" + body(mass)), {"includes itself"});
  scratch.write("defaults.xml", "<mujoco>\n<default><joint damping='x'/></default></mujoco>");
  expect_words(read("<include file='defaults.xml'/>" + body("<joint/>" + mass)),
               {"defaults.xml", "line 2", "damping"});
  expect_words(refused("<include file='defaults.xml'/>" + body(mass)),
               {"'defaults.xml'", "cannot include files"});
}

TEST(Mjcf, SeveralProblems_AreListedWithTheirLines) {
  const std::string sentence = refused(
      "\n<worldbody><body name='b' quat='0 0 0 0'>\n<joint name='j' type='hing'/>\n<inertial "
      "mass='a' "
      "pos='0 0 0'/></body></worldbody>");
  expect_words(sentence, {"3 problems", "line 2: body 'b'", "not a rotation", "line 3: joint 'j'",
                          "did you mean 'hinge'", "line 4", "mass = 'a'"});
}

TEST(Mjcf, BadModel_IsRefusedWithItsReason) {
  expect_words(refused("<compiler coordinate='global'/>" + body(mass)), {"line 1", "global"});
  expect_words(refused("<compiler eulerseq='xyw'/>" + body(mass)), {"'xyw'"});
  expect_words(refused("<compiler angle='grad'/>" + body(mass)), {"'grad'", "degree"});
  expect_words(
      refused(body("<joint class='ar'/>" + mass) + "<default><default class='arm'/></default>"),
      {"class 'ar'", "did you mean 'arm'"});
  expect_words(refused(body(mass, "quat='1 0 0 0' euler='0 0 0'")), {"quat and euler"});
  expect_words(refused(body("<geom type='box' size='1 1'/>")), {"box", "size 3 is 0"});
  expect_words(refused(body("<geom size='1' mass='-1'/>")), {"negative"});
  expect_words(refused(body("<geom type='cube'/>")), {"'cube'"});
  expect_words(refused("<worldbody><joint/></worldbody>"), {"no joints"});
  expect_words(refused("<option/>"), {"<worldbody>"});
  expect_words(refused(body("<joint name='j' axis='0 0 0'/>" + mass)), {"'j'", "axis is zero"});
  expect_words(refused(body("<joint name='j'/>" + mass) + body("<joint name='j'/>" + mass)),
               {"'b'", "defined twice"});
  expect_words(refusal([] { parse_mjcf("<robot/>", "r.xml"); }), {"r.xml", "<robot>", "<mujoco>"});
  expect_words(refusal([] { parse_mjcf("<mujoco><a></mujoco>", "r.xml"); }), {"r.xml", "line 1"});
  expect_words(refusal([] { parse_mjcf("", "r.xml"); }), {"r.xml", "empty", "MJCF"});
}

TEST(Mjcf, IgnoredElements_AreOneNote) {
  const TreeSpec tree =
      parse("<worldbody><light/><light/><camera/><body name='b'>" + mass +
            "</body></worldbody><sensor><gyro/></sensor><asset><texture/></asset>");
  EXPECT_TRUE(tree.warnings.empty());
  ASSERT_EQ(tree.notes.size(), 1u);
  expect_words(tree.notes[0], {"m.xml", "2 <light>", "1 <camera>", "1 <gyro>", "1 <texture>"});
}

TEST(Mjcf, StrictReading_RejectsOnlyWarningsAboutDynamics) {
  ModelOptions strict;
  strict.strict = true;
  const std::string hinge = "<joint name='j' range='0 1'/>" + mass;
  const TreeSpec plain =
      parse(body(hinge + "<light/><site name='j'/>") +
            "<actuator><position joint='j' forcerange='-1 1'/></actuator><equality><connect "
            "body1='b' anchor='0 0 0' active='false'/></equality>");
  const Model model = build_model(plain, strict);
  EXPECT_EQ(model.notes, plain.notes);
  EXPECT_EQ(model.notes.size(), 4u);
  EXPECT_NE(note_of(plain, "gains of servos"), "");
  EXPECT_NE(note_of(plain, "'_site'"), "");
  for (const char* unsupported :
       {"<plugin plugin='mujoco.elasticity.cable'/>", "<gerom/>", "<flexcomp/>"}) {
    const TreeSpec tree = parse(body(hinge + unsupported));
    ASSERT_EQ(tree.warnings.size(), 1u) << unsupported;
    expect_words(refusal([&] { build_model(tree, strict); }), {"strict", "line 1"});
  }
  expect_words(refused(body(hinge + "<composite type='cable'/>") +
                       "<equality><connect body1='B_last' anchor='0 0 0'/></equality>"),
               {"body 'B_last' does not exist", "<composite>"});
  const TreeSpec soft = parse(body(hinge) + "<deformable><flex name='f'/><skin/></deformable>");
  expect_words(warning_of(soft, "soft"), {"flex 'f'"});
  expect_words(note_of(soft, "ignored elements"), {"1 <skin>"});
}

}  // namespace
}  // namespace burnish::testing
