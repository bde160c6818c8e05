// A batch of states equals single states, and a bad state affects its own lane only.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "base/thread_pool.hpp"
#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "support/contact_states.hpp"

namespace burnish::test {
namespace {

// Factor on tolerances in instrumented code, which fuses multiply and add differently in the two
// kernels. Their last bits differ more, and mass matrix and contacts amplify the difference.
#ifdef __SANITIZE_ADDRESS__
constexpr double instrumented = 10.0;
#else
constexpr double instrumented = 1.0;
#endif

#ifdef __linux__
constexpr bool can_pin = true;
#else
constexpr bool can_pin = false;
#endif

struct BatchTouch {
  std::string robot, tool, base;
  double rounding = 1e-12;  ///< relative error allowed; the mass matrix amplifies rounding
};

void PrintTo(const BatchTouch& touch, std::ostream* out) { *out << touch.robot; }

struct Batch {
  Eigen::MatrixXd q, v, tau;
};

class ContactBatch : public ::testing::TestWithParam<BatchTouch> {
 protected:
  std::vector<ContactSpec> contacts(const Reference& reference) const {
    ContactSpec one = contact(GetParam().tool, "world", reference, Directions::parse("x,z,ry"));
    ContactSpec two = contact(GetParam().tool, GetParam().base, reference, Directions::y());
    two.name = "second";
    two.error = PoseError::Log6;
    two.with_gains(40.0, 7.0);
    return {one, two};
  }

  /// Draws well-conditioned states.
  Batch states(int count, ContactDynamics& dynamics) {
    Batch batch{Eigen::MatrixXd(model_.nq, count), Eigen::MatrixXd(model_.nv, count),
                Eigen::MatrixXd(model_.nv, count)};
    for (int i = 0; i < count; ++i) {
      const RobotState s = regular_state(model_, dynamics, generator_, 1e-3);
      batch.q.col(i) = s.q, batch.v.col(i) = s.v, batch.tau.col(i) = s.tau;
    }
    return batch;
  }

  /// Largest relative difference between state i of a batch and the same state alone.
  double difference(const ContactDynamicsBatch& packed, ContactDynamics& single, const Batch& batch,
                    int i) {
    EXPECT_EQ(single.forward(batch.q.col(i), batch.v.col(i), batch.tau.col(i)), Status::Ok);
    single.forward_derivatives();
    double worst = relative_error(packed.a(i), single.a());
    const auto compare = [&](const auto& got, const auto& want) {
      worst = std::max(worst, relative_error(got, want));
    };
    compare(packed.lambda(i), single.lambda());
    compare(packed.da_dq(i), single.da_dq());
    compare(packed.da_dv(i), single.da_dv());
    compare(packed.da_dtau(i), single.da_dtau());
    compare(packed.dlambda_dq(i), single.dlambda_dq());
    compare(packed.dlambda_dv(i), single.dlambda_dv());
    compare(packed.dlambda_dtau(i), single.dlambda_dtau());
    return worst;
  }

