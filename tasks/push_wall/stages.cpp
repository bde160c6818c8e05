// Stages of push_wall over time, with contacts and supports of hands and feet.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "ocp/position_limits.hpp"
#include "pressing/arm.hpp"
#include "pressing/foot_contacts.hpp"
#include "pressing/stage_terms.hpp"
#include "pressing/standing_terms.hpp"
#include "push_wall/pushing.hpp"

namespace burnish::push_wall {
namespace {

using Shared = std::shared_ptr<SearchState>;

/// Calls see(name, index) for both hands.
template <class See>
void each_hand(const Task& task, const See& see) {
  for (int h = 0; h < 2; ++h) see(task.hands[to_size(h)], h);
}

/// Returns the target position of the centre of mass in the world [m] while each hand pushes with
/// `force` [N].
/// - Small forces: the centre of mass stays, and the centre of pressure moves back to the middle of
///   the feet.
/// - Larger forces: the centre of mass moves towards the wall, and the centre of pressure stays.
/// The transition is rounded over 1 cm. The centre of mass moves on a circle about the ground point
/// below its start, so that the knees stay bent.
Eigen::Vector3d com_at(const Setting& setting, double force) {
  constexpr double rounding = 0.01;  // width of the rounding [m]
  const double length = setting.com_per_force.norm();
  if (!(length > 0.0)) return setting.com;
  const double beyond = force * length - setting.room;
  const double shift = 0.5 * (beyond + std::hypot(beyond, rounding));
  const double height = setting.com.z() - setting.scene.touches.front().surface.point.z();
  const double down = height - std::sqrt(std::max(0.0, height * height - shift * shift));
  return setting.com + shift / length * setting.com_per_force - down * Eigen::Vector3d::UnitZ();
}

struct Builder {
  const Task& task;
  const Setting& setting;
  const Model& model;
  Shared force_search;
  std::vector<ContactSpec> feet = pressing::foot_contacts(model, task.standing, setting.q_start);

