// Toy task: an arm in free motion; the test sets stages, events and quantities.
#pragma once

#include <memory>

#include "burnish/mpc/mpc.hpp"
#include "support/arm7.hpp"

namespace burnish::test {

/// Outputs of the toy task, shared by the test and the controller's task.
struct Toy {
  bool rings = false;             ///< the event "bell"
  double heat = 0.0, sway = 0.0;  ///< watched quantities, in this order; the limit is 1
  std::function<void(double, Command&)> aim = nullptr;
  int resets = 0, senses = 0, watches = 0;
  double dt = 0.0;  ///< last dt of the task's view [s]
};

class ToyTask final : public MpcTask {
 public:
  explicit ToyTask(std::shared_ptr<Toy> toy) : toy_(std::move(toy)) {}
  std::vector<std::string> events() const override { return {"bell"}; }
  std::vector<WatchedQuantity> watched() const override {
    return {{"heat", "K"}, {"sway", "m", FaultKind::SpeedLimit}};
  }
  void reset() noexcept override { ++toy_->resets; }
  unsigned sense(const TaskView& view) noexcept override {
    ++toy_->senses;
    toy_->dt = view.dt;
    return toy_->rings ? 1U : 0U;
  }
  void watch(const TaskView& /*view*/, std::span<Reading> out) noexcept override {
    ++toy_->watches;
    out[0] = {toy_->heat, 1.0};
    out[1] = {toy_->sway, 1.0};
  }
  std::vector<TraceColumn> signals() const override { return {{"heat", "K"}}; }
  void write_signals(std::span<double> values) const noexcept override { values[0] = toy_->heat; }
  void aim(double time, Command& command) override {
    if (toy_->aim) toy_->aim(time, command);
  }

 private:
  std::shared_ptr<Toy> toy_;
};

/// Rests for 20 ms, then until the event "bell" (30 ms by plan), then waves; ticks of 1 ms.
inline MpcSpec toy_spec(const std::shared_ptr<Toy>& toy = nullptr) {
  MpcSpec spec;
  spec.problem.model = arm7::model(Base::Fixed);
  const Model& model = spec.problem.model;
  spec.problem.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
  spec.problem.initial_state.head(model.nq) = arm7::ready();
  Eigen::VectorXd aside = spec.problem.initial_state;
  aside[1] += 0.3;
  const CostTerm torque{.residual = residual::Control{}, .weight = 1e-6};
  spec.problem.stages = {
      {.name = "rest",
       .costs = {{.residual = residual::State{spec.problem.initial_state}, .weight = 10.0}, torque},
       .step = 0.01},
      {.name = "wave",
       .costs = {{.residual = residual::State{aside}, .weight = 10.0}, torque},
       .step = 0.01}};
  spec.problem.horizon = {{"rest", 6}};
  spec.schedule = {
      {.name = "settle", .stage = "rest", .duration = 0.02},
      {.name = "wait", .stage = "rest", .duration = 0.03, .until = "bell", .hold = 0.01},
      {.name = "wave", .stage = "wave"}};
  if (!toy) spec.schedule[1].until.clear();
  if (toy) spec.task = [toy](const MpcSpec&) { return std::make_unique<ToyTask>(toy); };
  spec.tools = {{.frame = "tool"}};
  spec.tick_period = 1e-3;
  spec.update_period = 5e-3;
  spec.model_error.kind = ModelErrorKind::None;
  return spec;
}

/// Measurement at rest in the toy's first state, with wrenches of zero at the controller's touches.
inline Measurement toy_measurement(const MpcSpec& spec) {
  Measurement m;
  m.q = spec.problem.initial_state.head(spec.problem.model.nq);
  m.v = m.tau = Eigen::VectorXd::Zero(spec.problem.model.nv);
  m.wrenches.setZero(6, static_cast<Eigen::Index>(touches_of(spec).size()));
  return m;
}

}  // namespace burnish::test