  Model model_ = robot(GetParam().robot);
  std::mt19937_64 generator_{71};
};

TEST_P(ContactBatch, AnySize_EqualsSingleStates) {
  const int width = pack_width();
  double worst = 0.0;
  for (const Reference& reference : all_references()) {
    ContactDynamics single(model_, contacts(reference));
    ContactDynamicsBatch packed(model_, contacts(reference), 3 * width + 1);
    for (const int count : {1, width - 1, width, width + 1, 3 * width + 1}) {
      if (count < 1) continue;
      const Batch batch = states(count, single);
      ASSERT_EQ(packed.forward_with_derivatives(batch.q, batch.v, batch.tau), Status::Ok);
      for (int i = 0; i < count; ++i) {
        EXPECT_EQ(packed.status(i), Status::Ok);
        worst = std::max(worst, difference(packed, single, batch, i));
      }
    }
  }
  RecordProperty("worst", std::to_string(worst * 1e12) + "e-12");
  EXPECT_LT(worst, instrumented * GetParam().rounding);
}

TEST_P(ContactBatch, SingleCalls_GiveTheSameBits) {
  const int count = 2 * pack_width() + 1;
  ContactDynamics single(model_, contacts(Reference::centered()));
  ContactDynamicsBatch whole(model_, contacts(Reference::centered()), count);
  ContactDynamicsBatch cut(model_, contacts(Reference::centered()), count);
  const Batch batch = states(count, single);
  whole.forward_with_derivatives(batch.q, batch.v, batch.tau);
  for (int i = 0; i < count; ++i) {
    cut.forward_with_derivatives(batch.q.col(i), batch.v.col(i), batch.tau.col(i));
    EXPECT_EQ(whole.a(i), cut.a(0));
    EXPECT_EQ(whole.da_dq(i), cut.da_dq(0));
    EXPECT_EQ(whole.dlambda_dtau(i), cut.dlambda_dtau(0));
  }
}

TEST_P(ContactBatch, ProximalIterations_EqualEachLaneAlone) {
  std::vector<ContactSpec> twice = contacts(Reference::centered());
  twice.push_back(twice[0]);
  twice.back().name = "third";
  const ContactSolver solver{
      .mu = 1e-2, .max_proximal_iterations = 200, .proximal_tolerance = 1e-9};
  const int count = pack_width();
  ContactDynamics single(model_, contacts(Reference::centered())), soft(model_, twice, solver);
  ContactDynamicsBatch whole(model_, twice, count, solver), alone(model_, twice, 1, solver);
  Batch batch = states(count, single);
  // Forces of different sizes, so that the lanes need different numbers of iterations.
  for (int i = 0; i < count; ++i) batch.tau.col(i) *= std::pow(10.0, i % 4);
  whole.forward_with_derivatives(batch.q, batch.v, batch.tau);
  std::set<int> iterations;
  for (int i = 0; i < count; ++i) {
    soft.forward(batch.q.col(i), batch.v.col(i), batch.tau.col(i));
    iterations.insert(soft.proximal_iterations());
    alone.forward_with_derivatives(batch.q.col(i), batch.v.col(i), batch.tau.col(i));
    EXPECT_EQ(whole.status(i), alone.status(0));
    EXPECT_EQ(whole.a(i), alone.a(0));
    EXPECT_EQ(whole.lambda(i), alone.lambda(0));
    EXPECT_EQ(whole.da_dq(i), alone.da_dq(0));
    EXPECT_EQ(whole.da_dv(i), alone.da_dv(0));
    EXPECT_EQ(whole.da_dtau(i), alone.da_dtau(0));
    EXPECT_EQ(whole.dlambda_dq(i), alone.dlambda_dq(0));
    EXPECT_EQ(whole.dlambda_dv(i), alone.dlambda_dv(0));
    EXPECT_EQ(whole.dlambda_dtau(i), alone.dlambda_dtau(0));
  }
  if (count > 1) {
    EXPECT_GT(iterations.size(), 1U) << "all lanes need the same number of iterations";
  }
}

TEST_P(ContactBatch, SeveralThreads_GiveTheSameBits) {
  const int count = 20 * pack_width() + 1;
  ContactDynamics single(model_, contacts(Reference::centered()));
  const Batch batch = states(count, single);
  ContactDynamicsBatch alone(model_, contacts(Reference::centered()), count);
  ASSERT_EQ(alone.forward_with_derivatives(batch.q, batch.v, batch.tau), Status::Ok);
  for (const int threads : {2, 3}) {
    const bool pinned = can_pin && threads <= allowed_cores();
    ContactDynamicsBatch threaded(model_, contacts(Reference::centered()), count, {}, threads,
                                  pinned);
    EXPECT_EQ(threaded.threads(), threads);
    ASSERT_EQ(threaded.forward_with_derivatives(batch.q, batch.v, batch.tau), Status::Ok);
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(alone.a(i), threaded.a(i));
      EXPECT_EQ(alone.da_dq(i), threaded.da_dq(i));
      EXPECT_EQ(alone.dlambda_dtau(i), threaded.dlambda_dtau(i));
    }
    // set_active() applies to all threads.
    threaded.set_active(1, false);
    alone.set_active(1, false);
    ASSERT_EQ(alone.forward(batch.q, batch.v, batch.tau), Status::Ok);
    ASSERT_EQ(threaded.forward(batch.q, batch.v, batch.tau), Status::Ok);
    for (int i = 0; i < count; ++i) EXPECT_EQ(alone.lambda(i), threaded.lambda(i));
    alone.set_active(1, true);
    ASSERT_EQ(alone.forward_with_derivatives(batch.q, batch.v, batch.tau), Status::Ok);
  }
}

TEST_P(ContactBatch, BadState_IsFlaggedInItsOwnLaneOnly) {
  const int count = 2 * pack_width() + 1, bad = pack_width() / 2;
  ContactDynamics single(model_, contacts(Reference::local()));
  ContactDynamicsBatch packed(model_, contacts(Reference::local()), count);
  const Batch good = states(count, single);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int kind = 0; kind < 6; ++kind) {
    Batch batch = good;
    if (kind == 0) batch.q(model_.nq - 1, bad) = nan;
    if (kind == 1) batch.v(0, bad) = infinity;
    if (kind == 2) batch.tau(model_.nv - 1, bad) = nan;
    if (kind == 3) batch.tau(0, bad) = -infinity;
    if (kind == 4) batch.q(0, bad) = -infinity;
    const bool has_quaternion = model_.joints[0].kind == JointKind::FreeFlyer;
    if (kind == 5 && !has_quaternion) continue;
    if (kind == 5) batch.q.block(3, bad, 4, 1) *= 1.1;
    const Status expected = kind == 5 ? Status::NotNormalized : Status::NotFinite;
    EXPECT_EQ(packed.forward_with_derivatives(batch.q, batch.v, batch.tau), expected);
    for (int i = 0; i < count; ++i) {
      EXPECT_EQ(packed.status(i), i == bad ? expected : Status::Ok);
      if (i == bad) continue;
      EXPECT_LT(difference(packed, single, good, i), instrumented * GetParam().rounding)
          << "kind " << kind << ", state " << i;
    }
    EXPECT_EQ(packed.a(bad), Eigen::VectorXd::Zero(model_.nv)) << kind;
    EXPECT_EQ(packed.lambda(bad), Eigen::VectorXd::Zero(packed.rows())) << kind;
    EXPECT_EQ(packed.da_dq(bad), RowMatrix::Zero(model_.nv, model_.nv)) << kind;
    EXPECT_EQ(packed.da_dtau(bad), RowMatrix::Zero(model_.nv, model_.nv)) << kind;
    EXPECT_EQ(packed.dlambda_dv(bad), RowMatrix::Zero(packed.rows(), model_.nv)) << kind;
  }
}

