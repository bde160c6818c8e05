// The task as stages over time, events and watches.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/press_hold/press_hold.hpp"

namespace burnish::press_hold {
namespace {

constexpr double step = 0.01;            // s, of the knots
constexpr double position_weight = 1e4;  // 1/m^2

double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

/// What pressing watches, and how far the tool slips from its point.
class Holding final : public MpcTask {
 public:
  Holding(std::unique_ptr<MpcTask> pressing, const MpcSpec& spec, const Task& task,
          const Setting& setting)
      : pressing_(std::move(pressing)),
        tool_(RigidBody(spec.problem.model).frame(spec.tool)),
        tangents_(setting.surface_axes.leftCols<2>()),
        p_hold_(setting.p_hold),
        limit_(task.slip) {}

  std::vector<std::string> events() const override { return pressing_->events(); }
  std::vector<WatchedQuantity> watched() const override {
    std::vector<WatchedQuantity> all = pressing_->watched();
    all.push_back({"slip of the tool", "m"});
    return all;
  }
  void reset() noexcept override { pressing_->reset(); }
  unsigned sense(const TaskView& view) noexcept override { return pressing_->sense(view); }
  void watch(const TaskView& view, std::span<Reading> out) noexcept override {
    pressing_->watch(view, out.first(out.size() - 1));
    const Eigen::Vector3d off = view.body.placement(tool_).translation() - p_hold_;
    out.back() = {(tangents_.transpose() * off).norm(), limit_};
  }
  void aim(double time, Command& command) override { pressing_->aim(time, command); }

