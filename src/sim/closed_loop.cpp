#include "burnish/sim/closed_loop.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <span>
#include <utility>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "model/joint_entries.hpp"
#include "sim/traced_tool.hpp"

namespace burnish {
namespace {

std::vector<TraceColumn> axes(const std::string& what, const char* unit) {
  return {{what + "_x_world", unit}, {what + "_y_world", unit}, {what + "_z_world", unit}};
}

std::vector<TraceColumn> rotation(const std::string& what, const std::string& from) {
  return {
      {what + "_rx_" + from, "rad"}, {what + "_ry_" + from, "rad"}, {what + "_rz_" + from, "rad"}};
}

std::string unit_of_q(const Model& model, int k) {
  for (const Joint& joint : model.joints) {
    const int entry = k - joint.q_index;
    if (entry < 0 || entry >= joint.nq) continue;
    return unit_of_q(joint.kind, entry);
  }
  return "-";
}

std::vector<TraceColumn> entries_of_q(const Model& model, const std::string& what) {
  std::vector<TraceColumn> columns;
  for (int k = 0; k < model.nq; ++k)
    columns.push_back({what + model.q_name(k), unit_of_q(model, k)});
  return columns;
}

std::vector<TraceColumn> entries_of_v(const Model& model, const std::string& what,
                                      const char* turning, const char* sliding) {
  std::vector<TraceColumn> columns;
  for (int k = 0; k < model.nv; ++k)
    columns.push_back({what + model.v_name(k), unit_of_v(model, k, turning, sliding)});
  return columns;
}

std::vector<TraceColumn> wrench_on(const std::string& support) {
  std::vector<TraceColumn> columns;
  for (const auto& [entry, unit] :
       {std::pair("fx", "N"), {"fy", "N"}, {"fz", "N"}, {"mx", "Nm"}, {"my", "Nm"}, {"mz", "Nm"}})
    columns.push_back({"support_" + support + "_" + entry, unit});
  return columns;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Gains of the spring and damper of a hoist, along and about the world's axes. Leg forces of the
/// robot stretch the spring little. Oscillations are well damped and slow relative to plant steps.
struct HoistGains {
  explicit HoistGains(double mass) {
    // Chosen by hand.
    constexpr double arm = 0.3;                 // typical radius of gyration of a robot [m]
    constexpr double stiffness_per_mass = 2e3;  // [1/s^2]
    constexpr double damping_per_mass = 60.0;   // [1/s]
    stiffness << Eigen::Vector3d::Constant(stiffness_per_mass * mass),
        Eigen::Vector3d::Constant(arm * arm * stiffness_per_mass * mass);
    damping << Eigen::Vector3d::Constant(damping_per_mass * mass),
        Eigen::Vector3d::Constant(arm * arm * damping_per_mass * mass);
  }
  Vector6 stiffness;  ///< Stiffness, linear and angular [N/m, Nm/rad]
  Vector6 damping;    ///< Damping, linear and angular [Ns/m, Nms/rad]
};

/// Returns the acceleration of a frame per wrench on the frame, J M^-1 J^T, in world axes.
/// Allocates memory.
Matrix6 mobility_of(const Model& model, const RigidBody& body, int frame,
                    const Eigen::VectorXd& q) {
  ContactDynamics dynamics(model);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  if (!is_usable(dynamics.forward(q, rest, rest))) return Matrix6::Zero();
  FrameDerivatives motion;
  body.frame_derivatives(frame, Reference::centered(), motion);
  const Eigen::MatrixXd J = motion.jacobian;
  return J * solve_positive(dynamics.mass_matrix(), J.transpose());
}

/// Returns the number of plant steps in one control period.
int steps_per_tick(double control_period, double dt) {
  const double ratio = control_period / dt;
  const double steps = std::round(ratio);
  if (!(steps >= 1.0 && steps < 1e6 && std::abs(ratio - steps) < 1e-6 * steps))
    throw Error("the control period is " + number(control_period) +
                " s; wanted a multiple of the plant's step of " + number(dt) + " s");
  return static_cast<int>(steps);
}

int rows_for(const ClosedLoopOptions& options, double dt) {
  if (options.record_every < 1)
    throw Error("record_every is " + std::to_string(options.record_every) +
                "; wanted at least 1 step");
  if (!(options.max_duration >= 0.0 && options.max_duration / dt < 1e9))
    throw Error("max_duration is " + number(options.max_duration) +
                " s; wanted at least 0, and less than 1e9 plant steps of " + number(dt) + " s");
  return static_cast<int>(std::ceil(options.max_duration / dt)) / options.record_every + 2;
}

/// Writer of the entries of a trace row, from left to right.
class Row {
 public:
  explicit Row(double* at) : at_(at) {}
  void put(double value) { *at_++ = value; }
  void put(Status value) { put(static_cast<double>(value)); }
  void put(bool value) { put(value ? 1.0 : 0.0); }
  void put(int value) { put(static_cast<double>(value)); }
  void put(const Eigen::Ref<const Eigen::VectorXd>& values) {
    for (const double value : values) put(value);
  }
  /// Returns the next `count` entries, for a function that fills them.
  std::span<double> next(std::size_t count) { return {std::exchange(at_, at_ + count), count}; }

 private:
  double* at_;
};

/// Throws Error if the touch (tool or foot) lacks a sensor for a component the controller reads.
void check_sensor(const TouchSensor& wanted, const TouchSpec& touch) {
  const bool wants_moment = wanted.sensor == WrenchSensor::Wrench;
  const bool wants_force = wants_moment || wanted.sensor == WrenchSensor::Force;
  const WrenchSensor has = touch.measured();
  if ((wants_moment && has != WrenchSensor::Wrench) || (wants_force && has == WrenchSensor::None))
    throw Error("the controller reads the " + std::string(wants_moment ? "moment" : "force") +
                " at " + in_quotes(touch.frame) +
                ", but the plant's sensor there does not measure it; wanted TouchSpec.sensor " +
                (wants_moment ? "wrench" : "force or wrench") +
                " in the plant's scene, or another sensor in MpcSpec.touches");
}

/// Returns the frames of the columns of Measurement::wrenches. Throws Error if the controller reads
/// a touch (tool or foot) that the scene does not have or does not measure.
std::vector<std::string> measured_touches(const Controller& controller, const SceneSpec& scene) {
  std::vector<std::string> all;
  for (const TouchSpec& touch : scene.touches) all.push_back(touch.frame);
  const std::optional<std::vector<TouchSensor>> stated = controller.touches();
  if (!stated) return all;
  std::vector<std::string> result;
  for (const TouchSensor& wanted : *stated) {
    if (std::find(all.begin(), all.end(), wanted.frame) == all.end()) {
      const std::string hint = did_you_mean(wanted.frame, all);
      throw Error("the controller reads the wrench at " + in_quotes(wanted.frame) +
                  ", which is not a touch of the plant's scene" +
                  (hint.empty() ? "; wanted a touch at this frame, or no tool at this frame "
                                  "(MpcSpec.tools)"
                                : hint));
    }
    check_sensor(wanted, scene.touch(wanted.frame));
    result.push_back(wanted.frame);
  }
  return result;
}

}  // namespace

struct ClosedLoop::Impl {
  Impl(Plant& driven, Controller& driver, const Disturbances& disturbances,
       const ClosedLoopOptions& chosen)
      : plant(&driven),
        controller(&driver),
        pushes(disturbances.pushes),
        record_every(chosen.record_every),
        ticks(steps_per_tick(chosen.control_period, driven.dt())),
        actuation(driven.model(), disturbances, driven.dt()),
        touches(measured_touches(driver, driven.scene())),
        sensing(driven.model(), disturbances, driven.scene(), touches, chosen.control_period),
        body(driven.model()),
        tools(tools_of(driven.scene())),
        hoist(driven.scene().hoist),
        hung(hoist.holds() ? body.frame(hoist.frame) : -1),
        total(Eigen::VectorXd::Zero(driven.model().nv)),
        signals(signals_of(driven.model())),
        trace(columns_of(signals), rows_for(chosen, driven.dt())) {
    measurement.q = driven.model().q_neutral;
    measurement.v = measurement.tau = Eigen::VectorXd::Zero(driven.model().nv);
    command.tau = measurement.v;
    measurement.wrenches.setZero(6, static_cast<Eigen::Index>(touches.size()));
    for (const Push& push : pushes) {
      if (push.frame.empty() && tools.empty())
        throw Error("a push at " + number(push.start) +
                    " s states no frame, and the robot has no tool; wanted the push's frame");
      pushed.push_back(push.frame.empty() ? tools.front().frame : body.frame(push.frame));
    }
    // Allocates here, because steps must not allocate.
    for (const int frame : pushed) body.frame_derivatives(frame, Reference::centered(), motion);
    if (hung >= 0) body.frame_derivatives(hung, Reference::centered(), motion);
    if (chosen.imu_frame) sensing.mount_imu(driven.model(), *chosen.imu_frame);
  }