TEST_P(ContactBatch, WrongSizes_AreRefused) {
  ContactDynamics single(model_, contacts(Reference::world()));
  ContactDynamicsBatch packed(model_, contacts(Reference::world()), 2);
  const Batch three = states(3, single);
  EXPECT_EQ(packed.forward(three.q, three.v, three.tau), Status::WrongSize);
  const Batch two{three.q.leftCols(2), three.v.leftCols(2), three.tau.leftCols(2)};
  EXPECT_EQ(packed.forward(two.q, two.v, two.tau), Status::Ok);
  EXPECT_EQ(packed.forward(two.q, two.v, three.tau), Status::WrongSize);
  EXPECT_EQ(packed.forward(two.q.topRows(1), two.v, two.tau), Status::WrongSize);
  EXPECT_EQ(packed.forward(two.q.leftCols(0), two.v.leftCols(0), two.tau.leftCols(0)),
            Status::WrongSize);
}

std::vector<BatchTouch> batch_touches() {
  const std::vector<BatchTouch> all = {
      {"talos:fixed", "tool", "torso_1_link", 1e-11},
      {"talos:right_arm", "tool", "torso_1_link", 1e-11},
      {humanoid().name, "right_sole_link", "left_sole_link", 1e-11},
      {"arm7", "tool", "link_1", 1e-11},
      {"arm7:floating", "tool", "link_1", 1e-11},
      {"crane", "left_tip", "right_tip"},
      {"crane:floating", "left_tip", "right_tip"}};
  return available(all, [](const BatchTouch& touch) { return touch.robot; });
}

