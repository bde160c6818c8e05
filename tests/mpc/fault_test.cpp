// Every fault, made to happen in closed loop: what is reported, and that the robot comes to rest.
#include "burnish/mpc/fault.hpp"

#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/placement.hpp"
#include "support/mpc_run.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;

/// The documented fallback at a state: gravity compensation and damping.
Eigen::VectorXd fallback_torque(const Model& model, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& v) {
  ContactDynamics dynamics(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  EXPECT_EQ(dynamics.forward(q, zero, zero), Status::Ok);
  const Eigen::VectorXd inertia = dynamics.mass_matrix().diagonal();
  return dynamics.bias() - Fallback{}.damping * inertia.cwiseProduct(v);
}

/// The report of a fault at `time`, give or take `tolerance` s.
void expect_report(const FaultReport& fault, FaultKind kind, double time, double tolerance) {
  ASSERT_EQ(fault.kind, kind) << fault.text();
  EXPECT_NEAR(fault.time, time, tolerance) << fault.text();
  // The sentence.
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.4f s", fault.time);
  expect_words(fault.text(), {std::string(name_of(kind)) + " at ", seconds});
  // The last second: in order, and the fault in its last row alone.
  const Trace& trace = fault.last_second;
  const int last = trace.rows() - 1;
  ASSERT_EQ(trace.rows(), std::min(2000, static_cast<int>(std::lround(fault.time / 5e-4)) + 1));
  EXPECT_NEAR(trace.column("time")[last], fault.time, 1e-12);
  for (int row = 1; row <= last; ++row)
    ASSERT_NEAR(trace.column("time")[row] - trace.column("time")[row - 1], 5e-4, 1e-9) << row;
  EXPECT_EQ(trace.column("fault")[last], static_cast<double>(kind));
  for (int row = 0; row < last; ++row) ASSERT_EQ(trace.column("fault")[row], 0.0);
}

/// What latches: the kind, the trace, no force aimed at, the fallback's torque.
void expect_fallback(MpcRun& run) {
  const FaultKind kind = run.mpc().fault().kind;
  const double time = run.mpc().fault().time;
  const int rows = run.mpc().fault().last_second.rows();
  ASSERT_EQ(run.run(0.02), Status::Ok);
  const Command& command = run.loop().command();
  const Measurement& seen = run.watched().seen;
  const Eigen::VectorXd wanted = fallback_torque(run.mpc().problem().model(), seen.q, seen.v);
  EXPECT_LT((command.tau - wanted).norm(), 1e-9 * wanted.norm());
  EXPECT_EQ(command.target_force, 0.0);
  EXPECT_EQ(command.iterations, 0);
  EXPECT_EQ(run.mpc().fault().kind, kind);
  EXPECT_EQ(run.mpc().fault().time, time);
  EXPECT_EQ(run.mpc().fault().last_second.rows(), rows);
}

void expect_rest(MpcRun& run) {
  ASSERT_EQ(run.run(1.5), Status::Ok);
  EXPECT_LT(run.plant().v().norm(), 0.01);
  EXPECT_TRUE(run.watched().finite);
}

std::function<void(Measurement&)> between(double from, double to,
                                          std::function<void(Measurement&)> what) {
  return [from, to, what = std::move(what)](Measurement& m) {
    const double time = m.time;
    if (time > from - 1e-9 && time < to - 1e-9) what(m);
  };
}

TEST(Fault, stale_measurement_when_time_stands_still) {
  MpcCase wanted;
  wanted.spoil = between(0.6, 0.64, [](Measurement& m) { m.time = 0.5995; });
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.65), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::StaleMeasurement, 0.62, 1e-3);
  EXPECT_EQ(run.mpc().fault().limit, 0.02);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, stale_measurement_when_time_leaps) {
  MpcCase wanted;
  wanted.spoil = between(0.6, 100.0, [](Measurement& m) { m.time += 0.1; });
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.65), Status::Ok);
  const FaultReport& fault = run.mpc().fault();
  EXPECT_EQ(fault.kind, FaultKind::StaleMeasurement);
  EXPECT_NEAR(fault.value, 0.1005, 1e-9);
  EXPECT_NEAR(fault.time, 0.7, 1e-9);
  expect_fallback(run);
}

