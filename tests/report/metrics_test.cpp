// Tests of the metrics of a run, on traces whose figures follow by hand.
#include "burnish/report/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "burnish/mpc/controller.hpp"
#include "report/moving_mean.hpp"
#include "report/run_page.hpp"
#include "support/refusal.hpp"

namespace burnish {
namespace {

using testing::expect_words;
using testing::refusal;

constexpr double dt = 1e-3;

/// Returns an arm with one revolute joint and limits.
Model one_joint() {
  TreeSpec tree;
  tree.name = "one";
  LinkSpec base{"base", {}, {}}, arm{"arm", {}, {}};
  arm.inertia.mass = 1.0;
  arm.inertia.inertia_at_com = Eigen::Matrix3d::Identity();
  tree.links = {base, arm};
  JointSpec joint;
  joint.name = "hinge";
  joint.type = JointType::Revolute;
  joint.parent_link = "base";
  joint.child_link = "arm";
  joint.lower = -1.0;
  joint.upper = 2.0;
  joint.effort_limit = 10.0;
  tree.joints = {joint};
  return build_model(tree);
}

/// Returns a trace of 1 s along x = 0.1 t with 30 N and no error; `change` edits each row.
Trace trace_with(const std::function<void(int row, Trace& trace, double* values)>& change) {
  std::vector<TraceColumn> columns;
  for (const char* name : {"time",
                           "phase",
                           "in_contact",
                           "tool_x_world",
                           "tool_y_world",
                           "tool_z_world",
                           "tool_rx_start",
                           "tool_ry_start",
                           "tool_rz_start",
                           "target_x_world",
                           "target_y_world",
                           "target_z_world",
                           "target_force",
                           "tool_force_x_world",
                           "tool_force_y_world",
                           "tool_force_z_world",
                           "estimated_force_x_world",
                           "estimated_force_y_world",
                           "estimated_force_z_world",
                           "surface_normal_x_world",
                           "surface_normal_y_world",
                           "surface_normal_z_world",
                           "estimated_normal_x_world",
                           "estimated_normal_y_world",
                           "estimated_normal_z_world",
                           "q_hinge",
                           "tau_applied_hinge",
                           "limited_joints",
                           "solve_time",
                           "iterations",
                           "missed_deadline",
                           "tick",
                           "active_constraints",
                           "constraint_violation",
                           "constraints_infeasible",
                           "clipped_torques"})
    columns.push_back({name, "-"});
  Trace trace(columns, 1000);
  for (int row = 0; row < 1000; ++row) {
    double* values = trace.add_row();
    const auto set = [&](const char* name, double value) { values[trace.index(name)] = value; };
    set("time", dt * row);
    set("phase", row < 300 ? 2.0 : 3.0);
    set("in_contact", 1.0);
    set("tool_x_world", 0.1 * dt * row);
    set("target_x_world", 0.1 * dt * row);
    set("target_force", 30.0);
    set("tool_force_z_world", 30.0);
    set("estimated_force_z_world", 30.0);
    set("surface_normal_z_world", 1.0);
    set("estimated_normal_z_world", 1.0);
    change(row, trace, values);
  }
  return trace;
}

MetricsSpec from_half() {
  MetricsSpec spec;
  spec.start = 0.5;
  return spec;
}

TEST(Metrics, PerfectRun_HasZeroErrors) {
  const Metrics m = measure(trace_with([](int, Trace&, double*) {}), one_joint(), from_half());
  EXPECT_EQ(m.rows, 500);
  EXPECT_EQ(m.start, 0.5);
  EXPECT_NEAR(m.force_mean, 30.0, 1e-12);
  EXPECT_NEAR(m.force_mae, 0.0, 1e-9);
  EXPECT_NEAR(m.force_peak_raw, 0.0, 1e-12);
  EXPECT_EQ(m.without_contact, 0.0);
  EXPECT_NEAR(m.overshoot.value_or(-1.0), 0.0, 1e-9);
  EXPECT_EQ(m.position_p95, 0.0);
  EXPECT_EQ(m.orientation_drift, 0.0);
  EXPECT_NEAR(m.joint_margin, 1.0, 1e-12);
  EXPECT_EQ(m.tightest_joint, "hinge");
  EXPECT_EQ(m.torque_margin, 1.0);
  EXPECT_FALSE(m.solver.has_value());
}

TEST(Metrics, ForceErrors_UseTheMovingAverage) {
  // A constant error of 2 N, and a ripple that averages out over 10 ms.
  const Metrics m = measure(trace_with([](int row, Trace& trace, double* values) {
                              values[trace.index("tool_force_z_world")] =
                                  32.0 + (row % 2 == 0 ? 5.0 : -5.0);
                            }),
                            one_joint(), from_half());
  EXPECT_NEAR(m.force_mean, 32.0, 1e-9);
  EXPECT_NEAR(m.force_mae, 2.0, 0.02);
  EXPECT_NEAR(m.force_rmse, 2.0, 0.02);
  EXPECT_NEAR(m.force_peak, 2.0, 1.1);
  EXPECT_NEAR(m.force_rmse_raw, std::sqrt(2.0 * 2.0 + 5.0 * 5.0), 1e-9);
  EXPECT_NEAR(m.force_peak_raw, 7.0, 1e-9);
  EXPECT_NEAR(m.estimate_rmse, std::sqrt(2.0 * 2.0 + 5.0 * 5.0), 1e-9);
}

TEST(Metrics, Errors_UseNormalForceAndTangentialDistance) {
  const auto change = [](int, Trace& trace, double* values) {
    values[trace.index("tool_force_x_world")] = 9.0;  // friction
    values[trace.index("tool_z_world")] = -3e-3;      // sinks in
    values[trace.index("tool_y_world")] = 4e-3;       // off the path
  };
  const Metrics m = measure(trace_with(change), one_joint(), from_half());
  EXPECT_NEAR(m.force_peak, 0.0, 1e-9);
  EXPECT_NEAR(m.position_mean, 4e-3, 1e-12);
  EXPECT_NEAR(m.position_rmse, 4e-3, 1e-12);
  EXPECT_NEAR(m.position_p95, 4e-3, 1e-12);
  MetricsSpec sideways = from_half();
  sideways.normal_world = Eigen::Vector3d(2.0, 0.0, 0.0);
  const Metrics other = measure(trace_with(change), one_joint(), sideways);
  EXPECT_NEAR(other.force_mean, 9.0, 1e-9);
  EXPECT_NEAR(other.position_mean, 5e-3, 1e-12);
}

TEST(Metrics, LostContactOvershootAndImpact_AreMeasuredInTheirPhases) {
  const Metrics m = measure(trace_with([](int row, Trace& trace, double* values) {
                              double& force = values[trace.index("tool_force_z_world")];
                              double& contact = values[trace.index("in_contact")];
                              if (row < 100) contact = force = 0.0;
                              if (row >= 100 && row < 103) force = 80.0;  // the impact
                              if (row >= 320 && row < 360) force = 34.0;  // after the ramp
                              if (row >= 600 && row < 650) contact = force = 0.0;
                            }),
                            one_joint(), from_half());
  EXPECT_NEAR(m.without_contact, 0.1, 1e-12);
  EXPECT_NEAR(m.impact_peak.value_or(0.0), 80.0, 1e-12);
  EXPECT_NEAR(m.overshoot.value_or(0.0), 4.0, 1e-9);
  EXPECT_NEAR(m.force_peak, 30.0, 1e-9);
}

TEST(Metrics, DriftAndSmallestMargins_AreFound) {
  const Metrics m = measure(trace_with([](int row, Trace& trace, double* values) {
                              values[trace.index("tool_rz_start")] = 0.5 + 0.2 * dt * row;
                              values[trace.index("q_hinge")] = row == 700 ? 1.7 : 0.0;
                              values[trace.index("tau_applied_hinge")] = row == 800 ? -9.0 : 1.0;
                              values[trace.index("limited_joints")] = row >= 900 ? 1.0 : 0.0;
                            }),
                            one_joint(), from_half());
  EXPECT_NEAR(m.orientation_drift, 0.2 * 0.499, 1e-9);
  EXPECT_NEAR(m.joint_margin, 0.3, 1e-12);
  EXPECT_NEAR(m.torque_margin, 0.1, 1e-12);
  EXPECT_NEAR(m.limited_torque, 0.2, 1e-12);
}

TEST(Metrics, TiltedTool_GivesTheAngleOfItsAxisToTheNormal) {
  const Trace inclined = trace_with([](int row, Trace& trace, double* values) {
    values[trace.index("tool_rx_start")] = row == 700 ? 0.3 : 0.0;
  });
  MetricsSpec spec = from_half();
  EXPECT_FALSE(measure(inclined, one_joint(), spec).tool_to_normal);
  // At the start the tool's z points along -y of the world, and its x presses down.
  spec.tool_start_world << 0, 1, 0, 0, 0, -1, -1, 0, 0;
  spec.tool_axis = Eigen::Vector3d(2.0, 0.0, 0.0);
  EXPECT_NEAR(measure(inclined, one_joint(), spec).tool_to_normal.value_or(-1.0), 0.0, 1e-9)
      << "a rotation about the pressing axis does not incline it";
  spec.tool_axis = Eigen::Vector3d(2.0, 0.2, 0.0);
  EXPECT_NEAR(measure(inclined, one_joint(), spec).tool_to_normal.value_or(-1.0), std::atan(0.1),
              1e-9);
  spec.tool_axis = Eigen::Vector3d::Zero();
  expect_words(refusal([&] { measure(inclined, one_joint(), spec); }),
               {"tool's axis", "direction"});
}

TEST(Metrics, SolverFigures_CountTicksOnly) {
  const Metrics m = measure(trace_with([](int row, Trace& trace, double* values) {
                              if (row % 10 != 0) return;
                              values[trace.index("tick")] = 1.0;
                              values[trace.index("solve_time")] = row == 990 ? 5e-3 : 1e-3;
                              values[trace.index("iterations")] = 2.0;
                              values[trace.index("missed_deadline")] = row == 990 ? 1.0 : 0.0;
                              values[trace.index("active_constraints")] = row >= 900 ? 3.0 : 0.0;
                              values[trace.index("constraint_violation")] = row == 990 ? 0.2 : 0.1;
                              values[trace.index("constraints_infeasible")] =
                                  row == 990 ? 1.0 : 0.0;
                              values[trace.index("clipped_torques")] = row == 800 ? 2.0 : 0.0;
                            }),
                            one_joint(), from_half());
  ASSERT_TRUE(m.solver.has_value());
  EXPECT_EQ(m.solver->updates, 50);
  EXPECT_EQ(m.solver->median, 1e-3);
  EXPECT_EQ(m.solver->maximum, 5e-3);
  EXPECT_EQ(m.solver->mean_iterations, 2.0);
  EXPECT_EQ(m.solver->missed_deadlines, 1);
  EXPECT_EQ(m.solver->at_limits, 10);
  EXPECT_EQ(m.solver->infeasible, 1);
  EXPECT_EQ(m.solver->constraint_violation, 0.2);
  EXPECT_EQ(m.solver->clipped, 1);
  const std::string text = metrics_text(m);
  EXPECT_NE(text.find(" 50 "), std::string::npos) << "a count must have no decimals\n" << text;
}

TEST(Metrics, Table_HasUnitsAndAlignedLines) {
  const Model model = one_joint();
  const Metrics m = measure(trace_with([](int, Trace&, double*) {}), model, from_half());
  const std::string table = metrics_table({{"first", m}, {"the second run", m}});
  EXPECT_NE(table.find("force_rmse"), std::string::npos) << table;
  EXPECT_NE(table.find("mm"), std::string::npos) << table;
  EXPECT_NE(table.find("the second run"), std::string::npos) << table;
  std::size_t width = table.find('\n');
  for (std::size_t at = 0; at < table.size(); at += width + 1)
    EXPECT_EQ(table.find('\n', at) - at, width) << "lines must have one width\n" << table;
  EXPECT_NE(metrics_text(m).find("hinge"), std::string::npos) << metrics_text(m);
  EXPECT_EQ(metrics_table({}), "");
}

TEST(Metrics, Text_StatesTheAveragingWindow) {
  const Model model = one_joint();
  const Trace trace = trace_with([](int, Trace&, double*) {});
  MetricsSpec spec = from_half();
  for (const auto& [average, rounded, words] :
       {std::tuple(0.010, 0.010, "mean over 10 ms"), std::tuple(0.0252, 0.025, "mean over 25 ms"),
        std::tuple(0.0, 0.0, "root mean square error of the force\n")}) {
    spec.average = average;
    const Metrics m = measure(trace, model, spec);
    EXPECT_NEAR(m.average, rounded, 1e-12);
    EXPECT_NE(metrics_text(m).find(words), std::string::npos) << metrics_text(m);
    std::string page;
    for (const PageMetric& metric : page_metrics(m)) page += metric.text + "\n";
    EXPECT_NE(page.find(average > 0.0 ? words : "square error of the force\n"), std::string::npos)
        << page;
    EXPECT_EQ(page.find('{'), std::string::npos) << page;
  }
}

TEST(Metrics, Text_HasNoUnreadableNumbers) {
  Metrics m;
  m.force_mean = 1e300;
  m.force_mae = -0.0;
  const std::string text = metrics_text(m);
  EXPECT_NE(text.find("1.00e+300"), std::string::npos) << text;
  EXPECT_EQ(text.find("-0.0"), std::string::npos) << text;
}

/// Returns the mean of a window, summed in extended precision.
double mean_about(const Eigen::VectorXd& x, Eigen::Index i, int width) {
  const Eigen::Index from = std::max<Eigen::Index>(0, i - width / 2);
  const Eigen::Index to = std::min(x.size(), i - width / 2 + width);
  long double sum = 0.0;
  for (Eigen::Index k = from; k < to; ++k) sum += x[k];
  return static_cast<double>(sum / static_cast<long double>(to - from));
}

TEST(MovingMean, AnyWidth_GivesTheMeanOfEveryWindow) {
  const Eigen::VectorXd x = Eigen::VectorXd::Random(137);
  for (const int width : {1, 2, 3, 7, 10, 64, 136, 137, 138, 500}) {
    const Eigen::VectorXd mean = moving_mean(x, width);
    for (Eigen::Index i = 0; i < x.size(); ++i)
      ASSERT_NEAR(mean[i], mean_about(x, i, width), 1e-14) << width << " " << i;
  }
  EXPECT_EQ(moving_mean(Eigen::VectorXd(), 5).size(), 0);
}

TEST(MovingMean, LongSignal_KeepsItsDigits) {
  const Eigen::VectorXd x = Eigen::VectorXd::Random(1'000'000).array() + 1e6;
  for (const int width : {20, 1000, 300'000}) {
    const Eigen::VectorXd mean = moving_mean(x, width);
    for (Eigen::Index i = 0; i < x.size(); i += width < 1000 ? 101 : 49'999)
      ASSERT_NEAR(mean[i] / mean_about(x, i, width), 1.0, 1e-12) << width << " " << i;
  }
}

TEST(Metrics, EmptyWindowsAndTraces_AreRefused) {
  const Model model = one_joint();
  const Trace trace = trace_with([](int, Trace&, double*) {});
  MetricsSpec spec;
  spec.start = 2.0;
  expect_words(refusal([&] { measure(trace, model, spec); }), {"no row", "2 s", "window"});
  spec = {};
  spec.normal_world = Eigen::Vector3d::Zero();
  expect_words(refusal([&] { measure(trace, model, spec); }), {"normal"});
  expect_words(refusal([&] { measure(Trace({{"time", "s"}}, 0), model); }), {"no row"});
}

}  // namespace
}  // namespace burnish
