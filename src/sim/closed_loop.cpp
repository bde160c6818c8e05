#include "burnish/sim/closed_loop.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {

void add_axes(std::vector<TraceColumn>& columns, const std::string& what, const char* unit) {
  for (const char* axis : {"x", "y", "z"}) columns.push_back({what + "_" + axis + "_world", unit});
}

/// Returns the unit of a column for entry k of v: `sliding` for a sliding joint, `turning` for a
/// turning joint.
std::string unit_of_v(const Model& model, int k, const char* turning, const char* sliding) {
  const Joint& joint = model.joints[to_size(model.joint_of_v[k])];
  const int entry = k - joint.v_index;
  return entry < sliding_entries(joint.kind) ? sliding : turning;
}

std::string unit_of_q(const Model& model, int k) {
  for (const Joint& joint : model.joints) {
    const int entry = k - joint.q_index;
    if (entry < 0 || entry >= joint.nq) continue;
    return unit_of_q(joint.kind, entry);
  }
  return "-";
}

void add_entries_of_v(std::vector<TraceColumn>& columns, const Model& model, const char* what,
                      const char* turning, const char* sliding) {
  for (int k = 0; k < model.nv; ++k)
    columns.push_back({what + model.v_name(k), unit_of_v(model, k, turning, sliding)});
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Gains of the spring and damper of a hoist, along and about the world's axes. The spring is stiff
/// relative to forces of a robot's legs, well damped, and slow relative to a plant's step.
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

/// Returns the columns of the trace, in the order in which record_state() and record_step() write
/// them.
std::vector<TraceColumn> columns_of(const Model& model, const SceneSpec& scene) {
  std::vector<TraceColumn> columns{{"time", "s"}, {"phase", "-"}, {"status", "-"}};
  add_axes(columns, "tool", "m");
  for (const char* axis : {"rx", "ry", "rz"})
    columns.push_back({std::string("tool_") + axis + "_start", "rad"});
  add_axes(columns, "target", "m");
  columns.push_back({"target_force", "N"});
  for (const char* what : {"measured_force", "estimated_force", "push"})
    add_axes(columns, what, "N");
  for (const char* what : {"q_", "measured_q_"})
    for (int k = 0; k < model.nq; ++k)
      columns.push_back({what + model.q_name(k), unit_of_q(model, k)});
  for (const char* what : {"v_", "measured_v_"})
    add_entries_of_v(columns, model, what, "rad/s", "m/s");
  for (const char* what : {"tau_command_", "tau_applied_", "tau_measured_", "tau_friction_"})
    add_entries_of_v(columns, model, what, "Nm", "N");
  add_axes(columns, "tool_force", "N");
  for (const char* what : {"surface_normal", "estimated_normal"}) add_axes(columns, what, "-");
  columns.push_back({"estimated_friction", "-"});
  for (const char* what : {"in_contact", "plant_status", "limited_joints", "held_command"})
    columns.push_back({what, "-"});
  columns.push_back({"solve_time", "s"});
  for (const char* what :
       {"iterations", "missed_deadline", "tick", "constraint_violation", "constraint_residual",
        "active_constraints", "constraints_infeasible", "clipped_torques"})
    columns.push_back({what, "-"});
  if (!scene.surface.frame.empty()) {
    add_axes(columns, "surface", "m");
    for (const char* axis : {"rx", "ry", "rz"})
      columns.push_back({std::string("surface_") + axis + "_world", "rad"});
  }
  for (const SupportSpec& support : scene.supports) {
    for (const char* axis : {"fx", "fy", "fz"})
      columns.push_back({"support_" + support.frame + "_" + axis, "N"});
    for (const char* axis : {"mx", "my", "mz"})
      columns.push_back({"support_" + support.frame + "_" + axis, "Nm"});
  }
  return columns;
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
  void put(const Eigen::Ref<const Eigen::VectorXd>& values) {
    for (const double value : values) put(value);
  }
  double* end() const { return at_; }

 private:
  double* at_;
};

int sensed_supports(const Plant& plant, const ClosedLoopOptions& options) {
  return options.support_sensors ? static_cast<int>(plant.scene().supports.size()) : 0;
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
        sensing(driven.model(), disturbances, sensed_supports(driven, chosen),
                chosen.control_period),
        body(driven.model()),
        tip(body.frame(driven.scene().tip.frame)),
        carrier(driven.scene().surface.frame.empty() ? -1
                                                     : body.frame(driven.scene().surface.frame)),
        hoist(driven.scene().hoist),
        hung(hoist.holds() ? body.frame(hoist.frame) : -1),
        total(Eigen::VectorXd::Zero(driven.model().nv)),
        trace(columns_of(driven.model(), driven.scene()), rows_for(chosen, driven.dt())) {
    measurement.q = driven.model().q_neutral;
    measurement.v = measurement.tau = Eigen::VectorXd::Zero(driven.model().nv);
    command.tau = measurement.v;
    measurement.support_wrenches.setZero(6, sensed_supports(driven, chosen));
    for (const Push& push : pushes)
      pushed.push_back(push.frame.empty() ? tip : body.frame(push.frame));
    // Allocates here, because steps must not allocate.
    body.frame_derivatives(tip, Reference::centered(), motion);
    if (chosen.imu_frame) sensing.mount_imu(driven.model(), *chosen.imu_frame);
  }

  double* record_state(double* to) noexcept;
  void record_step(double* to, Status status, bool ticked) const noexcept;
  void place_tool() noexcept;
  void hang();
  void add_hoist(double fraction) noexcept;
  void place_surface() noexcept {
    if (carrier >= 0) surface_world = body.placement(carrier);
  }
  const Eigen::VectorXd& with_pushes(const Eigen::VectorXd& tau) noexcept;

  Plant* plant;
  Controller* controller;
  std::vector<Push> pushes;
  int record_every, ticks;
  Actuation actuation;
  Sensing sensing;
  std::optional<EstimatedBase> estimated;
  RigidBody body;
  int tip;
  int carrier;              ///< Frame that carries the surface; -1: the world
  std::vector<int> pushed;  ///< Frames on which pushes act
  FrameDerivatives motion;
  HoistSpec hoist;
  int hung;  ///< Frame that hangs on the hoist; -1: none
  /// Placement of the hanging frame at the start.
  Eigen::Isometry3d hung_world = Eigen::Isometry3d::Identity();
  /// Factor on the wrench of the hoist's spring and damper. It makes the step implicit if they are
  /// stiff relative to the plant's step; otherwise it is the identity.
  Matrix6 implicit_factor = Matrix6::Identity();
  Eigen::VectorXd total;
  Trace trace;
  long steps = 0;
  Measurement measurement;
  Command command;
  Eigen::Vector3d push_world = Eigen::Vector3d::Zero();
  /// Rotation of the tool at the start, in the axes of the surface
  Eigen::Matrix3d start_R = Eigen::Matrix3d::Identity();
  /// Placement of the frame that carries the surface.
  Eigen::Isometry3d surface_world = Eigen::Isometry3d::Identity();
  Eigen::Vector3d p_tool_world = Eigen::Vector3d::Zero();
  /// Rotation vector of the tool since the start, in the axes of the surface [rad].
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
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
  if (impl_->controller->carries_payload())
    throw Error(
        "estimate_base: the controller has a payload, which the base estimator ignores; wanted "
        "models that contain the payload, from with_payload()");
  impl_->estimated.emplace(nominal, estimator, feet);
  impl_->controller->expect_estimated_base();
  impl_->sensing.mount_imu(impl_->plant->model(), estimator.imu_frame);
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
    impl_->place_surface();
    impl_->hang();
    impl_->start_R =
        impl_->surface_world.linear().transpose() * impl_->body.placement(impl_->tip).linear();
  }
  return status;
}

