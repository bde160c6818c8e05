// Tests of foot contacts and foot forces, from force sensors and from joint torques.
#include "burnish/estimate/foot_contacts.hpp"

#include <gtest/gtest.h>

#include <random>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/estimate/foot_forces.hpp"
#include "support/allocation_guard.hpp"
#include "support/biped.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

using burnish::testing::expect_words;
using burnish::testing::refusal;
using Eigen::VectorXd;

const std::vector<FootSpec> two_soles = {{"left_sole_link", FootKind::Sole},
                                         {"right_sole_link", FootKind::Sole}};

double weight_of(const Model& model) { return model.total_mass() * model.gravity.norm(); }

TEST(FootContacts, SensorNoise_DoesNotToggleTheContacts) {
  const Model model = biped::model(Base::FreeFlyer);
  const FootContactOptions options;
  FootContacts contacts(model, 2, options);
  const double weight = weight_of(model), dt = 1e-3;
  std::mt19937_64 generator(1);
  std::normal_distribution<double> noise(0.0, options.force_noise / std::sqrt(dt));
  int changes = 0;
  unsigned before = 0;
  // The load fraction of each foot goes slowly from zero to one and back, twice.
  for (int tick = 0; tick < 8000; ++tick) {
    const double fraction = 0.5 - 0.5 * std::cos(2.0 * M_PI * tick / 4000.0);
    const VectorXd forces = weight * Eigen::Vector2d(fraction, 1.0 - fraction) +
                            Eigen::Vector2d(noise(generator), noise(generator));
    ASSERT_EQ(contacts.update(forces, dt), Status::Ok);
    changes += contacts.standing() != before ? 1 : 0;
    before = contacts.standing();
    if (fraction > 0.3) {
      EXPECT_EQ(contacts.standing() & 1U, 1U) << tick;
    }
    if (fraction < 0.01) {
      EXPECT_EQ(contacts.standing() & 1U, 0U) << tick;
    }
  }
  // The second foot stands at first; then each foot touches down and lifts off once in each round.
  EXPECT_EQ(changes, 1 + 2 * 4);
}

TEST(FootContacts, InvalidInput_ChangesNothing) {
  FootContacts contacts(biped::model(Base::FreeFlyer), 2);
  contacts.reset(2);
  EXPECT_EQ(contacts.update(Eigen::Vector3d::Zero(), 1e-3), Status::WrongSize);
  EXPECT_EQ(contacts.update(Eigen::Vector2d(nan, 0.0), 1e-3), Status::NotFinite);
  EXPECT_EQ(contacts.update(Eigen::Vector2d::Zero(), 0.0), Status::NotFinite);
  EXPECT_EQ(contacts.standing(), 2U);
  EXPECT_TRUE(contacts.forces().isZero(0.0));
}

TEST(FootContacts, InvalidThresholds_AreRefused) {
  const Model model = biped::model(Base::FreeFlyer);
  const auto refused = [&](FootContactOptions options, int feet = 2) {
    return refusal([&] { FootContacts(model, feet, options); });
  };
  expect_words(refused({.touch = 0.1, .lift = 0.1}), {"lift", "touch", "0.1"});
  expect_words(refused({.touch = -1.0}), {"touch", "-1"});
  expect_words(refused({.force_noise = 20.0}), {"20 N/sqrt(Hz)", "200 N"});
  expect_words(refused({}, 0), {"0 feet", "1 to 32"});
}

/// Robot with loaded feet: joint torques and foot forces at given accelerations.
struct LoadedRobot {
  Model model = biped::model(Base::FreeFlyer);
  std::vector<FootSpec> feet = two_soles;
  std::mt19937_64 generator{3};
  ContactDynamics dynamics{model};

  /// Returns tau = M a + b - J^T f; the entries of the base must vanish, because no motor drives
  /// it.
  VectorXd torques(const VectorXd& q, const VectorXd& v, const VectorXd& a,
                   const VectorXd& wrenches) {
    RigidBody body(model);
    EXPECT_EQ(dynamics.inverse(q, v, a, VectorXd()), Status::Ok);
    EXPECT_EQ(body.update(q, v), Status::Ok);
    VectorXd tau = dynamics.tau();
    FrameDerivatives by;
    for (std::size_t k = 0; k < feet.size(); ++k) {
      body.frame_derivatives(body.frame(feet[k].frame), Reference::centered(), by);
      tau -= by.jacobian.transpose() * wrenches.segment<6>(6 * static_cast<Eigen::Index>(k));
    }
    return tau;
  }
  /// Returns accelerations with the base's entries changed so that the base needs no torque.
  VectorXd consistent_acceleration(const VectorXd& q, const VectorXd& v, VectorXd a,
                                   const VectorXd& wrenches) {
    const VectorXd residual = torques(q, v, a, wrenches);
    const Eigen::MatrixXd M = dynamics.mass_matrix();
    a.head<6>() -= M.topLeftCorner<6, 6>().ldlt().solve(residual.head<6>());
    return a;
  }
};

