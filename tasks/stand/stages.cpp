// Stages of the task stand over time, with contacts of the feet and targets of the trunk.
#include <algorithm>
#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "pressing/arm.hpp"
#include "pressing/foot_contacts.hpp"
#include "pressing/foot_posture.hpp"
#include "pressing/found_standing.hpp"
#include "pressing/light_joints.hpp"
#include "pressing/stage_terms.hpp"
#include "pressing/standing_terms.hpp"
#include "pressing/steady_hold.hpp"
#include "stand/reach.hpp"
#include "stand/swaying.hpp"

namespace burnish::stand {
namespace {

constexpr const char* standing_stage = "stand";

struct Builder {
  const Task& task;
  const Setting& setting;
  const Model& model;
  std::vector<ContactSpec> feet = pressing::foot_contacts(model, setting.standing, setting.q_start);

  Eigen::VectorXd start_state() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(model.nq + model.nv);
    x.head(model.nq) = setting.q_start;
    return x;
  }
  /// Returns a signal. write(trunk, out) computes its value `out` from the target of the trunk.
  template <class Write>
  Signal of_trunk(int size, const Write& write) const {
    return Signal::over_time(
        size, [task = task, setting = setting, write](double t, Eigen::Ref<Eigen::VectorXd> out) {
          write(trunk_at(task, setting, t), out);
        });
  }
  Signal com() const {
    return of_trunk(3, [](const Trunk& trunk, Eigen::Ref<Eigen::VectorXd> p) { p = trunk.com; });
  }
  Signal base() const {
    return of_trunk(4, [](const Trunk& trunk, Eigen::Ref<Eigen::VectorXd> quaternion) {
      quaternion = Eigen::Quaterniond(trunk.base).coeffs();
    });
  }
  Signal momentum() const {
    return of_trunk(6,
                    [mass = model.total_mass()](const Trunk& trunk, Eigen::Ref<Eigen::VectorXd> h) {
                      h.setZero();
                      h.head<3>() = mass * trunk.com_velocity;
                    });
  }
  std::vector<CostTerm> everywhere() const {
    const Weights& w = task.weights;
    Eigen::VectorXd rows = Eigen::VectorXd::Constant(2 * model.nv, w.posture);
    rows.tail(model.nv).setConstant(w.velocity);
    rows.head<6>().setZero();  // the costs "balance" and "turn" determine the pose of the base
    rows.segment<6>(model.nv).setZero();  // the cost "momentum" determines the velocity of the base
    std::vector<CostTerm> terms{
        {.name = "state", .residual = residual::State{start_state()}, .weights = rows},
        {.name = "turn",
         .residual = residual::FrameRotation{setting.base, base()},
         .weight = setting.standing.base}};
    for (CostTerm term : pressing::standing_costs(model, setting.standing, setting.q_start)) {
      if (term.name == "balance") term.residual = residual::CenterOfMass{com()};
      if (term.name == "momentum") term.residual = residual::CentroidalMomentum{momentum()};
      terms.push_back(std::move(term));
    }
    return terms;
  }
  Eigen::VectorXd rest_control() const {
    RigidBody body(model);
    if (!is_usable(body.update(setting.q_start, Eigen::VectorXd::Zero(model.nv))))
      throw Error("the starting posture cannot be evaluated");
    return pressing::torque_on_supports(model, body, setting.scene.touches, body.gravity_torque())
        .tail(model.nv - 6);
  }
  Stage stage() const {
    Stage result{.name = standing_stage, .contacts = setting.standing.feet, .costs = everywhere()};
    result.step = task.step;
    result.costs.push_back(pressing::torque_cost(rest_control(), task.weights.torque));
    result.constraints = pressing::joint_limits(model, task.constraints, setting.q_start);
    for (const Constraint& rows : pressing::torque_limits(model, task.constraints))
      result.constraints.push_back(rows);
    pressing::keep_standing(model, setting.standing, feet, result);
    return result;
  }
};

/// Returns the scene with the feet on the ground.
SceneSpec make_scene(const Setting& s) {
  SceneSpec scene;
  scene.touches = pressing::supports_at(s.robot.model, s.standing, s.q_start);
  return checked_scene(s.robot.model, scene);
}

/// Returns the ground to draw: a plane at the height of the lowest foot, in the middle of the feet.
SurfaceSpec ground_below(const std::vector<TouchSpec>& feet) {
  SurfaceSpec ground{.friction = feet.front().surface.friction};
  for (const TouchSpec& foot : feet)
    ground.point += foot.surface.point / static_cast<double>(feet.size());
  for (const TouchSpec& foot : feet)
    ground.point.z() = std::min(ground.point.z(), foot.surface.point.z());
  return ground;
}

/// Returns horizontal axes with x forwards, computed from the yaw of the base.
Eigen::Matrix3d heading_of(const Eigen::Matrix3d& R_base) {
  const double yaw = std::atan2(R_base(1, 0), R_base(0, 0));
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

/// Returns the name of the task's posture. If the robot lacks this posture, returns
/// searched_posture, with a note, in two cases: the robot has no postures at all, or its feet were
/// found by search.
std::string posture_of(const Task& task, Setting& s) {
  const bool is_of_another = s.robot.postures.empty() || s.standing.feet != task.standing.feet;
  if (!is_of_another || task.posture.empty() || task.posture == searched_posture ||
      s.robot.postures.contains(task.posture))
    return task.posture;
  s.notes.push_back("posture: robot " + in_quotes(s.robot.model.name) +
                    " does not have the posture " + in_quotes(task.posture) +
                    "; a posture found by search replaces it");
  return searched_posture;
}

}  // namespace

const std::vector<std::string>& phase_names() {
  static const std::vector<std::string> names{"settle", "sway", "rest"};
  return names;
}

Robot load_task_robot(const Task& task) {
  Robot robot = pressing::load_floating(task.robot);
  std::vector<std::string> notes;  // not reported here, because make_setting() reports the notes
  const Standing standing = pressing::standing_on(robot, task.standing, notes);
  return pressing::light_joints_locked(std::move(robot), task.robot, standing);
}

Setting make_setting(const Task& task) { return make_setting(task, load_task_robot(task)); }

Setting make_setting(const Task& task, const Robot& robot) {
  Setting s;
  s.robot = robot;
  s.standing = pressing::standing_on(s.robot, task.standing, s.notes);
  const Model& model = s.robot.model;
  pressing::check_standing(model, s.standing);
  s.q_start = pressing::start_posture(s.robot, posture_of(task, s), [&] {
    const Eigen::VectorXd from =
        s.robot.default_posture.empty() ? model.q_neutral : s.robot.reference_configuration();
    const Eigen::VectorXd q = pressing::crouched_posture(model, s.standing, from, task.crouch);
    constexpr double tolerance = 0.01;
    const double crouch = pressing::crouch_at(model, s.standing, q);
    if (crouch < task.crouch - tolerance)
      s.notes.push_back("crouch: " + number(std::round(1e3 * crouch) / 1e3) +
                        " is used in place of " + number(task.crouch) +
                        ", because a lower base brings the legs to their limits");
    return q;
  });
  s.base = pressing::base_frame(model);
  s.scene = make_scene(s);
  s.ground = ground_below(s.scene.touches);
  const Eigen::Isometry3d base = frame_placement(model, s.q_start, s.base);
  s.R_base = base.linear();
  s.p_base = base.translation();
  s.heading = heading_of(s.R_base);
  RigidBody body(model);
  if (!is_usable(body.update(s.q_start, Eigen::VectorXd::Zero(model.nv))))
    throw EntryError("posture", "the posture cannot be evaluated");
  s.com = body.com();
  s.sway = task.sway;
  s.sway_end = task.settle_duration + task.sway_duration;
  if (task.sway.fit) s.sway = fitted_sway(task, s);
  return s;
}

MpcSpec make_mpc(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  const Builder build{task, setting, model};
  MpcSpec mpc;
  mpc.problem.model = model;
  mpc.problem.contacts = build.feet;
  mpc.problem.initial_state = build.start_state();
  mpc.problem.stages = {build.stage()};
  mpc.problem.terminal = build.everywhere();
  for (CostTerm& term : mpc.problem.terminal) term.weight *= task.weights.terminal;
  mpc.problem.terminal_constraints =
      pressing::joint_limits(model, task.constraints, setting.q_start);
  mpc.problem.horizon = {
      {.stage = standing_stage, .knots = task.knots, .step = task.step, .duration = task.horizon}};
  mpc.schedule = {{.stage = standing_stage, .duration = task.settle_duration},
                  {.stage = standing_stage, .duration = task.sway_duration},
                  {.stage = standing_stage}};
  for (std::size_t i = 0; i < mpc.schedule.size(); ++i) mpc.schedule[i].name = phase_names()[i];
  mpc.task = [task, setting](const MpcSpec& spec) -> std::unique_ptr<MpcTask> {
    return std::make_unique<Swaying>(spec, task, setting);
  };
  pressing::set_standing(setting.standing, mpc);
  mpc.tick_period = 1.0 / task.tick_rate;
  mpc.update_period = 1.0 / task.update_rate;
  mpc.solver_delay = task.solver_delay;
  mpc.command_delay = task.command_delay;
  mpc.measurement_delay = task.measurement_delay;
  mpc.torque_limit = pressing::torque_limit(model, task.constraints);
  mpc.model_error = task.model_error;
  mpc.limits = task.limits;
  mpc.fallback = pressing::steady_fallback(mpc, setting.scene.touches);
  return mpc;
}

std::vector<std::string> setting_notes(const Task& task, const Setting& setting) {
  std::vector<std::string> notes = setting.notes;
  for (std::string& note : sway_notes(task, setting)) notes.push_back(std::move(note));
  if (std::string ground = pressing::ground_note(setting.robot.model, setting.standing);
      !ground.empty())
    notes.push_back(std::move(ground));
  const MpcSpec mpc = make_mpc(task, setting);
  const std::string left = pressing::directions_left_out(setting.standing, mpc.problem.contacts);
  if (!left.empty())
    notes.push_back(
        "standing.feet: the legs cannot move every foot in every direction independently; " + left +
        " depends on the other directions of the feet, so plans do not constrain it");
  const double scale = mpc.fallback.damping / setting.standing.fallback.damping;
  if (scale < 1.0)
    notes.push_back("standing.fallback: stiffness and damping are multiplied by " + number(scale) +
                    "; with larger gains, the light feet of this robot would shake on the ground");
  const double noise = task.disturbances.support_force_noise;
  const double used = pressing::for_feet(setting.robot.model, setting.standing, task.disturbances)
                          .support_force_noise;
  if (used < noise)
    notes.push_back("disturbances.support_force_noise: " + number(used) +
                    " N is used in place of " + number(noise) +
                    " N, because the feet carry a small load");
  return notes;
}

}  // namespace burnish::stand
