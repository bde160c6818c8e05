#include "burnish/derivatives/rigid_body.hpp"

#include <algorithm>
#include <cmath>

#include "derivatives/frame_kinematics.tpp"
#include "derivatives/kinematic_state.hpp"
#include "derivatives/momentum.tpp"
#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/kinematics.tpp"
#include "dynamics/passive.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {

Vector6 stacked(const Motion<double>& m) {
  Vector6 result;
  result << to_eigen(m.linear), to_eigen(m.angular);
  return result;
}
Vector6 stacked(const Force<double>& f) {
  Vector6 result;
  result << to_eigen(f.linear), to_eigen(f.angular);
  return result;
}

/// Sets a matrix of the given size to zero. Allocates only if the size changes.
void clear(RowMatrix& matrix, int rows, int columns) {
  if (matrix.rows() != rows || matrix.cols() != columns) matrix.resize(rows, columns);
  matrix.setZero();
}

/// Returns true if quaternions and (cos, sin) pairs have unit length within 1e-6, the tolerance of
/// the contact kernels.
bool is_normalized(const Tree& tree, const ConstVectorRef& q) {
  for (const TreeJoint& joint : tree.joints) {
    const int size = unit_entries(joint.kind);
    if (size == 0) continue;
    const int first = joint.q + joint_nq(joint.kind) - size;
    if (!(std::abs(q.segment(first, size).squaredNorm() - 1.0) < 2e-6)) return false;
  }
  return true;
}

/// Compiles all frames of the model, followed by the world.
std::vector<CompiledFrame> compile_frames(const Model& model) {
  std::vector<CompiledFrame> result;
  for (const Frame& frame : model.frames) result.push_back(compile_frame(model, frame));
  result.push_back(world_frame());
  return result;
}

}  // namespace

struct RigidBody::Impl {
  Impl(const Model& robot, double slip_velocity)
      : model(robot),
        tree(robot),
        passive(robot, slip_velocity),
        frames(compile_frames(robot)),
        slopes(passive.springs.places.size()),
        passive_dq(RowMatrix::Zero(robot.nv, robot.nv)),
        passive_dv(passive_dq),
        q(robot.q_neutral),
        v(Eigen::VectorXd::Zero(robot.nv)),
        a(v),
        at_rest(Eigen::VectorXd::Zero(robot.nv)),
        gravity(Eigen::VectorXd::Zero(robot.nv)),
        friction(Eigen::VectorXd::Zero(robot.nv)),
        friction_dv(Eigen::VectorXd::Zero(robot.nv)),
        kinematics(tree),
        inverse_dynamics(tree),
        momentum(tree),
        derivatives(tree) {
    evaluate(robot.q_neutral, at_rest, at_rest);
  }

  Status check(const ConstVectorRef& new_q, const ConstVectorRef& new_v,
               const ConstVectorRef& new_a) const {
    if (new_q.size() != tree.nq || new_v.size() != tree.nv || new_a.size() != tree.nv)
      return Status::WrongSize;
    if (!new_q.allFinite() || !new_v.allFinite() || !new_a.allFinite()) return Status::NotFinite;
    return is_normalized(tree, new_q) ? Status::Ok : Status::NotNormalized;
  }

  void evaluate(const ConstVectorRef& new_q, const ConstVectorRef& new_v,
                const ConstVectorRef& new_a) {
    q = new_q;
    v = new_v;
    a = new_a;
    update_kinematics(tree, q.data(), v.data(), kinematics);
    accelerate(tree, kinematics, new_a.data(), inverse_dynamics);
    update_momentum(tree, kinematics, v.data(), momentum);
    burnish::gravity_torque(tree, kinematics, momentum, gravity.data());
    burnish::passive_torque(passive, v.data(), friction.data(), friction_dv.data());
    add_spring_torque(passive.springs, q.data(), v.data(), friction.data());
  }

  void update_passive_derivatives() {
    passive_dv.diagonal() = friction_dv;
    spring_slopes(passive.springs, q.data(), slopes.data());
    const std::vector<Springs::Place>& places = passive.springs.places;
    for (std::size_t i = 0; i < places.size(); ++i) {
      passive_dq(places[i].row, places[i].column) = slopes[i];
      if (places[i].row == places[i].column)
        passive_dv(places[i].row, places[i].column) += places[i].by_v;
      else
        passive_dv(places[i].row, places[i].column) = places[i].by_v;
    }
  }

