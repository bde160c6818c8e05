// Tests of payloads that a controller is given between ticks.
#include <gtest/gtest.h>

#include <limits>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

using burnish::testing::expect_words;
using burnish::testing::refusal;

InertiaSpec brick(double mass) {
  InertiaSpec result;
  result.mass = mass;
  result.com = {0.02, -0.01, 0.05};
  result.inertia_at_com = 2e-3 * Eigen::Matrix3d::Identity();
  return result;
}

MpcSpec spec_of(const Model* model = nullptr) {
  MpcSpec spec = toy_spec();
  if (model != nullptr) spec.problem.model = *model;
  spec.model_error.kind = ModelErrorKind::Torque;
  return spec;
}

TEST(MpcPayload, SetPayload_EqualsThePayloadInTheModel) {
  const MpcSpec plain = spec_of();
  const Model loaded = with_payload(plain.problem.model, {"tool", brick(2.0)});
  MpcController with_payload_set(plain), with_loaded_model(spec_of(&loaded)), bare(plain);
  const InertiaSpec carried = brick(2.0);
  ASSERT_EQ(with_payload_set.set_payload("tool", brick(5.0)), Status::Ok);
  ASSERT_EQ(with_payload_set.set_payload("tool", carried), Status::Ok);
  Measurement m = toy_measurement(plain);
  double apart = 0.0;
  const auto tick_all = [&](int tick) {
    m.time = 1e-3 * tick;
    m.v[1] = 0.01 * std::sin(0.3 * tick);
    const Eigen::VectorXd wanted = with_loaded_model.tick(m).tau;
    EXPECT_LE((with_payload_set.tick(m).tau - wanted).cwiseAbs().maxCoeff(), 1e-7) << tick;
    apart = std::max(apart, (bare.tick(m).tau - wanted).cwiseAbs().maxCoeff());
  };
  int tick = 0;
  for (; tick < 40; ++tick) tick_all(tick);
  EXPECT_GT(apart, 1.0) << "the payload has no effect: this test checks nothing";
  // After a fault, the fallback accounts for the payload.
  m.q[0] = std::numeric_limits<double>::quiet_NaN();
  for (; tick < 80; ++tick) tick_all(tick);
  EXPECT_NE(with_payload_set.fault().kind, FaultKind::None);
  EXPECT_EQ(with_payload_set.fault().kind, with_loaded_model.fault().kind);
  // reset() keeps the payload.
  with_payload_set.reset(), with_loaded_model.reset(), bare.reset();
  m = toy_measurement(plain);
  for (tick = 0; tick < 5; ++tick) tick_all(tick);
}

TEST(MpcPayload, EstimatedBaseWithAnotherPayload_HoldsTheRobotWithAStatus) {
  MpcController mpc(spec_of());
  ASSERT_EQ(mpc.set_payload("tool", brick(2.0)), Status::Ok);
  Measurement m = toy_measurement(spec_of());
  EXPECT_NE(mpc.tick(m).status, Status::NotPhysical);
  const auto tick = [&](double base_payload) {
    m.base_is_estimated = true;
    m.base_payload = base_payload;
    m.time += 1e-3;
    return mpc.tick(m);
  };
  for (const double other : {0.0, 1.9, std::numeric_limits<double>::quiet_NaN()}) {
    const Command command = tick(other);
    EXPECT_EQ(command.status, Status::NotPhysical) << other;
    EXPECT_TRUE(command.tau.allFinite());
    EXPECT_GT(command.tau.norm(), 1.0) << "the fallback must hold the robot";
  }
  EXPECT_NE(tick(2.0).status, Status::NotPhysical);
  ASSERT_EQ(mpc.set_payload("tool", {}), Status::Ok);
  EXPECT_EQ(tick(2.0).status, Status::NotPhysical);
  EXPECT_NE(tick(0.0).status, Status::NotPhysical);
}

TEST(MpcPayload, PayloadOfALoop_ReachesTheController) {
  const MpcSpec spec = spec_of();
  const SceneSpec scene{.touches = {{.frame = "tool"}}};
  const std::unique_ptr<Plant> plant = make_ideal_plant(spec.problem.model, scene);
  MpcController alone(spec), looped(spec);
  ClosedLoop loop(*plant, looped);
  ASSERT_EQ(alone.set_payload("tool", brick(2.0)), Status::Ok);
  ASSERT_EQ(loop.set_payload("tool", brick(2.0)), Status::Ok);
  const Measurement m = toy_measurement(spec);
  EXPECT_EQ(looped.tick(m).tau, alone.tick(m).tau);
  InertiaSpec bad = brick(1.0);
  bad.inertia_at_com(0, 0) = 1.0;
  EXPECT_EQ(loop.set_payload("tool", bad), Status::NotPhysical);
  EXPECT_THROW((void)loop.set_payload("tole", brick(1.0)), Error);
}

TEST(MpcPayload, PayloadBeforeTheEstimateOfTheBase_IsRefused) {
  const MpcSpec spec = spec_of();
  const SceneSpec scene{.touches = {{.frame = "tool"}}};
  const std::unique_ptr<Plant> plant = make_ideal_plant(spec.problem.model, scene);
  MpcController mpc(spec);
  ClosedLoop loop(*plant, mpc);
  ASSERT_EQ(mpc.set_payload("tool", brick(2.0)), Status::Ok);
  testing::expect_words(
      testing::refusal([&] { loop.estimate_base(spec.problem.model, BaseEstimatorOptions{}); }),
      {"payload of 2 kg", "a call of estimate_base() before"});
}

TEST(MpcPayload, InvalidPayload_IsRefusedAndAValidOneAllocatesNothing) {
  MpcController mpc(spec_of());
  InertiaSpec bad = brick(1.0);
  bad.inertia_at_com(0, 0) = 1.0;
  EXPECT_EQ(mpc.set_payload("tool", bad), Status::NotPhysical);
  EXPECT_THROW((void)mpc.set_payload("tole", brick(1.0)), Error);
  EXPECT_THROW((void)mpc.set_payload("base", brick(1.0)), Error) << "it is fixed to the world";
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const InertiaSpec good = brick(1.0);
  const AllocationGuard guard;
  EXPECT_EQ(mpc.set_payload("tool", good), Status::Ok);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace burnish::test
