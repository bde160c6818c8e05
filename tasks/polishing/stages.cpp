#include "burnish/tasks/polishing/stages.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/horizon.hpp"
#include "polishing/resting_hand.hpp"
#include "pressing/arm.hpp"
#include "pressing/foot_contacts.hpp"
#include "pressing/stage_terms.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::polishing {
namespace {

/// Returns the anchor of the surface: the frame that carries the surface, or the world.
Anchor carrier(const Task& task) {
  return task.surface_frame.empty() ? Anchor(Anchor::World) : Anchor(task.surface_frame);
}

/// Returns costs with which the frame that carries the surface follows the motion Task::waving.
std::vector<CostTerm> waving_costs(const Task& task, const Setting& setting) {
  if (task.surface_frame.empty()) return {};
  const Eigen::Isometry3d start =
      surface_placement(setting.robot.model, setting.q_start, setting.scene.tool().surface);
  const auto wave = [waving = task.waving, touch = setting.touch](double time) {
    const double t = std::max(0.0, time - touch);
    return pressing::smooth(t / waving.start_up) *
           std::sin(2.0 * std::numbers::pi * waving.frequency * t);
  };
  const Signal place = Signal::over_time(
      3, [wave, start, shift = task.waving.shift_world](double t, Eigen::Ref<Eigen::VectorXd> p) {
        p = start.translation() + wave(t) * shift;
      });
  const Signal rotation = Signal::over_time(
      4, [wave, start, turn = task.waving.turn_world](double t, Eigen::Ref<Eigen::VectorXd> xyzw) {
        const double angle = turn.norm();
        const Eigen::Vector3d axis =
            angle > 0.0 ? Eigen::Vector3d(turn / angle) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
        xyzw = (Eigen::Quaterniond(Eigen::AngleAxisd(wave(t) * angle, axis)) *
                Eigen::Quaterniond(start.linear()))
                   .normalized()
                   .coeffs();
      });
  return {{.name = "waving",
           .residual = residual::FramePosition{task.surface_frame, place},
           .weight = task.waving.position},
          {.name = "waving turn",
           .residual = residual::FrameRotation{task.surface_frame, rotation},
           .weight = task.waving.rotation}};
}

constexpr int time_input = 0;  // index of the input "time" of plans without preview

struct Builder {
  const Task& task;
  const Setting& setting;
  const Model& model;
  std::shared_ptr<const Path> path;
  std::vector<ContactSpec> feet = pressing::foot_contacts(model, task.standing, setting.q_start);

