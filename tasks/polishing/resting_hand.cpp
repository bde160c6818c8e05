#include "polishing/resting_hand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"
#include "polishing/descriptions.hpp"
#include "pressing/arm.hpp"
#include "pressing/sliding.hpp"
#include "pressing/stage_terms.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::polishing {
namespace {

/// Factor on RestingHand::weight for the tangential force. push_wall has the same ratio of weights.
constexpr double tangential_factor = 1e-2;
/// Ratio of damping to stiffness of the plane in the plant, as for the wall in push_wall [s].
constexpr double plane_lag = 0.02;

int body_of(const Model& model, const std::string& frame) {
  return model.has_frame(frame) ? model.frames[to_size(model.frame_index(frame))].body : -1;
}

/// Throws EntryError if the hand is on the link of `frame`. `key`: key of `frame` in task files.
void refuse_same_link(const RestingHand& rest, const Model& model, const std::string& key,
                      const std::string& frame) {
  if (frame.empty() || body_of(model, frame) != body_of(model, rest.frame)) return;
  throw EntryError("rest.frame", "frame " + in_quotes(rest.frame) + " is on the link of " +
                                     in_quotes(frame) + " (" + key +
                                     "); wanted a hand on another link");
}

/// Throws EntryError if the hand is on the base or on a link of the leg of `foot`.
void refuse_leg(const RestingHand& rest, const Model& model, const std::string& foot) {
  const int hand = body_of(model, rest.frame);
  for (int body = body_of(model, foot); body >= 0; body = model.joints[to_size(body)].parent)
    if (body == hand)
      throw EntryError("rest.frame", "frame " + in_quotes(rest.frame) + " carries foot " +
                                         in_quotes(foot) +
                                         " (standing.feet); wanted a hand outside legs and base");
}

/// Throws EntryError if `rest` states other keys but no frame of the hand.
void refuse_nameless(const RestingHand& rest) {
  const auto numbers = [](const RestingHand& of) {
    return std::array{of.force,     of.radius, of.friction, of.plan_friction,
                      of.stiffness, of.weight, of.slip};
  };
  const RestingHand usual;
  if (numbers(rest) != numbers(usual) || rest.normal_world != usual.normal_world)
    throw EntryError("rest.frame",
                     "no hand is stated, but other keys of rest are; wanted the "
                     "frame of the hand");
}

/// Returns the generalized force (nv) of the plane on the hand, at the state of `body`.
Eigen::VectorXd force_of_plane(const RestingHand& rest, const RigidBody& body) {
  FrameDerivatives at;
  body.frame_derivatives(body.frame(rest.frame), Reference::centered(), at);
  return rest.force * (at.jacobian.topRows<3>().transpose() * rest.normal_world.normalized());
}

/// Adds monitors of a resting hand to another task: the hand's time without force, and its slip.
class WatchedRest final : public MpcTask {
 public:
  WatchedRest(std::unique_ptr<MpcTask> task, const MpcSpec& spec, const RestingHand& rest,
              double contact_lost)
      : task_(std::move(task)),
        name_("hand " + in_quotes(rest.frame)),
        rest_(rest),
        contact_lost_(contact_lost),
        frame_(RigidBody(spec.problem.model).frame(rest.frame)),
        column_(wrench_column(spec, rest.frame)),
        of_task_(task_->watched().size()) {
    rest_.normal_world.normalize();
    force_ = rest_.force;
  }

  std::vector<std::string> events() const override { return task_->events(); }
  std::vector<WatchedQuantity> watched() const override {
    std::vector<WatchedQuantity> all = task_->watched();
    all.push_back({"time without force", "s", FaultKind::ContactLost, name_});
    all.push_back({"slip of " + name_, "m"});
    return all;
  }
  void reset() noexcept override {
    task_->reset();
    started_ = false;
    without_ = felt_ = 0.0;
    force_ = rest_.force;
  }
  unsigned sense(const TaskView& view) noexcept override {
    const Eigen::Isometry3d now = view.body.placement(frame_);
    if (!started_) contact_ = now;
    started_ = true;
    slip_ = pressing::slid(contact_, now, rest_.normal_world, rest_.radius).norm();
    // Averaging time of the force [s], equal to that of hands in push_wall.
    constexpr double window = 10e-3;
    const Eigen::Vector3d force_world = now.linear() * view.measurement.force_at(column_);
    force_ += -std::expm1(-view.dt / window) * (force_world.dot(rest_.normal_world) - force_);
    return task_->sense(view);
  }
  const Quadric* surface(int tool) const noexcept override { return task_->surface(tool); }
  double surface_depth(int tool) const noexcept override { return task_->surface_depth(tool); }
  void set_inputs(Problem& problem) noexcept override { task_->set_inputs(problem); }
  void watch(const TaskView& view, std::span<Reading> out) noexcept override {
    task_->watch(view, out.first(of_task_));
    const bool lost = force_ < lost_force();
    felt_ = lost && without_ > 0.0 ? std::max(felt_, force_) : force_;
    without_ = lost ? without_ + view.dt : 0.0;
    out[of_task_] = {without_, contact_lost_};
    out[of_task_ + 1] = {slip_, rest_.slip};
  }
  void explain(std::size_t quantity, std::span<char> clause) const noexcept override {
    if (quantity < of_task_) return task_->explain(quantity, clause);
    if (quantity == of_task_)
      std::snprintf(clause.data(), clause.size(),
                    "the largest force was %.4g N; contact needs %.4g N", felt_, lost_force());
  }
  void aim(double time, Command& command) override { task_->aim(time, command); }

 private:
  /// Returns the force below which the hand counts as lifted [N].
  double lost_force() const noexcept {
    constexpr double fraction = 0.1;  // fraction of the stated force, chosen by hand
    return fraction * rest_.force;
  }

