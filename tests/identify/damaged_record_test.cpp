// Tests of identification from damaged copies of one simulated record. A damaged record never gives
// a wrong mass: it is refused with column, time and likely cause, or repaired with a warning.
#include <gtest/gtest.h>

#include <functional>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/identify/trial.hpp"
#include "identify/signal_check.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

using Damage = std::function<void(MotionRecord&)>;

constexpr double degrees_per_radian = 180.0 / M_PI;

Eigen::VectorXd middle_of(const Model& model) { return 0.5 * (model.q_lower + model.q_upper); }

/// Simulated record of arm7 with an unknown payload: 10 s at 250 Hz, sensors with noise.
struct SimulatedRecord {
  Model model = named_robot("arm7");
  Payload carried = drawn_payload("tool", 3);
  MotionRecord record;

  SimulatedRecord() {
    const Excitation motion(model, middle_of(model), "tool", {.candidates = 8});
    Disturbances disturbances = disturbance_preset("sensors");
    disturbances.torque_sensor_noise = 0.05;
    const MotionRecord fine =
        motion_record(model, record_motion(model, carried, motion, disturbances));
    constexpr int every = 4;
    const Eigen::Index rows = fine.q.rows() / every;
    record.period = every * fine.period;
    record.q = RowMatrix(rows, model.nq);
    record.tau = RowMatrix(rows, model.nv);
    for (Eigen::Index i = 0; i < rows; ++i) {
      record.q.row(i) = fine.q.row(every * i);
      record.tau.row(i) = fine.tau.row(every * i);
    }
  }
  MotionRecord damaged(const Damage& damage) const {
    MotionRecord result = record;
    damage(result);
    return result;
  }
};
const SimulatedRecord& recorded() {
  static const SimulatedRecord one;
  return one;
}

void expect_refused(const Damage& damage, const std::vector<std::string>& words) {
  try {
    const Identification found = identify(recorded().model, recorded().damaged(damage));
    ADD_FAILURE() << "not refused, found " << found.inertias[0].values[0]
                  << " kg; expected: " << words[0];
  } catch (const Error& error) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << word << " is missing in: " << error.what();
  }
}

/// Expects the true mass, and a warning with these words.
void expect_repaired(const Damage& damage, const std::vector<std::string>& words) {
  const Identification found = identify(recorded().model, recorded().damaged(damage));
  const double mass = recorded().carried.inertia.mass;
  EXPECT_NEAR(found.inertias[0].values[0], mass, 0.005 * mass);
  std::string warnings;
  for (const std::string& warning : found.warnings) warnings += warning + "\n";
  for (const std::string& word : words)
    EXPECT_NE(warnings.find(word), std::string::npos) << word << " is missing in: " << warnings;
}

TEST(DamagedRecord, UndamagedRecord_GivesTheMassWithoutAWarning) {
  const Identification found = identify(recorded().model, recorded().record);
  EXPECT_EQ(found.warnings.size(), 0U) << found.warnings.front();
  EXPECT_NEAR(found.inertias[0].values[0], recorded().carried.inertia.mass,
              4.0 * found.inertias[0].sigma[0]);
  // The residuals are explained by the noise.
  const Eigen::ArrayXd ratio = found.rms_after.array() / found.rms_expected.array();
  EXPECT_LE(ratio.maxCoeff(), 1.5);
  EXPECT_GE(ratio.minCoeff(), 0.1);
}

TEST(DamagedRecord, TorquesInOtherUnits_AreRefusedWithTheUnit) {
  expect_refused([](auto& r) { r.tau *= 1e3; }, {"all torques", "Nmm"});
  expect_refused([](auto& r) { r.tau *= 1.2; }, {"all torques", "1.2"});
  expect_refused(
      [](auto& r) {
        for (int k = 0; k < r.tau.cols(); ++k)
          r.tau.col(k) *= 100.0 / recorded().model.effort_limit[k];
      },
      {"percent"});
}

TEST(DamagedRecord, TorquesWithTheWrongSign_AreRefused) {
  expect_refused([](auto& r) { r.tau *= -1.0; }, {"all torques", "sign"});
  expect_refused([](auto& r) { r.tau.col(1) *= -1.0; },
                 {"-1.0", "times for 'tau_joint_2'", "sign"});
}