Status ClosedLoop::step() noexcept {
  Impl& loop = *impl_;
  const bool ticks = loop.steps % loop.ticks == 0;
  if (ticks) {
    const Measurement& measured = loop.sensing.measure(*loop.plant, loop.actuation.step().applied);
    loop.measurement = loop.estimated ? loop.estimated->update(measured) : measured;
    loop.command = loop.controller->tick(loop.measurement);
    if (loop.steps == 0 && loop.command.tau.allFinite()) loop.actuation.reset(loop.command.tau);
  }
  loop.push_world = push_at(loop.pushes, loop.plant->time());
  const Eigen::VectorXd& tau = loop.actuation.apply(loop.command.tau);
  double* row = loop.steps % loop.record_every == 0 ? loop.trace.add_row() : nullptr;
  if (row != nullptr) row = loop.record_state(row);
  const Status status = loop.plant->step(loop.with_pushes(tau), loop.push_world);
  if (row != nullptr) loop.record_step(row, status, ticks);
  ++loop.steps;
  return status;
}

Status ClosedLoop::run(double duration) noexcept {
  const long end = impl_->steps + std::lround(duration / impl_->plant->dt());
  Status status = Status::Ok;
  while (impl_->steps < end && is_usable(status)) status = worst(status, step());
  return status;
}

