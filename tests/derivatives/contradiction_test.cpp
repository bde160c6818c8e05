// Redundant contact rows that contradict each other. Forces are least-squares forces for any number
// of iterations, messages name the rows, and derivatives equal differences.
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "contact/constrained_dynamics.hpp"
#include "support/contact_states.hpp"
#include "support/robots.hpp"
#include "support/trees.hpp"

namespace burnish::test {
namespace {

/// A body of 8 kg that stands on four of its points.
Model body_on_four_points() {
  TreeSpec tree;
  tree.name = "cart4";
  tree.links = {testing::link("body", 8.0)};
  tree.links[0].inertia.com = {0.0, 0.0, 0.05};
  tree.links[0].inertia.inertia_at_com = Eigen::Vector3d(0.1, 0.2, 0.25).asDiagonal();
  ModelOptions options;
  options.base = Base::FreeFlyer;
  return build_model(tree, options);
}

constexpr int point_count = 4;

/// Contacts at four points of a frame's body, in a plane below it; their rows are redundant.
std::vector<ContactSpec> on_points(Model& model, const std::string& frame) {
  std::vector<ContactSpec> contacts;
  const Frame on = model.frames[static_cast<std::size_t>(model.frame_index(frame))];
  for (int i = 0; i < point_count; ++i) {
    Frame point = on;
    point.kind = FrameKind::User;
    point.name = "p" + std::to_string(i + 1);
    const Eigen::Vector3d offset(i < 2 ? 0.3 : -0.3, i % 2 == 0 ? 0.2 : -0.2, -0.1);
    point.placement.translation() += on.placement.linear() * offset;
    model.frames.push_back(point);
    ContactSpec contact;
    contact.tool = point.name;
    contact.directions = Directions::linear();
    contact.with_gains(0.0, 10.0);
    contacts.push_back(contact);
  }
  return contacts;
}

TEST(ContradictingContacts, SpinningBody_GivesLeastSquaresForces) {
  Model model = body_on_four_points();
  const std::vector<ContactSpec> contacts = on_points(model, "body");
  Eigen::VectorXd q = model.q_neutral, v = Eigen::VectorXd::Zero(6);
  q[2] = 0.1;
  v[5] = 0.3;  // rad/s, about z
  const Eigen::VectorXd tau = Eigen::VectorXd::Zero(6);
  std::vector<Eigen::VectorXd> forces;
  for (const int iterations : {10, 1000, 10000}) {
    ContactDynamics dynamics(model, contacts, {.mu = 1e-4, .max_proximal_iterations = iterations});
    ASSERT_EQ(dynamics.forward(q, v, tau), Status::NotConverged);
    forces.emplace_back(dynamics.lambda());
    // No force can change the acceleration omega^2 r of a point: 0.09 * 0.3 along x.
    EXPECT_NEAR(dynamics.proximal_residual(), 0.027, 1e-9);
    EXPECT_NEAR(dynamics.unmet().cwiseAbs().maxCoeff(), 0.027, 1e-9);
    const std::string sentence = dynamics.explanation();
    for (const char* words : {"p1/x (-0.027 m/s^2)", "p4/x (0.027 m/s^2)", "p2/y (0.018 m/s^2)",
                              "contradict each other", "least-squares"})
      EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("p1/z"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("allow more iterations"), std::string::npos) << sentence;
  }
  for (int i = 0; i < point_count; ++i) {
    const Eigen::Vector3d force = forces[0].segment<3>(3 * i);
    EXPECT_NEAR(std::abs(force.x()), 0.2885, 1e-4);
    EXPECT_NEAR(std::abs(force.y()), 0.4327, 1e-4);
    EXPECT_NEAR(force.z(), 19.62, 1e-9);
  }
  EXPECT_LT((forces[0] - forces[1]).norm(), 1e-8);
  EXPECT_LT((forces[2] - forces[1]).norm(), 1e-8);
}

TEST(ContradictingContacts, ConsistentRows_AreOk) {
  Model model = body_on_four_points();
  const std::vector<ContactSpec> contacts = on_points(model, "body");
  ContactDynamics dynamics(model, contacts, {.mu = 1e-4, .max_proximal_iterations = 10});
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(6);
  ASSERT_EQ(dynamics.forward(model.q_neutral, rest, rest), Status::Ok);
  EXPECT_EQ(dynamics.unmet(), Eigen::VectorXd::Zero(12));
  EXPECT_EQ(dynamics.explanation(), describe(Status::Ok));
}

/// Forces of least norm, and the remaining J a + alpha_0 + kd nu + kp e, by the pseudo-inverse of
/// G.
struct LeastSquares {
  Eigen::VectorXd lambda, unmet;
};

LeastSquares least_squares_of(ContactDynamics& dynamics, const RobotState& s) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(s.v.size());
  dynamics.acceleration(s.q, s.v, zero);
  const Eigen::VectorXd drift = dynamics.alpha();
  const RowMatrix J = dynamics.jacobian(), M = dynamics.mass_matrix();
  const Eigen::MatrixXd G = J * solve_positive(M, J.transpose());
  const Eigen::VectorXd rho =
      -drift - J * solve_positive(M, Eigen::MatrixXd(s.tau - dynamics.bias()));
  const SymmetricEigen parts = symmetric_eigen(G);
  LeastSquares result{Eigen::VectorXd::Zero(rho.size()), -rho};
  const double largest = parts.values.maxCoeff();
  for (Eigen::Index i = 0; i < rho.size(); ++i) {
    if (parts.values[i] < 1e-9 * largest) continue;
    const Eigen::VectorXd u = parts.vectors.col(i);
    result.lambda += u * (u.dot(rho) / parts.values[i]);
    result.unmet += u * u.dot(rho);
  }
  return result;
}

struct Contradicting {
  std::string name;
  Model model;
  std::vector<ContactSpec> contacts;
};

ContactSpec twin_of(const ContactSpec& contact, const std::string& name, double height) {
  ContactSpec twin = contact;
  twin.name = name;
  twin.kp.setConstant(50.0);
  twin.target.translation().z() = height;
  return twin;
}

std::vector<Contradicting> contradicting_cases() {
  std::vector<Contradicting> all;
  Contradicting box{"body", body_on_four_points(), {}};
  box.contacts = on_points(box.model, "body");
  all.push_back(box);
  const TestRobot walker = humanoid();
  Contradicting foot{"foot", walker.model(), {}};
  foot.contacts = on_points(foot.model, walker.tool);
  all.push_back(foot);
  Contradicting arm{"arm", named_robot("arm7"), {}};
  ContactSpec pad = contact("tool", "world", Reference::centered(), Directions::pad_z());
  pad.with_gains(0.0, 20.0);
  ContactSpec turned = twin_of(pad, "turned", 3.0);
  turned.reference = Reference::local();
  arm.contacts = {pad, twin_of(pad, "twin", 3.0)};
  all.push_back(arm);
  Contradicting axes{"axes", named_robot("arm7"), {}};
  ContactSpec pose = pad;
  pose.directions = Directions::all();
  axes.contacts = {pose, turned};
  all.push_back(axes);
  Contradicting friction{"friction", named_robot("arm7"), {}};
  ContactSpec sliding = contact("tool", "world", Reference::centered(), Directions::z());
  sliding.friction = SlidingFriction{0.3, 0.1};
  friction.contacts = {sliding, twin_of(sliding, "twin", 3.0)};
  all.push_back(friction);
  return all;
}

constexpr ContactSolver iterated{
    .mu = 1e-4, .max_proximal_iterations = 200, .proximal_tolerance = 1e-12};

TEST(ContradictingContacts, Robots_GiveLeastSquaresForces) {
  for (const Contradicting& c : contradicting_cases()) {
    if (c.name == "friction") continue;  // its system of forces is not symmetric
    ContactDynamics dynamics(c.model, c.contacts, iterated), probe(c.model, c.contacts);
    std::mt19937_64 generator(11);
    for (int i = 0; i < 5; ++i) {
      const RobotState s = random_state(c.model, generator);
      const LeastSquares want = least_squares_of(probe, s);
      ASSERT_EQ(dynamics.forward(s.q, s.v, s.tau), Status::NotConverged) << c.name;
      EXPECT_LT(relative_error(dynamics.lambda(), want.lambda), 1e-6) << c.name;
      EXPECT_LT(relative_error(dynamics.unmet(), want.unmet), 1e-7) << c.name;
      // unmet() is the remaining contact acceleration.
      const Eigen::VectorXd a = dynamics.a(), unmet = dynamics.unmet();
      probe.acceleration(s.q, s.v, a);
      EXPECT_LT(relative_error(probe.alpha(), unmet), 1e-7) << c.name;
    }
  }
}

/// d(a, lambda) by differences of fourth order along `state_at`.
Eigen::VectorXd slope_of_forces(ContactDynamics& dynamics, const auto& state_at) {
  const auto value = [&](double t) {
    const RobotState at = state_at(t);
    EXPECT_EQ(dynamics.forward(at.q, at.v, at.tau), Status::NotConverged);
    Eigen::VectorXd both(dynamics.nv() + dynamics.rows());
    both << dynamics.a(), dynamics.lambda();
    return both;
  };
  const double h = 2e-4;
  const Eigen::VectorXd narrow = (value(h) - value(-h)) / (2.0 * h);
  const Eigen::VectorXd wide = (value(2.0 * h) - value(-2.0 * h)) / (4.0 * h);
  return (4.0 * narrow - wide) / 3.0;
}

TEST(ContradictingContacts, Derivatives_EqualDifferences) {
  for (const Contradicting& c : contradicting_cases()) {
    const int n = c.model.nv;
    ContactDynamics dynamics(c.model, c.contacts, iterated), other(c.model, c.contacts, iterated);
    std::mt19937_64 generator(12);
    const RobotState s = random_state(c.model, generator);
    ASSERT_EQ(dynamics.forward(s.q, s.v, s.tau), Status::NotConverged) << c.name;
    ASSERT_EQ(dynamics.forward_derivatives(), Status::NotConverged) << c.name;
    const auto stacked = [&](MatrixView a, MatrixView lambda) {
      Eigen::MatrixXd both(a.rows() + lambda.rows(), n);
      both << a, lambda;
      return both;
    };
    Eigen::MatrixXd dq = stacked(dynamics.da_dq(), dynamics.dlambda_dq()), want_dq = dq;
    Eigen::MatrixXd dv = stacked(dynamics.da_dv(), dynamics.dlambda_dv()), want_dv = dv;
    Eigen::MatrixXd dtau = stacked(dynamics.da_dtau(), dynamics.dlambda_dtau()), want_dtau = dtau;
    for (int k = 0; k < n; ++k) {
      const Eigen::VectorXd e = Eigen::VectorXd::Unit(n, k);
      want_dq.col(k) = slope_of_forces(other, [&](double t) {
        return RobotState{integrate(c.model, s.q, t * e), s.v, s.tau};
      });
      want_dv.col(k) = slope_of_forces(other, [&](double t) {
        return RobotState{s.q, s.v + t * e, s.tau};
      });
      want_dtau.col(k) = slope_of_forces(other,
                                         [&](double t) {
                                           return RobotState{s.q, s.v, s.tau + 1e3 * t * e};
                                         }) /
                         1e3;
    }
    const double size = want_dq.topRows(n).norm();  // zero where the rows fix a body completely
    EXPECT_LT((dq - want_dq).topRows(n).norm(), 1e-6 * (1.0 + size)) << c.name;
    EXPECT_LT(relative_error(dq, want_dq), 1e-6) << c.name;
    EXPECT_LT(relative_error(dv, want_dv), 1e-6) << c.name;
    EXPECT_LT(relative_error(dtau, want_dtau), 1e-6) << c.name;
  }
}

TEST(ContradictingContacts, Batch_EqualsEachStateAlone) {
  for (const Contradicting& c : contradicting_cases()) {
    const int count = 2 * pack_width() + 1, n = c.model.nv;
    ContactDynamics single(c.model, c.contacts, iterated);
    ContactDynamicsBatch whole(c.model, c.contacts, count, iterated),
        alone(c.model, c.contacts, 1, iterated);
    Eigen::MatrixXd q(c.model.nq, count), v(n, count), tau(n, count);
    std::mt19937_64 generator(13);
    for (int i = 0; i < count; ++i) {
      const RobotState s = random_state(c.model, generator);
      q.col(i) = s.q, v.col(i) = s.v, tau.col(i) = s.tau;
    }
    EXPECT_EQ(whole.forward_with_derivatives(q, v, tau), Status::NotConverged);
    for (int i = 0; i < count; ++i) {
      single.forward(q.col(i), v.col(i), tau.col(i));
      single.forward_derivatives();
      EXPECT_LT(relative_error(whole.lambda(i), single.lambda()), 1e-8) << c.name;
      EXPECT_LT(relative_error(whole.dlambda_dq(i), single.dlambda_dq()), 1e-7) << c.name;
      EXPECT_EQ(whole.explanation(i), single.explanation());
      alone.forward_with_derivatives(q.col(i), v.col(i), tau.col(i));
      EXPECT_EQ(whole.lambda(i), alone.lambda(0)) << c.name;
      EXPECT_EQ(whole.da_dq(i), alone.da_dq(0)) << c.name;
    }
  }
}

TEST(ContradictingContacts, Impact_IsConsistentAtAnyVelocity) {
  // The joints produce J v before the impact, so the rows are consistent.
  Model model = body_on_four_points();
  const ContactSet set(model, on_points(model, "body"));
  ConstrainedDynamics<double> dynamics(model, set, {.mu = 1e-4, .max_proximal_iterations = 50});
  std::mt19937_64 generator(14);
  const RobotState s = random_state(model, generator);
  dynamics.impact(s.q.data(), s.v.data());
  EXPECT_EQ(dynamics.status(), Status::Ok);
  EXPECT_FALSE(dynamics.contradiction().found);
  for (const double v : dynamics.velocity_after) EXPECT_NEAR(v, 0.0, 1e-8);
}

}  // namespace
}  // namespace burnish::test
