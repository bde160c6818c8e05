// Tests of each disturbance alone: the size of its effect, and that all other signals stay
// unchanged.
#include "burnish/sim/disturbances.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <set>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/actuation.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/sim/sensing.hpp"
#include "sim/random.hpp"
#include "support/allocation_guard.hpp"
#include "support/polishing_run.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

constexpr double plant_step = 5e-4;

TEST(RandomStream, FirstNumbers_AreTheSameOnEveryMachine) {
  RandomStream random(7, 3);
  EXPECT_EQ(random.normal(), -0.7781829833984375);
  EXPECT_EQ(random.normal(), 0.4647064208984375);
  EXPECT_EQ(random.uniform(), 0.967922209237977);
}

TEST(RandomStream, NormalNumbers_HaveMeanZeroAndDeviationOne) {
  RandomStream random(1, 0);
  const int n = 200000;
  double sum = 0.0, squares = 0.0, beyond_two = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    beyond_two += std::abs(x) > 2.0 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(sum / n, 0.0, 0.01);
  EXPECT_NEAR(squares / n, 1.0, 0.02);
  EXPECT_NEAR(beyond_two / n, 0.0455, 0.003);
}

TEST(RandomStream, SeedsAndStreams_GiveDifferentNumbers) {
  const auto first = [](std::uint64_t seed, std::uint64_t stream) {
    return RandomStream(seed, stream).uniform();
  };
  std::set<double> measured;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (std::uint64_t stream = 0; stream < 10; ++stream) measured.insert(first(seed, stream));
  EXPECT_EQ(measured.size(), 100U);
}

/// Response of an actuation to a varying command.
struct Response {
  Eigen::MatrixXd command, delayed, tracked, noise, applied;  ///< nv x steps
  bool operator==(const Response&) const = default;
};

Response respond(const Model& model, const Disturbances& disturbances, double size = 10.0) {
  constexpr int steps = 60;
  Actuation actuation(model, disturbances, plant_step);
  Response result;
  for (Eigen::MatrixXd* x :
       {&result.command, &result.delayed, &result.tracked, &result.noise, &result.applied})
    *x = Eigen::MatrixXd::Zero(model.nv, steps);
  for (int i = 0; i < steps; ++i) {
    actuation.apply(Eigen::VectorXd::Constant(model.nv, size * std::sin(0.2 * i + 0.3)));
    const ActuationStep& step = actuation.step();
    result.command.col(i) = step.command;
    result.delayed.col(i) = step.delayed;
    result.tracked.col(i) = step.tracked;
    result.noise.col(i) = step.noise;
    result.applied.col(i) = step.applied;
  }
  return result;
}

class ActuationTest : public ::testing::Test {
 protected:
  Eigen::VectorXd q;
  Model model = right_arm(&q);
  Response ideal = respond(model, {});
};

TEST_F(ActuationTest, NoDisturbance_AppliesTheCommand) {
  EXPECT_EQ(ideal.applied, ideal.command);
  EXPECT_EQ(ideal.noise, Eigen::MatrixXd::Zero(model.nv, ideal.noise.cols()));
}

TEST_F(ActuationTest, CommandDelay_DelaysByWholeSteps) {
  Disturbances d;
  d.command_delay = 3.1 * plant_step;
  const Response late = respond(model, d);
  EXPECT_EQ(late.delayed.rightCols(57), ideal.command.leftCols(57));
  EXPECT_EQ(late.delayed.leftCols(3), Eigen::MatrixXd::Zero(model.nv, 3));
  EXPECT_EQ(late.applied, late.delayed);
  EXPECT_EQ(late.command, ideal.command);
}

TEST_F(ActuationTest, TorqueCutoff_FiltersTheCommand) {
  Disturbances d;
  d.torque_cutoff = 100.0;
  Actuation actuation(model, d, plant_step);
  const Eigen::VectorXd step = Eigen::VectorXd::Ones(model.nv);
  for (int i = 0; i < 20; ++i) actuation.apply(step);
  EXPECT_NEAR(actuation.step().applied[0], 1.0 - std::exp(-100.0 * 20 * plant_step), 1e-12);
  EXPECT_EQ(actuation.step().delayed, step);
}

