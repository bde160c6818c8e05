// Tests of build_model(): order of joints, placements, lumped bodies, tables, names and frames.
#include <gtest/gtest.h>

#include "burnish/model/model.hpp"
#include "support/built_robots.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using test::infinity;
using test::nan;

std::vector<std::string> names(const std::vector<Joint>& joints) {
  std::vector<std::string> result;
  for (const Joint& spec : joints) result.push_back(spec.name);
  return result;
}

TreeSpec chain(int links, JointType type) {
  TreeSpec tree;
  tree.name = "chain";
  tree.links.push_back(link("l0"));
  for (int i = 1; i < links; ++i) {
    const std::string child = "l" + std::to_string(i);
    tree.links.push_back(link(child));
    tree.joints.push_back(joint("j" + std::to_string(i), type, "l" + std::to_string(i - 1), child));
  }
  return tree;
}

TEST(ModelBuild, Joints_AreOrderedDepthFirstAndByName) {
  const Model model = build_model(branching_tree());
  EXPECT_EQ(names(model.joints), (std::vector<std::string>{"c", "d", "b", "e"}));
  EXPECT_EQ(model.joints[0].parent, -1);
  EXPECT_EQ(model.joints[3].parent, 2);
  EXPECT_EQ(model.nq, 5);
  EXPECT_EQ(model.nv, 4);
  EXPECT_EQ(model.joints[3].q_index, 3);
  EXPECT_EQ(model.joints[3].v_index, 3);
}

TEST(ModelBuild, OrderOfTheFile_DoesNotChangeTheOrderOfJoints) {
  TreeSpec turned = branching_tree();
  std::reverse(turned.joints.begin(), turned.joints.end());
  std::reverse(turned.links.begin(), turned.links.end());
  EXPECT_EQ(names(build_model(turned).joints), names(build_model(branching_tree()).joints));
}

TEST(ModelBuild, RandomTree_PlacesLinksAsDescribed) {
  std::mt19937_64 generator(1);
  for (int round = 0; round < 20; ++round) {
    const TreeSpec tree = random_tree(generator, 18);
    ModelOptions options;
    options.base_placement = random_placement(generator);
    const Model model = build_model(tree, options);
    const Posture posture = random_posture(tree, generator);
    const auto expected = link_placements(tree, posture, "link_0", options.base_placement);
    const Eigen::VectorXd q = configuration(model, posture);
    for (const auto& [name, placement] : expected) {
      EXPECT_TRUE(frame_placement(model, q, name).isApprox(placement, 1e-12)) << name;
    }
    for (const JointSpec& spec : tree.joints) {
      EXPECT_TRUE(frame_placement(model, q, spec.name)
                      .isApprox(frame_placement(model, q, spec.child_link), 1e-12));
    }
  }
}

TEST(ModelBuild, RotationFromZ_IsExactForAxesOfTheFrame) {
  EXPECT_EQ(rotation_from_z(Eigen::Vector3d::UnitZ()), Eigen::Matrix3d::Identity());
  std::mt19937_64 generator(2);
  std::vector<Eigen::Vector3d> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(Eigen::Vector3d::Unit(i));
    axes.push_back(-Eigen::Vector3d::Unit(i));
  }
  for (const Eigen::Vector3d& axis : axes) EXPECT_EQ(rotation_from_z(axis).col(2), axis);
  axes.push_back(Eigen::Vector3d(1e-9, 0.0, -1.0).normalized());
  for (int i = 0; i < 50; ++i) axes.push_back(random_vector(generator).normalized());
  for (const Eigen::Vector3d& axis : axes) {
    const Eigen::Matrix3d rotation = rotation_from_z(axis);
    EXPECT_TRUE(rotation.col(2).isApprox(axis, 1e-14));
    EXPECT_TRUE((rotation.transpose() * rotation).isIdentity(1e-14));
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-14);
  }
}

TEST(ModelBuild, AxisOfAnyLength_IsNormalized) {
  TreeSpec tree = branching_tree();
  tree.joints[0].axis = Eigen::Vector3d(0.0, 3.0, 0.0);
  const Model model = build_model(tree);
  const Joint& turned = model.joints[static_cast<std::size_t>(model.joint_index("b"))];
  EXPECT_TRUE(turned.placement.linear().col(2).isApprox(Eigen::Vector3d::UnitY()));
}

/// Sum over the tree of mass, mass * com and inertia about the world's origin at a posture.
struct Composite {
  double mass = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  void add(double m, const Eigen::Vector3d& com, const Eigen::Matrix3d& at_com,
           const Eigen::Isometry3d& placement) {
    const Eigen::Vector3d c = placement * com;
    mass += m;
    moment += m * c;
    inertia += placement.linear() * at_com * placement.linear().transpose() +
               m * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  }
};