  std::unique_ptr<MpcTask> task_;
  std::string name_;
  RestingHand rest_;
  double contact_lost_;   ///< Largest allowed time without force [s].
  int frame_;             ///< Frame of the hand.
  int column_;            ///< Column of the hand in Measurement::wrenches.
  std::size_t of_task_;   ///< Number of quantities that `task_` monitors.
  bool started_ = false;  ///< Whether `contact_` is set.
  double force_ = 0.0;    ///< Mean normal force of the hand [N].
  double without_ = 0.0;  ///< Time without force [s].
  double felt_ = 0.0;     ///< Largest force since the hand was lifted [N].
  double slip_ = 0.0;     ///< Distance that the hand slid [m].
  Eigen::Isometry3d contact_ = Eigen::Isometry3d::Identity();  ///< Initial placement of the hand.
};

}  // namespace

void check_rest(const Task& task, const Model& model) {
  const RestingHand& rest = task.rest;
  if (!rest.is_stated()) return refuse_nameless(rest);
  check_ranges(description_of(&rest), &rest,
               [](const std::string& entry) { return "the task: rest." + entry; });
  if (!task.standing.stands())
    throw EntryError("rest.frame", "hand " + in_quotes(rest.frame) +
                                       " rests only while the robot stands on its feet; wanted "
                                       "standing.feet, or rest.frame none");
  if (!model.has_frame(rest.frame))
    throw EntryError("rest.frame", "frame " + pressing::none_of(model, rest.frame));
  refuse_same_link(rest, model, "tool.frame", task.tool);
  refuse_same_link(rest, model, "surface.frame", task.surface_frame);
  for (const std::string& foot : task.standing.feet) refuse_leg(rest, model, foot);
  if (!task.standing.force_sensors)
    throw EntryError("standing.force_sensors",
                     "without force sensors, the force of the resting hand " +
                         in_quotes(rest.frame) +
                         " is not measured; wanted true, or rest.frame none");
}

TouchSpec resting_support(const RestingHand& rest, const Model& model, const Eigen::VectorXd& q) {
  const Eigen::Vector3d n_world = rest.normal_world.normalized();
  const double sinks = rest.force / rest.stiffness;  // indentation of the plane [m]
  const Eigen::Vector3d p_hand = frame_placement(model, q, rest.frame).translation();
  return {.frame = rest.frame,
          .radius = rest.radius,
          .surface = {.point = p_hand - (rest.radius - sinks) * n_world,
                      .normal = n_world,
                      .friction = rest.friction,
                      .stiffness = rest.stiffness,
                      .damping = plane_lag * rest.stiffness},
          .is_support = true};
}

std::vector<TouchSpec> feet_in(const Task& task, const SceneSpec& scene) {
  std::vector<TouchSpec> feet = scene.supports();
  feet.resize(task.standing.feet.size());
  return feet;
}

Eigen::VectorXd torque_at_start(const Task& task, const Setting& setting) {
  const Model& model = setting.robot.model;
  RigidBody body(model);
  if (!is_usable(body.update(setting.q_start, Eigen::VectorXd::Zero(model.nv))))
    throw Error("the starting posture cannot be evaluated");
  Eigen::VectorXd needed = body.gravity_torque();
  if (task.rest.is_stated()) needed -= force_of_plane(task.rest, body);
  return pressing::torque_on_supports(model, body, feet_in(task, setting.scene), needed);
}

void refuse_weak_rest(const Task& task, const Setting& setting) {
  if (!task.rest.is_stated()) return;
  const Model& model = setting.robot.model;
  const Eigen::VectorXd torque = torque_at_start(task, setting);
  const Eigen::VectorXd limit = pressing::torque_limit(model, task.constraints);
  for (int k = 0; k < model.nv; ++k)
    if (std::abs(torque[k]) > limit[k])
      throw EntryError("rest.force",
                       "hand " + in_quotes(task.rest.frame) + " with " + number(task.rest.force) +
                           " N at the start needs " + number(std::abs(torque[k])) +
                           " Nm in joint " + in_quotes(model.v_name(k)) + "; wanted at most " +
                           number(limit[k]) + " Nm: a smaller force, or another posture");
}

ContactSpec resting_contact(const Task& task) {
  ContactSpec contact{
      .name = task.rest.frame, .tool = task.rest.frame, .directions = Directions::linear()};
  contact.reference =
      Reference::surface(Reference::surface_with_normal(task.rest.normal_world).rotation);
  return contact.with_gains(0.0, task.standing.contact_kd);
}

void keep_resting(const RestingHand& rest, Stage& stage) {
  if (!rest.is_stated()) return;
  stage.contacts.push_back(rest.frame);
  stage.costs.push_back(
      {.name = "force of " + rest.frame,
       .residual = residual::ContactForce{rest.frame, {}, Eigen::Vector3d(0.0, 0.0, rest.force)},
       .weight = rest.weight,
       .weights = Eigen::Vector3d(tangential_factor, tangential_factor, 1.0)});
  stage.constraints.push_back({.name = "friction of " + rest.frame,
                               .residual = residual::FrictionCone{rest.frame, rest.plan_friction}});
}

void set_resting(const Task& task, MpcSpec& mpc) {
  if (!task.rest.is_stated()) return;
  mpc.supports.push_back(task.rest.frame);
  mpc.resting_supports = {task.rest.frame};
  mpc.touches.push_back({task.rest.frame});
  mpc.task = [make = mpc.task, rest = task.rest,
              lost = task.tool_limits.contact_lost](const MpcSpec& spec) {
    return std::make_unique<WatchedRest>(make(spec), spec, rest, lost);
  };
}

}  // namespace burnish::polishing