TEST_F(ActuationTest, ScaleAndBias_DifferByJointWithinTheirRange) {
  Disturbances d;
  d.torque_scale_range = 0.2;
  d.seed = 5;
  const Actuation scaled(model, d, plant_step);
  EXPECT_LE((scaled.scale().array() - 1.0).abs().maxCoeff(), 0.2);
  EXPECT_GT((scaled.scale().array() - 1.0).abs().maxCoeff(), 0.02);
  EXPECT_GT(std::abs(scaled.scale()[0] - scaled.scale()[1]), 1e-6);
  EXPECT_EQ(scaled.bias(), Eigen::VectorXd::Zero(model.nv));
  const Response response = respond(model, d);
  EXPECT_LE((response.applied - scaled.scale().asDiagonal() * ideal.command).norm(), 1e-12);

  d = {};
  d.torque_bias = Eigen::VectorXd::LinSpaced(model.nv, -2.0, 2.0);
  const Response biased = respond(model, d);
  EXPECT_LE((biased.applied.colwise() - d.torque_bias - ideal.command).norm(), 1e-12);
}

TEST_F(ActuationTest, TorqueNoise_HasItsDeviation) {
  Disturbances d;
  d.torque_noise = 0.05;
  const Response noisy = respond(model, d);
  EXPECT_EQ(noisy.tracked, ideal.tracked);
  EXPECT_LE((noisy.applied - ideal.applied - noisy.noise).norm(), 1e-12);
  const double deviation =
      std::sqrt(noisy.noise.squaredNorm() / static_cast<double>(noisy.noise.size()));
  EXPECT_NEAR(deviation, 0.05, 0.008);
}

TEST_F(ActuationTest, TorqueNoise_IsLimitedToAFractionOfTheEffortLimit) {
  Model weak = model;
  weak.effort_limit.setConstant(100.0);
  weak.effort_limit[1] = 1.0;
  Disturbances d;
  d.torque_noise = 0.05;
  const Response unlimited = respond(weak, d);
  d.torque_noise_share = 0.0125;
  const Response noisy = respond(weak, d);
  EXPECT_EQ(noisy.noise.row(0), unlimited.noise.row(0));
  EXPECT_LE((noisy.noise.row(1) - 0.25 * unlimited.noise.row(1)).norm(), 1e-15);
  EXPECT_EQ(torque_noise(weak, d).head<2>(), Eigen::Vector2d(0.05, 0.0125));
  d.torque_loop = true;
  d.torque_sensor_noise = 0.1;
  EXPECT_NEAR(torque_noise(weak, d)[0], std::hypot(0.05, 0.1), 1e-15);
}

TEST(DisturbancePreset, TorqueNoiseOfTalos_IsEqualInAllJoints) {
  if (!has_robot_files) GTEST_SKIP() << "needs robots in files";
  const Model talos = named_robot("talos");
  const Eigen::VectorXd noise = torque_noise(talos, disturbance_preset("mismatch"));
  EXPECT_EQ(noise.head<6>(), Eigen::VectorXd::Zero(6));
  EXPECT_EQ(noise.tail(talos.nv - 6), Eigen::VectorXd::Constant(talos.nv - 6, 0.05));
}

TEST_F(ActuationTest, TorqueLoop_CancelsScaleAndBiasAndFollowsTheSensor) {
  Disturbances d;
  d.torque_scale_range = 0.2;
  d.torque_bias_range = 2.0;
  d.torque_loop = true;
  EXPECT_EQ(respond(model, d).applied, ideal.applied);
  d.torque_sensor_noise = 0.1;
  const Response sensed = respond(model, d);
  EXPECT_NE(sensed.applied, ideal.applied);
  d.torque_loop = false;
  EXPECT_EQ(respond(model, d).noise, ideal.noise)
      << "without the torque loop, the sensor does not affect the motors";
}