  Eigen::VectorXd state_target() const {
    const int filtered = task.torque_cutoff > 0.0 ? model.nv : 0;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(model.nq + model.nv + filtered);
    x.head(model.nq) = setting.q_start;
    if (filtered > 0) x.tail(filtered) = rest_torque();
    return x;
  }
  /// Returns the torque that holds the start posture against gravity and the force of a resting
  /// hand.
  Eigen::VectorXd rest_torque() const { return torque_at_start(task, setting); }
  /// Returns the entries of rest_torque() for joints with motors.
  Eigen::VectorXd rest_control() const {
    const Eigen::VectorXd torque = rest_torque();
    return task.standing.stands() ? Eigen::VectorXd(torque.tail(model.nv - 6)) : torque;
  }
  Signal position() const {
    // Captures copies, because the signal outlives this builder.
    return Signal::over_time(
        3, [task = task, setting = setting, path = path](double t, Eigen::Ref<Eigen::VectorXd> p) {
          p = task_point(task, setting, *path, t).p_world;
        });
  }
  Signal force() const {
    return Signal::of_inputs(1, [task = task, setting = setting, path = path](
                                    double t, const InputValues& inputs,
                                    Eigen::Ref<Eigen::VectorXd> f) {
      // Without preview, plans do not know how the force changes after the current time.
      if (!task.force_profile.preview && t > setting.ramp_end)
        t = std::clamp(t, setting.ramp_end, std::max(setting.ramp_end, inputs.scalar(time_input)));
      f[0] = task_point(task, setting, *path, t).force;
    });
  }
  /// Returns the reference frame with the axes `axes`, fixed in the frame that carries the surface.
  /// If no frame carries the surface, the reference frame is fixed in the world.
  Reference on_surface(const Eigen::Matrix3d& axes) const {
    const Anchor of = carrier(task);
    return {of, of, axes};
  }
  /// Returns the target rotation of the tool, relative to the frame that carries the surface. It is
  /// the rotation at the start; on curved surfaces, it turns with the normal at the target.
  Signal rotation() const {
    const Eigen::Matrix3d start =
        (surface_placement(model, setting.q_start, setting.scene.tool().surface).inverse() *
         frame_placement(model, setting.q_start, task.tool))
            .linear();
    if (task.shape.is_flat()) return Eigen::Quaterniond(start).coeffs();
    return Signal::over_time(4, [task = task, setting = setting, path = path, start](
                                    double t, Eigen::Ref<Eigen::VectorXd> xyzw) {
      const Eigen::Vector3d n = task_point(task, setting, *path, t).normal_world;
      xyzw = (Eigen::Quaterniond::FromTwoVectors(setting.surface_axes.col(2), n) *
              Eigen::Quaterniond(start))
                 .normalized()
                 .coeffs();
    });
  }
  std::vector<CostTerm> everywhere() const {
    const Weights& w = task.weights;
    const int ndx = static_cast<int>(2 * model.nv + (task.torque_cutoff > 0.0 ? model.nv : 0));
    Eigen::VectorXd rows = Eigen::VectorXd::Zero(ndx);
    rows.head(model.nv).setConstant(w.posture);
    rows.segment(model.nv, model.nv).setConstant(w.velocity);
    if (task.torque_cutoff > 0.0) rows.tail(model.nv).setConstant(w.torque);
    if (task.standing.stands()) {
      rows.head<3>().setZero();  // balance costs determine the position of the base
      rows.segment<3>(3).setConstant(task.standing.base);
    }
    std::vector<CostTerm> terms{
        {.name = "state", .residual = residual::State{state_target()}, .weights = rows},
        {.name = "rotation",
         .residual = residual::FrameRotation{task.tool, rotation(),
                                             on_surface(Eigen::Matrix3d::Identity())},
         .weight = w.rotation}};
    for (const CostTerm& term : waving_costs(task, setting)) terms.push_back(term);
    for (const CostTerm& term : pressing::standing_costs(model, task.standing, setting.q_start))
      terms.push_back(term);
    return terms;
  }
  CostTerm place(double normal_weight) const {
    return pressing::place_cost("position", task.tool, position(), on_surface(setting.surface_axes),
                                *task.weights.position, normal_weight);
  }
  /// Returns the target speed of the tool along the normal during the retreat, over the time of the
  /// schedule [m/s]. A target height could press the tool into a surface higher than modelled.
  Signal retreat_speed() const {
    return Signal::over_time(
        6, [task = task, begin = setting.track_end](double t, Eigen::Ref<Eigen::VectorXd> v) {
          v.setZero();
          const double T = task.retreat_duration;
          v[2] = task.clearance / T * pressing::smooth_rate((t - begin) / T);
        });
  }
  CostTerm move(const std::string& name, const Signal& target, const Eigen::Vector3d& n) const {
    return pressing::normal_speed_cost(
        name, task.tool, target,
        {Anchor::Tool, carrier(task), Reference::surface_with_normal(n).rotation},
        task.weights.approach);
  }
  /// Returns the surface normal at the end of the path.
  Eigen::Vector3d last_normal() const {
    return task_point(task, setting, *path, setting.track_end).normal_world;
  }