  /// Returns the state of a frame. Frames are evaluated on demand, because most are never used.
  FrameState<double> state(int frame) const {
    FrameState<double> result;
    update_frame(frames.at(frame), kinematics, result);
    return result;
  }
  FrameState<double> state_with_acceleration(int frame) const {
    FrameState<double> result = state(frame);
    update_frame_acceleration(tree, frames[frame], kinematics, inverse_dynamics, result);
    return result;
  }
  CompiledReference reference(int frame, const Reference& stated) const {
    return compile_reference(model, stated, frames.at(frame), frames.back());
  }
  std::span<const MovingAxis> support(int frame, const Anchor& anchor) const {
    const std::span<const MovingAxis> tool = frames.at(frame).support, world;
    return fixed_in(anchor, tool, world, world, [&](const std::string& name) {
      return model.has_frame(name)
                 ? std::span<const MovingAxis>(frames[model.frame_index(name)].support)
                 : world;
    });
  }
  FrameError<double> error(int frame, const Eigen::Isometry3d& target) const {
    return frame_error(state(frame), from_eigen(Eigen::Matrix3d(target.linear())),
                       from_eigen(Eigen::Vector3d(target.translation())));
  }
  MatrixView view(const std::vector<double>& entries, int rows) const {
    return {entries.data(), rows, tree.nv};
  }
  VectorView view(const std::vector<double>& entries) const { return {entries.data(), tree.nv}; }

  Model model;
  Tree tree;
  PassiveJoints passive;
  std::vector<CompiledFrame> frames;
  std::vector<double> slopes;        ///< Derivatives of spring torques by q, at `springs.places`
  RowMatrix passive_dq, passive_dv;  ///< Nonzero only at `springs.places` and on the diagonal
  Eigen::VectorXd q, v, a, at_rest;
  Eigen::VectorXd gravity, friction, friction_dv;
  Kinematics<double> kinematics;
  InverseDynamics<double> inverse_dynamics;
  Momentum<double> momentum;
  MomentumDerivatives<double> derivatives;
};

RigidBody::RigidBody(const Model& model, double slip_velocity)
    : impl_(std::make_unique<Impl>(model, slip_velocity)) {}
RigidBody::~RigidBody() = default;
RigidBody::RigidBody(RigidBody&&) noexcept = default;
RigidBody& RigidBody::operator=(RigidBody&&) noexcept = default;

int RigidBody::nq() const { return impl_->tree.nq; }
int RigidBody::nv() const { return impl_->tree.nv; }
int RigidBody::frame(const std::string& name) const {
  if (name == "world" && !impl_->model.has_frame(name))
    return static_cast<int>(impl_->frames.size()) - 1;
  return impl_->model.frame_index(name);
}

Status RigidBody::set_payload(std::string_view frame, const InertiaSpec& payload) {
  const LoadedBody loaded = loaded_body("set_payload", impl_->model, frame, payload);
  if (loaded.status != Status::Ok) return loaded.status;
  set_body_inertia(impl_->tree, loaded.body, body_inertia(loaded.inertia));
  impl_->momentum.set_mass(impl_->tree);
  impl_->evaluate(impl_->q, impl_->v, impl_->a);
  return Status::Ok;
}

Status RigidBody::update(const ConstVectorRef& q, const ConstVectorRef& v) {
  return update(q, v, impl_->at_rest);
}
Status RigidBody::update(const ConstVectorRef& q, const ConstVectorRef& v,
                         const ConstVectorRef& a) {
  const Status status = impl_->check(q, v, a);
  if (status == Status::Ok) impl_->evaluate(q, v, a);
  return status;
}

KinematicState RigidBody::state() const { return {impl_->q, impl_->v, impl_->kinematics}; }

Eigen::Isometry3d RigidBody::placement(int frame) const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = to_eigen(impl_->state(frame).R);
  result.translation() = to_eigen(impl_->state(frame).p);
  return result;
}
Vector6 RigidBody::velocity(int frame, const Reference& reference) const {
  const CompiledReference compiled = impl_->reference(frame, reference);
  return stacked(
      frame_velocity(compiled, reference_pose(compiled, impl_->kinematics), impl_->state(frame)));
}
Vector6 RigidBody::acceleration(int frame, const Reference& reference) const {
  const CompiledReference compiled = impl_->reference(frame, reference);
  return stacked(frame_acceleration(compiled, reference_pose(compiled, impl_->kinematics),
                                    impl_->kinematics, impl_->state_with_acceleration(frame)));
}

void RigidBody::frame_jacobian(int frame, const Reference& reference, RowMatrix& out) const {
  const CompiledReference seen_in = impl_->reference(frame, reference);
  clear(out, 6, nv());
  burnish::frame_jacobian(impl_->frames.at(frame), seen_in,
                          reference_pose(seen_in, impl_->kinematics), impl_->kinematics, out.data(),
                          nv());
}