TEST_F(ActuationTest, EffortLimits_ClampTheTorqueAndCountTheJoints) {
  const Response strong = respond(model, {}, 1e4);
  for (Eigen::Index i = 0; i < strong.applied.cols(); ++i)
    EXPECT_LE((strong.applied.col(i).cwiseAbs() - model.effort_limit).maxCoeff(), 0.0);
  Disturbances d;
  d.torque_limits = false;
  EXPECT_EQ(respond(model, d, 1e4).applied, strong.command);
  Actuation actuation(model, {}, plant_step);
  actuation.apply(Eigen::VectorXd::Constant(model.nv, 1e4));
  EXPECT_EQ(actuation.step().limited, model.nv);
}

TEST_F(ActuationTest, MotorLoss_ScalesOneMotorForItsDuration) {
  Disturbances d;
  const Joint& joint = model.joints[2];
  d.motor_losses = {{.start = 10 * plant_step, .duration = 20 * plant_step, .joint = joint.name},
                    {.start = 50 * plant_step, .joint = joint.name, .share = 0.5}};
  const Response lost = respond(model, d);
  Eigen::MatrixXd expected = ideal.applied;
  expected.row(joint.v_index).segment(10, 20).setZero();
  expected.row(joint.v_index).tail(10) *= 0.5;
  EXPECT_EQ(lost.applied, expected);
  EXPECT_EQ(lost.tracked, ideal.tracked);
}

TEST_F(ActuationTest, MotorLoss_KeepsItsTimeAfterResetAndInACopy) {
  Disturbances d;
  d.motor_losses = {{.start = 3 * plant_step, .joint = model.joints[0].name}};
  Actuation actuation(model, d, plant_step);
  const Eigen::VectorXd step = Eigen::VectorXd::Ones(model.nv);
  const auto after = [&](Actuation& of, int steps) {
    for (int i = 0; i < steps; ++i) of.apply(step);
    return of.step().applied[0];
  };
  EXPECT_EQ(after(actuation, 3), 1.0);
  Actuation copy(actuation);
  EXPECT_EQ(after(actuation, 1), 0.0);
  EXPECT_EQ(after(copy, 1), 0.0);
  actuation.reset();
  EXPECT_EQ(after(actuation, 3), 1.0);
}

TEST_F(ActuationTest, NonFiniteCommand_AppliesTheLastFiniteOne) {
  Actuation actuation(model, {}, plant_step);
  const Eigen::VectorXd good = Eigen::VectorXd::Constant(model.nv, 2.0);
  actuation.apply(good);
  actuation.apply(Eigen::VectorXd::Constant(model.nv, std::nan("")));
  EXPECT_EQ(actuation.step().applied, good);
  EXPECT_TRUE(actuation.step().held);
  actuation.apply(good);
  EXPECT_FALSE(actuation.step().held);
}

TEST_F(ActuationTest, SameSeed_GivesTheSameBitsWithOtherDisturbances) {
  Disturbances d;
  d.seed = 11;
  d.torque_noise = 0.05;
  const Response once = respond(model, d), again = respond(model, d);
  EXPECT_TRUE(once == again);
  Disturbances more = d;
  more.torque_bias_range = 1.0;
  more.command_delay = 1e-3;
  EXPECT_EQ(respond(model, more).noise, once.noise);
  d.seed = 12;
  EXPECT_NE(respond(model, d).noise, once.noise);
}

/// Measurements of a plant, to compare with the ideal ones.
class SensingTest : public ::testing::Test {
 protected:
  struct Measured {
    Eigen::MatrixXd q, v, tau, force;  ///< one column per tick
  };