  /// Signal of the trace: its columns, and the function that writes one value per column.
  struct Signal {
    std::vector<TraceColumn> columns;
    std::function<void(const Impl& loop, Row& row)> put;
    bool is_of_step = false;  ///< True for values of a whole step, false for values at its start.
  };
  std::vector<TracedTool> tools_of(const SceneSpec& scene) const;
  Signal published_signal(bool is_of_step) const;
  std::vector<Signal> signals_of(const Model& model) const;
  template <class Add>
  void add_tool_signals(std::size_t tool, bool is_of_step, const Add& add) const;
  std::vector<int> command_entries() const;
  const ToolCommand& tool_command(int entry) const noexcept;
  std::string name_of_tool(std::size_t tool) const;
  template <class Add>
  void add_command_signals(bool is_of_step, const Add& add) const;
  template <class Add>
  static void add_plan_signals(const Add& add);
  static std::vector<TraceColumn> columns_of(const std::vector<Signal>& signals);
  void record(Row& row, bool of_step) const noexcept;
  Eigen::Vector3d sum_of_pushes() const noexcept;
  void place_tools() noexcept;
  void hang();
  void add_hoist(double fraction) noexcept;
  const Eigen::VectorXd& with_pushes(const Eigen::VectorXd& tau) noexcept;

