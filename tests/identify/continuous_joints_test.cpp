// Tests of records of continuous joints, given as angles, as by encoders, or as (cos, sin).
#include <gtest/gtest.h>

#include <functional>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/identify/trial.hpp"
#include "identify/joint_angles.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

constexpr double round_turn = 2.0 * M_PI;

/// Record of arm7 with a payload; every second joint is continuous, joint_3 starts at half a turn.
struct ContinuousArm {
  Model model;
  Eigen::VectorXd start;
  Payload carried = drawn_payload("tool", 3);
  Trace trace;

  ContinuousArm() {
    TreeSpec tree = arm7::tree();
    for (const std::size_t i : {0U, 2U, 4U, 6U}) tree.joints[i].type = JointType::Continuous;
    model = build_model(tree, arm7::options(Base::Fixed));
    start = configuration(
        model, {{"joint_2", {0.3}}, {"joint_3", {M_PI}}, {"joint_4", {-1.2}}, {"joint_6", {0.2}}});
    const Excitation motion(model, start, "tool", {.duration = 5.0, .candidates = 4});
    Disturbances sensors = disturbance_preset("sensors");
    sensors.torque_sensor_noise = 0.05;
    trace = record_motion(model, carried, motion, sensors);
  }
};
const ContinuousArm& continuous_arm() {
  static const ContinuousArm one;
  return one;
}

/// Returns the angle of a joint in row i; that of a continuous joint is between -pi and pi.
double angle_of(const Trace& trace, const std::string& joint, int i) {
  const std::string name = "measured_q_" + joint;
  if (trace.has(name)) return trace.column(name)[i];
  return std::atan2(trace.column(name + ".sin")[i], trace.column(name + ".cos")[i]);
}

using Change = std::function<double(const std::string& joint, int i, double angle)>;
const Change unchanged = [](const std::string&, int, double angle) { return angle; };

/// Returns the record with one column per joint, named by `prefix`. Every `lost`-th row is missing.
Trace by_angles(const Change& change = unchanged, const std::string& prefix = "q_", int lost = 0) {
  const Trace& full = continuous_arm().trace;
  const Model& model = continuous_arm().model;
  std::vector<TraceColumn> columns{{"time", "s"}};
  for (int k = 0; k < model.nv; ++k) columns.push_back({prefix + model.v_name(k), "rad"});
  for (int k = 0; k < model.nv; ++k) columns.push_back({"tau_" + model.v_name(k), "Nm"});
  Trace result(columns, full.rows());
  for (int i = 0; i < full.rows(); ++i) {
    if (lost > 0 && i % lost == 1) continue;
    double* row = result.add_row();
    *row++ = full.column("time")[i];
    for (int k = 0; k < model.nv; ++k)
      *row++ = change(model.v_name(k), i, angle_of(full, model.v_name(k), i));
    for (int k = 0; k < model.nv; ++k) *row++ = full.column("tau_measured_" + model.v_name(k))[i];
  }
  return result;
}

Identification found_in(const Trace& trace) {
  return identify(continuous_arm().model, motion_record(continuous_arm().model, trace));
}

