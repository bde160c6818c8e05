// Stages of press_hold over time, with events and monitors.
#include <algorithm>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/press_hold/press_hold.hpp"
#include "pressing/arm.hpp"
#include "pressing/posture_search.hpp"
#include "pressing/reach_walk.hpp"
#include "pressing/stage_terms.hpp"
#include "pressing/tool_direction.hpp"

namespace burnish::press_hold {
namespace {

/// Monitor with the checks of a PressingTask and a limit on the slip of the tool from its point of
/// contact.
class Holding final : public MpcTask {
 public:
  Holding(std::unique_ptr<MpcTask> pressing, const MpcSpec& spec, const Task& task,
          const Setting& setting)
      : pressing_(std::move(pressing)),
        tool_(RigidBody(spec.problem.model).frame(spec.tools.front().frame)),
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
  double limit_;  ///< Largest allowed slip [m].
};

/// Returns the target force at a time of the schedule [N].
double force_at(const Task& task, const Setting& setting, double time) {
  if (time < setting.touch || time >= setting.hold_end) return 0.0;
  return task.touch_force + (task.force - task.touch_force) *
                                pressing::smooth((time - setting.touch) / task.ramp_duration);
}

/// Returns the target state over time: a smooth motion from q_start to q_aside, with rest before
/// and after the motion.
Signal posture(const Task& task, const Setting& setting) {
  const Eigen::Index nq = setting.q_start.size(), nv = setting.robot.model.nv;
  return Signal::over_time(
      static_cast<int>(nq + nv),
      [from = setting.q_start, displacement = Eigen::VectorXd(setting.q_aside - setting.q_start),
       begin = setting.ramp_end, T = task.aside_duration](double t, Eigen::Ref<Eigen::VectorXd> x) {
        x.setZero();
        x.head(from.size()) = from + pressing::smooth((t - begin) / T) * displacement;
      });
}

std::vector<Stage> stages(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  Eigen::VectorXd rows = Eigen::VectorXd::Constant(2 * model.nv, task.posture_weight);
  rows.tail(model.nv).setConstant(0.1 * task.posture_weight);
  std::vector<CostTerm> common{
      {.name = "posture", .residual = residual::State{posture(task, setting)}, .weights = rows},
      pressing::place_cost("point", task.tool, setting.p_hold,
                           Reference::world(setting.surface_axes), 1e4, 0.0)};
  common.push_back(pressing::torque_cost(pressing::rest_torque(model, setting.q_start), 1e-4));
  std::vector<Constraint> limits = pressing::joint_limits(model, task.constraints, setting.q_start);
  for (Constraint& torque : pressing::torque_limits(model, task.constraints))
    limits.push_back(std::move(torque));
  const auto stage = [&](const char* name, CostTerm own) {
    Stage result{.name = name, .costs = common, .constraints = limits, .step = 0.01};
    result.costs.push_back(std::move(own));
    return result;
  };
  const auto move = [&](double speed) {
    return pressing::normal_speed_cost("move", task.tool, pressing::normal_twist(speed),
                                       Reference::centered(setting.surface_axes), 1e2);
  };
  const Signal force = Signal::over_time(
      1, [task, setting](double t, auto f) { f[0] = force_at(task, setting, t); });
  std::vector<Stage> all{stage("approach", move(-task.approach_speed)),
                         stage("press", pressing::force_cost(force, 1.0)),
                         stage("retreat", move(task.clearance / task.retreat_duration))};
  all[1].contacts = {"surface"};
  all[1].constraints.push_back(pressing::force_limit(force, std::min(task.touch_force, task.force),
                                                     task.force, task.constraints));
  return all;
}

/// Returns `q` with the joints moved by the amounts in task.aside.
Eigen::VectorXd moved_aside(const Task& task, const Model& model, Eigen::VectorXd q) {
  std::vector<std::string> names;
  for (const Joint& joint : model.joints)
    if (joint.nq == 1) names.push_back(joint.name);
  for (const auto& [name, displacement] : task.aside) {
    const std::string entry = "aside." + name;
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw EntryError(entry, "robot " + in_quotes(model.name) + " does not have a joint " +
                                  in_quotes(name) + " with one coordinate" +
                                  did_you_mean(name, names));
    const int at =
        std::find_if(model.joints.begin(), model.joints.end(),
                     [&wanted = name](const Joint& joint) { return joint.name == wanted; })
            ->q_index;
    q[at] += displacement;
    if (q[at] < model.q_lower[at] || q[at] > model.q_upper[at])
      throw EntryError(entry, "joint " + in_quotes(name) + " would move from " +
                                  number(q[at] - displacement) + " to " + number(q[at]) +
                                  "; wanted a target within its limits, " +
                                  number(model.q_lower[at]) + " to " + number(model.q_upper[at]));
  }
  return q;
}

Setting setting_from(const Task& task, const Robot& robot, const Eigen::VectorXd& q_start) {
  Setting s;
  s.robot = robot;
  s.q_start = q_start;
  const Model& model = s.robot.model;
  const TouchSpec tool{
      .frame = task.tool,
      .radius = task.tip_radius,
      .surface = {.friction = task.friction, .stiffness = task.stiffness, .damping = task.damping}};
  s.scene.touches = {with_surface_at(model, q_start, task.normal_world, tool, task.clearance)};
  SurfaceSpec& surface = s.scene.tool().surface;
  const Eigen::Vector3d n = surface.normal;
  s.surface_axes = Reference::surface_with_normal(n).rotation;
  s.p_hold = frame_placement(model, q_start, task.tool).translation() - task.clearance * n;
  surface.point = s.p_hold - task.tip_radius * n;
  surface.extent = task.extent;
  s.touch = task.clearance / task.approach_speed;
  s.ramp_end = s.touch + task.ramp_duration;
  s.hold_end = s.ramp_end + task.aside_duration + task.hold_duration;
  return s;
}

Eigen::VectorXd search_start(const Task& task, const Robot& robot) {
  return pressing::search_posture({task.tool, task.tool_axis, task.normal_world, std::nullopt,
                                   task.tip_radius, task.clearance, task.force},
                                  robot.model, pressing::known_postures(robot),
                                  pressing::posture_options_of(task),
                                  [&](const Eigen::VectorXd& q) {
                                    return check_reach(task, setting_from(task, robot, q));
                                  })
      .q;
}

bool searches_posture(const Task& task, const Robot& robot) {
  return task.posture.empty() ? robot.default_posture.empty()
                              : !robot.postures.contains(task.posture);
}

}  // namespace

const std::vector<std::string>& phase_names() {
  static const std::vector<std::string> names{"approach", "ramp", "aside", "hold", "retreat"};
  return names;
}

Robot load_task_robot(const Task& task) {
  Robot robot = pressing::load_arm(task.robot, task.tool);
  if (searches_posture(task, robot))
    pressing::note_tool_direction(task.tool, task.tool_axis, robot.model, robot.notes);
  return robot;
}

namespace {

bool has_joint(const Model& model, const std::string& name) {
  return std::any_of(model.joints.begin(), model.joints.end(),
                     [&](const Joint& joint) { return joint.nq == 1 && joint.name == name; });
}

/// Returns the third of the joints that carry the tool, counted from the base. If fewer than three
/// joints carry it, returns the last of them.
const Joint& third_joint(const Model& model, const std::string& tool) {
  const int body = model.frames[to_size(model.frame_index(tool))].body;
  const Joint* last = nullptr;
  int count = 0;
  for (const int v : model.support(body)) {
    const auto j = to_size(model.joint_of_v[to_size(v)]);
    if (model.joints[j].nq != 1) continue;
    last = &model.joints[j];
    if (++count == 3) break;
  }
  if (last == nullptr)
    throw EntryError("aside", "robot " + in_quotes(model.name) +
                                  " does not have a joint with one coordinate between base and "
                                  "tool; wanted at least one");
  return *last;
}

}  // namespace

std::vector<std::string> fit_to_robot(Task& task, const Robot& robot) {
  const Model& model = robot.model;
  const std::string of_robot = "robot " + in_quotes(model.name) + " does not have ";
  std::vector<std::string> changes;
  if (!task.posture.empty() && task.posture != searched_posture &&
      !robot.postures.contains(task.posture)) {
    changes.push_back("posture: " + of_robot + "the posture " + in_quotes(task.posture) +
                      "; a posture found for the surface replaces it");
    task.posture = searched_posture;
  }
  if (task.aside.empty() || std::any_of(task.aside.begin(), task.aside.end(),
                                        [&](const auto& of) { return has_joint(model, of.first); }))
    return changes;
  const auto [stated, displacement] = *task.aside.begin();
  task.aside.clear();
  const Joint& joint = third_joint(model, task.tool);
  const double q = make_setting(task, robot).q_start[joint.q_index];
  const double above = model.q_upper[joint.q_index] - q, below = q - model.q_lower[joint.q_index];
  const double distance = displacement > 0.0 ? above : below;  // distance to the joint limit
  const bool reverses = distance < std::abs(displacement) && std::max(above, below) > distance;
  const double size = std::min(std::abs(displacement), 0.9 * std::max(above, below));
  task.aside[joint.name] = (displacement > 0.0) != reverses ? size : -size;
  changes.push_back("aside: " + of_robot + "joint " + in_quotes(stated) + "; joint " +
                    in_quotes(joint.name) + " moves instead, by " + number(task.aside[joint.name]) +
                    (joint.kind == JointKind::Prismatic ? " m" : " rad"));
  return changes;
}

Setting make_setting(const Task& task) { return make_setting(task, load_task_robot(task)); }

Setting make_setting(const Task& task, const Robot& robot) {
  pressing::refuse_floating_base(robot.model);
  Setting setting = setting_from(task, robot, pressing::start_posture(robot, task.posture, [&] {
                                   return search_start(task, robot);
                                 }));
  if (task.tool_axis && !searches_posture(task, robot))
    pressing::check_tool_axis(frame_placement(robot.model, setting.q_start, task.tool).linear() *
                                  task.tool_axis->normalized(),
                              setting.scene.tool().surface.normal, task.search.tilt);
  setting.q_aside = moved_aside(task, robot.model, setting.q_start);
  return setting;
}

ReachReport check_reach(const Task& task, const Setting& setting, const ReachOptions& options) {
  pressing::ReachWalk walk(setting.robot.model, setting.scene, setting.q_start, options, false);
  const Eigen::Vector3d above =
      setting.p_hold + task.clearance * setting.scene.tool().surface.normal;
  if (walk.visit_line(above, setting.p_hold, 0.0)) walk.visit({setting.p_hold, 0.0, task.force});
  return walk.report();
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
  mpc.problem.terminal_constraints =
      pressing::joint_limits(model, task.constraints, setting.q_start);
  mpc.problem.horizon = {{"approach", 50}};
  mpc.schedule = {{.stage = "approach", .duration = setting.touch, .until = "contact"},
                  {.stage = "press", .duration = task.ramp_duration},
                  {.stage = "press", .duration = task.aside_duration},
                  {.stage = "press", .duration = task.hold_duration},
                  {.stage = "retreat"}};
  for (std::size_t i = 0; i < mpc.schedule.size(); ++i) mpc.schedule[i].name = phase_names()[i];
  const PressingTask pressing{
      .touch = {Touch::Due, Touch::Wanted, Touch::Wanted, Touch::Wanted, Touch::Leaving},
      .target =
          [task, setting](double time) {
            return TaskTarget{setting.p_hold, force_at(task, setting, time)};
          },
      .limits = task.tool_limits};
  mpc.task = [pressing, task, setting](const MpcSpec& spec) -> std::unique_ptr<MpcTask> {
    return std::make_unique<Holding>(pressing(spec), spec, task, setting);
  };
  mpc.tools = {{.frame = task.tool,
                .normal_base = setting.scene.tool().surface.normal,
                .contact_threshold = task.contact_threshold}};
  mpc.tick_period = mpc.update_period = 1.0 / task.tick_rate;
  mpc.command_delay = task.command_delay;
  mpc.measurement_delay = task.measurement_delay;
  mpc.limits = task.limits;
  mpc.torque_limit = pressing::torque_limit(model, task.constraints);
  mpc.model_error.bandwidth = 150.0;
  mpc.model_error.transient_scale = 1.0;
  return mpc;
}

}  // namespace burnish::press_hold