  Plant* plant;
  Controller* controller;
  std::vector<Push> pushes;
  int record_every, ticks;
  Actuation actuation;
  std::vector<std::string> touches;  ///< Frames of the columns of Measurement::wrenches.
  Sensing sensing;
  std::optional<EstimatedBase> estimated;
  RigidBody body;
  std::vector<TracedTool> tools;  ///< Touches (tools or feet) that are not supports.
  std::vector<int> pushed;        ///< Frames on which pushes act.
  FrameDerivatives motion;
  HoistSpec hoist;
  int hung;  ///< Frame that hangs on the hoist; -1: none
  /// Placement of the hanging frame at the start.
  Eigen::Isometry3d hung_world = Eigen::Isometry3d::Identity();
  /// Factor on the wrench of the hoist's spring and damper. If the spring or the damper is stiff
  /// for the plant's step, the factor makes the step implicit; otherwise it is the identity.
  Matrix6 implicit_factor = Matrix6::Identity();
  Eigen::VectorXd total;
  std::vector<Signal> signals;
  Trace trace;
  long steps = 0;
  Measurement measurement;
  Command command;
  Status step_status = Status::Ok;  ///< Status of the plant's last step
  bool ticked = false;              ///< Whether the controller ticked in the last step
};

ClosedLoop::ClosedLoop(Plant& plant, Controller& controller, const Disturbances& disturbances,
                       const ClosedLoopOptions& options)
    : impl_(std::make_unique<Impl>(plant, controller, disturbances, options)) {
  if (controller.nv() != plant.model().nv)
    throw Error("the controller has " + std::to_string(controller.nv()) + " torques; wanted " +
                std::to_string(plant.model().nv) + ", as the plant has");
}
ClosedLoop::~ClosedLoop() = default;
ClosedLoop::ClosedLoop(ClosedLoop&&) noexcept = default;
ClosedLoop& ClosedLoop::operator=(ClosedLoop&&) noexcept = default;

void ClosedLoop::estimate_base(const Model& nominal, const BaseEstimatorOptions& estimator,
                               const FootContactOptions& feet) {
  if (const double mass = impl_->controller->payload_mass(); mass != 0.0)
    throw Error("ClosedLoop: the controller already has a payload of " + number(mass) +
                " kg, which the base estimate would not include; wanted a call of estimate_base() "
                "before the loop's set_payload()");
  impl_->estimated.emplace(nominal, estimator, feet, impl_->touches);
  impl_->sensing.mount_imu(impl_->plant->model(), estimator.imu_frame);
}

Status ClosedLoop::set_payload(std::string_view frame, const InertiaSpec& payload) {
  const Status status = impl_->controller->set_payload(frame, payload);
  if (status != Status::Ok || !impl_->estimated) return status;
  return impl_->estimated->set_payload(frame, payload);
}

Status ClosedLoop::reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  const Status status = impl_->plant->reset(q, v);
  if (!is_usable(status)) return status;
  impl_->controller->reset();
  impl_->sensing.reset();
  impl_->actuation.reset();
  if (impl_->estimated) (void)impl_->estimated->reset(impl_->plant->q(), impl_->plant->v());
  impl_->trace.clear();
  impl_->steps = 0;
  if (impl_->body.update(impl_->plant->q(), impl_->plant->v()) == Status::Ok) {
    impl_->hang();
    for (TracedTool& tool : impl_->tools) tool.start(impl_->body);
  }
  return status;
}

Status ClosedLoop::step() noexcept {
  Impl& loop = *impl_;
  loop.ticked = loop.steps % loop.ticks == 0;
  if (loop.ticked) {
    loop.place_tools();
    const Measurement& measured = loop.sensing.measure(*loop.plant, loop.actuation.step().applied);
    loop.measurement = loop.estimated ? loop.estimated->update(measured) : measured;
    for (TracedTool& tool : loop.tools) tool.measure(loop.measurement);
    loop.command = loop.controller->tick(loop.measurement);
    if (loop.steps == 0 && loop.command.tau.allFinite()) loop.actuation.reset(loop.command.tau);
  }
  const Eigen::VectorXd& tau = loop.actuation.apply(loop.command.tau);
  double* const begin = loop.steps % loop.record_every == 0 ? loop.trace.add_row() : nullptr;
  Row row(begin);
  if (begin != nullptr) {
    if (!loop.ticked) loop.place_tools();
    loop.record(row, false);
  }
  loop.step_status = loop.plant->step(loop.with_pushes(tau));
  if (begin != nullptr) loop.record(row, true);
  ++loop.steps;
  return loop.step_status;
}

Status ClosedLoop::run(double duration) noexcept {
  const long end = impl_->steps + std::lround(duration / impl_->plant->dt());
  Status status = Status::Ok;
  while (impl_->steps < end && is_usable(status)) status = worst(status, step());
  return status;
}

std::vector<TracedTool> ClosedLoop::Impl::tools_of(const SceneSpec& scene) const {
  std::vector<TracedTool> result;
  for (std::size_t i = 0; i < scene.touches.size(); ++i)
    if (!scene.touches[i].is_support)
      result.emplace_back(scene, static_cast<Eigen::Index>(i), body, touches);
  return result;
}

void ClosedLoop::Impl::place_tools() noexcept {
  if (body.update(plant->q(), plant->v()) != Status::Ok) return;
  for (TracedTool& tool : tools) tool.place(body);
}

void ClosedLoop::Impl::hang() {
  if (hung < 0) return;
  hung_world = body.placement(hung);
  const HoistGains gains(body.mass());
  const double dt = plant->dt();
  const Matrix6 step = (dt * gains.damping + dt * dt * gains.stiffness).asDiagonal();
  // Largest gain per step for which the hoist's step is explicit. Explicit steps are accurate up to
  // a gain of 0.5, and unstable from 2 on.
  constexpr double max_explicit_gain = 0.5;
  const Matrix6 stepped = step * mobility_of(plant->model(), body, hung, plant->q());
  implicit_factor.setIdentity();
  if (stepped.diagonal().maxCoeff() > max_explicit_gain)
    implicit_factor = least_squares(Matrix6::Identity() + stepped, Matrix6::Identity());
}

/// Adds `fraction` times the hoist's torques on the joints to `total`. The torques are those at the
/// state of `body`.
void ClosedLoop::Impl::add_hoist(double fraction) noexcept {
  const double mass = body.mass();
  const HoistGains gains(mass);
  const Eigen::Isometry3d now = body.placement(hung);
  const Vector6 v_hung_world = body.velocity(hung, Reference::centered());
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(now.linear() * hung_world.linear().transpose()));
  Vector6 displacement;
  displacement << now.translation() - hung_world.translation(), turn.angle() * turn.axis();
  Vector6 wrench_world = -implicit_factor * (gains.stiffness.cwiseProduct(displacement) +
                                             gains.damping.cwiseProduct(v_hung_world));
  wrench_world.head<3>() -= mass * plant->model().gravity;
  body.frame_derivatives(hung, Reference::centered(), motion);
  total.noalias() += fraction * (motion.jacobian.transpose() * wrench_world);
}