void expect_refused_record(const Trace& trace, const std::vector<std::string>& words) {
  try {
    (void)found_in(trace);
    ADD_FAILURE() << "not refused; expected: " << words[0];
  } catch (const Error& error) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(ContinuousJointRecord, Angles_GiveTheResultOfCosineAndSine) {
  const Identification by_pairs = found_in(continuous_arm().trace);
  const double mass = continuous_arm().carried.inertia.mass;
  EXPECT_NEAR(by_pairs.inertias[0].values[0], mass, 4.0 * by_pairs.inertias[0].sigma[0]);
  const auto expect_same = [&](const Trace& trace, double tolerance) {
    const Identification found = found_in(trace);
    EXPECT_TRUE(found.warnings.empty()) << found.warnings.front();
    EXPECT_LE((found.inertias[0].values - by_pairs.inertias[0].values).norm(), tolerance);
  };
  // joint_3 starts at half a turn: its angle jumps from pi to -pi and back.
  expect_same(by_angles(), 1e-9);
  expect_same(by_angles(unchanged, "measured_q_"), 1e-9);
  expect_same(by_angles([](const std::string& joint, int, double angle) {
                const bool ends = joint == "joint_2" || joint == "joint_4" || joint == "joint_6";
                return ends ? angle : angle + 3.0 * round_turn;
              }),
              1e-9);
}

TEST(ContinuousJointRecord, AngleBesideCosineAndSine_IsRead) {
  const Trace& full = continuous_arm().trace;
  std::vector<TraceColumn> columns;
  for (const TraceColumn& column : full.columns())
    if (column.name.find("q_joint_1.sin") == std::string::npos) {
      columns.push_back(column);
      if (const auto end = column.name.find("q_joint_1.cos"); end != std::string::npos)
        columns.back().name = column.name.substr(0, end) + "q_joint_1";
    }
  Trace mixed(columns, full.rows());
  for (int i = 0; i < full.rows(); ++i) {
    double* row = mixed.add_row();
    for (const TraceColumn& column : columns) {
      const bool is_angle = column.name.ends_with("q_joint_1");
      *row++ = is_angle ? angle_of(full, "joint_1", i) : full.column(column.name)[i];
    }
  }
  const Vector10 values = found_in(mixed).inertias[0].values;
  EXPECT_LE((values - found_in(full).inertias[0].values).norm(), 1e-9);
}

TEST(ContinuousJointRecord, LostSamplesAtAWrap_AreInterpolated) {
  const Identification found = found_in(by_angles(unchanged, "q_", 50));
  const double mass = continuous_arm().carried.inertia.mass;
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_NE(found.warnings[0].find("samples are missing"), std::string::npos);
  EXPECT_NEAR(found.inertias[0].values[0], mass, 0.005 * mass);
}

TEST(ContinuousJointRecord, FaultyAngle_IsNamedWithItsFault) {
  const auto of = [](const std::string& changed, const Change& change) {
    return by_angles([=](const std::string& joint, int i, double angle) {
      return joint == changed ? change(joint, i, angle) : angle;
    });
  };
  expect_refused_record(
      by_angles([](const std::string&, int, double angle) { return angle * 180.0 / M_PI; }),
      {"'q_joint_3' jumps by", "degrees"});
  expect_refused_record(by_angles([](const std::string& joint, int, double angle) {
                          const bool wraps = joint == "joint_3" && angle < 0.0;
                          return (wraps ? angle + round_turn : angle) * 180.0 / M_PI;
                        }),
                        {"positions look like degrees"});
  expect_refused_record(
      of("joint_5", [](const std::string&, int i, double a) { return i < 2000 ? a : a + 0.7; }),
      {"'q_joint_5' jumps by 0.7 rad at 2 s"});
  expect_refused_record(of("joint_5", [](const std::string&, int, double a) { return -a; }),
                        {"'q_joint_5' have the opposite sign"});
  expect_refused_record(of("joint_3", [](const std::string&, int, double a) { return a + 0.2; }),
                        {"'q_joint_3' seems to have a constant error of 0.2"});
  expect_refused_record(of("joint_5", [](const std::string&, int i,
                                         double a) { return i == 700 ? std::nan("") : a; }),
                        {"'q_joint_5' holds a NaN or an infinity at 0.7 s"});
  const Identification repaired = found_in(
      of("joint_5", [](const std::string&, int i, double a) { return i == 2000 ? a + 1.0 : a; }));
  ASSERT_FALSE(repaired.warnings.empty());
  EXPECT_NE(repaired.warnings[0].find("'q_joint_5' has outliers of up to 1 rad in 1 sample"),
            std::string::npos);
}

TEST(ContinuousJointRecord, MissingPosition_IsRefusedWithPossibleColumns) {
  const Trace angles = by_angles();
  std::vector<TraceColumn> columns = angles.columns();
  columns[1].name = "q_joint_one";
  expect_refused_record(Trace(columns, 10),
                        {"continuous joint 'joint_1'", "'q_joint_1'", "'q_joint_1.cos'"});
  MotionRecord record = motion_record(continuous_arm().model, angles);
  record.q.conservativeResize(Eigen::NoChange, 9);
  try {
    (void)identify(continuous_arm().model, record);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_STREQ(
        error.what(),
        "identify: q has 9 columns; wanted 7, with one angle for each continuous joint, or "
        "11, with a cosine and a sine for each");
  }
}

TEST(ContinuousJointRecord, ExcitationTrace_HasAnglesOfContinuousJoints) {
  const Model& model = continuous_arm().model;
  const Excitation motion(model, continuous_arm().start, "tool",
                          {.duration = 5.0, .candidates = 1});
  const Trace trace = motion.trace(0.01);
  ASSERT_EQ(static_cast<int>(trace.columns().size()), 1 + 3 * model.nv);
  Eigen::VectorXd q, v, a;
  for (int i = 0; i < trace.rows(); i += 25) {
    motion.at(0.01 * i, q, v, a);
    for (const Joint& joint : model.joints) {
      const double angle = trace.column("q_" + joint.name)[i];
      if (joint.nq == 2) {
        EXPECT_NEAR(std::cos(angle), q[joint.q_index], 1e-12);
        EXPECT_NEAR(std::sin(angle), q[joint.q_index + 1], 1e-12);
      } else {
        EXPECT_NEAR(angle, q[joint.q_index], 1e-12);
      }
    }
  }
  EXPECT_EQ(trace.columns()[3].name, "q_joint_3");
  EXPECT_EQ(trace.columns()[3].unit, "rad");
}

TEST(AngleModel, InverseDynamics_EqualsTheRobots) {
  TreeSpec tree = arm7::tree();
  for (const std::size_t i : {0U, 2U, 3U}) tree.joints[i].type = JointType::Continuous;
  tree.joints[3].mimic = MimicSpec{"joint_1", -2.0, 0.4};
  tree.joints[6].type = JointType::Prismatic;
  const Model model = build_model(tree, arm7::options(Base::Fixed));
  const Model angles = identify_detail::angle_model(model);
  ASSERT_EQ(angles.nq, model.nv);
  ContactDynamics circle(model), line(angles);
  std::mt19937_64 generator(5);
  const Eigen::VectorXd none;
  for (int i = 0; i < 5; ++i) {
    MotionRecord record;
    record.q = random_configuration(model, generator).transpose();
    const Eigen::VectorXd q = identify_detail::with_angles(model, record).q.row(0).transpose();
    const Eigen::VectorXd v = Eigen::VectorXd::Random(model.nv),
                          a = Eigen::VectorXd::Random(model.nv);
    ASSERT_EQ(circle.inverse(record.q.row(0).transpose(), v, a, none), Status::Ok);
    ASSERT_EQ(line.inverse(q, v, a, none), Status::Ok);
    EXPECT_LE((circle.tau() - line.tau()).norm(), 1e-10);
  }
}

}  // namespace
}  // namespace burnish::test
