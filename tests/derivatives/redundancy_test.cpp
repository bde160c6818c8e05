// Redundant contacts: results of the proximal iterations, and their derivatives.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/model/state.hpp"
#include "support/robots.hpp"

namespace burnish {
namespace {

class DuplicatedPad : public ::testing::Test {
 protected:
  DuplicatedPad() {
    first_.name = "first";
    first_.tool = "tool";
    first_.directions = Directions::pad_z();
    first_.with_gains(0.0, 20.0);
    second_ = first_;
    second_.name = "second";
    std::mt19937_64 generator(3);
    q_ = random_configuration(model_, generator);
    v_ = Eigen::VectorXd::LinSpaced(model_.nv, -0.4, 0.5);
    tau_ = Eigen::VectorXd::LinSpaced(model_.nv, 5.0, -8.0);
  }

  Model model_ = test::named_robot("arm7");
  ContactSpec first_, second_;
  ContactSolver proximal_{.mu = 1e-4, .max_proximal_iterations = 30, .proximal_tolerance = 1e-11};
  Eigen::VectorXd q_, v_, tau_;
};

TEST_F(DuplicatedPad, WithoutCompliance_GivesAStatusAndZeros) {
  ContactDynamics twice(model_, {first_, second_});
  EXPECT_EQ(twice.forward(q_, v_, tau_), Status::SingularContacts);
  EXPECT_EQ(twice.forward_derivatives(), Status::SingularContacts);
  EXPECT_EQ(twice.a().norm(), 0.0);
  EXPECT_EQ(twice.da_dq().norm(), 0.0);
}

TEST_F(DuplicatedPad, Diagnosis_NamesTheRedundantRows) {
  const ContactDiagnosis found = diagnose(model_, ContactSet(model_, {first_, second_}), q_);
  ASSERT_EQ(found.redundant.size(), 3U);
  EXPECT_EQ(found.redundant[0].text(), "contact 'second', direction z: already held by first/z");
}

TEST_F(DuplicatedPad, ProximalIterations_MoveLikeOnePadWithForcesAddedUp) {
  ContactDynamics once(model_, {first_});
  ContactDynamics twice(model_, {first_, second_}, proximal_);
  ASSERT_EQ(once.forward(q_, v_, tau_), Status::Ok);
  ASSERT_EQ(twice.forward(q_, v_, tau_), Status::Ok);
  EXPECT_GT(twice.proximal_iterations(), 0);
  EXPECT_LE(twice.proximal_residual(), 1e-11);
  once.forward_derivatives();
  twice.forward_derivatives();
  const auto close = [](const auto& got, const auto& want) {
    EXPECT_LE((got - want).norm(), 1e-8 * (1.0 + want.norm()));
  };
  const auto sum = [](const auto& rows) { return (rows.topRows(3) + rows.bottomRows(3)).eval(); };
  close(twice.a(), once.a());
  close(sum(twice.lambda()), once.lambda());
  close(twice.da_dq(), once.da_dq());
  close(twice.da_dv(), once.da_dv());
  close(twice.da_dtau(), once.da_dtau());
  close(sum(twice.dlambda_dq()), once.dlambda_dq());
  close(sum(twice.dlambda_dv()), once.dlambda_dv());
  close(sum(twice.dlambda_dtau()), once.dlambda_dtau());
}

TEST_F(DuplicatedPad, WithoutIterations_HasTheRequestedCompliance) {
  // alpha + kd nu = -mu lambda: the lower row of the relaxed KKT system.
  ContactDynamics soft(model_, {first_}, {.mu = 0.05});
  ASSERT_EQ(soft.forward(q_, v_, tau_), Status::Ok);
  const Eigen::VectorXd a = soft.a(), lambda = soft.lambda();
  soft.acceleration(q_, v_, a);
  EXPECT_LE((soft.alpha() + 0.05 * lambda).norm(), 1e-10);
}

TEST_F(DuplicatedPad, ContradictingPads_GiveNotConverged) {
  second_.kp.setConstant(50.0);
  second_.target.translation().z() = 3.0;
  ContactDynamics twice(model_, {first_, second_}, proximal_);
  EXPECT_EQ(twice.forward(q_, v_, tau_), Status::NotConverged);
  EXPECT_TRUE(twice.a().allFinite());
  EXPECT_GT(twice.proximal_residual(), 1e-11);
}

TEST_F(DuplicatedPad, InvalidSolverOptions_AreRefused) {
  const auto make = [&](const ContactSolver& solver) {
    return ContactDynamics(model_, {first_}, solver);
  };
  EXPECT_THROW(make({.mu = -1.0}), Error);
  EXPECT_THROW(make({.mu = std::nan("")}), Error);
  EXPECT_THROW(make({.mu = 0.1, .max_proximal_iterations = -1}), Error);
}

TEST_F(DuplicatedPad, DerivativesOfAnotherEvaluation_AreRefused) {
  ContactDynamics dynamics(model_, {first_});
  EXPECT_EQ(dynamics.forward_derivatives(), Status::NotEvaluated);
  ASSERT_EQ(dynamics.forward(q_, v_, tau_), Status::Ok);
  EXPECT_EQ(dynamics.inverse_derivatives(), Status::NotEvaluated);
  ASSERT_EQ(dynamics.inverse(q_, v_, tau_, Eigen::VectorXd::Zero(3)), Status::Ok);
  EXPECT_EQ(dynamics.forward_derivatives(), Status::NotEvaluated);
  EXPECT_EQ(dynamics.inverse_derivatives(), Status::Ok);
  ASSERT_EQ(dynamics.forward(q_, v_, tau_), Status::Ok);
  dynamics.set_active(0, false);
  EXPECT_EQ(dynamics.forward_derivatives(), Status::NotEvaluated);
}

}  // namespace
}  // namespace burnish