  /// Simulates a plant that presses and slides, measured every two steps.
  Measured measure(const Disturbances& disturbances) const {
    const SceneSpec scene = plane_under_tip(model, q, {0.0, 0.0, 1.0});
    const auto plant = make_ideal_plant(model, scene);
    EXPECT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    Sensing sensing(model, disturbances, scene, {"tool"});
    RigidBody body(model);
    Measured measured;
    constexpr int ticks = 100;
    measured.q = Eigen::MatrixXd::Zero(model.nq, ticks);
    measured.v = measured.tau = Eigen::MatrixXd::Zero(model.nv, ticks);
    measured.force = Eigen::MatrixXd::Zero(3, ticks);
    Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
    for (int i = 0; i < ticks; ++i) {
      const Measurement& m = sensing.measure(*plant, tau);
      measured.q.col(i) = m.q;
      measured.v.col(i) = m.v;
      measured.tau.col(i) = m.tau;
      measured.force.col(i) = m.wrenches.col(0).head<3>();
      EXPECT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
      tau = body.gravity_torque() + Eigen::VectorXd::LinSpaced(model.nv, -2.0, 2.0);
      for (int k = 0; k < 2; ++k) {
        EXPECT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
        const Eigen::VectorXd push = torque_of_force(body, "tool", {0.0, 0.0, -40.0});
        EXPECT_EQ(plant->step(tau + push), Status::Ok);
      }
    }
    return measured;
  }
  static std::string changes(const Measured& a, const Measured& b) {
    return std::string(a.q == b.q ? "" : "q ") + (a.v == b.v ? "" : "v ") +
           (a.tau == b.tau ? "" : "tau ") + (a.force == b.force ? "" : "force ");
  }

  Eigen::VectorXd q;
  Model model = plant_model(right_arm(&q), {});
};

TEST_F(SensingTest, EachDisturbance_ChangesOnlyItsOwnSignals) {
  const Measured ideal = measure({});
  struct Case {
    const char* name;
    std::function<void(Disturbances&)> switch_on;
    const char* changed;
  };
  const std::vector<Case> cases{
      {"nothing", [](Disturbances&) {}, ""},
      {"torque_sensor_noise", [](Disturbances& d) { d.torque_sensor_noise = 0.1; }, "tau "},
      {"encoder_bits", [](Disturbances& d) { d.encoder_bits = 12; }, "q "},
      {"position_noise", [](Disturbances& d) { d.position_noise = 1e-3; }, "q "},
      {"velocity_noise", [](Disturbances& d) { d.velocity_noise = 1e-3; }, "v "},
      {"differences", [](Disturbances& d) { d.finite_difference_velocity = true; }, "v "},
      {"velocity_cutoff alone", [](Disturbances& d) { d.velocity_cutoff = 100.0; }, ""},
      {"force_noise", [](Disturbances& d) { d.force_noise = 0.3; }, "force "},
      {"force_cutoff", [](Disturbances& d) { d.force_cutoff = 100.0; }, "force "},
      {"measurement_delay", [](Disturbances& d) { d.measurement_delay = 2e-3; }, "q v tau force "},
      {"actuation", [](Disturbances& d) { d.torque_noise = d.command_delay = 1.0; }, ""}};
  for (const Case& c : cases) {
    Disturbances d;
    c.switch_on(d);
    EXPECT_EQ(changes(measure(d), ideal), c.changed) << c.name;
  }
}

TEST_F(SensingTest, MeasurementDelay_DelaysAllButTheTimeByWholeTicks) {
  Disturbances d;
  d.velocity_noise = 1e-3;
  const Measured now = measure(d);
  d.measurement_delay = 3.4e-3;
  const Measured late = measure(d);
  constexpr Eigen::Index ticks = 3;
  const Eigen::Index rest = now.q.cols() - ticks;
  EXPECT_EQ(late.q.rightCols(rest), now.q.leftCols(rest));
  EXPECT_EQ(late.v.rightCols(rest), now.v.leftCols(rest));
  EXPECT_EQ(late.tau.rightCols(rest), now.tau.leftCols(rest));
  EXPECT_EQ(late.force.rightCols(rest), now.force.leftCols(rest));
  for (Eigen::Index i = 0; i < ticks; ++i)
    EXPECT_EQ(late.q.col(i), now.q.col(0)) << "before the delay, the first measurement is repeated";
  d.measurement_delay = 0.4e-3;
  EXPECT_EQ(changes(measure(d), now), "") << "a delay below half a measurement rounds to zero";

  const auto plant = make_ideal_plant(model, plane_under_tip(model, q, {0.0, 0.0, 1.0}));
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  d.measurement_delay = 5e-3;
  Sensing sensing(model, d, plant->scene(), {"tool"}, plant->dt());
  for (int i = 0; i < 20; ++i) {
    const AllocationGuard guard;
    EXPECT_EQ(sensing.measure(*plant, q).time, plant->time());
    if (AllocationGuard::unavailable() == nullptr) {
      EXPECT_EQ(guard.count(), 0);
    }
    ASSERT_EQ(plant->step(q), Status::Ok);
  }
}

