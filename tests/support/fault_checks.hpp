// Checks of faults: the report, the fallback torque, and that the robot comes to rest.
#pragma once

#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "support/mpc_run.hpp"
#include "support/refusal.hpp"

namespace burnish::test {

/// Fallback torque at a state, without its spring: gravity compensation and damping.
inline Eigen::VectorXd fallback_torque(const Model& model, const Eigen::VectorXd& q,
                                       const Eigen::VectorXd& v) {
  ContactDynamics dynamics(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  EXPECT_EQ(dynamics.forward(q, zero, zero), Status::Ok);
  return dynamics.bias() - Fallback{}.damping * dynamics.mass_matrix() * v;
}

/// Expects the report of a fault at `time`, up to `tolerance` [s].
inline void expect_report(const FaultReport& fault, FaultKind kind, double time, double tolerance) {
  ASSERT_EQ(fault.kind, kind) << fault.text();
  EXPECT_NEAR(fault.time, time, tolerance) << fault.text();
  // The sentence of the report.
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.4f s", fault.time);
  testing::expect_words(fault.text(), {std::string(name_of(kind)) + " at ", seconds});
  // The last second of the trace: times in order, and the fault only in the last row.
  const Trace& trace = fault.last_second;
  const int last = trace.rows() - 1;
  ASSERT_EQ(trace.rows(), std::min(2000, static_cast<int>(std::lround(fault.time / 5e-4)) + 1));
  EXPECT_NEAR(trace.column("time")[last], fault.time, 1e-12);
  for (int row = 1; row <= last; ++row)
    ASSERT_NEAR(trace.column("time")[row] - trace.column("time")[row - 1], 5e-4, 1e-9) << row;
  EXPECT_EQ(trace.column("fault")[last], static_cast<double>(kind));
  for (int row = 0; row < last; ++row) ASSERT_EQ(trace.column("fault")[row], 0.0);
}

inline const Eigen::VectorXd& effort_of(MpcRun& run) {
  return run.mpc().problem().model().effort_limit;
}

/// Expects a latched fault: kind and trace unchanged, zero target force, the fallback torque.
inline void expect_fallback(MpcRun& run) {
  const FaultKind kind = run.mpc().fault().kind;
  const double time = run.mpc().fault().time;
  const int rows = run.mpc().fault().last_second.rows();
  ASSERT_EQ(run.run(0.02), Status::Ok);
  const Command& command = run.loop().command();
  const Measurement& seen = run.watched().seen;
  const Eigen::VectorXd wanted = fallback_torque(run.mpc().problem().model(), seen.q, seen.v);
  // Largest torque of the spring; fallback_test.cpp tests it exactly.
  const Eigen::ArrayXd spring = Fallback{}.saturation_fraction * effort_of(run).array();
  EXPECT_TRUE(((command.tau - wanted).array().abs() <= spring + 1e-9).all())
      << (command.tau - wanted).transpose();
  for (const ToolCommand& tool : command.tools) EXPECT_EQ(tool.target_force, 0.0);
  EXPECT_EQ(command.iterations, 0);
  EXPECT_EQ(run.mpc().fault().kind, kind);
  EXPECT_EQ(run.mpc().fault().time, time);
  EXPECT_EQ(run.mpc().fault().last_second.rows(), rows);
}

inline void expect_rest(MpcRun& run) {
  ASSERT_EQ(run.run(1.5), Status::Ok);
  EXPECT_LT(run.plant().v().norm(), 0.01);
  EXPECT_TRUE(run.watched().finite);
}

inline std::function<void(Measurement&)> between(double from, double to,
                                                 std::function<void(Measurement&)> change) {
  return [from, to, change = std::move(change)](Measurement& m) {
    const double time = m.time;
    if (time > from - 1e-9 && time < to - 1e-9) change(m);
  };
}

}  // namespace burnish::test