void RigidBody::frame_derivatives(int frame, const Reference& reference,
                                  FrameDerivatives& out) const {
  const CompiledFrame& compiled = impl_->frames.at(frame);
  const FrameState<double> state = impl_->state_with_acceleration(frame);
  const CompiledReference seen_in = impl_->reference(frame, reference);
  const FrameReference<double> at{
      seen_in,
      reference_pose(seen_in, impl_->kinematics),
      {impl_->support(frame, reference.origin), impl_->support(frame, reference.axes)}};
  const int n = nv();
  for (RowMatrix* matrix :
       {&out.jacobian, &out.velocity_dq, &out.acceleration_dq, &out.acceleration_dv})
    clear(*matrix, 6, n);
  burnish::frame_jacobian(compiled, seen_in, at.pose, impl_->kinematics, out.jacobian.data(), n);
  frame_velocity_derivative(compiled, at, impl_->kinematics, state, out.velocity_dq.data(), n);
  frame_acceleration_derivatives(compiled, at, impl_->kinematics, impl_->inverse_dynamics, state,
                                 {out.acceleration_dq.data(), out.acceleration_dv.data(), n});
}

Vector6 RigidBody::placement_error(int frame, const Eigen::Isometry3d& target) const {
  return stacked(impl_->error(frame, target).placement);
}

void RigidBody::placement_derivatives(int frame, const Eigen::Isometry3d& target,
                                      PlacementDerivatives& out) const {
  const CompiledFrame& compiled = impl_->frames.at(frame);
  const FrameState<double> state = impl_->state(frame);
  const FrameError<double> error = impl_->error(frame, target);
  const Kinematics<double>& kinematics = impl_->kinematics;
  const int n = nv();
  for (RowMatrix* matrix : {&out.position, &out.rotation, &out.rotation_error})
    clear(*matrix, 3, n);
  clear(out.placement_error, 6, n);
  frame_position_derivative(compiled, kinematics, state, out.position.data(), n);
  frame_rotation_derivative(compiled, kinematics, state, out.rotation.data(), n);
  frame_rotation_error_derivative(compiled, kinematics, state, error, out.rotation_error.data(), n);
  frame_placement_error_derivative(compiled, kinematics, state, error, out.placement_error.data(),
                                   n);
}

double RigidBody::mass() const { return impl_->momentum.mass; }
Eigen::Vector3d RigidBody::com() const { return to_eigen(impl_->momentum.com); }
Eigen::Vector3d RigidBody::com_velocity() const { return to_eigen(impl_->momentum.com_velocity); }
Vector6 RigidBody::momentum() const { return stacked(impl_->momentum.total); }
Vector6 RigidBody::centroidal_momentum() const { return stacked(impl_->momentum.centroidal); }
double RigidBody::kinetic_energy() const { return impl_->momentum.kinetic; }
double RigidBody::potential_energy() const { return impl_->momentum.potential; }
VectorView RigidBody::gravity_torque() const { return {impl_->gravity.data(), nv()}; }
VectorView RigidBody::passive_torque() const { return {impl_->friction.data(), nv()}; }

void RigidBody::update_derivatives() {
  momentum_derivatives(impl_->tree, impl_->kinematics, impl_->momentum, impl_->v.data(),
                       impl_->derivatives);
  impl_->update_passive_derivatives();
}

MatrixView RigidBody::com_dq() const { return impl_->view(impl_->derivatives.com_dq, 3); }
MatrixView RigidBody::com_velocity_dq() const {
  return impl_->view(impl_->derivatives.com_velocity_dq, 3);
}
MatrixView RigidBody::momentum_dq() const { return impl_->view(impl_->derivatives.total_dq, 6); }
MatrixView RigidBody::momentum_dv() const { return impl_->view(impl_->derivatives.total_dv, 6); }
MatrixView RigidBody::centroidal_momentum_dq() const {
  return impl_->view(impl_->derivatives.centroidal_dq, 6);
}
MatrixView RigidBody::centroidal_momentum_dv() const {
  return impl_->view(impl_->derivatives.centroidal_dv, 6);
}
VectorView RigidBody::kinetic_energy_dq() const {
  return impl_->view(impl_->derivatives.kinetic_dq);
}
VectorView RigidBody::kinetic_energy_dv() const {
  return impl_->view(impl_->derivatives.kinetic_dv);
}
VectorView RigidBody::potential_energy_dq() const {
  return impl_->view(impl_->derivatives.potential_dq);
}
double RigidBody::spring_energy() const {
  return burnish::spring_energy(impl_->passive.springs, impl_->q.data());
}
MatrixView RigidBody::passive_torque_dq() const { return {impl_->passive_dq.data(), nv(), nv()}; }
MatrixView RigidBody::passive_torque_dv() const { return {impl_->passive_dv.data(), nv(), nv()}; }

}  // namespace burnish