/// Returns `tau` plus the torques J^T f of the hoist and of pushes.
const Eigen::VectorXd& ClosedLoop::Impl::with_pushes(const Eigen::VectorXd& tau) noexcept {
  const double now = plant->time();
  bool any = false;
  if (const double share = hung < 0 ? 0.0 : hoist.load_fraction(now); share > 0.0) {
    if (!is_usable(body.update(plant->q(), plant->v()))) return tau;
    total = tau;
    any = true;
    add_hoist(share);
  }
  for (std::size_t i = 0; i < pushes.size(); ++i) {
    if (!acts_at(pushes[i], now)) continue;
    if (!any) {
      if (!is_usable(body.update(plant->q(), plant->v()))) return tau;
      total = tau;
    }
    any = true;
    body.frame_derivatives(pushed[i], Reference::centered(), motion);
    total.noalias() += motion.jacobian.topRows<3>().transpose() * pushes[i].force_world;
  }
  return any ? total : tau;
}

/// Adds the signals of plans and of their limits. `add(columns, get)` adds a signal.
template <class Add>
void ClosedLoop::Impl::add_plan_signals(const Add& add) {
  using L = const Impl&;
  add({{"solve_time", "s"}}, [](L l) { return l.command.solve_time; });
  add({{"iterations", "-"}}, [](L l) { return l.command.iterations; });
  add({{"missed_deadline", "-"}}, [](L l) { return l.command.missed_deadline; });
  add({{"tick", "-"}}, [](L l) { return l.ticked; });
  add({{"constraint_violation", "-"}}, [](L l) { return l.command.constraint_violation; });
  add({{"constraint_residual", "-"}}, [](L l) { return l.command.constraint_residual; });
  add({{"active_constraints", "-"}}, [](L l) { return l.command.active_constraints; });
  add({{"constraints_infeasible", "-"}}, [](L l) { return l.command.constraints_infeasible; });
  add({{"clipped_torques", "-"}}, [](L l) { return l.command.clipped_torques; });
}