TEST(Fault, bad_measurement_of_any_kind) {
  const double nan = std::nan("");
  const std::vector<std::function<void(Measurement&)>> ways{
      [&](Measurement& m) { m.q[3] = nan; },
      [&](Measurement& m) { m.v[0] = nan; },
      [&](Measurement& m) { m.tau[5] = std::numeric_limits<double>::infinity(); },
      [&](Measurement& m) { m.tool_force_world[1] = nan; },
      [&](Measurement& m) { m.time = nan; },
      [](Measurement& m) { m.q.conservativeResize(5); },
      [](Measurement& m) { m.v.conservativeResize(7); },
      [](Measurement& m) { m.tau.resize(0); }};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    SCOPED_TRACE(i);
    MpcCase wanted;
    wanted.spoil = between(0.6, 0.63, ways[i]);
    MpcRun run(wanted);
    ASSERT_EQ(run.run(0.64), Status::Ok);
    expect_report(run.mpc().fault(), FaultKind::BadMeasurement, 0.61, 1e-3);
    expect_fallback(run);
    expect_rest(run);

    // The same for a single tick is bridged, whichever it is.
    for (const double when : {0.6, 0.6005}) {
      wanted.spoil = between(when, when + 5e-4, ways[i]);
      MpcRun bridged(wanted);
      ASSERT_EQ(bridged.polish(), Status::Ok);
      EXPECT_EQ(bridged.mpc().fault().kind, FaultKind::None) << bridged.mpc().fault().text();
      EXPECT_LT(bridged.metrics().force_mae, 0.1);
    }
  }
}

TEST(Fault, damping_dies_away_when_nothing_is_measured_any_more) {
  // Blind in the middle of a motion: the torque must not go on braking a velocity of long ago.
  MpcCase wanted;
  wanted.task.path.rate = 8.0;
  wanted.spoil =
      between(1.0, 100.0, [](Measurement& m) { m.q.setConstant(std::nan("")), m.v = m.q; });
  MpcRun run(wanted);
  ASSERT_EQ(run.run(1.02), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::BadMeasurement);
  const Model& model = run.mpc().problem().model();
  const Trace& last = run.mpc().fault().last_second;
  Eigen::VectorXd q(6), v(6);
  for (int k = 0; k < 6; ++k) {
    q[k] = last.column("q_" + model.q_name(k))[last.rows() - 1];
    v[k] = last.column("v_" + model.v_name(k))[last.rows() - 1];
  }
  ASSERT_GT(v.norm(), 0.1);
  const Eigen::VectorXd gravity = fallback_torque(model, q, Eigen::VectorXd::Zero(6));
  const Eigen::VectorXd damping = fallback_torque(model, q, v) - gravity;
  for (const double duration : {0.1, 0.4}) {
    ASSERT_EQ(run.run(duration), Status::Ok);
    const double share =
        std::exp(-Fallback{}.damping * (run.now() - 5e-4 - run.mpc().fault().time));
    const Eigen::VectorXd due = gravity + share * damping;
    EXPECT_LT((run.loop().command().tau - due).norm(), 1e-2 * damping.norm()) << duration;
  }
}

TEST(Fault, joint_out_of_range) {
  MpcCase wanted;
  double limit = 0.0;
  wanted.change = [&](MpcSpec& spec) {
    // The approach bends the elbow over this.
    limit = spec.problem.initial_state[5] - 0.002;
    spec.problem.model.q_lower[5] = limit;
    spec.problem.model.q_upper[5] = limit + 0.004;
    spec.limits.joint_margin = 1e-3;
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  const FaultReport& fault = run.mpc().fault();
  ASSERT_EQ(fault.kind, FaultKind::OutOfRange) << fault.text();
  EXPECT_EQ(fault.joint, 5);
  EXPECT_NE(fault.value, fault.limit);
  EXPECT_NEAR(fault.value, fault.limit, 2e-3);
  expect_report(fault, FaultKind::OutOfRange, fault.time, 1e-9);
  expect_words(fault.text(), {"joint out of range", "entry 5 of v"});
  expect_fallback(run);
  expect_rest(run);
}

/// Replaces the target of the tool's position in the stage "press".
void aim(MpcSpec& spec, const Signal::Function& function) {
  for (CostTerm& term : spec.problem.stages[2].costs)
    if (auto* position = std::get_if<residual::FramePosition>(&term.residual)) {
      const Signal before = position->target;
      position->target = Signal::over_time(3, [before, function](double t, auto p) {
        before.at(t, p);
        function(t, p);
      });
    }
}

TEST(Fault, solver_failed_when_there_is_no_target) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    aim(spec, [](double t, Eigen::Ref<Eigen::VectorXd> p) {
      if (t > 1.0) p[0] = std::nan("");
    });
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  // A second is in sight from 0.7 s on; the fifth update without a plan is 40 ms later.
  expect_report(run.mpc().fault(), FaultKind::SolverFailed, 0.76, 0.011);
  EXPECT_EQ(run.mpc().fault().value, 5.0);
  expect_words(run.mpc().fault().text(), {"no usable plan for 5 updates"});
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, solver_failed_when_a_function_throws) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    aim(spec, [](double t, const Eigen::Ref<Eigen::VectorXd>&) {
      if (t > 1.0) throw std::runtime_error("no such point");
    });
    spec.target = [target = spec.target](double t) {
      if (t > 0.72) throw std::runtime_error("no such target");
      return target(t);
    };
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.73), Status::Ok);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  EXPECT_NE(run.loop().command().status, Status::Ok);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::SolverFailed, 0.76, 0.011);
  expect_fallback(run);
}

