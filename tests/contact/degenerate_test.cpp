// Constraints in directions that no joint can move. Status and diagnosis report them whatever the
// size and place of the robot. Slightly away from such a posture, the constraint works.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <numbers>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "contact/row_size.hpp"
#include "support/contact_states.hpp"

namespace burnish::test {
namespace {

/// Two links in the xz plane whose base is turned about x, so that they move in xy at a quarter
/// turn.
Model turned_arm(double about_x, double scale = 1.0, const Eigen::Vector3d& at = {0, 0, 0}) {
  ModelOptions options;
  options.base_placement.linear() =
      Eigen::AngleAxisd(about_x, Eigen::Vector3d::UnitX()).toRotationMatrix();
  options.base_placement.translation() = at;
  return build_model(testing::two_links(scale), options);
}

/// Result of a constraint of the tip along y.
struct TipConstraint {
  Status status;
  bool independent, immovable;
  double lambda;
};
TipConstraint constrain_along_y(const Model& model, const Reference& reference) {
  const ContactSpec tip = contact("tip", "world", reference, Directions::y());
  ContactDynamics dynamics(model, {tip});
  const Eigen::Vector2d q(0.3, 0.8), v(0.5, -1.0), tau(3.0, -2.0);
  const Status status = dynamics.forward(q, v, tau);
  ContactDynamicsBatch batch(model, {tip}, 1);
  EXPECT_EQ(batch.forward_with_derivatives(q, v, tau), status);
  EXPECT_EQ(batch.explanation(0), dynamics.explanation());
  EXPECT_EQ(dynamics.forward_derivatives(), status);
  EXPECT_TRUE(dynamics.dlambda_dq().allFinite());
  const ContactDiagnosis found = diagnose(model, dynamics.contacts(), q);
  return {status, found.redundant.empty(),
          !found.redundant.empty() && found.redundant.front().immovable, dynamics.lambda()[0]};
}

TEST(ImmovableDirection, RoundedQuarterTurn_IsSingular) {
  for (const double quarter : {std::numbers::pi / 2.0, 1.5707963, 1.570796327, 1.570796})
    for (const double scale : {1e-3, 1.0, 1e3})
      for (const Eigen::Vector3d& at : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, -70, 8)})
        for (const Reference& reference : {Reference::centered(), Reference::world()}) {
          const TipConstraint tip = constrain_along_y(turned_arm(quarter, scale, at), reference);
          EXPECT_EQ(tip.status, Status::SingularContacts) << quarter << " " << scale;
          EXPECT_EQ(tip.lambda, 0.0);
          EXPECT_FALSE(tip.independent) << quarter << " " << scale;
          EXPECT_TRUE(tip.immovable);
        }
}

TEST(ImmovableDirection, SmallTurnAway_MakesTheConstraintRegular) {
  const double quarter = std::numbers::pi / 2.0;
  const double far = constrain_along_y(turned_arm(quarter - 1e-2), Reference::centered()).lambda;
  for (const double away : {1e-3, 1e-4, 1e-5}) {
    const TipConstraint tip = constrain_along_y(turned_arm(quarter - away), Reference::centered());
    EXPECT_EQ(tip.status, Status::Ok) << away;
    EXPECT_TRUE(tip.independent);
    // The force grows with 1 / sin(away): J and the acceleration along y shrink with sin(away).
    EXPECT_NEAR(tip.lambda * std::sin(away), far * std::sin(1e-2), 1e-2 * std::abs(far) * 1e-2);
  }
}

/// Two frames of a robot that one or two joints move against each other.
struct Pair {
  std::string tool, base;
};
std::vector<Pair> pairs_of(const Model& model) {
  std::vector<Pair> pairs;
  const auto frame_on = [&](int body) {
    for (const Frame& frame : model.frames)
      if (frame.body == body && model.frame_index(frame.name) == &frame - model.frames.data())
        return frame.name;
    return std::string(body < 0 ? "world" : "");
  };
  for (int tool = 0; tool < static_cast<int>(model.joints.size()); ++tool) {
    int base = model.joints[tool].parent;
    for (int joints = 1; joints <= 2; ++joints) {
      if (!frame_on(tool).empty() && !frame_on(base).empty())
        pairs.push_back({frame_on(tool), frame_on(base)});
      if (base < 0) break;
      base = model.joints[base].parent;
    }
  }
  return pairs;
}

/// Axes whose column `d` is `n` turned by `away` towards `towards` [rad].
Eigen::Matrix3d axes_with(int d, const Eigen::Vector3d& n, const Eigen::Vector3d& towards,
                          double away) {
  Eigen::Matrix3d axes;
  axes.col(d) = std::cos(away) * n + std::sin(away) * towards;
  axes.col((d + 1) % 3) = std::cos(away) * towards - std::sin(away) * n;
  axes.col((d + 2) % 3) = axes.col(d).cross(axes.col((d + 1) % 3));
  return axes;
}

class DegeneratePosture : public ::testing::TestWithParam<TestRobot> {
 protected:
  /// Jacobian of the tool of a pair, in the axes of the base.
  Eigen::MatrixXd motions(const Pair& pair, const RobotState& state) {
    ContactDynamics all(model_, {contact(pair.tool, pair.base, Reference::surface(identity_))});
    all.acceleration(state.q, state.v, state.v);
    return all.jacobian();
  }