  Stage stage(const std::string& name, const std::vector<CostTerm>& extra, bool contact) const {
    Stage result{.name = name, .costs = everywhere(), .step = task.step};
    result.costs.push_back(pressing::torque_cost(rest_control(), task.weights.torque));
    result.contacts = task.standing.feet;
    for (const CostTerm& term : extra) result.costs.push_back(term);
    result.constraints = pressing::joint_limits(model, task.constraints, setting.q_start);
    for (const Constraint& rows : pressing::torque_limits(model, task.constraints))
      result.constraints.push_back(rows);
    for (const Constraint& rows :
         pressing::torque_rate_limits(model, task.constraints, task.torque_cutoff))
      result.constraints.push_back(rows);
    pressing::keep_standing(model, task.standing, feet, result);
    keep_resting(task.rest, result);
    if (!contact) return result;
    result.contacts.insert(result.contacts.begin(), "surface");
    const double min_force = task.force_profile.min_force(task.force);
    result.constraints.push_back(pressing::force_limit(
        force(), std::min(task.touch_force, min_force), task.force, task.constraints));
    return result;
  }
};

}  // namespace

namespace {

/// Computes the tip centre p over a point t of the tangent plane, and its velocity p'. Projecting t
/// along the plane's normal n0 onto the surface gives the point s. With the surface normal n at s,
/// its derivative H and the tip radius r:
///   s' = t' - n0 (n . t') / (n . n0),   p = s + r n,   p' = s' + r H s'.
void put_on(const Surface& surface, const Eigen::Vector3d& n0, double radius,
            const Eigen::Vector3d& in_plane, const Eigen::Vector3d& rate, TaskPoint& point) {
  const Eigen::Vector3d s = surface.along_normal(in_plane);
  const SurfaceDistance at = surface.at(s);
  const Eigen::Vector3d s_rate = rate - n0 * (at.normal.dot(rate) / at.normal.dot(n0));
  point.normal_world = at.normal;
  point.p_world = s + radius * at.normal;
  point.v_world = s_rate + radius * at.hessian * s_rate;
}

}  // namespace

TaskPoint point_on(const Task& task, const Setting& setting, const PlanarPoint& point) {
  const auto tangents = setting.surface_axes.leftCols<2>();
  const Eigen::Vector3d n = setting.scene.tool().surface.normal;
  TaskPoint result{.p_world = setting.p_center + tangents * point.p,
                   .v_world = tangents * point.v,
                   .a_world = tangents * point.a,
                   .normal_world = n};
  if (task.shape.is_flat()) return result;
  const Surface surface = surface_of(setting.scene.tool().surface);
  const Eigen::Vector3d in_plane = result.p_world - task.tip_radius * n;
  const Eigen::Vector3d rate = result.v_world, acceleration = result.a_world;
  put_on(surface, n, task.tip_radius, in_plane, rate, result);
  // Acceleration from a central difference of velocities along the path; the error is of second
  // order.
  constexpr double dt = 1e-4;  // step of the difference; chosen by hand [s]
  TaskPoint ends[2];
  for (const int side : {0, 1}) {
    const double t = side == 0 ? -dt : dt;
    put_on(surface, n, task.tip_radius, in_plane + t * rate + 0.5 * t * t * acceleration,
           rate + t * acceleration, ends[side]);
  }
  result.a_world = (ends[1].v_world - ends[0].v_world) / (2.0 * dt);
  return result;
}

TaskPoint task_point(const Task& task, const Setting& setting, const Path& path, double time) {
  const Eigen::Vector3d n = setting.scene.tool().surface.normal;
  const Eigen::Vector3d p_above = setting.p_center + task.clearance * n;
  const auto on_surface = [&](double t) { return point_on(task, setting, path.at(t)); };
  TaskPoint result{.normal_world = n};
  if (time < setting.reach_end) {
    result.p_world =
        setting.p_start + pressing::smooth(time / setting.reach_end) * (p_above - setting.p_start);
  } else if (time < setting.touch) {
    const double fraction = (time - setting.reach_end) / (setting.touch - setting.reach_end);
    result.p_world = p_above - fraction * task.clearance * n;
    result.v_world = -task.approach_speed * n;
  } else if (time < setting.track_end) {
    result = on_surface(time - setting.ramp_end);
    const double first = std::min(task.touch_force, task.force);
    result.force = time < setting.ramp_end
                       ? first + (task.force - first) *
                                     pressing::smooth((time - setting.touch) / task.ramp_duration)
                       : task.force_profile.at(task.force, time - setting.ramp_end);
  } else {
    result = on_surface(task.polish_duration);
    result.v_world.setZero();
    result.a_world.setZero();
    result.p_world += pressing::smooth((time - setting.track_end) / task.retreat_duration) *
                      task.clearance * result.normal_world;
  }
  return result;
}