INSTANTIATE_TEST_SUITE_P(robots, ContactBatch, ::testing::ValuesIn(batch_touches()),
                         [](const auto& test) {
                           std::string name = test.param.robot;
                           for (char& c : name)
                             if (c == ':') c = '_';
                           return name;
                         });

/// A floating robot with two tips and a continuous joint.
struct TwoTips {
  std::string robot, tip, other_tip, joint;
};
TwoTips two_tips() {
  if (has_robot_files) return {"crane:floating", "left_tip", "right_tip", "slew_joint"};
  return {"every_joint:floating", "tip", "b_side", "to_e"};
}

class ContactDynamicsInput : public ::testing::Test {
 protected:
  Model model_ = robot(two_tips().robot);
  ContactDynamics dynamics_{model_, {contact(two_tips().tip, two_tips().other_tip)}};
  std::mt19937_64 generator_{73};
  RobotState good_ = regular_state(model_, dynamics_, generator_);
  const double nan_ = std::numeric_limits<double>::quiet_NaN();

  void expect(Status wanted, const RobotState& state, const char* what) {
    ASSERT_EQ(dynamics_.forward(good_.q, good_.v, good_.tau), Status::Ok);
    EXPECT_EQ(dynamics_.forward(state.q, state.v, state.tau), wanted) << what;
    EXPECT_EQ(dynamics_.forward_derivatives(), wanted) << what;
    EXPECT_EQ(dynamics_.a(), Eigen::VectorXd::Zero(model_.nv)) << what;
    EXPECT_EQ(dynamics_.lambda(), Eigen::VectorXd::Zero(6)) << what;
    EXPECT_EQ(dynamics_.da_dq(), RowMatrix::Zero(model_.nv, model_.nv)) << what;
    EXPECT_EQ(dynamics_.dlambda_dv(), RowMatrix::Zero(6, model_.nv)) << what;
  }
};

TEST_F(ContactDynamicsInput, BadStateOfForward_GivesAStatusAndZeros) {
  RobotState bad = good_;
  bad.q[7] = nan_;
  expect(Status::NotFinite, bad, "NaN in q");
  bad = good_;
  bad.v[3] = -1.0 / 0.0;
  expect(Status::NotFinite, bad, "infinite v");
  bad = good_;
  bad.tau[9] = nan_;
  expect(Status::NotFinite, bad, "NaN in tau");
  bad = good_;
  bad.q.segment<4>(3) *= 1.001;
  expect(Status::NotNormalized, bad, "quaternion");
  bad = good_;
  bad.q.segment<4>(3).setZero();
  expect(Status::NotNormalized, bad, "zero quaternion");
  bad = good_;
  const int continuous = model_.joint_index(two_tips().joint);
  bad.q.segment<2>(model_.joints[static_cast<std::size_t>(continuous)].q_index) *= 0.5;
  expect(Status::NotNormalized, bad, "angle");
}

TEST_F(ContactDynamicsInput, WrongSize_GivesAStatusAndKeepsTheResults) {
  ASSERT_EQ(dynamics_.forward(good_.q, good_.v, good_.tau), Status::Ok);
  const Eigen::VectorXd a = dynamics_.a(), long_v = Eigen::VectorXd::Zero(model_.nv + 1);
  const Eigen::VectorXd short_q = good_.q.head(model_.nq - 1), none;
  const auto check = [&](Status got, const char* what) {
    EXPECT_EQ(got, Status::WrongSize) << what;
    EXPECT_EQ(dynamics_.a(), a) << what;
    EXPECT_EQ(dynamics_.forward_derivatives(), Status::Ok) << what;
  };
  check(dynamics_.forward(short_q, good_.v, good_.tau), "q");
  check(dynamics_.forward(good_.q, long_v, good_.tau), "v");
  check(dynamics_.forward(good_.q, good_.v, none), "tau");
  check(dynamics_.inverse(good_.q, good_.v, a, dynamics_.lambda().head(5)), "lambda");
  check(dynamics_.inverse(good_.q, good_.v, none, dynamics_.lambda()), "a");
  check(dynamics_.acceleration(good_.q, good_.v, long_v), "a");
  EXPECT_EQ(dynamics_.inverse_derivatives(), Status::NotEvaluated);
  EXPECT_EQ(dynamics_.acceleration_derivatives(), Status::NotEvaluated);
}