 private:
  std::unique_ptr<MpcTask> pressing_;
  int tool_;
  Eigen::Matrix<double, 3, 2> tangents_;
  Eigen::Vector3d p_hold_;
  double limit_;  ///< m
};

Eigen::VectorXd gravity_torque(const Setting& setting) {
  const Model& model = setting.robot.model;
  RigidBody body(model);
  if (body.update(setting.q_start, Eigen::VectorXd::Zero(model.nv)) != Status::Ok)
    throw Error("the starting posture cannot be evaluated");
  return body.gravity_torque();
}

/// Force at a time of the schedule, N.
double force_at(const Task& task, const Setting& setting, double time) {
  if (time < setting.touch || time >= setting.hold_end) return 0.0;
  return task.touch_force +
         (task.force - task.touch_force) * smooth((time - setting.touch) / task.ramp_duration);
}

/// The posture's reference, at rest before and behind its way.
Signal posture(const Task& task, const Setting& setting) {
  const Eigen::Index nq = setting.q_start.size(), nv = setting.robot.model.nv;
  return Signal::over_time(
      static_cast<int>(nq + nv),
      [from = setting.q_start, way = Eigen::VectorXd(setting.q_aside - setting.q_start),
       begin = setting.ramp_end, T = task.aside_duration](double t, Eigen::Ref<Eigen::VectorXd> x) {
        x.setZero();
        x.head(from.size()) = from + smooth((t - begin) / T) * way;
      });
}

/// Speed of the tool along the normal.
CostTerm move(const Task& task, const Setting& setting, double speed) {
  Eigen::VectorXd target = Eigen::VectorXd::Zero(6), rows = target;
  target[2] = speed;
  rows[2] = 1.0;
  return {.name = "move",
          .residual =
              residual::FrameVelocity{task.tool, Reference::centered(setting.surface_axes), target},
          .weight = 1e2,
          .weights = rows};
}

std::vector<Stage> stages(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  Eigen::VectorXd rows = Eigen::VectorXd::Constant(2 * model.nv, task.posture_weight);
  rows.tail(model.nv).setConstant(0.1 * task.posture_weight);
  const CostTerm state{
      .name = "posture", .residual = residual::State{posture(task, setting)}, .weights = rows};
  const CostTerm point{.name = "point",
                       .residual = residual::FramePosition{task.tool, setting.p_hold,
                                                           Reference::world(setting.surface_axes)},
                       .weight = position_weight,
                       .weights = Eigen::Vector3d(1.0, 1.0, 0.0)};
  const CostTerm torque{
      .name = "torque", .residual = residual::Control{gravity_torque(setting)}, .weight = 1e-4};
  const CostTerm force{
      .name = "force",
      .residual = residual::ContactForce{"surface",
                                         {},
                                         Signal::over_time(1,
                                                           [task, setting](double t, auto f) {
                                                             f[0] = force_at(task, setting, t);
                                                           })},
      .weight = 1.0};
  const double away = task.clearance / task.retreat_duration;
  return {{.name = "approach",
           .costs = {state, point, torque, move(task, setting, -task.approach_speed)},
           .step = step},
          {.name = "press",
           .contacts = {"surface"},
           .costs = {state, point, torque, force},
           .step = step},
          {.name = "retreat",
           .costs = {state, point, torque, move(task, setting, away)},
           .step = step}};
}

}  // namespace

const std::vector<std::string>& phase_names() {
  static const std::vector<std::string> names{"approach", "ramp", "aside", "hold", "retreat"};
  return names;
}

Setting make_setting(const Task& task) {
  Setting s;
  RobotOverrides overrides;
  overrides.carrying = task.tool;
  s.robot = load_robot(task.robot, overrides);
  const Model& model = s.robot.model;
  (void)model.frame_index(task.tool);
  s.q_start =
      task.posture.empty() ? s.robot.reference_configuration() : s.robot.posture(task.posture);
  s.q_aside = s.q_start;
  for (const auto& [name, way] : task.aside) {
    std::vector<std::string> names;
    const Joint* found = nullptr;
    for (const Joint& joint : model.joints) {
      if (joint.nq == 1) names.push_back(joint.name);
      if (joint.nq == 1 && joint.name == name) found = &joint;
    }
    if (found == nullptr)
      throw Error("aside: " + in_quotes(name) + " is no joint of robot " + in_quotes(model.name) +
                  " with one position" + did_you_mean(name, names));
    double& q = s.q_aside[found->q_index];
    q += way;
    if (q < model.q_lower[found->q_index] || q > model.q_upper[found->q_index])
      throw Error("aside: joint " + in_quotes(name) + " would go to " + number(q) +
                  ", beyond its limits of " + number(model.q_lower[found->q_index]) + " to " +
                  number(model.q_upper[found->q_index]));
  }
  SceneSpec scene;
  scene.tip = {task.tool, task.tip_radius};
  s.scene = scene_under_tip(model, s.q_start, task.normal_world, scene, task.clearance);
  const Eigen::Vector3d n = s.scene.surface.normal;
  s.surface_axes = Reference::surface_with_normal(n).rotation;
  s.p_hold = frame_placement(model, s.q_start, task.tool).translation() - task.clearance * n;
  s.touch = task.clearance / task.approach_speed;
  s.ramp_end = s.touch + task.ramp_duration;
  s.hold_end = s.ramp_end + task.aside_duration + task.hold_duration;
  return s;
}

MpcSpec make_mpc(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  MpcSpec mpc;
  mpc.problem.model = model;
  ContactSpec contact{.name = "surface", .tool = task.tool, .directions = Directions::z()};
  contact.reference = Reference::surface(setting.surface_axes);
  mpc.problem.contacts = {contact.with_gains(0.0, 40.0)};
  mpc.problem.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
  mpc.problem.initial_state.head(model.nq) = setting.q_start;
  mpc.problem.stages = stages(task, setting);
  const auto& costs = mpc.problem.stages.front().costs;
  mpc.problem.terminal = {costs[0], costs[1]};
  for (CostTerm& term : mpc.problem.terminal) term.weight *= 0.1;
  mpc.problem.horizon = {{"approach", 50}};
  mpc.schedule = {{.stage = "approach", .duration = setting.touch, .until = "contact"},
                  {.stage = "press", .duration = task.ramp_duration},
                  {.stage = "press", .duration = task.aside_duration},
                  {.stage = "press", .duration = task.hold_duration},
                  {.stage = "retreat"}};
  for (std::size_t i = 0; i < mpc.schedule.size(); ++i) mpc.schedule[i].name = phase_names()[i];
  const PressingTask pressing{
      .touch = {Touch::Due, Touch::Wanted, Touch::Wanted, Touch::Wanted, Touch::Leaving},
      .target = [task, setting](double time) {
        return TaskTarget{setting.p_hold, force_at(task, setting, time)};
      }};
  mpc.task = [pressing, task, setting](const MpcSpec& spec) -> std::unique_ptr<MpcTask> {
    return std::make_unique<Holding>(pressing(spec), spec, task, setting);
  };
  mpc.tool = task.tool;
  mpc.normal_world = setting.scene.surface.normal;
  mpc.tick_period = mpc.update_period = 1.0 / task.tick_rate;
  mpc.model_error.bandwidth = 150.0;
  return mpc;
}

}  // namespace burnish::press_hold
