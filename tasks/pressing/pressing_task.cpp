#include "burnish/tasks/pressing/pressing_task.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/ocp/problem.hpp"
#include "pressing/descriptions.gen.hpp"
#include "pressing/tool_watch.hpp"

namespace burnish {
namespace {

void check_tool_limits(const ToolLimits& limits) {
  check_ranges(description_of(&limits), &limits,
               [](const std::string& entry) { return "pressing task: the limit " + entry; });
  if (!(limits.force_window < 1.0))
    throw Error("pressing task: the limit force_window is " + number(limits.force_window) +
                " s; wanted less than 1 s");
}

SurfaceEstimator estimator_of(const PressedSurface& surface, double tick_period) {
  return {Surface(surface.shape, surface.point_base, surface.normal_base), surface.tip_radius,
          surface.estimate, tick_period};
}

int input_named(const std::string& name, const ProblemSpec& problem) {
  std::vector<std::string> known;
  for (const InputSpec& input : problem.inputs) known.push_back(input.name);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end())
    throw Error("pressing task: the problem has no input " + in_quotes(name) +
                did_you_mean(name, known));
  const auto index = static_cast<std::size_t>(found - known.begin());
  if (problem.inputs[index].kind != InputKind::Scalar)
    throw Error("pressing task: input " + in_quotes(name) + " has another kind; wanted a scalar");
  return static_cast<int>(index);
}

class Pressing final : public MpcTask {
 public:
  Pressing(const PressingTask& task, const MpcSpec& spec)
      : touch_(task.touch),
        target_(task.target),
        limits_(task.limits),
        normal_world_(spec.tools.front().normal_base),
        normal_at_first_(normal_world_),
        tool_(RigidBody(spec.problem.model).frame(spec.tools.front().frame)),
        base_(spec.tools.front().base.empty()
                  ? -1
                  : RigidBody(spec.problem.model).frame(spec.tools.front().base)),
        detector_(spec.tools.front().contact_threshold,
                  pressing::samples_of(touch_window, spec.tick_period)),
        mean_(pressing::samples_of(task.limits.force_window, spec.tick_period)),
        free_space_(task.limits, spec.tools.front().contact_threshold),
        approach_(task.limits),
        loss_(task.limits) {
    if (task.surface) surface_.emplace(estimator_of(*task.surface, spec.tick_period));
    if (!task.time_input.empty()) time_input_ = input_named(task.time_input, spec.problem);
  }

  std::vector<std::string> events() const override { return {"contact"}; }
  std::vector<WatchedQuantity> watched() const override {
    // The order must match explain().
    return {{"speed of the tool", "m/s", FaultKind::SpeedLimit},
            {"force in free space", "N", FaultKind::UnexpectedContact},
            {"travel since contact was due", "m", FaultKind::NoContact},
            {"time since contact was due", "s", FaultKind::ContactLate},
            {"force at the tool", "N", FaultKind::ForceLimit},
            {"time without contact", "s", FaultKind::ContactLost}};
  }

  void reset() noexcept override {
    detector_.reset();
    mean_.reset();
    free_space_.reset();
    approach_.reset();
    loss_.reset();
    if (surface_) surface_->reset();
    normal_world_ = normal_at_first_;
    depth_ = 0.0;
    time_ = 0.0;
  }

  const Quadric* surface(int /*tool*/) const noexcept override {
    return surface_ ? &surface_->surface() : nullptr;
  }

  double surface_depth(int /*tool*/) const noexcept override { return depth_; }

  void set_inputs(Problem& problem) noexcept override {
    if (time_input_ >= 0) (void)problem.set_input(time_input_, time_);
  }

  unsigned sense(const TaskView& view) noexcept override {
    const Eigen::Vector3d force = view.tool_forces_world.col(0);
    if (base_ >= 0) {
      base_world_ = view.body.placement(base_);
      normal_world_ = base_world_.linear() * (surface_ ? surface_->normal() : normal_at_first_);
    }
    mean_.add(force);
    // If the schedule has no phase in free space, noise is estimated in the phase in which contact
    // is due.
    const Touch phase = phase_of(view);
    const bool in_air = phase == Touch::Free || (phase == Touch::Due && !detector_.knows_noise());
    detector_.add(force.dot(normal_world_), in_air);
    if (surface_) {
      const bool slides = phase == Touch::Wanted && detector_.touches();
      surface_->update(base_world_.inverse() * view.body.placement(tool_).translation(),
                       force.dot(normal_world_), slides);
      normal_world_ = base_world_.linear() * surface_->normal();
      constexpr double max_depth = 0.02;  // largest indentation [m], chosen by hand
      depth_ =
          slides ? std::clamp(surface_->compliance() * target_force(view), 0.0, max_depth) : 0.0;
    }
    return detector_.touches() ? 1U : 0U;
  }

