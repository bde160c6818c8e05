// Each disturbance alone: what it changes, by how much, and that it leaves the rest alone.
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

TEST(RandomStream, gives_the_same_numbers_on_every_machine) {
  RandomStream random(7, 3);
  EXPECT_EQ(random.normal(), -0.7781829833984375);
  EXPECT_EQ(random.normal(), 0.4647064208984375);
  EXPECT_EQ(random.uniform(), 0.967922209237977);
}

TEST(RandomStream, draws_normal_numbers_of_mean_zero_and_deviation_one) {
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

TEST(RandomStream, differs_between_seeds_and_between_streams) {
  const auto first = [](std::uint64_t seed, std::uint64_t stream) {
    return RandomStream(seed, stream).uniform();
  };
  std::set<double> seen;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (std::uint64_t stream = 0; stream < 10; ++stream) seen.insert(first(seed, stream));
  EXPECT_EQ(seen.size(), 100U);
}

/// What an actuation makes of one varying command.
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

TEST_F(ActuationTest, gives_what_is_commanded_when_nothing_is_switched_on) {
  EXPECT_EQ(ideal.applied, ideal.command);
  EXPECT_EQ(ideal.noise, Eigen::MatrixXd::Zero(model.nv, ideal.noise.cols()));
}

TEST_F(ActuationTest, delays_the_command_by_whole_steps) {
  Disturbances d;
  d.command_delay = 3.1 * plant_step;
  const Response late = respond(model, d);
  EXPECT_EQ(late.delayed.rightCols(57), ideal.command.leftCols(57));
  EXPECT_EQ(late.delayed.leftCols(3), Eigen::MatrixXd::Zero(model.nv, 3));
  EXPECT_EQ(late.applied, late.delayed);
  EXPECT_EQ(late.command, ideal.command);
}

TEST_F(ActuationTest, follows_the_command_at_the_rate_of_the_cutoff) {
  Disturbances d;
  d.torque_cutoff = 100.0;
  Actuation actuation(model, d, plant_step);
  const Eigen::VectorXd step = Eigen::VectorXd::Ones(model.nv);
  for (int i = 0; i < 20; ++i) actuation.apply(step);
  EXPECT_NEAR(actuation.step().applied[0], 1.0 - std::exp(-100.0 * 20 * plant_step), 1e-12);
  EXPECT_EQ(actuation.step().delayed, step);
}

TEST_F(ActuationTest, scales_and_biases_every_joint_by_its_own_draw_within_the_range) {
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

TEST_F(ActuationTest, adds_noise_of_the_wanted_deviation_to_nothing_else) {
  Disturbances d;
  d.torque_noise = 0.05;
  const Response noisy = respond(model, d);
  EXPECT_EQ(noisy.tracked, ideal.tracked);
  EXPECT_LE((noisy.applied - ideal.applied - noisy.noise).norm(), 1e-12);
  const double deviation =
      std::sqrt(noisy.noise.squaredNorm() / static_cast<double>(noisy.noise.size()));
  EXPECT_NEAR(deviation, 0.05, 0.008);
}

TEST_F(ActuationTest, noise_is_at_most_a_share_of_the_effort_limit) {
  Model weak = model;
  weak.effort_limit.setConstant(100.0);
  weak.effort_limit[1] = 1.0;
  Disturbances d;
  d.torque_noise = 0.05;
  const Response all = respond(weak, d);
  d.torque_noise_share = 0.0125;
  const Response noisy = respond(weak, d);
  EXPECT_EQ(noisy.noise.row(0), all.noise.row(0));
  EXPECT_LE((noisy.noise.row(1) - 0.25 * all.noise.row(1)).norm(), 1e-15);
  EXPECT_EQ(torque_noise(weak, d).head<2>(), Eigen::Vector2d(0.05, 0.0125));
  d.torque_loop = true;
  d.torque_sensor_noise = 0.1;
  EXPECT_NEAR(torque_noise(weak, d)[0], std::hypot(0.05, 0.1), 1e-15);
}

TEST(DisturbancePreset, torque_noise_of_talos_is_the_same_in_all_joints) {
  if (!has_robot_files) GTEST_SKIP() << "needs robots in files";
  const Model talos = named_robot("talos");
  const Eigen::VectorXd noise = torque_noise(talos, disturbance_preset("mismatch"));
  EXPECT_EQ(noise.head<6>(), Eigen::VectorXd::Zero(6));
  EXPECT_EQ(noise.tail(talos.nv - 6), Eigen::VectorXd::Constant(talos.nv - 6, 0.05));
}

TEST_F(ActuationTest, takes_scale_and_bias_away_by_its_torque_loop_and_follows_the_sensor) {
  Disturbances d;
  d.torque_scale_range = 0.2;
  d.torque_bias_range = 2.0;
  d.torque_loop = true;
  EXPECT_EQ(respond(model, d).applied, ideal.applied);
  d.torque_sensor_noise = 0.1;
  const Response sensed = respond(model, d);
  EXPECT_NE(sensed.applied, ideal.applied);
  d.torque_loop = false;
  EXPECT_EQ(respond(model, d).noise, ideal.noise) << "open, the sensor moves no motor";
}

TEST_F(ActuationTest, stays_within_the_effort_limits_and_says_so) {
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

TEST_F(ActuationTest, loses_the_torque_of_a_motor_for_a_while_and_of_no_other) {
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

TEST_F(ActuationTest, loses_it_at_the_same_time_after_a_reset_and_in_a_copy) {
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

TEST_F(ActuationTest, holds_the_last_command_in_place_of_one_that_is_no_number) {
  Actuation actuation(model, {}, plant_step);
  const Eigen::VectorXd good = Eigen::VectorXd::Constant(model.nv, 2.0);
  actuation.apply(good);
  actuation.apply(Eigen::VectorXd::Constant(model.nv, std::nan("")));
  EXPECT_EQ(actuation.step().applied, good);
  EXPECT_TRUE(actuation.step().held);
  actuation.apply(good);
  EXPECT_FALSE(actuation.step().held);
}

TEST_F(ActuationTest, draws_the_same_bits_for_the_same_seed_whatever_else_is_on) {
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

/// The entries of a measurement that differ from the ideal one.
class SensingTest : public ::testing::Test {
 protected:
  struct Seen {
    Eigen::MatrixXd q, v, tau, force;  ///< a column per tick
  };

  /// A plant that presses and slides, measured every two steps.
  Seen see(const Disturbances& disturbances) const {
    SceneSpec scene = scene_under_tip(model, q, {0.0, 0.0, 1.0});
    const auto plant = make_ideal_plant(model, scene);
    EXPECT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    Sensing sensing(model, disturbances);
    RigidBody body(model);
    Seen seen;
    constexpr int ticks = 100;
    seen.q = Eigen::MatrixXd::Zero(model.nq, ticks);
    seen.v = seen.tau = Eigen::MatrixXd::Zero(model.nv, ticks);
    seen.force = Eigen::MatrixXd::Zero(3, ticks);
    Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
    for (int i = 0; i < ticks; ++i) {
      const Measurement& m = sensing.measure(*plant, tau);
      seen.q.col(i) = m.q;
      seen.v.col(i) = m.v;
      seen.tau.col(i) = m.tau;
      seen.force.col(i) = m.tool_force_world;
      EXPECT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
      tau = body.gravity_torque() + Eigen::VectorXd::LinSpaced(model.nv, -2.0, 2.0);
      for (int k = 0; k < 2; ++k) EXPECT_EQ(plant->step(tau, {0.0, 0.0, -40.0}), Status::Ok);
    }
    return seen;
  }
  static std::string changes(const Seen& a, const Seen& b) {
    return std::string(a.q == b.q ? "" : "q ") + (a.v == b.v ? "" : "v ") +
           (a.tau == b.tau ? "" : "tau ") + (a.force == b.force ? "" : "force ");
  }

  Eigen::VectorXd q;
  Model model = plant_model(right_arm(&q), {});
};

TEST_F(SensingTest, each_disturbance_changes_what_it_should_and_nothing_else) {
  const Seen ideal = see({});
  struct Case {
    const char* what;
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
    EXPECT_EQ(changes(see(d), ideal), c.changed) << c.what;
  }
}

TEST_F(SensingTest, MeasurementDelay_OfAllButTheTime_IsRoundedToMeasurements) {
  Disturbances d;
  d.velocity_noise = 1e-3;
  const Seen now = see(d);
  d.measurement_delay = 3.4e-3;
  const Seen late = see(d);
  constexpr Eigen::Index ticks = 3;
  const Eigen::Index rest = now.q.cols() - ticks;
  EXPECT_EQ(late.q.rightCols(rest), now.q.leftCols(rest));
  EXPECT_EQ(late.v.rightCols(rest), now.v.leftCols(rest));
  EXPECT_EQ(late.tau.rightCols(rest), now.tau.leftCols(rest));
  EXPECT_EQ(late.force.rightCols(rest), now.force.leftCols(rest));
  for (Eigen::Index i = 0; i < ticks; ++i) EXPECT_EQ(late.q.col(i), now.q.col(0)) << "at first";
  d.measurement_delay = 0.4e-3;
  EXPECT_EQ(changes(see(d), now), "") << "less than half a measurement";

  const auto plant = make_ideal_plant(model, scene_under_tip(model, q, {0.0, 0.0, 1.0}));
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  d.measurement_delay = 5e-3;
  Sensing sensing(model, d, 0, plant->dt());
  for (int i = 0; i < 20; ++i) {
    const AllocationGuard guard;
    EXPECT_EQ(sensing.measure(*plant, q).time, plant->time());
    if (AllocationGuard::unavailable() == nullptr) {
      EXPECT_EQ(guard.count(), 0);
    }
    ASSERT_EQ(plant->step(q, Eigen::Vector3d::Zero()), Status::Ok);
  }
}

TEST_F(SensingTest, a_reset_gives_the_same_bits_again) {
  Disturbances d;
  d.position_noise = d.velocity_noise = d.torque_sensor_noise = d.force_noise = 0.1;
  const auto plant = make_ideal_plant(model, scene_under_tip(model, q, {0.0, 0.0, 1.0}));
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(plant->reset(q, rest), Status::Ok);
  Sensing sensing(model, d);
  std::vector<Measurement> seen;
  for (int time = 0; time < 2; ++time) {
    for (int i = 0; i < 20; ++i) seen.push_back(sensing.measure(*plant, rest));
    sensing.reset();
  }
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(seen[i].q, seen[20 + i].q);
    EXPECT_EQ(seen[i].v, seen[20 + i].v);
    EXPECT_EQ(seen[i].tau, seen[20 + i].tau);
    EXPECT_EQ(seen[i].tool_force_world, seen[20 + i].tool_force_world);
  }
}

TEST_F(SensingTest, encoders_show_multiples_of_their_step) {
  Disturbances d;
  d.encoder_bits = 12;
  const double step = 2.0 * std::numbers::pi / 4096.0;
  const Eigen::ArrayXXd marks = see(d).q.array() / step;
  EXPECT_LE((marks - marks.round()).abs().maxCoeff(), 1e-9);
  EXPECT_LE((see(d).q - see({}).q).cwiseAbs().maxCoeff(), 0.5 * step + 1e-12);
}

TEST_F(SensingTest, differences_follow_the_velocity_and_their_low_pass_lags_behind) {
  Disturbances d;
  d.finite_difference_velocity = true;
  const Seen ideal = see({}), plain = see(d);
  const double scale = ideal.v.cwiseAbs().maxCoeff();
  EXPECT_LE((plain.v - ideal.v).rightCols(50).cwiseAbs().maxCoeff(), 0.1 * scale);
  d.velocity_cutoff = 50.0;
  const Seen filtered = see(d);
  EXPECT_GT((filtered.v - ideal.v).norm(), 2.0 * (plain.v - ideal.v).norm());
  EXPECT_EQ(filtered.v.col(0), ideal.v.col(0));
}

TEST_F(SensingTest, force_filter_takes_noise_away) {
  Disturbances d;
  d.force_noise = 0.3;
  const Seen ideal = see({}), noisy = see(d);
  const auto tail = [&](const Seen& seen) {
    return (seen.force - ideal.force).rightCols(60).norm() / std::sqrt(180.0);
  };
  EXPECT_NEAR(tail(noisy), 0.3, 0.06);
  d.force_cutoff = 100.0;
  const Seen smooth = see(d);
  const Eigen::MatrixXd steps = smooth.force.rightCols(60) - smooth.force.middleCols(39, 60);
  const Eigen::MatrixXd rough = noisy.force.rightCols(60) - noisy.force.middleCols(39, 60);
  EXPECT_LT(steps.norm(), 0.3 * rough.norm());
}

TEST(PlantModel, scales_masses_and_states_joint_friction) {
  const Model nominal = right_arm();
  const Model ideal = plant_model(nominal, {});
  EXPECT_EQ(ideal.total_mass(), nominal.total_mass());
  EXPECT_TRUE(ideal.friction.isZero(0.0)) << "unless it is switched on";
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
  EXPECT_TRUE(plant_model(nominal, d).friction.isZero(0.0)) << "the loop takes friction away";
  EXPECT_TRUE(plant_model(nominal, d).damping.isZero(0.0));
}

TEST(PlantModel, joint_friction_is_at_most_a_share_of_the_effort_limit) {
  Model nominal = right_arm();
  nominal.effort_limit.setConstant(100.0);
  nominal.effort_limit[1] = 4.0;
  const Model real = plant_model(nominal, disturbance_preset("joint_friction"));
  EXPECT_EQ(real.friction.head<2>(), Eigen::Vector2d(1.0, 0.2));
  EXPECT_EQ(real.damping.head<2>(), Eigen::Vector2d(1.0, 0.2));
}

TEST(PlantModel, carries_a_payload_that_the_controller_does_not_know) {
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
  double least = 2.0, most = 0.0;
  for (d.seed = 0; d.seed < 50; ++d.seed) {
    const Payload drawn = carried_payload(d);
    EXPECT_LE(std::abs(drawn.inertia.mass - 1.0), 0.4);
    EXPECT_LE((drawn.inertia.com - d.payload.com).cwiseAbs().maxCoeff(), 0.02);
    least = std::min(least, drawn.inertia.mass), most = std::max(most, drawn.inertia.mass);
  }
  EXPECT_LT(least, 0.7);
  EXPECT_GT(most, 1.3);
  d.payload.mass = -1.0;
  EXPECT_THROW((void)plant_model(nominal, d), Error);
  d.payload.mass = 1.0;
  d.payload.frame = "tol";
  EXPECT_THROW((void)plant_model(nominal, d), Error);
}

TEST(PlantModel, spares_a_floating_base) {
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

TEST(PlantScene, tilts_about_the_tangents_and_shifts_along_the_normal) {
  SceneSpec nominal;
  nominal.surface.point = {0.4, -0.3, 1.0};
  nominal.surface.normal = {0.0, 0.0, 1.0};
  nominal.surface.friction = 0.2;
  const SceneSpec same = plant_scene(nominal, {});
  EXPECT_EQ(same.surface.normal, nominal.surface.normal);
  EXPECT_EQ(same.surface.point, nominal.surface.point);
  EXPECT_EQ(same.surface.friction, 0.2);

  Disturbances d;
  d.surface_height = 0.003;
  d.surface_friction = 0.5;
  for (int axis = 0; axis < 2; ++axis) {
    d.surface_tilt_deg.setZero();
    d.surface_tilt_deg[axis] = 6.0;
    const SurfaceSpec real = plant_scene(nominal, d).surface;
    const double tilt = std::atan2(real.normal.cross(nominal.surface.normal).norm(),
                                   real.normal.dot(nominal.surface.normal));
    EXPECT_NEAR(tilt * 180.0 / std::numbers::pi, 6.0, 1e-9);
    EXPECT_NEAR(real.normal[axis], 0.0, 1e-12) << "its own axis stays";
    EXPECT_LE((real.point - nominal.surface.point - Eigen::Vector3d(0.0, 0.0, 0.003)).norm(),
              1e-15);
    EXPECT_EQ(real.friction, 0.5);
  }
}

TEST(Pushes, act_from_their_start_for_their_duration_and_add_up) {
  const std::vector<Push> pushes{{1.0, 0.5, {1.0, 0.0, 0.0}}, {1.2, 1.0, {0.0, 2.0, 0.0}}};
  EXPECT_EQ(push_at(pushes, 0.9), Eigen::Vector3d::Zero());
  EXPECT_EQ(push_at(pushes, 1.0), Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(push_at(pushes, 1.3), Eigen::Vector3d(1.0, 2.0, 0.0));
  EXPECT_EQ(push_at(pushes, 1.5), Eigen::Vector3d(0.0, 2.0, 0.0));
}

TEST(DisturbancesTest, are_refused_by_name) {
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