TEST(DamagedRecord, TorquesThatNeverChange_AreRefused) {
  expect_refused([](auto& r) { r.tau.setZero(); }, {"no torque ever changes", "'tau_joint_1'"});
  expect_refused([](auto& r) { r.tau.col(3).setZero(); }, {"'tau_joint_4' is 0 throughout"});
}

TEST(DamagedRecord, SwappedColumns_AreNamed) {
  expect_refused([](auto& r) { r.q.col(1).swap(r.q.col(3)); },
                 {"'q_joint_2' and 'q_joint_4' swapped"});
  expect_refused([](auto& r) { r.tau.col(1).swap(r.tau.col(2)); },
                 {"'tau_joint_2' and 'tau_joint_3' swapped"});
}

TEST(DamagedRecord, AnglesInDegrees_AreRefusedWithLimitsAndSpeeds) {
  expect_refused([](auto& r) { r.q *= degrees_per_radian; },
                 {"positions look like degrees", "beyond its limit", "per s"});
}

/// Returns the record read from a table. `moved` shifts each row's time, `dropped` omits rows.
MotionRecord from_table(const std::function<double(int)>& moved,
                        const std::function<bool(int)>& dropped) {
  const Model& model = recorded().model;
  const MotionRecord& record = recorded().record;
  const auto n = static_cast<int>(record.q.rows());
  std::vector<TraceColumn> columns{{"time", "s"}};
  for (int k = 0; k < model.nq; ++k) columns.push_back({"q_" + model.q_name(k), "rad"});
  for (int k = 0; k < model.nv; ++k) columns.push_back({"tau_" + model.v_name(k), "Nm"});
  Trace trace(columns, n);
  for (int i = 1; i + 1 < n; ++i) {
    if (dropped(i)) continue;
    const double shift = moved(i);  // fraction of a period; a parabola gives the values there
    const auto at = [&](const RowMatrix& all, int k) {
      const double a = all(i - 1, k), b = all(i, k), c = all(i + 1, k);
      return b + 0.5 * shift * (c - a) + 0.5 * shift * shift * (a - 2.0 * b + c);
    };
    double* row = trace.add_row();
    *row++ = (i + shift) * record.period;
    for (int k = 0; k < model.nq; ++k) *row++ = at(record.q, k);
    for (int k = 0; k < model.nv; ++k) *row++ = at(record.tau, k);
  }
  return motion_record(model, trace);
}

void expect_resampled(const MotionRecord& record, const std::vector<std::string>& words) {
  const Identification found = identify(recorded().model, record);
  const double mass = recorded().carried.inertia.mass;
  EXPECT_NEAR(found.inertias[0].values[0], mass, 0.005 * mass);
  ASSERT_FALSE(found.warnings.empty());
  for (const std::string& word : words)
    EXPECT_NE(found.warnings[0].find(word), std::string::npos) << found.warnings[0];
}

TEST(DamagedRecord, UnevenTimes_AreResampled) {
  expect_resampled(
      from_table([](int i) { return 0.3 * std::sin(2.4 * i); }, [](int) { return false; }),
      {"differ from 4", "resampled every 4"});
}

TEST(DamagedRecord, LostSamples_AreInterpolated) {
  const auto lost = [](int i) { return i % 100 < 3; };
  expect_resampled(from_table([](int) { return 0.0; }, lost),
                   {"samples are missing", "the longest gap lasts 16 ms"});
}