TEST(Fault, solver_failed_at_once_when_the_first_plan_fails) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    spec.problem.stages[0].costs.push_back(
        {.name = "impossible",
         .residual = residual::FramePosition{
             "tool", Signal::over_time(3, [](double, Eigen::Ref<Eigen::VectorXd> p) {
               p.setConstant(std::nan(""));
             })}});
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.01), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::SolverFailed, 0.0, 0.0);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, is_none_when_a_few_updates_fail) {
  for (const bool throws : {false, true}) {
    bool broken = false;
    MpcCase wanted;
    wanted.change = [&](MpcSpec& spec) {
      aim(spec, [&](double, Eigen::Ref<Eigen::VectorXd> p) {
        if (broken && throws) throw std::runtime_error("broken");
        if (broken) p[1] = std::nan("");
      });
    };
    MpcRun run(wanted);
    ASSERT_EQ(run.run(0.795), Status::Ok);
    broken = true;
    ASSERT_EQ(run.run(0.04), Status::Ok);  // four updates
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None);
    broken = false;
    ASSERT_EQ(run.run(0.6), Status::Ok);
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
    EXPECT_LT(run.metrics().force_mae, 0.1) << throws;
    EXPECT_LT(run.metrics().position_rmse, 3e-4) << throws;
  }
}

TEST(Fault, solver_late_after_deadlines_in_a_row) {
  MpcCase wanted;
  wanted.task.limits.deadline = 0.0;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.1), Status::Ok);
  // The first solve may take its time; then five.
  expect_report(run.mpc().fault(), FaultKind::SolverLate, 0.05, 1e-9);
  EXPECT_EQ(run.mpc().fault().value, 5.0);
  const Trace::Column missed = run.loop().trace().column("missed_deadline");
  EXPECT_EQ(missed[0], 0.0);
  EXPECT_EQ(missed[20], 1.0);
  expect_fallback(run);
  expect_rest(run);
}

/// A plant whose surface is gone after a while.
class Vanishing final : public Plant {
 public:
  Vanishing(const Model& model, const SceneSpec& scene, double until)
      : until_(until), with_(make_ideal_plant(model, scene)) {
    SceneSpec far = scene;
    far.surface.point -= 10.0 * scene.surface.normal;
    without_ = make_ideal_plant(model, far);
  }
  const Model& model() const override { return with_->model(); }
  const SceneSpec& scene() const override { return with_->scene(); }
  double dt() const override { return with_->dt(); }
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept override {
    gone_ = false;
    return with_->reset(q, v);
  }
  Status step(const ConstVectorRef& tau, const Eigen::Vector3d& push) noexcept override {
    if (!gone_ && with_->time() > until_) {
      gone_ = true;
      if (without_->reset(with_->q(), with_->v()) != Status::Ok) return Status::NotFinite;
    }
    return now().step(tau, push);
  }
  double time() const override { return gone_ ? with_->time() + without_->time() : with_->time(); }
  const Eigen::VectorXd& q() const override { return now().q(); }
  const Eigen::VectorXd& v() const override { return now().v(); }
  const Eigen::Vector3d& contact_force_world() const override {
    return now().contact_force_world();
  }
  bool in_contact() const override { return now().in_contact(); }
  const Eigen::VectorXd& friction_torque() const override { return now().friction_torque(); }
  void save(PlantSnapshot& snapshot) const override { now().save(snapshot); }
  Status restore(const PlantSnapshot& snapshot) noexcept override {
    return now().restore(snapshot);
  }

 private:
  Plant& now() const { return gone_ ? *without_ : *with_; }
  double until_;
  bool gone_ = false;
  std::unique_ptr<Plant> with_, without_;
};