  /// Constrains direction `d`, which is `away` from an immovable one, and checks the results.
  void expect_results(const Pair& pair, const RobotState& state, int d, const Eigen::Vector3d& n,
                      const Eigen::Vector3d& towards, double away) {
    Directions one;
    one.bits = static_cast<std::uint8_t>(1U << static_cast<unsigned>(d));
    ContactSpec spec =
        contact(pair.tool, pair.base, Reference::surface(axes_with(d % 3, n, towards, away)), one);
    ContactDynamics dynamics(model_, {spec});
    const Status status = dynamics.forward(state.q, state.v, state.tau);
    const ContactDiagnosis found = diagnose(model_, dynamics.contacts(), state.q);
    const bool movable = away > 1e-6;
    EXPECT_EQ(status, movable ? Status::Ok : Status::SingularContacts)
        << pair.tool << " on " << pair.base << ", " << one.text() << ", " << away;
    EXPECT_EQ(found.redundant.empty(), movable) << pair.tool << " on " << pair.base;
    EXPECT_EQ(dynamics.forward_derivatives(), status);
    EXPECT_TRUE(dynamics.dlambda_dq().allFinite());
    if (movable) {
      const Eigen::VectorXd a = dynamics.a();
      const double lambda = std::abs(dynamics.lambda()[0]);
      dynamics.acceleration(state.q, state.v, a);
      EXPECT_LE(std::abs(dynamics.alpha()[0]), 1e-9 * (1.0 + a.norm() + lambda));
    } else {
      EXPECT_EQ(dynamics.lambda()[0], 0.0);
      EXPECT_NE(dynamics.explanation().find(dynamics.row_names()[0]), std::string::npos);
    }
    ++tried_;
  }

  Model model_ = GetParam().model();
  std::mt19937_64 generator_{91};
  const Eigen::Matrix3d identity_ = Eigen::Matrix3d::Identity();
  int tried_ = 0;
};

TEST_P(DegeneratePosture, Direction_IsSingularOnlyWithinRounding) {
  for (const Pair& pair : pairs_of(model_)) {
    const RobotState state = random_state(model_, generator_);
    const Eigen::MatrixXd J = motions(pair, state);
    for (const int first : {0, 3}) {
      const Eigen::Matrix<double, 3, Eigen::Dynamic> moved = J.middleRows(first, 3);
      // No joint moves along (or about) the first of three axes; the last one moves well.
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> square(
          Eigen::Matrix3d(moved * moved.transpose()));
      const Eigen::Vector3d n = square.eigenvectors().col(0),
                            towards = square.eigenvectors().col(2);
      const double max_motion = (towards.transpose() * moved).norm();
      if ((n.transpose() * moved).norm() > 1e-9 * max_motion || max_motion < 0.05) continue;
      for (int d = first; d < first + 3; ++d)
        for (const double away : {0.0, 1e-15, 2.7e-9, 1e-3, 0.1})
          expect_results(pair, state, d, n, towards, away);
    }
  }
  EXPECT_GT(tried_, 0);
}

TEST_P(DegeneratePosture, RandomRows_AreSingularExactlyWhereDiagnosed) {
  const std::vector<Pair> pairs = pairs_of(model_);
  for (int i = 0; i < 60; ++i) {
    const Pair& pair = pairs[generator_() % pairs.size()];
    const RobotState state = random_state(model_, generator_);
    Directions directions;
    directions.bits = static_cast<std::uint8_t>(1 + generator_() % 63);
    for (const Reference& reference : all_references()) {
      ContactDynamics dynamics(model_, {contact(pair.tool, pair.base, reference, directions)});
      const Status status = dynamics.forward(state.q, state.v, state.tau);
      const ContactDiagnosis found = diagnose(model_, dynamics.contacts(), state.q);
      EXPECT_EQ(status == Status::Ok, found.redundant.empty())
          << pair.tool << " on " << pair.base << ", " << directions.text() << ": " << found.text();
      for (const RedundantRow& row : found.redundant)
        EXPECT_TRUE(row.immovable || !row.implied_by.empty()) << found.text();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryRobot, DegeneratePosture,
                         ::testing::ValuesIn(available(test_robots())),
                         [](const auto& test) { return test.param.label(); });

/// One link on a hinge; the tool is on the axis up to the rounding errors of a drawing.
TEST(ImmovableDirection, LeverOfRoundingErrors_IsSingular) {
  for (const double lever : {0.0, 2.8e-17, 1e-12, 1e-9}) {
    TreeSpec tree;
    tree.name = "spinner";
    for (const char* name : {"root", "disc", "tip"}) tree.links.push_back(testing::link(name));
    tree.links[1].inertia.com = Eigen::Vector3d(0.2, 0.0, 0.0);
    tree.joints.push_back(testing::joint("spin", JointType::Revolute, "root", "disc"));
    tree.joints.push_back(testing::joint("end", JointType::Fixed, "disc", "tip"));
    tree.joints.back().placement.translation() = Eigen::Vector3d(lever, 0.0, 0.4);
    const Model model = build_model(tree);
    const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, 0.4), v = q, tau = q;
    for (const Directions& d : {Directions::x(), Directions::y(), Directions::z()}) {
      ContactDynamics dynamics(model, {contact("tip", "world", Reference::centered(), d)});
      EXPECT_EQ(dynamics.forward(q, v, tau), Status::SingularContacts) << lever;
      EXPECT_FALSE(diagnose(model, dynamics.contacts(), q).redundant.empty());
    }
  }
}

}  // namespace
}  // namespace burnish::test