TEST_F(SensingTest, Reset_GivesTheSameBits) {
  Disturbances d;
  d.position_noise = d.velocity_noise = d.torque_sensor_noise = d.force_noise = 0.1;
  const auto plant = make_ideal_plant(model, plane_under_tip(model, q, {0.0, 0.0, 1.0}));
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(plant->reset(q, rest), Status::Ok);
  Sensing sensing(model, d, plant->scene(), {"tool"});
  std::vector<Measurement> measured;
  for (int time = 0; time < 2; ++time) {
    for (int i = 0; i < 20; ++i) measured.push_back(sensing.measure(*plant, rest));
    sensing.reset();
  }
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(measured[i].q, measured[20 + i].q);
    EXPECT_EQ(measured[i].v, measured[20 + i].v);
    EXPECT_EQ(measured[i].tau, measured[20 + i].tau);
    EXPECT_EQ(measured[i].wrenches.topRows(3), measured[20 + i].wrenches.topRows(3));
  }
}

TEST_F(SensingTest, EncoderBits_RoundPositionsToTheirStep) {
  Disturbances d;
  d.encoder_bits = 12;
  const double step = 2.0 * std::numbers::pi / 4096.0;
  const Eigen::ArrayXXd marks = measure(d).q.array() / step;
  EXPECT_LE((marks - marks.round()).abs().maxCoeff(), 1e-9);
  EXPECT_LE((measure(d).q - measure({}).q).cwiseAbs().maxCoeff(), 0.5 * step + 1e-12);
}

TEST_F(SensingTest, FiniteDifferences_FollowTheVelocityAndTheirFilterLags) {
  Disturbances d;
  d.finite_difference_velocity = true;
  const Measured ideal = measure({}), plain = measure(d);
  const double scale = ideal.v.cwiseAbs().maxCoeff();
  EXPECT_LE((plain.v - ideal.v).rightCols(50).cwiseAbs().maxCoeff(), 0.1 * scale);
  d.velocity_cutoff = 50.0;
  const Measured filtered = measure(d);
  EXPECT_GT((filtered.v - ideal.v).norm(), 2.0 * (plain.v - ideal.v).norm());
  EXPECT_EQ(filtered.v.col(0), ideal.v.col(0));
}

TEST_F(SensingTest, ForceCutoff_ReducesTheNoise) {
  Disturbances d;
  d.force_noise = 0.3;
  const Measured ideal = measure({}), noisy = measure(d);
  const auto tail = [&](const Measured& measured) {
    return (measured.force - ideal.force).rightCols(60).norm() / std::sqrt(180.0);
  };
  EXPECT_NEAR(tail(noisy), 0.3, 0.06);
  d.force_cutoff = 100.0;
  const Measured smooth = measure(d);
  const Eigen::MatrixXd increments = smooth.force.rightCols(60) - smooth.force.middleCols(39, 60);
  const Eigen::MatrixXd noisy_increments =
      noisy.force.rightCols(60) - noisy.force.middleCols(39, 60);
  EXPECT_LT(increments.norm(), 0.3 * noisy_increments.norm());
}