  Eigen::VectorXd state_target() const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(model.nq + model.nv);
    x.head(model.nq) = setting.q_start;
    return x;
  }
  /// Returns the target of the centre of mass, which is nearer to the wall for larger forces.
  Signal com() const {
    return Signal::over_time(3, [task = task, setting = setting, force_search = force_search](
                                    double t, Eigen::Ref<Eigen::VectorXd> p) {
      p = com_at(setting, force_at(task, setting, *force_search, t));
    });
  }
  Signal hand_force() const {
    return Signal::over_time(3, [task = task, setting = setting, force_search = force_search](
                                    double t, Eigen::Ref<Eigen::VectorXd> f) {
      f.setZero();
      f[2] = force_at(task, setting, *force_search, t);
    });
  }
  Signal retreat_speed() const {
    return Signal::over_time(
        6, [task = task, begin = setting.release_end](double t, Eigen::Ref<Eigen::VectorXd> v) {
          v.setZero();
          const double T = task.retreat_duration;
          v[2] = task.clearance / T * pressing::smooth_rate((t - begin) / T);
        });
  }
  std::vector<CostTerm> everywhere() const {
    const Weights& w = task.weights;
    Eigen::VectorXd rows = Eigen::VectorXd::Constant(2 * model.nv, w.posture);
    rows.tail(model.nv).setConstant(w.velocity);
    rows.head<3>().setZero();  // the cost "balance" determines the position of the base
    rows.segment<3>(3).setConstant(task.standing.base);
    std::vector<CostTerm> terms{
        {.name = "state", .residual = residual::State{state_target()}, .weights = rows}};
    if (const ocp::PositionLimits range = ocp::position_limits(model); range.lower.size() > 0)
      terms.push_back({.name = "margins of joints",
                       .residual = residual::JointPosition{},
                       .weight = w.range,
                       .penalty = Penalty::barrier(range.lower.array() + w.range_margin,
                                                   range.upper.array() - w.range_margin)});
    for (CostTerm term : pressing::standing_costs(model, task.standing, setting.q_start)) {
      if (term.name == "balance") term.residual = residual::CenterOfMass{com()};
      terms.push_back(std::move(term));
    }
    each_hand(task, [&](const std::string& hand, int) {
      const Eigen::Matrix3d R = frame_placement(model, setting.q_start, hand).linear();
      terms.push_back(
          {.name = "inclination of " + hand,
           .residual = residual::FrameInclination{hand, Reference::world(setting.wall_axes),
                                                  R.transpose() * setting.wall_axes.col(2)},
           .weight = w.inclination});
    });
    return terms;
  }
  CostTerm place(const std::string& hand, int h, double along_normal) const {
    const Eigen::Vector3d start = frame_placement(model, setting.q_start, hand).translation();
    return pressing::place_cost(
        "place of " + hand, hand,
        Eigen::VectorXd(along_normal > 0.0 ? start : setting.p_hands.col(h)),
        Reference::world(setting.wall_axes), task.weights.position, along_normal);
  }
  CostTerm move(const std::string& hand, const Signal& speed) const {
    return pressing::normal_speed_cost("speed of " + hand, hand, speed,
                                       Reference::centered(setting.wall_axes),
                                       task.weights.approach);
  }
  CostTerm press(const std::string& hand) const {
    return {.name = "force of " + hand,
            .residual = residual::ContactForce{hand, {}, hand_force()},
            .weights =
                Eigen::Vector3d(task.weights.friction, task.weights.friction, task.weights.force)};
  }
  /// Adds constraints on the friction of a hand and, if a band is stated, on its force.
  void keep_hand(const std::string& hand, std::vector<Constraint>& rows) const {
    rows.push_back({.name = "friction of " + hand,
                    .residual = residual::FrictionCone{hand, task.wall.plan_friction}});
    const double band = task.constraints.force_band;
    if (!std::isfinite(band)) return;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    rows.push_back({.name = "force band of " + hand,
                    .residual = residual::ContactForce{hand, {}, hand_force()},
                    .lower = Eigen::Vector3d(-infinity, -infinity, -band),
                    .upper = Eigen::Vector3d(infinity, infinity, band),
                    .scale = Eigen::Vector3d::Constant(task.force)});
  }
  Eigen::VectorXd rest_control() const {
    RigidBody body(model);
    if (!is_usable(body.update(setting.q_start, Eigen::VectorXd::Zero(model.nv))))
      throw Error("the starting posture cannot be evaluated");
    std::vector<TouchSpec> supports = setting.scene.touches;
    supports.resize(task.standing.feet.size());
    return pressing::torque_on_supports(model, body, supports, body.gravity_torque())
        .tail(model.nv - 6);
  }
  Stage stage(const std::string& name) const {
    Stage result{.name = name, .contacts = task.standing.feet, .costs = everywhere()};
    result.step = task.step;
    result.costs.push_back(pressing::torque_cost(rest_control(), task.weights.torque));
    result.constraints = pressing::joint_limits(model, task.constraints, setting.q_start);
    for (const Constraint& rows : pressing::torque_limits(model, task.constraints))
      result.constraints.push_back(rows);
    pressing::keep_standing(model, task.standing, feet, result);
    return result;
  }
  std::vector<Stage> stages() const {
    std::vector<Stage> all{stage("stand"), stage("approach"), stage("push"), stage("retreat")};
    each_hand(task, [&](const std::string& hand, int h) {
      all[0].costs.push_back(place(hand, h, 1.0));
      all[1].costs.push_back(place(hand, h, 0.0));
      all[1].costs.push_back(move(hand, pressing::normal_twist(-task.approach_speed)));
      all[2].contacts.push_back(hand);
      all[2].costs.push_back(press(hand));
      keep_hand(hand, all[2].constraints);
      all[3].costs.push_back(place(hand, h, 0.0));
      all[3].costs.push_back(move(hand, retreat_speed()));
    });
    return all;
  }
};

void check_hands(const Model& model, const Task& task) {
  for (const std::string& hand : task.hands)
    if (!model.has_frame(hand))
      throw EntryError("hands", "frame " + pressing::none_of(model, hand));
}

/// Sets the wall at `clearance` from the nearer hand, and the contact points of both hands.
void place_wall(const Task& task, Setting& s) {
  // Largest difference between the hands' distances to the wall [m], chosen by hand.
  constexpr double max_difference = 0.05;
  const Eigen::Vector3d n = s.wall_axes.col(2);
  Eigen::Vector2d height;
  each_hand(task, [&](const std::string& hand, int h) {
    s.p_hands.col(h) = frame_placement(s.robot.model, s.q_start, hand).translation();
    height[h] = s.p_hands.col(h).dot(n);
  });
  if (std::abs(height[0] - height[1]) > max_difference)
    throw EntryError("posture",
                     "hand " + in_quotes(task.hands[height[0] > height[1] ? 0 : 1]) + " is " +
                         number(std::abs(height[0] - height[1])) +
                         " m farther from the wall than the other hand; wanted at most " +
                         number(max_difference) + " m: another start, or another wall.normal");
  const double level = std::min(height[0], height[1]) - task.clearance;
  for (std::size_t h = 0; h < 2; ++h) s.p_hands.col(h) += (level - height[h]) * n;
}

/// Returns the scene with the feet on the ground and the hands on the wall, all modelled as
/// supports.
SceneSpec make_scene(const Task& task, const Setting& s) {
  const Eigen::Vector3d n = s.wall_axes.col(2);
  const SurfaceSpec wall{.point = s.p_hands.rowwise().mean() - task.tip_radius * n,
                         .normal = n,
                         .friction = task.wall.friction,
                         .stiffness = task.wall.stiffness,
                         .damping = task.wall.damping};
  SceneSpec scene;
  scene.touches = pressing::supports_at(s.robot.model, task.standing, s.q_start);
  each_hand(task, [&](const std::string& hand, int) {
    scene.touches.push_back(
        {.frame = hand, .radius = task.tip_radius, .surface = wall, .is_support = true});
  });
  return checked_scene(s.robot.model, scene);
}

/// Returns the ratio d / F [m/N]. F is the force of each hand, and d the horizontal displacement of
/// the centre of mass that leaves the centre of pressure in place. The hands push with F n at the
/// points r_i, seen from the ground point below the centre of mass. W is the weight. The moment
/// about the ground point is F m + d x (-W z) with m = sum r_i x n. Its horizontal part vanishes
/// for d = F / W (-m_y, m_x, 0).
Eigen::Vector3d com_per_force(const Setting& s, double weight, double ground) {
  const Eigen::Vector3d below(s.com.x(), s.com.y(), ground);
  Eigen::Vector3d m = Eigen::Vector3d::Zero();
  for (int h = 0; h < 2; ++h) m += (s.p_hands.col(h) - below).cross(s.wall_axes.col(2));
  return {-m.y() / weight, m.x() / weight, 0.0};
}

/// Returns the value of Setting::room, the distance of the centre of pressure at the start from the
/// middle of the feet [m].
double room_of(const Setting& s, std::size_t feet) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < feet; ++i)
    middle += s.scene.touches[to_size(i)].surface.point / static_cast<double>(feet);
  return std::max(0.0, (s.com - middle).dot(s.com_per_force.normalized()));
}

}  // namespace

