// A controller that makes a new plan at every tick, and a robot that stands still and presses: what
// is timed where ticks are.
#pragma once

#include <string>
#include <utility>

#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish::polishing {

class PressingController {
 public:
  /// For polishing::reference_problem with `tool`; plans at 1 kHz, 30 N wanted and measured. Of the
  /// options those of threads are taken.
  PressingController(const ProblemSpec& problem, const std::string& tool,
                     const DdpOptions& threads = {})
      : controller_(spec(problem, tool, threads)) {
    const Model& model = problem.model;
    measured_.q = problem.initial_state.head(model.nq);
    measured_.v = Eigen::VectorXd::Zero(model.nv);
    measured_.tau = Eigen::VectorXd::Zero(model.nv);
    measured_.tool_force_world.z() = force;
  }

  void tick() {
    controller_.tick(measured_);
    measured_.time += period;
  }
  const FaultReport& fault() const { return controller_.fault(); }

 private:
  static constexpr double force = 30.0;   ///< N, of the reference problem
  static constexpr double period = 1e-3;  ///< s

  static MpcSpec spec(const ProblemSpec& problem, const std::string& tool,
                      const DdpOptions& threads) {
    MpcSpec result{.problem = problem};
    result.tool = tool;
    result.schedule = {{.stage = "press"}};
    result.task = PressingTask{.touch = {Touch::Wanted},
                               .target = [](double) { return TaskTarget{.force = force}; }};
    result.tick_period = result.update_period = period;
    result.solver.threads = threads.threads;
    result.solver.pin_threads = threads.pin_threads;
    result.model_error.kind = ModelErrorKind::None;
    return result;
  }

  MpcController controller_;
  Measurement measured_;
};

}  // namespace burnish::polishing