namespace {
/// Returns whether plans use a surface that is curved or estimated at the tool.
bool follows_surface(const Task& task) {
  return task.axes == ForceAxes::Surface &&
         (task.surface_estimate.enabled || !task.shape.is_flat());
}

ContactSpec surface_contact(const Task& task, const Setting& setting) {
  ContactSpec contact{.name = "surface", .tool = task.tool, .directions = Directions::z()};
  if (!task.surface_frame.empty()) contact.base = task.surface_frame;
  contact.reference = Reference::surface(setting.surface_axes);
  if (follows_surface(task))
    contact.reference = Reference::on(surface_of(setting.scene.tool().surface)
                                          .at(setting.p_center)
                                          .quadric(setting.p_center, task.tip_radius),
                                      setting.p_center);
  const Eigen::Matrix3d axes_world =
      surface_placement(setting.robot.model, setting.q_start, setting.scene.tool().surface)
          .linear() *
      setting.surface_axes;
  if (task.axes == ForceAxes::World) contact.reference = Reference::centered(axes_world);
  if (task.axes == ForceAxes::Local) {
    const Eigen::Matrix3d R =
        frame_placement(setting.robot.model, setting.q_start, task.tool).linear();
    contact.reference = Reference::local(R.transpose() * axes_world);
  }
  if (task.friction_estimate.enabled || task.friction_estimate.coefficient > 0.0)
    contact.friction = SlidingFriction{task.friction_estimate.coefficient, task.friction_speed};
  contact.with_gains(0.0, task.contact_kd);
  return contact;
}
PressingTask pressing_task(const Task& task, const Setting& setting,
                           const std::shared_ptr<const Path>& path) {
  PressingTask pressing{
      .touch = {Touch::Free, Touch::Due, Touch::Wanted, Touch::Wanted, Touch::Leaving},
      .limits = task.tool_limits};
  if (!task.force_profile.preview) pressing.time_input = "time";
  pressing.target = [task, setting, path](double time) {
    const TaskPoint point = task_point(task, setting, *path, time);
    return TaskTarget{point.p_world, point.force};
  };
  if (follows_surface(task))
    pressing.surface =
        PressedSurface{task.shape, setting.scene.tool().surface.point,
                       setting.scene.tool().surface.normal, task.tip_radius, task.surface_estimate};
  return pressing;
}
}  // namespace

namespace {
/// Sets all options of the controller that do not depend on the target.
void set_controller(const Task& task, const Setting& setting, MpcSpec& mpc) {
  mpc.tools = {{.frame = task.tool,
                .base = task.surface_frame,
                .normal_base = setting.scene.tool().surface.normal,
                .contact_threshold = task.contact_threshold,
                .friction = task.friction_estimate}};
  mpc.tick_period = 1.0 / task.tick_rate;
  mpc.update_period = 1.0 / task.update_rate;
  mpc.timing = task.timing;
  mpc.solver_delay = task.solver_delay;
  mpc.command_delay = task.command_delay;
  mpc.measurement_delay = task.measurement_delay;
  mpc.slowdown = task.slowdown;
  mpc.solver.update = task.solver;
  mpc.solver.max_iterations = task.iterations;
  mpc.torque_limit = pressing::torque_limit(setting.robot.model, task.constraints);
  mpc.model_error = task.model_error;
  mpc.touches = {{task.tool, task.force_sensor ? WrenchSensor::Force : WrenchSensor::None}};
  mpc.limits = task.limits;
  mpc.fallback = task.fallback;
  mpc.feedback = task.feedback;
}
}  // namespace