std::string name_of(Limit limit) {
  static const std::array<const char*, 7> names{"none", "force_max", "statics", "tracking",
                                                "plan", "hand",      "foot"};
  return names[to_size(limit)];
}

const std::vector<std::string>& phase_names() {
  static const std::vector<std::string> names{"settle",       "approach", "ramp",    "hold",
                                              "force_search", "top",      "release", "retreat"};
  return names;
}

Robot load_task_robot(const Task& task) { return pressing::load_floating(task.robot); }

Setting make_setting(const Task& task) { return make_setting(task, load_task_robot(task)); }

Setting make_setting(const Task& task, const Robot& robot) {
  check_hands(robot.model, task);
  pressing::check_standing(robot.model, task.standing);
  Setting s;
  s.robot = robot;
  s.q_start = pressing::start_posture(robot, task.posture, []() -> Eigen::VectorXd {
    throw Error(
        "the robot does not have a default posture; wanted default_posture in its settings");
  });
  s.wall_axes = Reference::surface_with_normal(task.wall.normal_world.normalized()).rotation;
  place_wall(task, s);
  s.scene = make_scene(task, s);
  RigidBody body(robot.model);
  if (!is_usable(body.update(s.q_start, Eigen::VectorXd::Zero(robot.model.nv))))
    throw EntryError("posture", "the posture cannot be evaluated");
  s.com = body.com();
  s.com_per_force = com_per_force(s, body.mass() * robot.model.gravity.norm(),
                                  s.scene.touches.front().surface.point.z());
  s.room = room_of(s, task.standing.feet.size());
  s.touch = task.settle_duration + task.clearance / task.approach_speed;
  s.ramp_end = s.touch + task.ramp_duration;
  s.hold_end = s.ramp_end + task.hold_duration;
  s.search_end = s.hold_end + (force_max(task) - task.force) / task.force_search.rate;
  s.top_end = s.search_end + back_duration + task.force_search.hold_duration;
  s.release_end = s.top_end + task.release_duration;
  return s;
}

void refuse_out_of_reach(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  RigidBody body(model);
  if (!is_usable(body.update(setting.q_start, Eigen::VectorXd::Zero(model.nv)))) return;
  Eigen::VectorXd needed = body.gravity_torque();
  FrameDerivatives at;
  for (const std::string& hand : task.hands) {
    body.frame_derivatives(body.frame(hand), Reference::centered(), at);
    needed -= task.force * (at.jacobian.topRows<3>().transpose() * setting.wall_axes.col(2));
  }
  std::vector<TouchSpec> feet = setting.scene.touches;
  feet.resize(task.standing.feet.size());
  const Eigen::VectorXd torque = pressing::torque_on_supports(model, body, feet, needed);
  const Eigen::VectorXd limit = pressing::torque_limit(model, task.constraints);
  for (int k = 6; k < model.nv; ++k)
    if (std::abs(torque[k]) > limit[k])
      throw EntryError("force", "pushing with " + number(task.force) + " N at the start needs " +
                                    number(std::abs(torque[k])) + " Nm in joint " +
                                    in_quotes(model.v_name(k)) + "; wanted at most " +
                                    number(limit[k]) + " Nm: a smaller force, or another posture");
}

