// Results belong to the last evaluation; requests that need another evaluation are refused.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "support/contact_states.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

using burnish::testing::expect_words;
using burnish::testing::refusal;

class LastEvaluation : public ::testing::Test {
 protected:
  LastEvaluation() : s_(regular_state(model_, dynamics_, generator_)) {}

  std::mt19937_64 generator_{21};
  Model model_ = named_robot("arm7");
  std::vector<ContactSpec> contacts_{
      contact("tool", "world", Reference::centered(), Directions::z())};
  ContactDynamics dynamics_{model_, contacts_};
  RobotState s_;
  Eigen::VectorXd ten_ = Eigen::VectorXd::Constant(1, 10.0);  // N
};

TEST_F(LastEvaluation, Inverse_HasTheGivenForce) {
  ASSERT_EQ(dynamics_.forward(s_.q, s_.v, s_.tau), Status::Ok);
  ASSERT_GT(std::abs(dynamics_.lambda()[0] - 10.0), 1.0);
  ASSERT_EQ(dynamics_.inverse(s_.q, s_.v, s_.tau, ten_), Status::Ok);
  EXPECT_NEAR(dynamics_.force(0).value[2], 10.0, 1e-12);
  EXPECT_NEAR(dynamics_.wrench(0, Reference::centered())[2], 10.0, 1e-12);
}

/// Contacts, references and torques change at one state, and each result has the bits of a fresh
/// evaluation.
TEST_F(LastEvaluation, ForwardAtTheLoadedState_EqualsAFreshEvaluation) {
  contacts_.push_back(contact("link_4", "world", Reference::local(), Directions::linear()));
  const ContactSolver solver{.mu = 1e-9};
  ContactDynamics kept(model_, contacts_, solver);
  EXPECT_EQ(kept.forward(s_.tau), Status::NotEvaluated);
  ASSERT_EQ(kept.update(s_.q, s_.v), Status::Ok);
  Eigen::VectorXd tau = s_.tau;
  const auto expect_same = [&](const char* what) {
    ContactDynamics fresh(model_, contacts_, solver);
    for (int c = 0; c < 2; ++c) fresh.set_active(c, kept.is_active(c));
    const Status wanted = fresh.forward(s_.q, s_.v, tau);
    ASSERT_EQ(kept.forward(tau), wanted) << what;
    EXPECT_EQ(Eigen::VectorXd(kept.a()), Eigen::VectorXd(fresh.a())) << what;
    EXPECT_EQ(Eigen::VectorXd(kept.lambda()), Eigen::VectorXd(fresh.lambda())) << what;
    EXPECT_EQ(RowMatrix(kept.jacobian()), RowMatrix(fresh.jacobian())) << what;
    ASSERT_EQ(kept.forward_derivatives(), fresh.forward_derivatives()) << what;
    EXPECT_EQ(RowMatrix(kept.da_dq()), RowMatrix(fresh.da_dq())) << what;
  };
  expect_same("both contacts");
  tau *= -0.5;
  expect_same("another torque");
  kept.set_active(0, false);
  expect_same("the second contact alone");
  kept.set_active(1, false);
  expect_same("no contact");
  kept.set_active(0, true);
  expect_same("the first contact alone");
  ASSERT_EQ(kept.inverse(s_.q, s_.v, s_.tau, ten_), Status::Ok);
  expect_same("after an inverse");
  ASSERT_EQ(kept.set_payload("tool", {}), Status::Ok);
  EXPECT_EQ(kept.forward(tau), Status::NotEvaluated) << "the mass matrix is outdated";
  ASSERT_EQ(kept.update(s_.q, s_.v), Status::Ok);
  EXPECT_EQ(kept.forward(Eigen::VectorXd::Zero(3)), Status::WrongSize);
  expect_same("after a payload");
  RigidBody body(model_);
  ASSERT_EQ(body.update(s_.q, s_.v), Status::Ok);
  ASSERT_EQ(kept.update(model_.q_neutral, Eigen::VectorXd::Zero(model_.nv)), Status::Ok);
  ASSERT_EQ(kept.update(body), Status::Ok);
  expect_same("at the state of a body");
  EXPECT_EQ(kept.update(RigidBody(named_robot("every_joint"))), Status::WrongSize);
}

TEST_F(LastEvaluation, WrongSize_ChangesNoResult) {
  ASSERT_EQ(dynamics_.forward(s_.q, s_.v, s_.tau), Status::Ok);
  const Vector6 before = dynamics_.wrench(0, Reference::local());
  const Eigen::VectorXd three = Eigen::VectorXd::Zero(3);
  EXPECT_EQ(dynamics_.update(three, s_.v), Status::WrongSize);
  EXPECT_EQ(dynamics_.update(RigidBody(named_robot("every_joint"))), Status::WrongSize);
  EXPECT_EQ(dynamics_.forward(s_.q, s_.v, three), Status::WrongSize);
  EXPECT_EQ(dynamics_.inverse(s_.q, three, s_.tau, ten_), Status::WrongSize);
  EXPECT_EQ(dynamics_.wrench(0, Reference::local()), before);
  EXPECT_EQ(dynamics_.forward_derivatives(), Status::Ok);
}

