// Controller that computes a plan at every tick, for measuring how long a tick takes. Every tick
// receives the measurements of a robot that presses while at rest.
#pragma once

#include <string>
#include <utility>

#include "burnish/dynamics/placement.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish::polishing {

class PressingController {
 public:
  /// Creates a controller that plans at 1 kHz. `problem`: result of reference_problem() for the
  /// frame `tool`. Target and measured force are 30 N. `threads`: only thread options are used.
  PressingController(const ProblemSpec& problem, const std::string& tool,
                     const DdpOptions& threads = {})
      : controller_(spec(problem, tool, threads)) {
    const Model& model = problem.model;
    measured_.q = problem.initial_state.head(model.nq);
    measured_.v = Eigen::VectorXd::Zero(model.nv);
    measured_.tau = Eigen::VectorXd::Zero(model.nv);
    measured_.wrenches.setZero(6, 1);
    measured_.wrenches.col(0).head<3>() =
        frame_placement(model, measured_.q, tool).linear().transpose().col(2) * force;
  }

  void tick() {
    controller_.tick(measured_);
    measured_.time += period;
  }
  const FaultReport& fault() const { return controller_.fault(); }

 private:
  static constexpr double force = 30.0;   ///< Force of the reference problem [N].
  static constexpr double period = 1e-3;  ///< Period of ticks and plans [s].

  static MpcSpec spec(const ProblemSpec& problem, const std::string& tool,
                      const DdpOptions& threads) {
    MpcSpec result{.problem = problem};
    result.tools = {{.frame = tool}};
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