double force_at(const Task& task, const Setting& setting, const SearchState& force_search,
                double time) {
  if (time < setting.touch || time >= setting.release_end) return 0.0;
  const double reached = force_search.reached;
  const double largest = reached < 0.0 ? force_max(task) : reached;
  const auto between = [](double from, double to, double fraction) {
    return from + (to - from) * pressing::smooth(fraction);
  };
  if (time < setting.hold_end)
    return between(task.touch_force, task.force, (time - setting.touch) / task.ramp_duration);
  if (time < setting.search_end)
    return std::min(task.force + task.force_search.rate * (time - setting.hold_end), largest);
  const double held = task.force_search.hold_fraction * largest;
  if (time < setting.top_end)
    return between(largest, held, (time - setting.search_end) / back_duration);
  return between(held, task.touch_force, (time - setting.top_end) / task.release_duration);
}

pressing::Statics make_statics(const Task& task, const Setting& setting) {
  pressing::StaticsSpec spec{
      .feet = setting.scene.touches,
      .min_load = pressing::min_load_of(setting.robot.model, task.standing),
      .hands = task.hands,
      .normal_world = setting.wall_axes.col(2),
      .torque_limit = pressing::torque_limit(setting.robot.model, task.constraints)};
  spec.feet.resize(task.standing.feet.size());
  spec.feet = pressing::within_plans(std::move(spec.feet), task.standing);
  return {setting.robot.model, spec};
}

MpcSpec make_mpc(const Task& task, const Setting& setting, Shared force_search) {
  if (!force_search) force_search = std::make_shared<SearchState>();
  const Model& model = setting.robot.model;
  const Builder build{task, setting, model, force_search};
  MpcSpec mpc;
  mpc.problem.model = model;
  mpc.problem.contacts = build.feet;
  for (const std::string& hand : task.hands) {
    ContactSpec contact{.name = hand, .tool = hand, .directions = Directions::linear()};
    contact.reference = Reference::surface(setting.wall_axes);
    mpc.problem.contacts.push_back(contact.with_gains(0.0, task.wall.contact_kd));
  }
  pressing::set_standing(task.standing, mpc);
  mpc.supports.insert(mpc.supports.end(), task.hands.begin(), task.hands.end());
  for (const std::string& hand : task.hands) mpc.touches.push_back({hand});
  mpc.problem.initial_state = build.state_target();
  mpc.problem.stages = build.stages();
  mpc.problem.terminal = build.everywhere();
  for (CostTerm& term : mpc.problem.terminal) term.weight *= task.weights.terminal;
  mpc.problem.terminal_constraints =
      pressing::joint_limits(model, task.constraints, setting.q_start);
  mpc.problem.horizon = {
      {.stage = "stand", .knots = task.knots, .step = task.step, .duration = task.horizon}};
  mpc.schedule = {
      {.stage = "stand", .duration = task.settle_duration},
      {.stage = "approach", .duration = setting.touch - task.settle_duration, .until = "contact"},
      {.stage = "push", .duration = task.ramp_duration},
      {.stage = "push", .duration = task.hold_duration},
      {.stage = "push", .duration = setting.search_end - setting.hold_end, .until = "limit"},
      {.stage = "push", .duration = setting.top_end - setting.search_end},
      {.stage = "push", .duration = task.release_duration},
      {.stage = "retreat"}};
  for (std::size_t i = 0; i < mpc.schedule.size(); ++i) mpc.schedule[i].name = phase_names()[i];
  mpc.task = [task, setting, force_search](const MpcSpec& spec) -> std::unique_ptr<MpcTask> {
    return std::make_unique<Pushing>(spec, task, setting, force_search);
  };
  mpc.tick_period = 1.0 / task.tick_rate;
  mpc.update_period = 1.0 / task.update_rate;
  mpc.solver_delay = task.solver_delay;
  mpc.command_delay = task.command_delay;
  mpc.measurement_delay = task.measurement_delay;
  mpc.torque_limit = pressing::torque_limit(model, task.constraints);
  mpc.model_error = task.model_error;
  mpc.limits = task.limits;
  return mpc;
}

}  // namespace burnish::push_wall