TEST(PlantModel, Disturbances_ScaleMassesAndSetJointFriction) {
  const Model nominal = right_arm();
  const Model ideal = plant_model(nominal, {});
  EXPECT_EQ(ideal.total_mass(), nominal.total_mass());
  EXPECT_TRUE(ideal.friction.isZero(0.0)) << "joint friction is off by default";
  Disturbances d;
  d.mass_scale = 1.05;
  d.joint_coulomb = 1.0;
  d.joint_viscous = 0.5;
  const Model real = plant_model(nominal, d);
  EXPECT_NEAR(real.total_mass(), 1.05 * nominal.total_mass(), 1e-12);
  EXPECT_EQ(real.joints[2].inertia_at_com, 1.05 * nominal.joints[2].inertia_at_com);
  EXPECT_EQ(real.joints[2].com, nominal.joints[2].com);
  EXPECT_EQ(real.friction, Eigen::VectorXd::Constant(real.nv, 1.0));
  EXPECT_EQ(real.damping, Eigen::VectorXd::Constant(real.nv, 0.5));
  d.torque_loop = true;
  EXPECT_TRUE(plant_model(nominal, d).friction.isZero(0.0)) << "the torque loop cancels friction";
  EXPECT_TRUE(plant_model(nominal, d).damping.isZero(0.0));
}

TEST(PlantModel, JointFriction_IsLimitedToAFractionOfTheEffortLimit) {
  Model nominal = right_arm();
  nominal.effort_limit.setConstant(100.0);
  nominal.effort_limit[1] = 4.0;
  const Model real = plant_model(nominal, disturbance_preset("joint_friction"));
  EXPECT_EQ(real.friction.head<2>(), Eigen::Vector2d(1.0, 0.2));
  EXPECT_EQ(real.damping.head<2>(), Eigen::Vector2d(1.0, 0.2));
}

TEST(PlantModel, Payload_AddsItsInertiaWithinItsRange) {
  const Model nominal = right_arm();
  Disturbances d;
  EXPECT_EQ(plant_model(nominal, d).total_mass(), nominal.total_mass());
  d.payload.mass = 1.0;
  d.payload.com = {0.0, 0.01, 0.05};
  const Model real = plant_model(nominal, d);
  EXPECT_NEAR(real.total_mass(), nominal.total_mass() + 1.0, 1e-12);
  const int body = frame_on_body("test", nominal, "tool").body;
  const Eigen::Isometry3d& at = frame_on_body("test", nominal, "tool").placement;
  const InertiaSpec own = inertia_of_body(nominal, body), both = inertia_of_body(real, body);
  const Eigen::Vector3d centre = (own.mass * own.com + at * d.payload.com) / (own.mass + 1.0);
  EXPECT_LE((both.com - centre).norm(), 1e-12);
  d.payload.mass_range = 0.4;
  d.payload.com_range = 0.02;
  double min_mass = 2.0, max_mass = 0.0;
  for (d.seed = 0; d.seed < 50; ++d.seed) {
    const Payload payload = carried_payload(d);
    EXPECT_LE(std::abs(payload.inertia.mass - 1.0), 0.4);
    EXPECT_LE((payload.inertia.com - d.payload.com).cwiseAbs().maxCoeff(), 0.02);
    min_mass = std::min(min_mass, payload.inertia.mass),
    max_mass = std::max(max_mass, payload.inertia.mass);
  }
  EXPECT_LT(min_mass, 0.7);
  EXPECT_GT(max_mass, 1.3);
  d.payload.mass = -1.0;
  EXPECT_THROW((void)plant_model(nominal, d), Error);
  d.payload.mass = 1.0;
  d.payload.frame = "tol";
  EXPECT_THROW((void)plant_model(nominal, d), Error);
}

TEST(PlantModel, FloatingBase_GetsNoFrictionBiasOrNoise) {
  const Model floating = named_robot(has_robot_files ? "talos:right_arm" : "arm7", Base::FreeFlyer);
  Disturbances d;
  d.joint_coulomb = 1.0;
  d.torque_bias_range = 1.0;
  d.torque_noise = 1.0;
  const Model real = plant_model(floating, d);
  EXPECT_TRUE(real.friction.head(6).isZero(0.0));
  EXPECT_EQ(real.friction[6], 1.0);
  Actuation actuation(real, d, plant_step);
  EXPECT_TRUE(actuation.apply(Eigen::VectorXd::Zero(real.nv)).head(6).isZero(0.0));
}