  void watch(const TaskView& view, std::span<Reading> out) noexcept override {
    const Touch phase = phase_of(view);
    out[0] = {view.body.velocity(tool_, Reference::centered()).head<3>().norm(),
              limits_.tool_speed};
    out[1] = free_space_.look(phase, view.dt, mean_.value().dot(normal_world_), mean_, detector_);
    const Eigen::Vector3d p_tool_world = view.body.placement(tool_).translation();
    approach_.look(view.schedule.waits(), view.dt,
                   (p_tool_world - base_world_.translation()).dot(normal_world_), detector_.felt());
    out[2] = approach_.travel();
    out[3] = approach_.lateness();
    out[4] = {mean_.value().norm(), limits_.force};
    out[5] = loss_.look(phase == Touch::Wanted && detector_.is_lost(target_force(view)), view.dt,
                        detector_.felt());
  }

  void explain(std::size_t quantity, std::span<char> clause) const noexcept override {
    if (quantity < 2 || quantity == 4) return;  // only late and lost contact have explanations
    const double felt = quantity == 5 ? loss_.felt() : approach_.felt();
    std::snprintf(clause.data(), clause.size(),
                  "the largest force was %.2g N; contact needs %.2g N", felt, detector_.needed());
  }

  void aim(double time, Command& command) override {
    const TaskTarget target = target_(time);
    time_ = time;
    ToolCommand& tool = command.tools.front();
    tool.target_force = target.force;
    Eigen::Vector3d p = target.p_world;
    if (surface_ && target.force > 0.0) put_on_surface(p);
    tool.p_target_world = base_ < 0 ? p : base_world_ * p;
  }

 private:
  static double target_force(const TaskView& view) noexcept {
    return view.command.tools.front().target_force;
  }

  /// Moves a point onto the estimated surface, in the direction of the normal at the start of the
  /// path.
  void put_on_surface(Eigen::Vector3d& p) const noexcept {
    constexpr double max_step = 0.1;  // largest displacement [m], chosen by hand
    const Quadric& estimated = surface_->surface();
    const double slope = estimated.gradient(p).dot(normal_at_first_);
    const double step = -estimated.value(p) / slope;
    if (slope > 0.1 && std::abs(step) < max_step) p += step * normal_at_first_;
  }

  static constexpr double touch_window = 5e-3;  ///< Time window of `detector_` [s]. Chosen by hand.

  Touch phase_of(const TaskView& view) const noexcept {
    return touch_[to_size(view.schedule.phase())];
  }

  std::vector<Touch> touch_;
  std::function<TaskTarget(double)> target_;
  ToolLimits limits_;
  Eigen::Vector3d normal_world_, normal_at_first_;
  std::optional<SurfaceEstimator> surface_;
  double depth_ = 0.0;   ///< Indentation of the surface below the tool [m].
  int time_input_ = -1;  ///< Index of the input PressingTask::time_input; -1: none.
  double time_ = 0.0;    ///< Time of the schedule at the last tick [s].
  int tool_;
  int base_;  ///< Frame that the surface moves with; -1: the world.
  Eigen::Isometry3d base_world_ = Eigen::Isometry3d::Identity();  ///< Placement of `base_`.
  ContactDetector detector_;
  pressing::MeanForce mean_;
  pressing::FreeSpaceWatch free_space_;
  pressing::ApproachWatch approach_;
  pressing::LossWatch loss_;
};

}  // namespace

std::unique_ptr<MpcTask> PressingTask::operator()(const MpcSpec& spec) const {
  if (touch.size() != spec.schedule.size())
    throw Error("pressing task: touch has " + std::to_string(touch.size()) + " entries; wanted " +
                std::to_string(spec.schedule.size()) + ", one for each of the " +
                std::to_string(spec.schedule.size()) + " phases of the schedule");
  if (spec.tools.size() != 1)
    throw Error("pressing task: MpcSpec.tools has " + std::to_string(spec.tools.size()) +
                " entries; wanted one, the tool that presses");
  if (!target) throw Error("pressing task: target is empty; wanted a function of time");
  check_tool_limits(limits);
  return std::make_unique<Pressing>(*this, spec);
}

}  // namespace burnish