TEST(Fault, contact_lost_when_the_surface_is_taken_away) {
  MpcCase wanted;
  wanted.make_plant = [](const Model& model, const SceneSpec& scene) {
    return std::make_unique<Vanishing>(model, scene, 0.8);
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::ContactLost, 0.95, 2e-3);
  EXPECT_EQ(run.mpc().fault().limit, 0.15);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, unexpected_contact_in_the_reach) {
  MpcCase wanted;
  // The tool comes from 4 cm above and meets something 2 cm above the surface.
  const polishing::Setting setting = polishing::make_setting(wanted.task);
  wanted.task.reach_duration = 0.5;
  wanted.task.clearance = 0.005;
  wanted.task.point_world =
      setting.p_start - (wanted.task.tip_radius + 0.04) * wanted.task.normal_world;
  wanted.task.disturbances.surface_height = 0.02;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.6), Status::Ok);
  const FaultReport& fault = run.mpc().fault();
  ASSERT_EQ(fault.kind, FaultKind::UnexpectedContact) << fault.text();
  expect_report(fault, FaultKind::UnexpectedContact, fault.time, 1e-9);
  EXPECT_GT(fault.value, 15.0);
  const Trace::Column contact = run.loop().trace().column("in_contact");
  int touch = 0;
  while (contact[touch] == 0.0) ++touch;
  EXPECT_LT(fault.time - run.loop().trace().at(touch, 0), 0.01) << "within the window";
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, force_limit_when_the_tool_is_pushed_on) {
  MpcCase wanted;
  wanted.task.disturbances.pushes = {{0.8, 0.2, Eigen::Vector3d(0.0, 0.0, -150.0)}};
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::ForceLimit, 0.8025, 2.6e-3);
  EXPECT_GT(run.mpc().fault().value, 100.0);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, force_limit_is_not_a_single_sample) {
  // The touch-down on a rigid surface is an impulse: 0.1 Ns in a step of half a millisecond.
  MpcRun run({});
  ASSERT_EQ(run.polish(), Status::Ok);
  EXPECT_GT(run.loop().trace().column("tool_force_z_world").maxCoeff(), 100.0);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();

  MpcCase strict;
  strict.task.limits.force_window = 0.0;
  MpcRun hasty(strict);
  ASSERT_EQ(hasty.polish(), Status::Ok);
  EXPECT_EQ(hasty.mpc().fault().kind, FaultKind::ForceLimit);
}

TEST(Fault, speed_limit_of_the_tool_and_of_a_joint) {
  MpcCase wanted;
  wanted.task.limits.tool_speed = 0.2;
  wanted.task.disturbances.pushes = {{0.05, 0.2, Eigen::Vector3d(0.0, 100.0, 0.0)}};
  MpcRun tool(wanted);
  ASSERT_EQ(tool.run(0.3), Status::Ok);
  expect_report(tool.mpc().fault(), FaultKind::SpeedLimit, 0.15, 0.1);
  EXPECT_EQ(tool.mpc().fault().joint, -1);
  EXPECT_NEAR(tool.mpc().fault().value, 0.2, 0.02);
  expect_fallback(tool);
  expect_rest(tool);

  wanted.task.limits.tool_speed = 100.0;
  wanted.task.limits.joint_speed_ratio = 0.05;
  MpcRun joint(wanted);
  ASSERT_EQ(joint.run(0.3), Status::Ok);
  expect_report(joint.mpc().fault(), FaultKind::SpeedLimit, 0.15, 0.1);
  EXPECT_GE(joint.mpc().fault().joint, 0);
  expect_fallback(joint);
  expect_rest(joint);
}

TEST(Fault, is_cleared_by_a_reset) {
  MpcCase wanted;
  wanted.task.disturbances.pushes = {{0.8, 0.2, Eigen::Vector3d(0.0, 0.0, -150.0)}};
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_NE(run.mpc().fault().kind, FaultKind::None);
  run.reset();
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None);
  EXPECT_EQ(run.mpc().fault().last_second.rows(), 0);
  EXPECT_EQ(run.mpc().fault().text(), "no fault");
  ASSERT_EQ(run.run(0.7), Status::Ok);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None);
}

TEST(Fault, has_a_name_for_every_kind) {
  std::vector<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(FaultKind::SpeedLimit); ++kind) {
    FaultReport report;
    report.kind = static_cast<FaultKind>(kind);
    names.emplace_back(name_of(report.kind));
    EXPECT_EQ(report.text().rfind(names.back(), 0), 0U) << report.text();
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace burnish::test