/// Returns the index of each tool's entry in Command::tools; -1: none. A scene without tools has
/// one index, of the entry with the targets of the task.
/// Throws Error if the controller has a tool twice, or a tool that the scene lacks.
std::vector<int> ClosedLoop::Impl::command_entries() const {
  const std::vector<std::string> named = controller->tools();
  std::vector<std::string> frames;
  for (const TouchSpec& touch : plant->scene().touches) frames.push_back(touch.frame);
  for (auto tool = named.begin(); tool != named.end(); ++tool) {
    const std::string hint = did_you_mean(*tool, frames);
    if (std::find(frames.begin(), frames.end(), *tool) == frames.end())
      throw Error("the controller has the tool " + in_quotes(*tool) +
                  ", which is not a touch of the plant's scene" +
                  (hint.empty() ? "; wanted a touch at this frame" : hint));
    if (std::find(named.begin(), tool, *tool) != tool)
      throw Error("the controller has the tool " + in_quotes(*tool) +
                  " twice; wanted one entry for each tool");
  }
  std::vector<int> entries;
  for (const TracedTool& tool : tools) {
    const std::string& frame = plant->scene().touches[to_size(tool.touch)].frame;
    const auto at = std::find(named.begin(), named.end(), frame);
    entries.push_back(at == named.end() ? -1 : static_cast<int>(at - named.begin()));
  }
  if (entries.empty()) return {0};
  if (named.empty()) entries.front() = 0;
  return entries;
}

/// Returns an entry of Command::tools. Its values are NaN if the command lacks it.
const ToolCommand& ClosedLoop::Impl::tool_command(int entry) const noexcept {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static const Eigen::Vector3d unknown = Eigen::Vector3d::Constant(nan);
  static const ToolCommand none{nan, unknown, unknown, unknown, nan};
  return entry >= 0 && to_size(entry) < command.tools.size() ? command.tools[to_size(entry)] : none;
}

