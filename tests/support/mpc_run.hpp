// Model predictive polishing with Talos' right arm on the ideal plant: a short task, and a loop
// whose measurements, specification and plant a test may change.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/tasks/polishing/stages.hpp"
#include "support/allocation_guard.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {

/// Ramp from 0.3 s to 0.5 s, then half a turn on a small circle. The horizon is short: 30 knots.
inline polishing::Task short_task() {
  polishing::Task task;
  task.robot = std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm";
  task.clearance = 5e-3;
  task.reach_duration = 0.1;
  task.approach_speed = 0.025;
  task.ramp_duration = 0.2;
  task.polish_duration = 1.0;
  task.path.radius = 0.02;
  task.path.start_up = 0.4;
  task.path.rate = 3.0;
  task.horizon = 0.3;
  // Settings that the tests depend on, independent of the defaults.
  task.update_rate = 100.0;
  task.tick_rate = 2000.0;
  task.step = 0.01;
  task.iterations = 1;
  task.contact_kd = 50.0;
  task.model_error.bandwidth = 100.0;
  task.model_error.transient_scale = 6.0;
  task.weights.posture = 0.1;
  task.weights.velocity = 1.0;
  task.weights.torque = 1e-4;
  task.weights.position = 1e4;
  task.weights.approach = 1e2;
  task.weights.rotation = 1.0;
  task.weights.force = 0.1;
  task.weights.terminal = 0.1;
  return task;
}

/// Controller around another controller: it changes measurements, counts allocations, and records
/// the largest torques.
class Watched final : public ControllerWrapper {
 public:
  explicit Watched(Controller& inner) : ControllerWrapper(inner) {}
  void reset() noexcept override {
    ControllerWrapper::reset();
    allocations = 0;
    ticks = 0;
  }
  const Command& tick(const Measurement& measurement) noexcept override {
    seen = measurement;
    if (spoil) spoil(seen);
    const AllocationGuard guard;
    const Command& command = ControllerWrapper::tick(seen);
    allocations += guard.count();
    ++ticks;
    finite = finite && command.tau.allFinite();
    largest = largest.size() == 0 ? Eigen::VectorXd(command.tau.cwiseAbs())
                                  : Eigen::VectorXd(largest.cwiseMax(command.tau.cwiseAbs()));
    return command;
  }

  std::function<void(Measurement&)> spoil;
  Measurement seen;  ///< measurement of the last tick, after `spoil`
  long allocations = 0;
  long ticks = 0;
  bool finite = true;
  Eigen::VectorXd largest;  ///< largest |tau| per joint, over all ticks
};

struct MpcCase {
  polishing::Task task = short_task();
  std::function<void(MpcSpec&)> change = nullptr;
  std::function<void(Measurement&)> spoil = nullptr;
  /// Makes the plant from model and scene; default: the ideal plant.
  std::function<std::unique_ptr<Plant>(const Model&, const SceneSpec&)> make_plant = nullptr;
};

/// Plant, controller and loop of a case, at its start.
class MpcRun {
 public:
  /// With `estimator`, measurements contain only the estimated base.
  explicit MpcRun(const MpcCase& test_case,
                  const std::optional<BaseEstimatorOptions>& estimator = std::nullopt)
      : task_(test_case.task), setting_(polishing::make_setting(task_)) {
    const Model model = plant_model(setting_.robot.model, task_.disturbances);
    const SceneSpec scene = plant_scene(setting_.scene, task_.disturbances);
    plant_ =
        test_case.make_plant ? test_case.make_plant(model, scene) : make_ideal_plant(model, scene);
    MpcSpec spec = polishing::make_mpc(task_, setting_);
    if (test_case.change) test_case.change(spec);
    mpc_ = std::make_unique<MpcController>(spec);
    watched_ = std::make_unique<Watched>(*mpc_);
    watched_->spoil = test_case.spoil;
    ClosedLoopOptions options;
    options.control_period = spec.tick_period;
    options.max_duration = 4.0;
    loop_ = std::make_unique<ClosedLoop>(*plant_, *watched_, task_.disturbances, options);
    if (estimator) loop_->estimate_base(setting_.robot.model, *estimator);
    reset();
  }

  void reset() {
    status_ = loop_->reset(setting_.q_start, Eigen::VectorXd::Zero(setting_.robot.model.nv));
  }
  Status run(double duration) {
    if (is_usable(status_)) status_ = loop_->run(duration);
    return status_;
  }
  /// Runs until shortly before the retreat, by the schedule's time, which jumps when contact is
  /// early.
  Status polish() {
    while (mpc_->schedule().time() < setting_.track_end - 0.02 &&
           now() < setting_.track_end + 0.5 && mpc_->fault().kind == FaultKind::None &&
           is_usable(run(plant_->dt()))) {
    }
    return status_;
  }
  Status polish_and_retreat() { return is_usable(polish()) ? run(0.5) : status_; }

  /// Metrics from 0.1 s after the ramp until shortly before the retreat.
  Metrics metrics() const {
    const Trace::Column phase = loop_->trace().column("phase");
    const Trace::Column time = loop_->trace().column("time");
    MetricsSpec spec;
    spec.start = infinity;
    for (int row = 0; row < loop_->trace().rows(); ++row) {
      if (phase[row] != static_cast<double>(Phase::Track)) continue;
      spec.start = std::min(spec.start, time[row] + 0.1);
      spec.end = time[row] - 0.01;
    }
    spec.normal_world = setting_.scene.tool().surface.normal;
    return measure(loop_->trace(), setting_.robot.model, spec);
  }
  double now() const { return plant_->time(); }
  const polishing::Setting& setting() const { return setting_; }
  MpcController& mpc() { return *mpc_; }
  Watched& watched() { return *watched_; }
  ClosedLoop& loop() { return *loop_; }
  Plant& plant() { return *plant_; }

 private:
  polishing::Task task_;
  polishing::Setting setting_;
  std::unique_ptr<Plant> plant_;
  std::unique_ptr<MpcController> mpc_;
  std::unique_ptr<Watched> watched_;
  std::unique_ptr<ClosedLoop> loop_;
  Status status_ = Status::Ok;
};

}  // namespace burnish::test
