// Tests of spring, damper and Coulomb friction evaluated at the end of a step.
#include "sim/penalty_contact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace burnish::test {
namespace {

using Eigen::Vector3d;

struct Case {
  PenaltyContact contact;
  TipStep tip;
  Vector3d v_end(const Vector3d& f) const { return tip.v + tip.dt * tip.A * f; }
};

std::vector<Case> cases() {
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(unit(generator), unit(generator), unit(generator)); };
  std::vector<Case> result;
  for (int i = 0; i < 300; ++i) {
    Eigen::Matrix3d root;
    root << vector(), vector(), vector();
    Case one{{std::pow(10.0, 3.0 + 1.5 * (1.0 + unit(generator))), 300.0 * (1.0 + unit(generator)),
              0.5 * (1.0 + unit(generator))},
             {5e-4, 1e-4 * (1.0 + unit(generator)), vector().normalized(), 0.1 * vector(),
              root * root.transpose() + 0.1 * Eigen::Matrix3d::Identity()}};
    result.push_back(one);
  }
  return result;
}

TEST(PenaltyContact, Force_SatisfiesTheLawAtTheEndOfTheStep) {
  for (const Case& one : cases()) {
    const auto& [contact, tip] = one;
    const Vector3d f = penalty_force(contact, tip), v = one.v_end(f);
    const double fn = f.dot(tip.n), vn = v.dot(tip.n);
    const double law = contact.stiffness * (tip.depth - tip.dt * vn) - contact.damping * vn;
    EXPECT_NEAR(fn, std::max(0.0, law), 1e-8 * (1.0 + std::abs(law)));
    const Vector3d ft = f - fn * tip.n, vt = v - vn * tip.n;
    EXPECT_LE(ft.norm(), contact.friction * fn * (1.0 + 1e-9) + 1e-12);
    // The tip sticks, or slides against a friction force at its limit.
    if (vt.norm() > 1e-6) {
      EXPECT_NEAR(ft.norm(), contact.friction * fn, 1e-6 * (1.0 + fn));
      EXPECT_NEAR(ft.dot(vt), -ft.norm() * vt.norm(), 1e-5 * (1e-3 + ft.norm() * vt.norm()));
    }
  }
}

TEST(PenaltyContact, SeparatingTip_GetsNoForce) {
  Case one = cases().front();
  one.tip.depth = 0.0;
  EXPECT_EQ(penalty_force(one.contact, one.tip), Vector3d::Zero());
  one.tip.depth = 1e-9;
  one.tip.v = 10.0 * one.tip.n;  // separates fast: a damper alone would pull
  EXPECT_EQ(penalty_force(one.contact, one.tip), Vector3d::Zero());
}

TEST(PenaltyContact, TipAtRest_GetsTheSpringForce) {
  const PenaltyContact contact{1e5, 500.0, 0.3};
  // The contact force keeps the tip, pressed with 30 N, exactly at rest.
  const Vector3d n = Vector3d(0.2, 0.1, 1.0).normalized();
  TipStep tip{5e-4, 30.0 / 1e5, n, Vector3d::Zero(), Eigen::Matrix3d::Identity()};
  tip.v = -tip.dt * 30.0 * tip.A * n;
  EXPECT_LT((penalty_force(contact, tip) - 30.0 * n).norm(), 1e-9);
}

TEST(PenaltyContact, StiffSpring_AddsNoEnergy) {
  // A mass on a spring far too stiff for the step comes to rest.
  const PenaltyContact contact{1e9, 0.0, 0.5};
  const double dt = 5e-4, mass = 2.0;
  Vector3d p(0.0, 0.0, -1e-4), v(0.3, 0.0, -0.2);
  for (int i = 0; i < 4000; ++i) {
    const TipStep tip{dt, -p.z(), Vector3d::UnitZ(), v - dt * 9.81 * Vector3d::UnitZ(),
                      Eigen::Matrix3d::Identity() / mass};
    v = tip.v + dt * tip.A * penalty_force(contact, tip);
    p += dt * v;
    ASSERT_LT(std::abs(p.z()), 0.1);
  }
  EXPECT_LT(v.norm(), 1e-6);
}

}  // namespace
}  // namespace burnish::test