/// Adds the targets and estimates in Command::tools. The names of the first tool's columns have no
/// prefix. A further tool has columns only if the controller has this tool. For a scene without
/// tools, only targets are added.
template <class Add>
void ClosedLoop::Impl::add_command_signals(bool is_of_step, const Add& add) const {
  const std::vector<int> entries = command_entries();
  for (std::size_t tool = 0; tool < entries.size(); ++tool) {
    if (tool > 0 && entries[tool] < 0) continue;
    const auto name = [&](const char* what) {
      return tool == 0 ? what : name_of_tool(tool) + "_" + what;
    };
    const int entry = entries[tool];
    using L = const Impl&;
    if (!is_of_step) {
      add(axes(name("target"), "m"), [=](L l) { return l.tool_command(entry).p_target_world; });
      add({{name("target_force"), "N"}}, [=](L l) { return l.tool_command(entry).target_force; });
    }
    if (tools.empty()) continue;
    if (!is_of_step) {
      add(axes(name("estimated_force"), "N"),
          [=](L l) { return l.tool_command(entry).force_estimate_world; });
      continue;
    }
    add(axes(name("estimated_normal"), "-"),
        [=](L l) { return l.tool_command(entry).normal_world; });
    add({{name("estimated_friction"), "-"}}, [=](L l) { return l.tool_command(entry).friction; });
  }
}

/// Returns the start of the names of a tool's columns.
std::string ClosedLoop::Impl::name_of_tool(std::size_t tool) const {
  return tool == 0 ? "tool" : "tool_" + plant->scene().touches[to_size(tools[tool].touch)].frame;
}

/// Adds the signals of a tool. Columns of the first tool begin with "tool" or name no tool. All
/// columns of further tools begin with "tool_<frame>".
template <class Add>
void ClosedLoop::Impl::add_tool_signals(std::size_t tool, bool is_of_step, const Add& add) const {
  using L = const Impl&;
  const std::string own = name_of_tool(tool);
  const auto name = [&](const char* what) { return tool == 0 ? what : own + "_" + what; };
  if (!is_of_step) {
    add(axes(own, "m"), [=](L l) { return l.tools[tool].p_world; });
    add(rotation(own, "start"), [=](L l) { return l.tools[tool].turned; });
    add(axes(name("measured_force"), "N"), [=](L l) { return l.tools[tool].measured_force_world; });
    return;
  }
  add(axes(own + "_force", "N"), [=](L l) {
    const TracedTool& of = l.tools[tool];
    return Eigen::Vector3d(of.R_world * l.plant->wrenches().col(of.touch).head<3>());
  });
  add(axes(name("surface_normal"), "-"),
      [=](L l) { return l.tools[tool].normal_world(l.plant->time()); });
  add({{name("in_contact"), "-"}},
      [=](L l) { return !l.plant->wrenches().col(l.tools[tool].touch).isZero(0.0); });
  if (tools[tool].carrier < 0) return;
  add(axes(name("surface"), "m"),
      [=](L l) { return Eigen::Vector3d(l.tools[tool].surface_world.translation()); });
  add(rotation(name("surface"), "world"),
      [=](L l) { return vector_of(l.tools[tool].surface_world.linear()); });
}

/// Returns the values that the controller publishes, as one signal with a column each.
ClosedLoop::Impl::Signal ClosedLoop::Impl::published_signal(bool is_of_step) const {
  std::vector<TraceColumn> columns = controller->signals();
  for (TraceColumn& column : columns) column.name.insert(0, "signal_");
  const auto put = [count = columns.size()](const Impl& loop, Row& row) {
    const std::span<double> values = row.next(count);
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
    loop.controller->write_signals(values);
  };
  return {std::move(columns), put, is_of_step};
}