TEST(FootForces, ExactModel_GivesTheTrueForces) {
  LoadedRobot l;
  FootForces forces(l.model, l.feet, 200.0);
  VectorXd q = biped::half_sitting(l.model), v = VectorXd::Zero(l.model.nv);
  VectorXd a = 0.3 * random_vector(l.model.nv, 1.0, l.generator);
  VectorXd wrenches(12);
  const double weight = weight_of(l.model);
  wrenches << 10.0, -5.0, 0.7 * weight, 3.0, -8.0, 1.0, -4.0, 2.0, 0.3 * weight, -2.0, 5.0, 0.5;
  constexpr double dt = 1e-3;
  for (int tick = 0; tick < 100; ++tick) {
    a = l.consistent_acceleration(q, v, a, wrenches);
    VectorXd tau = l.torques(q, v, a, wrenches);
    EXPECT_LT(tau.head<6>().norm(), 1e-8 * weight);
    tau.head<6>().setZero();
    ASSERT_EQ(forces.update(q, v, tau, dt), Status::Ok);
    v += dt * a;
    q = integrate(l.model, q, dt * v);
    a.tail(l.model.nv - 6) *= 0.98;
  }
  for (int k = 0; k < 2; ++k)
    EXPECT_LT((forces.forces_world().col(k) - wrenches.segment<3>(6 * k)).norm(), 0.02 * weight)
        << k;
  EXPECT_NEAR(forces.normal_forces()[0], 0.7 * weight, 0.01 * weight);
  EXPECT_NEAR(forces.normal_forces()[1], 0.3 * weight, 0.01 * weight);
}

TEST(FootForces, NoFootSensors_StillFindTheStandingFeet) {
  LoadedRobot l;
  FootForces forces(l.model, l.feet, 150.0);
  FootContacts contacts(l.model, 2);
  const VectorXd q = biped::half_sitting(l.model), rest = VectorXd::Zero(l.model.nv);
  const double weight = weight_of(l.model);
  for (const double fraction : {0.5, 1.0, 0.0}) {
    // At rest, each foot carries its fraction of the weight; the moments balance the center of
    // mass.
    VectorXd wrenches = VectorXd::Zero(12);
    RigidBody body(l.model);
    ASSERT_EQ(body.update(q, rest), Status::Ok);
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector3d force(0.0, 0.0, (k == 0 ? fraction : 1.0 - fraction) * weight);
      const Eigen::Vector3d foot =
          body.placement(body.frame(l.feet[static_cast<std::size_t>(k)].frame)).translation();
      wrenches.segment<3>(6 * k) = force;
      wrenches.segment<3>(6 * k + 3) = (body.com() - foot).cross(force);
    }
    VectorXd tau = l.torques(q, rest, rest, wrenches);
    EXPECT_LT(tau.head<6>().norm(), 1e-8 * weight);
    for (int tick = 0; tick < 100; ++tick) {
      ASSERT_EQ(forces.update(q, rest, tau, 1e-3), Status::Ok);
      ASSERT_EQ(contacts.update(forces.normal_forces(), 1e-3), Status::Ok);
    }
    EXPECT_NEAR(forces.normal_forces()[0], fraction * weight, 1e-3 * weight);
    EXPECT_EQ(contacts.standing(), fraction == 0.5 ? 3U : fraction == 1.0 ? 1U : 2U);
  }
}

TEST(FootForces, InvalidInput_ChangesNothingAndUpdateAllocatesNothing) {
  LoadedRobot l;
  FootForces forces(l.model, l.feet, 150.0);
  const VectorXd q = biped::half_sitting(l.model), rest = VectorXd::Zero(l.model.nv);
  const VectorXd tau = random_vector(l.model.nv, 1.0, l.generator);
  ASSERT_EQ(forces.update(q, rest, tau, 1e-3), Status::Ok);
  const VectorXd before = forces.normal_forces();
  VectorXd bad = tau;
  bad[8] = nan;
  EXPECT_EQ(forces.update(q, rest, bad, 1e-3), Status::NotFinite);
  EXPECT_EQ(forces.update(q, bad, tau, 1e-3), Status::NotFinite);
  EXPECT_EQ(forces.update(q, rest, tau, -1.0), Status::NotFinite);
  EXPECT_EQ(forces.update(q, rest, tau.head(3), 1e-3), Status::WrongSize);
  EXPECT_EQ(forces.update(2.0 * q, rest, tau, 1e-3), Status::NotNormalized);
  EXPECT_TRUE(forces.normal_forces() == before);
  expect_words(refusal([&] {
                 FootForces(l.model, {{"left_sole_lnk", FootKind::Sole}}, 1.0);
               }),
               {"left_sole_link"});
  expect_words(refusal([&] { FootForces(l.model, l.feet, 0.0); }), {"bandwidth", "0"});
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const AllocationGuard guard;
  for (int tick = 0; tick < 5; ++tick) ASSERT_EQ(forces.update(q, rest, tau, 1e-3), Status::Ok);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace burnish::test