TEST(DamagedRecord, LongGapsAndManyLostSamples_AreRefused) {
  const auto refusal = [](const std::function<bool(int)>& lost) -> std::string {
    try {
      from_table([](int) { return 0.0; }, lost);
    } catch (const Error& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_NE(refusal([](int i) { return i > 1000 && i < 1020; }).find("a gap of 80"),
            std::string::npos);
  EXPECT_NE(refusal([](int i) { return i % 10 == 0; }).find("% of the samples"), std::string::npos);
}

TEST(DamagedRecord, WrappedAngleAtUnevenTimes_IsUnwrapped) {
  const Model& model = recorded().model;
  const auto n = static_cast<int>(recorded().record.q.rows());
  std::vector<TraceColumn> columns{{"time", "s"}};
  for (int k = 0; k < model.nq; ++k) columns.push_back({"q_" + model.q_name(k), "rad"});
  for (int k = 0; k < model.nv; ++k) columns.push_back({"tau_" + model.v_name(k), "Nm"});
  Trace trace(columns, n);
  for (int i = 0; i < n; ++i) {
    if (i % 50 == 7) continue;
    double* row = trace.add_row();
    *row++ = i * recorded().record.period;
    for (int k = 0; k < model.nq; ++k)
      *row++ = std::remainder(recorded().record.q(i, k) + (k == 0 ? 3.0 : 0.0), 2.0 * M_PI) -
               (k == 0 ? 3.0 : 0.0);
    for (int k = 0; k < model.nv; ++k) *row++ = recorded().record.tau(i, k);
  }
  const Identification found = identify(model, motion_record(model, trace));
  const double mass = recorded().carried.inertia.mass;
  EXPECT_NEAR(found.inertias[0].values[0], mass, 0.005 * mass);
}

TEST(DamagedRecord, WrappedAngle_IsUnwrapped) {
  expect_repaired(
      [](auto& r) {
        const double middle = r.q.col(5).mean();
        for (double& angle : r.q.col(5))
          if (angle > middle) angle -= 2.0 * M_PI;
      },
      {"'q_joint_6' wraps by 2 pi", " s"});
}

TEST(DamagedRecord, SingleOutliers_AreBridgedAndManyRefused) {
  expect_repaired([](auto& r) { r.q(1080, 1) += 3.0; },
                  {"'q_joint_2'", " rad in 1 sample", "at 4.32 s"});
  expect_repaired([](auto& r) { r.tau(1080, 1) += 300.0; }, {"'tau_joint_2'", "at 4.32 s"});
  expect_refused(
      [](auto& r) {
        for (int i = 20; i < r.q.rows() - 20; i += 50) r.q(i, 1) += 3.0;
      },
      {"'q_joint_2'", "outliers"});
}

TEST(DamagedRecord, JumpsAndStandstill_AreNamedWithTheirTimes) {
  expect_refused([](auto& r) { r.q.col(2).tail(1000).array() += 0.4; }, {"'q_joint_3' jumps"});
  expect_refused(
      [](auto& r) {
        for (Eigen::Index i = 700; i < 900; ++i) r.q(i, 1) = r.q(700, 1);
      },
      {"'q_joint_2' stands still from 2.8 s"});
  expect_refused([](auto& r) { r.q.col(1).setConstant(r.q(0, 1)); }, {"'q_joint_2' never changes"});
  expect_refused([](auto& r) { r.q(700, 2) = std::nan(""); }, {"'q_joint_3'", "NaN", "2.8 s"});
}

TEST(DamagedRecord, ArmAtRest_IsRefused) {
  expect_refused(
      [](auto& r) {
        r.q = r.q.row(0).replicate(r.q.rows(), 1).eval();
        r.tau = r.tau.row(0).replicate(r.tau.rows(), 1).eval();
      },
      {"at rest", "--excite"});
}

TEST(DamagedRecord, VelocitiesAsPositions_AreRefused) {
  expect_refused(
      [](auto& r) {
        const RowMatrix q = r.q;
        const Eigen::Index n = q.rows();
        r.q.middleRows(1, n - 2) = (q.bottomRows(n - 2) - q.topRows(n - 2)) / (2.0 * r.period);
        r.q.row(0) = r.q.row(1);
        r.q.row(n - 1) = r.q.row(n - 2);
      },
      {"do not fit", "positions in rad"});
}

TEST(DamagedRecord, TimesInOtherUnits_AreRefused) {
  expect_refused([](auto& r) { r.period *= 1e3; }, {"milliseconds"});
  expect_refused([](auto& r) { r.period *= 2.0; }, {"the period looks like 0.004 s"});
}

TEST(DamagedRecord, DelayedTorques_AreNamed) {
  const auto late = [](MotionRecord& r, int first, int last, Eigen::Index by) {
    const RowMatrix tau = r.tau;
    for (Eigen::Index i = 0; i < tau.rows(); ++i)
      for (int k = first; k <= last; ++k) r.tau(i, k) = tau(std::max<Eigen::Index>(0, i - by), k);
  };
  expect_refused([&](auto& r) { late(r, 1, 1, 50); }, {"'tau_joint_2' is 0.2 s behind"});
  expect_refused([&](auto& r) { late(r, 0, 6, 75); }, {"all torques are 0.", "s behind"});
  expect_repaired([&](auto& r) { late(r, 0, 6, 12); }, {"ms behind the positions"});
}

/// Replaces the gravity torques of `from` by those of `to`.
void change_gravity(MotionRecord& record, const Model& from, const Model& to) {
  ContactDynamics old_dynamics(from), new_dynamics(to);
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(from.nv), none;
  for (Eigen::Index i = 0; i < record.q.rows(); ++i) {
    const Eigen::VectorXd q = record.q.row(i).transpose();
    ASSERT_EQ(old_dynamics.inverse(q, still, still, none), Status::Ok);
    ASSERT_EQ(new_dynamics.inverse(q, still, still, none), Status::Ok);
    record.tau.row(i) += (new_dynamics.tau() - old_dynamics.tau()).transpose();
  }
}

TEST(DamagedRecord, TorquesWithWrongGravity_AreNamed) {
  const Model with = with_payload(recorded().model, recorded().carried);
  Model without = with, robot_without = recorded().model, tilted = with;
  without.gravity.setZero();
  robot_without.gravity.setZero();
  tilted.gravity = Eigen::Vector3d(3.0, 0.0, -9.34);
  expect_refused([&](auto& r) { change_gravity(r, with, without); },
                 {"weight of the robot and its payload"});
  expect_refused([&](auto& r) { change_gravity(r, recorded().model, robot_without); },
                 {"weight of the robot's own links"});
  expect_refused([&](auto& r) { change_gravity(r, with, tilted); },
                 {"the torques fit a gravity of", "mounted"});
}

TEST(DamagedRecord, EncoderOffset_IsNamed) {
  expect_refused([](auto& r) { r.q.col(1).array() += 0.1; },
                 {"'q_joint_2' seems to have a constant error"});
  expect_refused([](auto& r) { r.q.col(5).array() += 0.5 * M_PI; },
                 {"'q_joint_6' seems to have a constant error"});
}

TEST(DamagedRecord, UnmodelledFriction_IsAHintAndEnlargesTheDeviation) {
  const auto add_friction = [](MotionRecord& r) {
    for (int k = 0; k < r.tau.cols(); ++k)
      for (Eigen::Index i = 1; i + 1 < r.tau.rows(); ++i) {
        const double v = (r.q(i + 1, k) - r.q(i - 1, k)) / (2.0 * r.period);
        r.tau(i, k) += 0.5 * v + 0.2 * std::tanh(v / 0.02);
      }
  };
  const Identification found = identify(recorded().model, recorded().damaged(add_friction));
  const double error = found.inertias[0].values[0] - recorded().carried.inertia.mass;
  EXPECT_LE(std::abs(error), 4.0 * found.inertias[0].sigma[0]);
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings[0].find("--friction"), std::string::npos) << found.warnings[0];
}

TEST(SignalCheck, NoiseAndMovingEncoder_HaveNoSuddenSteps) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> draw;
  Eigen::VectorXd noise(20000), encoder(20000);
  for (int i = 0; i < 20000; ++i) {
    noise[i] = draw(generator);
    encoder[i] = std::round(1e4 * std::sin(1e-3 * i)) / 1e4;
  }
  EXPECT_TRUE(identify_detail::sudden_steps(noise).sudden.empty());
  EXPECT_TRUE(identify_detail::sudden_steps(encoder).sudden.empty());
  EXPECT_NEAR(identify_detail::white_noise(noise), 1.0, 0.03);
  encoder[7000] += 0.1;
  identify_detail::Steps steps = identify_detail::sudden_steps(encoder);
  const std::vector<identify_detail::Outlier> outliers = identify_detail::take_outliers(steps);
  ASSERT_EQ(outliers.size(), 1U);
  EXPECT_EQ(outliers[0].at, 7000);
  EXPECT_EQ(outliers[0].count, 1);
  EXPECT_TRUE(steps.sudden.empty());
}

}  // namespace
}  // namespace burnish::test