TEST(PlantScene, SurfaceErrors_TiltAboutTangentsAndShiftAlongTheNormal) {
  const SurfaceSpec nominal{.point = {0.4, -0.3, 1.0}, .normal = {0.0, 0.0, 1.0}, .friction = 0.2};
  const SceneSpec scene{.touches = {{.frame = "foot", .surface = nominal, .is_support = true},
                                    {.frame = "tool", .surface = nominal},
                                    {.frame = "left_tool", .surface = nominal}}};
  for (const TouchSpec& same : plant_scene(scene, {}).touches) {
    EXPECT_EQ(same.surface.normal, nominal.normal);
    EXPECT_EQ(same.surface.point, nominal.point);
    EXPECT_EQ(same.surface.friction, 0.2);
  }

  Disturbances d;
  d.surface_height = 0.003;
  d.surface_friction = 0.5;
  for (int axis = 0; axis < 2; ++axis) {
    d.surface_tilt_deg.setZero();
    d.surface_tilt_deg[axis] = 6.0;
    const SceneSpec disturbed = plant_scene(scene, d);
    for (const char* frame : {"tool", "left_tool"}) {
      const SurfaceSpec& real = disturbed.touch(frame).surface;
      const double tilt =
          std::atan2(real.normal.cross(nominal.normal).norm(), real.normal.dot(nominal.normal));
      EXPECT_NEAR(tilt * 180.0 / std::numbers::pi, 6.0, 1e-9);
      EXPECT_NEAR(real.normal[axis], 0.0, 1e-12) << "the tilt axis must stay in place";
      EXPECT_LE((real.point - nominal.point - Eigen::Vector3d(0.0, 0.0, 0.003)).norm(), 1e-15);
      EXPECT_EQ(real.friction, 0.5);
    }
    const SurfaceSpec& ground = disturbed.touch("foot").surface;
    EXPECT_EQ(ground.normal, nominal.normal) << "supports stand on the ground, not on the surface";
    EXPECT_EQ(ground.point, nominal.point);
    EXPECT_EQ(ground.friction, 0.2);
  }
}

TEST(DisturbanceCheck, ValueOutOfRange_IsRefusedByName) {
  const Model model = right_arm();
  const auto refused = [&](auto&& change) {
    Disturbances d;
    change(d);
    return testing::refusal([&] { check_disturbances(model, d); });
  };
  testing::expect_words(refused([](Disturbances& d) { d.torque_noise = -0.1; }),
                        {"'torque_noise'", "-0.1", "wanted at least 0"});
  testing::expect_words(refused([](Disturbances& d) { d.mass_scale = 0.0; }),
                        {"'mass_scale'", "wanted more than 0"});
  testing::expect_words(refused([](Disturbances& d) { d.torque_scale = Eigen::Vector2d::Ones(); }),
                        {"'torque_scale'", "2 entries", std::to_string(model.nv)});
  testing::expect_words(refused([](Disturbances& d) { d.encoder_bits = 64; }),
                        {"'encoder_bits'", "64"});
  testing::expect_words(refused([](Disturbances& d) { d.surface_tilt_deg[1] = 90.0; }),
                        {"'surface_tilt_deg'", "is 90; wanted more than -90 and less than 90"});
  testing::expect_words(refused([](Disturbances& d) {
                          d.pushes.push_back({0.0, -1.0, {}});
                        }),
                        {"'pushes[0].duration'", "-1; wanted at least 0"});
  testing::expect_words(
      refused([](Disturbances& d) { d.motor_losses = {{.joint = "arm_right_9"}}; }),
      {"'motor_losses'", "arm_right_9"});
  testing::expect_words(refused([](Disturbances& d) {
                          d.motor_losses = {{.joint = "arm_right_1_joint", .share = 1.5}};
                        }),
                        {"'motor_losses[0].share'", "1.5"});
  EXPECT_EQ(refused([](Disturbances&) {}), "");
}

}  // namespace
}  // namespace burnish::test