TEST_F(ContactDynamicsInput, DerivativesOfAnotherEvaluation_AreRefused) {
  const Eigen::VectorXd lambda = Eigen::VectorXd::Ones(6);
  ASSERT_EQ(dynamics_.forward(good_.q, good_.v, good_.tau), Status::Ok);
  EXPECT_EQ(dynamics_.inverse_derivatives(), Status::NotEvaluated);
  EXPECT_EQ(dynamics_.acceleration_derivatives(), Status::NotEvaluated);
  EXPECT_EQ(dynamics_.forward_derivatives(), Status::Ok);
  ASSERT_EQ(dynamics_.inverse(good_.q, good_.v, good_.v, lambda), Status::Ok);
  EXPECT_EQ(dynamics_.forward_derivatives(), Status::NotEvaluated);
  EXPECT_EQ(dynamics_.inverse_derivatives(), Status::Ok);
  ASSERT_EQ(dynamics_.forward(good_.q, good_.v, good_.tau), Status::Ok);
  dynamics_.set_active(0, false);
  EXPECT_EQ(dynamics_.forward_derivatives(), Status::NotEvaluated);
}

TEST_F(ContactDynamicsInput, BadStateOfInverse_GivesAStatusAndZeros) {
  const Eigen::VectorXd a = Eigen::VectorXd::Ones(model_.nv), lambda = Eigen::VectorXd::Ones(6);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model_.nv);
  const auto check = [&](Status wanted, Status got, const char* what) {
    EXPECT_EQ(got, wanted) << what;
    EXPECT_EQ(dynamics_.tau(), zero) << what;
    EXPECT_EQ(dynamics_.inverse_derivatives(), wanted) << what;
    EXPECT_EQ(dynamics_.dtau_dq(), RowMatrix::Zero(model_.nv, model_.nv)) << what;
  };
  ASSERT_EQ(dynamics_.inverse(good_.q, good_.v, a, lambda), Status::Ok);
  EXPECT_GT(dynamics_.tau().norm(), 0.0);
  Eigen::VectorXd q = good_.q, bad_a = a, bad_lambda = lambda;
  q[8] = nan_;
  bad_a[0] = nan_;
  bad_lambda[5] = nan_;
  check(Status::NotFinite, dynamics_.inverse(q, good_.v, a, lambda), "NaN in q");
  check(Status::NotFinite, dynamics_.inverse(good_.q, good_.v, bad_a, lambda), "NaN in a");
  check(Status::NotFinite, dynamics_.inverse(good_.q, good_.v, a, bad_lambda), "NaN in lambda");
}

TEST_F(ContactDynamicsInput, BadStateOfAcceleration_GivesAStatusAndZeros) {
  const Eigen::VectorXd a = Eigen::VectorXd::Ones(model_.nv);
  const auto check = [&](Status wanted, Status got, const char* what) {
    EXPECT_EQ(got, wanted) << what;
    EXPECT_EQ(dynamics_.alpha(), Eigen::VectorXd::Zero(6)) << what;
    EXPECT_EQ(dynamics_.acceleration_derivatives(), wanted) << what;
    EXPECT_EQ(dynamics_.dalpha_dq(), RowMatrix::Zero(6, model_.nv)) << what;
  };
  ASSERT_EQ(dynamics_.acceleration(good_.q, good_.v, a), Status::Ok);
  EXPECT_GT(dynamics_.alpha().norm(), 0.0);
  Eigen::VectorXd q = good_.q, bad_a = a;
  q[8] = nan_;
  bad_a[0] = nan_;
  check(Status::NotFinite, dynamics_.acceleration(q, good_.v, a), "NaN in q");
  check(Status::NotFinite, dynamics_.acceleration(good_.q, good_.v, bad_a), "NaN in a");
}

}  // namespace
}  // namespace burnish::test
