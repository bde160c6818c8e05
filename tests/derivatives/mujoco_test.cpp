// Dynamics and contact forces against MuJoCo, which shares no code with burnish.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>

#include "burnish/derivatives/rigid_body.hpp"
#include "support/contact_states.hpp"
#include "support/mujoco_model.hpp"
#include "support/trees.hpp"

namespace burnish::test {
namespace {

constexpr int states_tried = 60;

/// Largest error of each quantity, relative to its largest entry; recorded as properties of the
/// test.
class Worst {
 public:
  void note(const std::string& what, const Eigen::Ref<const Eigen::MatrixXd>& got,
            const Eigen::Ref<const Eigen::MatrixXd>& want) {
    const double error = relative_error(got, want);
    double& worst = worst_[what];
    worst = std::max(worst, error);
  }
  void expect_below(double tolerance) const {
    for (const auto& [what, error] : worst_) {
      char text[32];
      std::snprintf(text, sizeof text, "%.1e", error);
      ::testing::Test::RecordProperty(what, text);
      EXPECT_LE(error, tolerance) << what;
    }
  }

 private:
  std::map<std::string, double> worst_;
};

ContactSpec tied_contact(const std::string& tool, const std::string& base,
                         const Directions& directions) {
  return contact(tool, base, Reference::centered(), directions, Acceleration::Classical);
}

void compare_free_motion(const Model& model, Worst& worst) {
  MujocoModel theirs(model);
  ContactDynamics ours(model);
  std::mt19937_64 generator(7);
  for (int i = 0; i < states_tried; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    const Eigen::VectorXd v = uniform(model.nv, 1.5, generator);
    const Eigen::VectorXd tau = uniform(model.nv, 20.0, generator);
    const Eigen::VectorXd a = uniform(model.nv, 5.0, generator);
    theirs.set_state(q, v);
    ASSERT_EQ(ours.forward(q, v, tau), Status::Ok);
    worst.note("mass_matrix", ours.mass_matrix(), theirs.mass_matrix());
    worst.note("bias", ours.bias(), theirs.bias());
    worst.note("forward", ours.a(), theirs.forward(tau));
    ASSERT_EQ(ours.inverse(q, v, a, Eigen::VectorXd(0)), Status::Ok);
    worst.note("inverse", ours.tau(), theirs.inverse(a));
  }
}

struct Case {
  std::string robot;
  std::vector<std::string> frames;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.robot; }

class MujocoComparison : public ::testing::TestWithParam<Case> {};

TEST_P(MujocoComparison, DynamicsWithoutContact_Agree) {
  Worst worst;
  compare_free_motion(robot(GetParam().robot), worst);
  worst.expect_below(1e-10);
}

TEST_P(MujocoComparison, PlacementsAndJacobiansOfFrames_Agree) {
  const Model model = robot(GetParam().robot);
  MujocoModel theirs(model);
  std::mt19937_64 generator(8);
  Worst worst;
  for (const std::string& frame : GetParam().frames) {
    ContactDynamics ours(model, {tied_contact(frame, "world", Directions::all())});
    for (int i = 0; i < states_tried; ++i) {
      const Eigen::VectorXd q = random_configuration(model, generator);
      const Eigen::VectorXd v = uniform(model.nv, 1.5, generator);
      theirs.set_state(q, v);
      ASSERT_EQ(ours.acceleration(q, v, v), Status::Ok);
      worst.note("jacobian", ours.jacobian(), theirs.jacobian(frame));
      worst.note("velocity", ours.contact_velocity(), theirs.jacobian(frame) * v);
      const Eigen::Vector3d p = theirs.placement(frame).translation();
      const Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
      // Near-singular postures are allowed: the placement does not depend on the contact.
      ours.forward(q, v, tau);
      worst.note("position", ours.force(0).tool_position, p);
      worst.note("rotation", ours.force(0).tool_rotation, theirs.placement(frame).linear());
    }
  }
  worst.expect_below(1e-10);
}

INSTANTIATE_TEST_SUITE_P(robots, MujocoComparison,
                         ::testing::Values(Case{"talos:fixed", {"tool", "left_sole_link"}},
                                           Case{"talos:right_arm", {"tool"}},
                                           Case{"talos",
                                                {"tool", "left_sole_link", "right_sole_link"}},
                                           Case{"arm7", {"tool"}}, Case{"arm7:floating", {"tool"}},
                                           Case{"crane", {"left_tip", "right_tip"}},
                                           Case{"four_bar", {"tool", "pin/first", "pin/second"}},
                                           Case{"parallel_ankle", {"tool", "left_ball/first"}},
                                           Case{"gripper", {"tool", "right_pin/first"}},
                                           Case{"crane:floating", {"left_tip", "right_tip"}},
                                           Case{"in_a_row", {"tip", "side", "end"}},
                                           Case{"in_a_row:floating", {"tip", "side"}},
                                           Case{"followers", {"tip", "z_5", "z_6", "wheel_2"}},
                                           Case{"followers:floating", {"tip", "z_7", "c"}}),
                         [](const auto& test) {
                           std::string name = test.param.robot;
                           for (char& c : name)
                             if (c == ':') c = '_';
                           return name;
                         });

TEST(MujocoTreeComparison, RandomTreesOfAllJointKinds_Agree) {
  std::mt19937_64 generator(11);
  Worst worst;
  for (int i = 0; i < 4; ++i) {
    ModelOptions options;
    options.base = i % 2 == 0 ? Base::Fixed : Base::FreeFlyer;
    options.gravity = 9.0 * testing::random_vector(generator);
    compare_free_motion(build_model(testing::random_tree(generator, 10), options), worst);
  }
  worst.expect_below(1e-10);
}

TEST(MujocoTreeComparison, RandomTreesWithFollowers_Agree) {
  std::mt19937_64 generator(12);
  Worst worst;
  for (int i = 0; i < 6; ++i) {
    ModelOptions options;
    options.base = i % 2 == 0 ? Base::Fixed : Base::FreeFlyer;
    compare_free_motion(
        build_model(testing::with_random_followers(testing::random_tree(generator, 16), generator),
                    options),
        worst);
  }
  worst.expect_below(1e-10);
}

TEST(MujocoSpringComparison, JointAndTendonSprings_Agree) {
  const mujoco::ModelPointer theirs = mujoco::compile(
      "<mujoco><compiler angle=\"radian\"/><worldbody><body><joint name=\"a\" type=\"hinge\""
      " axis=\"0 0 1\" stiffness=\"6\" springref=\"0.4\"/><geom size=\"0.1\" mass=\"1\"/>"
      "<body><joint name=\"b\" type=\"slide\" axis=\"0 0 1\" stiffness=\"9\" springref=\"-0.2\"/>"
      "<geom size=\"0.1\" mass=\"1\"/><body><joint name=\"c\" type=\"ball\" stiffness=\"5\"/>"
      "<geom size=\"0.1\" mass=\"1\"/></body></body></body></worldbody><tendon>"
      "<fixed springlength=\"0.3\" stiffness=\"7\" damping=\"1.5\"><joint joint=\"a\" "
      "coef=\"0.8\"/>"
      "<joint joint=\"b\" coef=\"-1.2\"/></fixed></tendon></mujoco>");
  TreeSpec tree;
  for (const char* name : {"root", "a", "b", "c"}) tree.links.push_back(testing::link(name));
  tree.joints = {testing::joint("a", JointType::Revolute, "root", "a"),
                 testing::joint("b", JointType::Prismatic, "a", "b"),
                 testing::joint("c", JointType::Ball, "b", "c")};
  tree.joints[0].stiffness = 6.0, tree.joints[0].rest = 0.4;
  tree.joints[1].stiffness = 9.0, tree.joints[1].rest = -0.2;
  tree.joints[2].stiffness = 5.0;
  tree.tendons.push_back({"t", {{"a", 0.8}, {"b", -1.2}}, false, 0.3, 7.0, 1.5});
  const Model model = build_model(tree);
  RigidBody ours(model);
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(theirs.get()), mj_deleteData);
  mujoco::Coordinates coordinates(model, *theirs);
  std::mt19937_64 generator(9);
  Worst worst;
  for (int i = 0; i < states_tried; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    const Eigen::VectorXd v = uniform(model.nv, 1.5, generator);
    coordinates.store(q, v, *data);
    mj_forward(theirs.get(), data.get());
    ASSERT_EQ(ours.update(q, v), Status::Ok);
    worst.note("torque", ours.passive_torque(),
               Eigen::Map<const Eigen::VectorXd>(data->qfrc_passive, model.nv));
  }
  worst.expect_below(1e-12);
}

enum class Velocity { Zero, Tied, Any };

/// Motion with rigid ties, extrapolated from two small compliances, in which it is linear.
TiedMotion rigid(MujocoModel& theirs, const Eigen::VectorXd& tau) {
  constexpr double mu = 1e-10;
  const TiedMotion once = theirs.forward_tied(tau, mu), twice = theirs.forward_tied(tau, 2.0 * mu);
  return {2.0 * once.a - twice.a, 2.0 * once.lambda - twice.lambda};
}

/// Compares at random states, with compliance mu or rigid.
void compare_ties(const std::string& name, const std::vector<Tie>& ties, Velocity velocity,
                  double mu, Worst& worst) {
  const Model model = robot(name);
  std::vector<ContactSpec> contacts;
  for (const Tie& tie : ties)
    contacts.push_back(
        tied_contact(tie.tool, tie.base,
                     tie.kind == Tie::Kind::Weld ? Directions::all() : Directions::linear()));
  ContactSolver solver;
  solver.mu = mu;
  ContactDynamics ours(model, contacts, solver);
  MujocoModel theirs(model, ties);
  std::mt19937_64 generator(9);
  int tried = 0;
  for (int i = 0; i < states_tried;) {
    ASSERT_LT(++tried, 2000) << "too few random states have independent ties";
    const Eigen::VectorXd q = random_configuration(model, generator);
    Eigen::VectorXd v = uniform(model.nv, 1.5, generator);
    if (velocity == Velocity::Tied) v = at_rest(ours, q, v);
    if (velocity == Velocity::Zero) v.setZero();
    const Eigen::VectorXd tau = uniform(model.nv, 20.0, generator);
    ASSERT_LE(ours.forward(q, v, tau), Status::SingularContacts);
    if (independence(ours) < 1e-3) continue;
    ++i;
    theirs.set_state(q, v);
    const TiedMotion want = mu > 0.0 ? theirs.forward_tied(tau, mu) : rigid(theirs, tau);
    worst.note("acceleration", ours.a(), want.a);
    worst.note("force", ours.lambda(), want.lambda);
  }
}

struct TiedCase {
  std::string name, robot;
  std::vector<Tie> ties;
  bool tied_velocity;  ///< use velocities that satisfy the ties: for moving bodies and welds
};

void PrintTo(const TiedCase& c, std::ostream* out) { *out << c.name; }

class MujocoTieComparison : public ::testing::TestWithParam<TiedCase> {};

TEST_P(MujocoTieComparison, RigidTiesAtRest_Agree) {
  const TiedCase& c = GetParam();
  Worst worst;
  compare_ties(c.robot, c.ties, Velocity::Zero, 0.0, worst);
  worst.expect_below(1e-9);
}

TEST_P(MujocoTieComparison, RigidTiesInMotion_Agree) {
  const TiedCase& c = GetParam();
  Worst worst;
  compare_ties(c.robot, c.ties, c.tied_velocity ? Velocity::Tied : Velocity::Any, 0.0, worst);
  worst.expect_below(1e-9);
}

TEST_P(MujocoTieComparison, CompliantTiesInMotion_Agree) {
  const TiedCase& c = GetParam();
  Worst worst;
  compare_ties(c.robot, c.ties, c.tied_velocity ? Velocity::Tied : Velocity::Any, 1e-3, worst);
  worst.expect_below(1e-10);
}

constexpr Tie::Kind connect = Tie::Kind::Connect, weld = Tie::Kind::Weld;

INSTANTIATE_TEST_SUITE_P(
    robots, MujocoTieComparison,
    ::testing::Values(TiedCase{"right_arm_tip", "talos:right_arm", {{connect, "tool"}}, false},
                      TiedCase{"arm7_tip", "arm7", {{connect, "tool"}}, false},
                      TiedCase{"arm7_weld", "arm7", {{weld, "tool"}}, true},
                      TiedCase{"floating_arm7_weld", "arm7:floating", {{weld, "tool"}}, true},
                      TiedCase{"ankle_loops",
                               "parallel_ankle",
                               {{connect, "left_ball/second", "left_ball/first"},
                                {connect, "right_ball/second", "right_ball/first"}},
                               true},
                      TiedCase{"crane_tip", "crane", {{connect, "left_tip"}}, false},
                      TiedCase{
                          "crane_tip_to_tip", "crane", {{connect, "left_tip", "right_tip"}}, true},
                      TiedCase{"floating_crane_tip_to_tip",
                               "crane:floating",
                               {{connect, "left_tip", "right_tip"}},
                               true},
                      TiedCase{"talos_two_feet",
                               "talos",
                               {{connect, "left_sole_link"}, {connect, "right_sole_link"}},
                               false},
                      TiedCase{"talos_two_welded_feet",
                               "talos",
                               {{weld, "left_sole_link"}, {weld, "right_sole_link"}},
                               true},
                      TiedCase{"talos_hand_to_hip",
                               "talos",
                               {{connect, "tool", "leg_left_2_link"}, {connect, "left_sole_link"}},
                               true}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish::test