void ClosedLoop::Impl::place_tool() noexcept {
  if (body.update(plant->q(), plant->v()) != Status::Ok) return;
  const Eigen::Isometry3d placement = body.placement(tip);
  p_tool_world = placement.translation();
  place_surface();
  const Eigen::AngleAxisd rotation(Eigen::Matrix3d(
      start_R.transpose() * (surface_world.linear().transpose() * placement.linear())));
  turned = rotation.angle() * rotation.axis();
}

void ClosedLoop::Impl::hang() {
  if (hung < 0) return;
  hung_world = body.placement(hung);
  const HoistGains gains(body.mass());
  const double dt = plant->dt();
  const Matrix6 step = (dt * gains.damping + dt * dt * gains.stiffness).asDiagonal();
  // Largest gain per step for which the step is explicit. Explicit steps are accurate up to a gain
  // of 0.5, and unstable from 2 on.
  constexpr double max_explicit_gain = 0.5;
  const Matrix6 stepped = step * mobility_of(plant->model(), body, hung, plant->q());
  implicit_factor.setIdentity();
  if (stepped.diagonal().maxCoeff() > max_explicit_gain)
    implicit_factor = least_squares(Matrix6::Identity() + stepped, Matrix6::Identity());
}

/// Adds the hoist's joint torques, times `fraction`, to `total`. They are computed at the state of
/// `body`.
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

/// Returns `tau` plus the torques J^T f of the hoist and of pushes on frames other than the tip.
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
    if (pushes[i].frame.empty() || !acts_at(pushes[i], now)) continue;
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

/// Writes the columns that do not depend on the plant's step. Returns the address of the next
/// column.
double* ClosedLoop::Impl::record_state(double* to) noexcept {
  place_tool();
  Row row(to);
  row.put(plant->time());
  row.put(static_cast<double>(command.phase));
  row.put(command.status);
  row.put(p_tool_world);
  row.put(turned);
  row.put(command.p_target_world);
  row.put(command.target_force);
  row.put(measurement.tool_force_world);
  row.put(command.force_estimate_world);
  row.put(push_world);
  row.put(plant->q());
  row.put(measurement.q);
  row.put(plant->v());
  row.put(measurement.v);
  row.put(actuation.step().command);
  row.put(actuation.step().applied);
  row.put(measurement.tau);
  return row.end();
}

void ClosedLoop::Impl::record_step(double* to, Status status, bool ticked) const noexcept {
  Row row(to);
  row.put(plant->friction_torque());
  row.put(plant->contact_force_world());
  const SurfaceSpec& surface = plant->scene().surface;
  const double moved = surface.motion.displacement(plant->time());
  const Eigen::Vector3d p_tool = surface_world.inverse() * p_tool_world;
  const Eigen::Vector3d normal_world =
      surface_world.linear() * normal_at(plant->scene(), p_tool - moved * surface.normal);
  row.put(normal_world);
  row.put(command.normal_world);
  row.put(command.friction);
  row.put(plant->in_contact());
  row.put(status);
  row.put(static_cast<double>(actuation.step().limited));
  row.put(actuation.step().held);
  row.put(command.solve_time);
  row.put(static_cast<double>(command.iterations));
  row.put(command.missed_deadline);
  row.put(ticked);
  row.put(command.constraint_violation);
  row.put(command.constraint_residual);
  row.put(static_cast<double>(command.active_constraints));
  row.put(command.constraints_infeasible);
  row.put(static_cast<double>(command.clipped_torques));
  if (carrier >= 0) {
    const Eigen::AngleAxisd turn(surface_world.linear());
    const Eigen::Vector3d p_world = surface_world.translation(),
                          turned_world = turn.angle() * turn.axis();
    row.put(p_world);
    row.put(turned_world);
  }
  row.put(plant->support_wrenches().reshaped());
}

const Trace& ClosedLoop::trace() const { return impl_->trace; }
const Actuation& ClosedLoop::actuation() const { return impl_->actuation; }
const Measurement& ClosedLoop::measurement() const { return impl_->measurement; }
const Command& ClosedLoop::command() const { return impl_->command; }

const Trace& seen_from_surface(const Trace& trace, Trace& room) {
  if (!trace.has("surface_rx_world")) return trace;
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