TEST_F(LastEvaluation, Acceleration_HasNoForces) {
  EXPECT_EQ(dynamics_.wrench(0, Reference::local()), Vector6::Zero());
  ASSERT_EQ(dynamics_.forward(s_.q, s_.v, s_.tau), Status::Ok);
  ASSERT_EQ(dynamics_.acceleration(s_.q, s_.v, s_.tau), Status::Ok);
  EXPECT_EQ(dynamics_.force(0).value, Vector6::Zero());
  EXPECT_EQ(dynamics_.wrench(0, Reference::local()), Vector6::Zero());
}

TEST_F(LastEvaluation, WrenchDerivativesOfAnotherState_AreRefused) {
  WrenchDerivatives out;
  const auto refused_derivatives = [&] {
    return refusal([&] { dynamics_.wrench_derivatives(0, Reference::world(), out); });
  };
  expect_words(refused_derivatives(), {"wrench_derivatives", "forward_derivatives()"});
  ASSERT_EQ(dynamics_.forward(s_.q, s_.v, s_.tau), Status::Ok);
  expect_words(refused_derivatives(), {"forward_derivatives()"});
  ASSERT_EQ(dynamics_.forward_derivatives(), Status::Ok);
  dynamics_.wrench_derivatives(0, Reference::world(), out);
  const RowMatrix here = out.dq;
  ASSERT_EQ(dynamics_.forward(s_.q, 2.0 * s_.v, s_.tau), Status::Ok);
  expect_words(refused_derivatives(), {"forward_derivatives()"});
  ASSERT_EQ(dynamics_.inverse(s_.q, s_.v, s_.tau, ten_), Status::Ok);
  ASSERT_EQ(dynamics_.inverse_derivatives(), Status::Ok);
  expect_words(refused_derivatives(), {"forward_derivatives()"});
  EXPECT_EQ(out.dq, here) << "a refused call leaves the output unchanged";
}

TEST_F(LastEvaluation, Batch_HasTheStatusesOfItsLastCall) {
  ContactDynamicsBatch batch(model_, contacts_, 3);
  EXPECT_EQ(batch.status(0), Status::NotEvaluated);
  const Eigen::MatrixXd q = s_.q.replicate(1, 3), v = s_.v.replicate(1, 3),
                        tau = s_.tau.replicate(1, 3);
  ASSERT_EQ(batch.forward(q, v, tau), Status::Ok);
  EXPECT_EQ(batch.status(2), Status::Ok);
  ASSERT_EQ(batch.forward(q.leftCols(2), v.leftCols(2), tau.leftCols(2)), Status::Ok);
  EXPECT_EQ(batch.status(1), Status::Ok);
  EXPECT_EQ(batch.status(2), Status::NotEvaluated);
  EXPECT_EQ(batch.explanation(2), describe(Status::NotEvaluated));
  batch.set_active(0, false);
  EXPECT_EQ(batch.status(0), Status::NotEvaluated);
  ASSERT_EQ(batch.forward(q, v, tau), Status::Ok);
  ASSERT_EQ(batch.set_payload("tool", {}), Status::Ok);
  EXPECT_EQ(batch.status(0), Status::NotEvaluated);
}

TEST_F(LastEvaluation, RigidBodyWithAPayload_EqualsALoadedModel) {
  InertiaSpec brick;
  brick.mass = 2.0;
  brick.com = {0.05, 0.0, 0.1};
  brick.inertia_at_com = 0.01 * Eigen::Matrix3d::Identity();
  RigidBody body(model_), loaded(with_payload(model_, {"tool", brick}));
  ASSERT_EQ(body.update(s_.q, s_.v), Status::Ok);
  ASSERT_EQ(body.set_payload("tool", brick), Status::Ok);
  ASSERT_EQ(loaded.update(s_.q, s_.v), Status::Ok);
  body.update_derivatives();
  loaded.update_derivatives();
  EXPECT_NEAR(body.mass(), loaded.mass(), 1e-12);
  EXPECT_LT((body.com() - loaded.com()).norm(), 1e-12);
  EXPECT_LT(relative_error(body.gravity_torque(), loaded.gravity_torque()), 1e-12);
  EXPECT_LT(relative_error(body.com_dq(), loaded.com_dq()), 1e-12);
  EXPECT_LT(relative_error(body.momentum_dq(), loaded.momentum_dq()), 1e-12);
}

}  // namespace
}  // namespace burnish::test