MpcSpec make_mpc(const Task& task, const Setting& setting) {
  if (!task.model_error.transient_scale || !task.model_error.bandwidth || !task.weights.position) {
    Task fitted = task;
    (void)fit_gains(fitted, setting);
    return make_mpc(fitted, setting);
  }
  const Model& model = setting.robot.model;
  const auto path = std::make_shared<const Path>(task.path);
  const Builder build{task, setting, model, path};

  MpcSpec mpc;
  mpc.problem.model = model;
  ProblemSpec& problem = mpc.problem;
  if (!task.force_profile.preview) problem.inputs = {{.name = "time", .value = 0.0}};
  problem.contacts = {surface_contact(task, setting)};
  for (const ContactSpec& foot : build.feet) problem.contacts.push_back(foot);
  if (task.rest.is_stated()) problem.contacts.push_back(resting_contact(task));
  problem.initial_state = build.state_target();
  if (task.torque_cutoff > 0.0) problem.torque_model = TorqueModel{task.torque_cutoff};
  const CostTerm press = pressing::force_cost(build.force(), task.weights.force);
  problem.stages = {
      build.stage("reach", {build.place(1.0)}, false),
      build.stage(
          "approach",
          {build.place(0.0), build.move("approach", pressing::normal_twist(-task.approach_speed),
                                        setting.surface_axes.col(2))},
          false),
      build.stage("press", {build.place(0.0), press}, true),
      build.stage(
          "retreat",
          task.surface_frame.empty()
              ? std::vector<CostTerm>{build.place(0.0), build.move("retreat", build.retreat_speed(),
                                                                   build.last_normal())}
              // Has no cost on the speed relative to the world, because the surface moves.
              : std::vector<CostTerm>{build.place(1.0)},
          false)};
  problem.terminal = build.everywhere();
  problem.terminal.push_back(build.place(0.0));
  for (CostTerm& term : problem.terminal) term.weight *= task.weights.terminal;
  problem.terminal_constraints = pressing::joint_limits(model, task.constraints, setting.q_start);
  problem.horizon = {horizon_of(task, "reach")};

  // One entry per phase, in the order of the enum Phase.
  mpc.schedule = {
      {.stage = "reach", .duration = setting.reach_end},
      {.stage = "approach", .duration = setting.touch - setting.reach_end, .until = "contact"},
      {.stage = "press", .duration = task.ramp_duration},
      {.stage = "press", .duration = task.polish_duration},
      {.stage = "retreat"}};
  for (std::size_t i = 0; i < mpc.schedule.size(); ++i) mpc.schedule[i].name = phase_names()[i];
  mpc.task = pressing_task(task, setting, path);
  set_controller(task, setting, mpc);
  pressing::set_standing(task.standing, mpc);
  set_resting(task, mpc);
  return mpc;
}

std::string wants_plans(const Task& task) {
  if (!task.surface_frame.empty())
    return "surface.frame: controllers without a plan do not support a surface that the robot "
           "carries, here at " +
           in_quotes(task.surface_frame) + "; wanted no surface.frame, or the controller mpc";
  if (task.standing.stands())
    return "standing.feet: controllers without a plan do not keep balance; wanted a fixed base "
           "without feet, or the controller mpc";
  return {};
}

PressingPath pressing_path(const Task& task, const Setting& setting) {
  if (const std::string refusal = wants_plans(task); !refusal.empty()) throw Error(refusal);
  const auto path = std::make_shared<const Path>(task.path);
  PressingPath pressed;
  pressed.tool = task.tool;
  pressed.normal_world = setting.scene.tool().surface.normal;
  // In controllers without plans, time counts from the start of the path.
  pressed.task = [task, setting, path](double t) {
    TaskPoint point = task_point(task, setting, *path, setting.ramp_end + std::max(0.0, t));
    return point;
  };
  pressed.posture = setting.q_start;
  pressed.period = 1.0 / task.tick_rate;
  pressed.approach_speed = task.approach_speed;
  pressed.contact_threshold = task.contact_threshold;
  pressed.touch_force = task.touch_force;
  pressed.ramp = task.ramp_duration;
  return pressed;
}

ImpedanceSpec make_baseline(const Task& task, const Setting& setting) {
  return {pressing_path(task, setting), task.baseline};
}

AdmittanceSpec make_admittance(const Task& task, const Setting& setting) {
  return {pressing_path(task, setting), task.admittance};
}

}  // namespace burnish::polishing