/// Returns the signals of the trace, in the order of its columns: first all values at the start of
/// a step, then all values of the whole step.
std::vector<ClosedLoop::Impl::Signal> ClosedLoop::Impl::signals_of(const Model& model) const {
  std::vector<Signal> result;
  bool is_of_step = false;
  const auto add = [&](std::vector<TraceColumn> columns, const auto& get) {
    const auto put = [get](const Impl& loop, Row& row) { row.put(get(loop)); };
    result.push_back({std::move(columns), put, is_of_step});
  };
  const auto speeds = [&](const char* of) { return entries_of_v(model, of, "rad/s", "m/s"); };
  const auto torques = [&](const char* of) { return entries_of_v(model, of, "Nm", "N"); };
  using L = const Impl&;
  add({{"time", "s"}}, [](L l) { return l.plant->time(); });
  add({{"phase", "-"}}, [](L l) { return l.command.phase; });
  add({{"status", "-"}}, [](L l) { return l.command.status; });
  for (std::size_t i = 0; i < tools.size(); ++i) add_tool_signals(i, is_of_step, add);
  add_command_signals(is_of_step, add);
  add(axes("push", "N"), [](L l) { return l.sum_of_pushes(); });
  add(
      entries_of_q(model, "q_"), [](L l) -> const auto& { return l.plant->q(); });
  add(
      entries_of_q(model, "measured_q_"), [](L l) -> const auto& { return l.measurement.q; });
  add(
      speeds("v_"), [](L l) -> const auto& { return l.plant->v(); });
  add(
      speeds("measured_v_"), [](L l) -> const auto& { return l.measurement.v; });
  add(
      torques("tau_command_"), [](L l) -> const auto& { return l.actuation.step().command; });
  add(
      torques("tau_applied_"), [](L l) -> const auto& { return l.actuation.step().applied; });
  add(
      torques("tau_measured_"), [](L l) -> const auto& { return l.measurement.tau; });
  is_of_step = true;
  add(
      torques("tau_friction_"), [](L l) -> const auto& { return l.plant->friction_torque(); });
  for (std::size_t i = 0; i < tools.size(); ++i) add_tool_signals(i, is_of_step, add);
  add_command_signals(is_of_step, add);
  add({{"plant_status", "-"}}, [](L l) { return l.step_status; });
  add({{"limited_joints", "-"}}, [](L l) { return l.actuation.step().limited; });
  add({{"held_command", "-"}}, [](L l) { return l.actuation.step().held; });
  add_plan_signals(add);
  const std::vector<TouchSpec>& all = plant->scene().touches;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].is_support)
      add(wrench_on(all[i].frame),
          [i](L l) { return l.plant->wrenches().col(static_cast<Eigen::Index>(i)); });
  result.push_back(published_signal(is_of_step));
  return result;
}

/// Returns the columns of the trace. Throws Error if two have the same name, such as those of the
/// first tool's force and of a further tool with the frame "force".
std::vector<TraceColumn> ClosedLoop::Impl::columns_of(const std::vector<Signal>& signals) {
  std::vector<TraceColumn> columns;
  std::set<std::string> names;
  for (const Signal& signal : signals)
    for (const TraceColumn& column : signal.columns) {
      if (!names.insert(column.name).second)
        throw Error("the trace has two columns " + in_quotes(column.name) +
                    "; wanted another name for one of the touches, joints or signals");
      columns.push_back(column);
    }
  return columns;
}

void ClosedLoop::Impl::record(Row& row, bool of_step) const noexcept {
  for (const Signal& signal : signals)
    if (signal.is_of_step == of_step) signal.put(*this, row);
}

/// Returns the sum of the forces of all pushes, on any frame, in world axes [N].
Eigen::Vector3d ClosedLoop::Impl::sum_of_pushes() const noexcept {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Push& push : pushes)
    if (acts_at(push, plant->time())) sum += push.force_world;
  return sum;
}

const Trace& ClosedLoop::trace() const { return impl_->trace; }
const Actuation& ClosedLoop::actuation() const { return impl_->actuation; }
const Measurement& ClosedLoop::measurement() const { return impl_->measurement; }
const Command& ClosedLoop::command() const { return impl_->command; }

const Trace& seen_from_surface(const Trace& trace, Trace& room) {
  if (!trace.has("surface_rx_world") || !trace.has("tool_x_world")) return trace;
  room = Trace(trace.columns(), trace.rows());
  const int place = trace.index("surface_x_world"), turn = trace.index("surface_rx_world");
  std::vector<int> points, directions;
  for (const char* what : {"tool", "target"})
    points.push_back(trace.index(std::string(what) + "_x_world"));
  for (const char* what : {"measured_force", "estimated_force", "push", "tool_force",
                           "surface_normal", "estimated_normal"})
    directions.push_back(trace.index(std::string(what) + "_x_world"));
  const auto columns = static_cast<int>(trace.columns().size());
  for (int i = 0; i < trace.rows(); ++i) {
    double* const row = room.add_row();
    for (int c = 0; c < columns; ++c) row[c] = trace.at(i, c);
    const auto vector = [&](int first) { return Eigen::Map<Eigen::Vector3d>(row + first); };
    const Eigen::Vector3d origin = vector(place), turned = vector(turn);
    const double angle = turned.norm();
    const Eigen::Matrix3d to_surface =
        angle > 0.0 ? Eigen::AngleAxisd(-angle, turned / angle).toRotationMatrix()
                    : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    for (const int first : points) vector(first) = to_surface * (vector(first) - origin).eval();
    for (const int first : directions) vector(first) = (to_surface * vector(first)).eval();
  }
  return room;
}

}  // namespace burnish