TEST(ModelBuild, FixedLinks_AreLumpedWithAllMassAndInertia) {
  std::mt19937_64 generator(3);
  for (int round = 0; round < 10; ++round) {
    const TreeSpec tree = random_tree(generator, 18);
    ModelOptions options;
    options.base = Base::FreeFlyer;
    const Model model = build_model(tree, options);
    const Posture posture = random_posture(tree, generator);
    const auto links = link_placements(tree, posture, "link_0");
    Composite expected, lumped;
    for (const LinkSpec& spec : tree.links) {
      expected.add(spec.inertia.mass, spec.inertia.com, spec.inertia.inertia_at_com,
                   links.at(spec.name));
    }
    const auto bodies = body_placements(model, configuration(model, posture));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Joint& body = model.joints[i];
      lumped.add(body.mass, body.com, body.inertia_at_com, bodies[i]);
    }
    EXPECT_NEAR(model.total_mass(), expected.mass, 1e-12);
    EXPECT_NEAR(lumped.mass, expected.mass, 1e-12);
    EXPECT_TRUE(lumped.moment.isApprox(expected.moment, 1e-12));
    EXPECT_TRUE(lumped.inertia.isApprox(expected.inertia, 1e-12));
  }
}

TEST(ModelBuild, LumpedPointMasses_EqualAHandCalculation) {
  // A point of 1 kg on the axis and one of 3 kg fixed 4 m from it along x.
  TreeSpec tree;
  tree.links = {link("base"), link("near"), link("far")};
  tree.links[1].inertia = {1.0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  tree.links[2].inertia = {3.0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  tree.joints = {joint("turn", JointType::Revolute, "base", "near"),
                 joint("bolt", JointType::Fixed, "near", "far")};
  tree.joints[1].placement.translation() = Eigen::Vector3d(4.0, 0.0, 0.0);
  const Model model = build_model(tree);
  ASSERT_EQ(model.joints.size(), 1u);
  EXPECT_DOUBLE_EQ(model.joints[0].mass, 4.0);
  EXPECT_TRUE(model.joints[0].com.isApprox(Eigen::Vector3d(3.0, 0.0, 0.0)));
  EXPECT_TRUE(model.joints[0].inertia_at_com.isApprox(
      Eigen::Matrix3d(Eigen::Vector3d(0.0, 12.0, 12.0).asDiagonal())));
  EXPECT_EQ(model.joints[0].inertia_at_com, model.joints[0].inertia_at_com.transpose());
}

TEST(ModelBuild, FixedBase_CarriesTheRootInTheWorld) {
  ModelOptions options;
  options.base_placement.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  const Model model = build_model(branching_tree(), options);
  for (const char* name : {"base", "a"}) {
    EXPECT_EQ(model.frames[static_cast<std::size_t>(model.frame_index(name))].body, -1);
  }
  EXPECT_TRUE(frame_placement(model, model.q_neutral, "a")
                  .translation()
                  .isApprox(Eigen::Vector3d(1.1, 2.2, 3.3)));
  EXPECT_DOUBLE_EQ(model.total_mass(), 4.0);
}

TEST(ModelBuild, FreeFlyer_CarriesTheRoot) {
  std::mt19937_64 generator(4);
  ModelOptions options;
  options.base = Base::FreeFlyer;
  options.base_placement = random_placement(generator);
  const Model model = build_model(branching_tree(), options);
  const Joint& root = model.joints[0];
  EXPECT_EQ(root.name, "root_joint");
  EXPECT_EQ(root.kind, JointKind::FreeFlyer);
  EXPECT_TRUE(root.placement.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_DOUBLE_EQ(root.mass, 2.0);
  EXPECT_EQ(model.nq, 12);
  EXPECT_EQ(model.nv, 10);
  EXPECT_TRUE(frame_placement(model, model.q_neutral, "base").isApprox(options.base_placement));
  EXPECT_TRUE(
      frame_placement(model, model.q_neutral, "root_joint").isApprox(options.base_placement));
  EXPECT_DOUBLE_EQ(model.total_mass(), 6.0);
}

TEST(ModelBuild, Tables_FollowTheOrderOfQAndV) {
  TreeSpec tree = branching_tree();
  JointSpec& b = tree.joints[0];
  b.lower = -1.0;
  b.upper = 2.0;
  b.velocity_limit = 3.0;
  b.effort_limit = 4.0;
  b.damping = 5.0;
  b.friction = 6.0;
  b.armature = 7.0;
  tree.joints[4].lower = -1.0;  // a continuous joint ignores its range
  tree.joints[4].upper = 1.0;
  const Model model = build_model(tree);
  EXPECT_EQ(model.q_lower,
            (Eigen::VectorXd(5) << -infinity, -infinity, -1.0, -infinity, -infinity).finished());
  EXPECT_EQ(model.q_upper,
            (Eigen::VectorXd(5) << infinity, infinity, 2.0, infinity, infinity).finished());
  EXPECT_EQ(model.velocity_limit,
            (Eigen::VectorXd(4) << infinity, infinity, 3.0, infinity).finished());
  EXPECT_EQ(model.effort_limit,
            (Eigen::VectorXd(4) << infinity, infinity, 4.0, infinity).finished());
  EXPECT_EQ(model.damping, (Eigen::VectorXd(4) << 0.0, 0.0, 5.0, 0.0).finished());
  EXPECT_EQ(model.friction, (Eigen::VectorXd(4) << 0.0, 0.0, 6.0, 0.0).finished());
  EXPECT_EQ(model.armature, (Eigen::VectorXd(4) << 0.0, 0.0, 7.0, 0.0).finished());
  EXPECT_EQ(model.q_neutral, (Eigen::VectorXd(5) << 0.0, 0.0, 0.0, 1.0, 0.0).finished());
  EXPECT_EQ(model.gravity, Eigen::Vector3d(0.0, 0.0, -9.81));
}

TEST(ModelBuild, Support_IsThePathToTheRoot) {
  std::mt19937_64 generator(5);
  for (const Base base : {Base::Fixed, Base::FreeFlyer}) {
    ModelOptions options;
    options.base = base;
    const Model model = build_model(random_tree(generator, 24), options);
    EXPECT_TRUE(model.support(-1).empty());
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      const Joint& spec = model.joints[i];
      std::vector<int> path;
      for (int k = spec.v_index + spec.nv - 1; k >= 0;
           k = model.parent_of_v[static_cast<std::size_t>(k)]) {
        path.insert(path.begin(), k);
      }
      const auto support = model.support(static_cast<int>(i));
      EXPECT_EQ(std::vector<int>(support.begin(), support.end()), path);
      std::vector<int> owners;
      for (int owner = static_cast<int>(i); owner >= 0;
           owner = model.joints[static_cast<std::size_t>(owner)].parent) {
        EXPECT_LT(model.joints[static_cast<std::size_t>(owner)].parent, owner);
        for (int k = 0; k < model.joints[static_cast<std::size_t>(owner)].nv; ++k) {
          owners.insert(owners.begin(), owner);
        }
      }
      ASSERT_EQ(owners.size(), path.size());
      for (std::size_t k = 0; k < path.size(); ++k) {
        EXPECT_EQ(model.joint_of_v[static_cast<std::size_t>(path[k])], owners[k]);
      }
    }
  }
}

TEST(ModelBuild, EntriesOfQAndV_AreNamed) {
  TreeSpec tree;
  tree.links = {link("base"), link("a"), link("b"), link("c"), link("d"), link("e")};
  tree.joints = {joint("a", JointType::Planar, "base", "a"),
                 joint("b", JointType::Continuous, "a", "b"),
                 joint("c", JointType::Floating, "b", "c"),
                 joint("d", JointType::Prismatic, "c", "d"), joint("e", JointType::Ball, "d", "e")};
  const Model model = build_model(tree);
  std::string v, q;
  for (int k = 0; k < model.nv; ++k) v += model.v_name(k) + " ";
  for (int k = 0; k < model.nq; ++k) q += model.q_name(k) + " ";
  EXPECT_EQ(v, "a.vx a.vy a.wz b c.vx c.vy c.vz c.wx c.wy c.wz d e.wx e.wy e.wz ");
  EXPECT_EQ(
      q, "a.x a.y a.cos a.sin b.cos b.sin c.x c.y c.z c.qx c.qy c.qz c.qw d e.qx e.qy e.qz e.qw ");
  EXPECT_THROW(model.v_name(model.nv), Error);
  EXPECT_THROW(model.q_name(-1), Error);
}

TEST(ModelBuild, MasslessLinksBetweenJoints_GiveNoWarning) {
  EXPECT_TRUE(build_model(test::tree_of_joints_in_a_row()).warnings.empty());
  TreeSpec tree = test::tree_of_joints_in_a_row();
  for (LinkSpec& spec : tree.links)
    if (spec.name == "tip") spec.inertia = {};
  const Model model = build_model(tree);
  ASSERT_EQ(model.warnings.size(), 1u);
  expect_words(model.warnings[0], {"'to_c'", "'to_tip'", "move no mass"});
}

TEST(ModelBuild, FramesAndJoints_AreFoundByName) {
  const Model model = build_model(branching_tree());
  EXPECT_TRUE(model.has_frame("base"));
  EXPECT_FALSE(model.has_frame("bas"));
  expect_words(refusal([&] { model.frame_index("bse"); }), {"bse", "branches", "did you mean"});
  expect_words(refusal([&] { model.joint_index("arm"); }), {"joint 'arm'"});
  // "a" to "e" each name a link and a joint: the frame of the link is found.
  EXPECT_EQ(model.frames[static_cast<std::size_t>(model.frame_index("a"))].kind, FrameKind::Link);
}

TEST(ModelBuild, Visuals_KeepLinkAndPlacement) {
  TreeSpec tree = branching_tree();
  VisualSpec visual{SphereShape{0.1}, Eigen::Isometry3d::Identity(), Eigen::Vector4d::Ones()};
  visual.placement.translation() = Eigen::Vector3d(0.0, 0.0, 1.0);
  tree.links[1].visuals = {visual};
  const Model model = build_model(tree);
  ASSERT_EQ(model.visuals.size(), 1u);
  EXPECT_EQ(model.visuals[0].link, "a");
  EXPECT_EQ(model.visuals[0].body, -1);
  EXPECT_TRUE(model.visuals[0].placement.translation().isApprox(Eigen::Vector3d(0.1, 0.2, 1.3)));
}

TEST(ModelBuild, AddedFrames_AreFixedToTheirParents) {
  ModelOptions options;
  FrameSpec tool{"tool", "e", Eigen::Isometry3d::Identity()};
  tool.placement.translation().z() = 2.0;
  FrameSpec tip{"tip", "tool", Eigen::Isometry3d::Identity()};
  tip.placement.translation().z() = 1.0;
  options.frames = {tool, tip};
  const Model model = build_model(branching_tree(), options);
  const Frame& frame = model.frames[static_cast<std::size_t>(model.frame_index("tip"))];
  EXPECT_EQ(frame.kind, FrameKind::User);
  EXPECT_EQ(frame.body, model.joint_index("e"));
  EXPECT_DOUBLE_EQ(frame.placement.translation().z(), 3.0);

  options.frames = {tip};
  expect_words(refusal([&] { build_model(branching_tree(), options); }), {"tip", "tool"});
  options.frames = {tool, tool};
  expect_words(refusal([&] { build_model(branching_tree(), options); }), {"tool", "another frame"});
  options.frames = {tool};
  options.frames[0].placement.linear() *= 2.0;
  expect_words(refusal([&] { build_model(branching_tree(), options); }), {"tool", "placement"});
}

TEST(ModelBuild, Posture_GivesAConfiguration) {
  ModelOptions options;
  options.base = Base::FreeFlyer;
  const Model model = build_model(branching_tree(), options);
  const Posture posture = {{"root_joint", {1, 2, 3, 0, 0, 0, 1}}, {"e", {0.5}}, {"b", {0.25}}};
  const Eigen::VectorXd q = configuration(model, posture);
  EXPECT_EQ(q.head<3>(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(q[model.joints[3].q_index], 0.25);
  EXPECT_EQ(q[model.joints[4].q_index], std::cos(0.5));
  EXPECT_EQ(q[model.joints[4].q_index + 1], std::sin(0.5));
  const auto wrong = [&](const Posture& bad) {
    return refusal([&] { configuration(model, bad); });
  };
  expect_words(wrong({{"f", {0.0}}}), {"'f'", "does not exist"});
  expect_words(wrong({{"e", {0.0, 1.0}}}), {"'e'", "2 values", "wanted 1"});
  expect_words(wrong({{"e", {nan}}}), {"'e'", "nan"});
  expect_words(wrong({{"root_joint", {0, 0, 0, 0, 0, 0, 2}}}), {"quaternion", "2"});
  // A fixed base ignores the value of the root joint.
  EXPECT_NO_THROW(configuration(build_model(branching_tree()), posture));
}

TEST(ModelBuild, TreeAtTheSizeLimits_IsAllowed) {
  EXPECT_EQ(build_model(chain(500, JointType::Revolute)).nv, 499);
  EXPECT_EQ(build_model(chain(1, JointType::Revolute)).nv, 0);
  expect_words(refusal([&] { build_model(chain(501, JointType::Fixed)); }), {"501", "500", "l500"});
  TreeSpec star = chain(1, JointType::Fixed);
  for (int i = 1; i < 2000; ++i) {
    star.links.push_back(link("l" + std::to_string(i)));
    star.joints.push_back(
        joint("j" + std::to_string(i), JointType::Revolute, "l0", "l" + std::to_string(i)));
  }
  EXPECT_EQ(build_model(star).nv, 1999);
  star.links.push_back(link("one_more"));
  expect_words(refusal([&] { build_model(star); }), {"2001", "2000"});
}

}  // namespace
}  // namespace burnish::testing
