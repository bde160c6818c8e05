// Definitions of custom_lanes.hpp.
#pragma once

#include "base/to_size.hpp"
#include "ocp/custom_lanes.hpp"
#include "ocp/stage_dynamics.tpp"

namespace burnish::ocp {

template <class S>
LaneView<S>::LaneView(const CompiledProblem& problem)
    : model_(&problem.model),
      layout_(&problem.layout),
      q_(problem.layout.nq),
      v_(problem.layout.nv),
      u_(problem.layout.nu),
      tau_(problem.layout.nv),
      a_(problem.layout.nv),
      lambda_(problem.contacts.rows()),
      columns_(to_size(6 * problem.layout.nv)),
      jacobian_(6, problem.layout.nv),
      force_derivative_(problem.contacts.rows(), problem.layout.nz()) {}

template <class S>
void LaneView<S>::load(const KnotState<S>& knot, const CustomResidual& residual, int lane,
                       double time) {
  knot_ = &knot;
  residual_ = &residual;
  lane_ = lane;
  time_ = time;
  const auto copy = [lane](const S* from, Eigen::VectorXd& to) {
    for (Eigen::Index i = 0; i < to.size(); ++i) to[i] = Lanes<S>::get(from[i], lane);
  };
  copy(knot.q, q_);
  copy(knot.v, v_);
  copy(knot.u, u_);
  copy(knot.tau, tau_);
  if (knot.solved) {
    copy(knot.dynamics->a.data(), a_);
    copy(knot.dynamics->lambda.data(), lambda_);
  } else {
    a_.setZero();
    lambda_.setZero();
  }
  if (knot.dlambda_dz == nullptr) return;
  for (int r = 0; r < knot.dynamics->rows(); ++r)
    for (int c = 0; c < layout_->nz(); ++c)
      force_derivative_(r, c) = Lanes<S>::get(knot.dlambda_dz[r * layout_->nz() + c], lane);
}

namespace custom_detail {
template <class S>
Eigen::Vector3d lane_of_vector(const Vec3<S>& v, int lane) {
  return {Lanes<S>::get(v.x, lane), Lanes<S>::get(v.y, lane), Lanes<S>::get(v.z, lane)};
}
}  // namespace custom_detail

template <class S>
Eigen::Isometry3d LaneView<S>::placement(int frame) const {
  const FrameState<S>& state = knot_->frames[residual_->frames.at(frame)];
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (int c = 0; c < 3; ++c)
    result.linear().col(c) = custom_detail::lane_of_vector(column(state.R, c), lane_);
  result.translation() = custom_detail::lane_of_vector(state.p, lane_);
  return result;
}

template <class S>
CompiledReference LaneView<S>::compiled(int frame, const Reference& reference) const {
  return compile_reference(*model_, reference, knot_->compiled_frames[frame], world_frame());
}

template <class S>
Vector6 LaneView<S>::velocity(int frame, const Reference& reference) const {
  const int f = residual_->frames.at(frame);
  const CompiledReference seen_in = compiled(f, reference);
  const Motion<S> m = frame_velocity(
      seen_in, reference_pose(seen_in, knot_->dynamics->kinematics()), knot_->frames[f]);
  Vector6 result;
  result << custom_detail::lane_of_vector(m.linear, lane_),
      custom_detail::lane_of_vector(m.angular, lane_);
  return result;
}

template <class S>
VectorView LaneView<S>::force(int contact) const {
  const int c = residual_->contacts.at(contact);
  const int rows = static_cast<int>(knot_->dynamics->set().contacts()[c].directions.size());
  return {lambda_.data() + knot_->dynamics->active().first_row[c], rows};
}

template <class S>
MatrixView LaneView<S>::jacobian(int frame, const Reference& reference) const {
  const int f = residual_->frames.at(frame);
  std::fill(columns_.begin(), columns_.end(), S(0.0));
  const CompiledReference seen_in = compiled(f, reference);
  const Kinematics<S>& kinematics = knot_->dynamics->kinematics();
  frame_jacobian(knot_->compiled_frames[f], seen_in, reference_pose(seen_in, kinematics),
                 kinematics, columns_.data(), layout_->nv);
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < layout_->nv; ++k)
      jacobian_(i, k) = Lanes<S>::get(columns_[i * layout_->nv + k], lane_);
  return {jacobian_.data(), 6, layout_->nv};
}

template <class S>
MatrixView LaneView<S>::force_derivative(int contact) const {
  const int c = residual_->contacts.at(contact);
  const int rows = static_cast<int>(knot_->dynamics->set().contacts()[c].directions.size());
  const int first = knot_->dynamics->active().first_row[c];
  return {force_derivative_.data() + first * layout_->nz(), rows, layout_->nz()};
}

template <class S>
CustomLanes<S>::CustomLanes(const CompiledProblem& problem)
    : problem_(&problem),
      view_(problem),
      moved_(problem),
      moved_view_(problem),
      value_(problem.largest_rows),
      plus_(problem.largest_rows),
      minus_(problem.largest_rows),
      jacobian_(problem.largest_rows, problem.layout.nz()),
      x_(to_size(problem.layout.nx())),
      x_moved_(x_),
      u_(to_size(problem.layout.nu)),
      targets_(to_size(problem.largest_targets)),
      dx_(to_size(problem.layout.ndx())) {}

template <class S>
void CustomLanes<S>::evaluate(const CompiledStage& stage, const CustomResidual& residual,
                              const KnotState<S>& knot, const double* times, S* r, S* J) {
  const int rows = residual.user.rows, nz = problem_->layout.nz();
  for (int l = 0; l < Lanes<S>::count; ++l) {
    view_.load(knot, residual, l, times[l]);
    residual.user.value(view_, value_.head(rows));
    for (int i = 0; i < rows; ++i) Lanes<S>::set(r[i], l, value_[i]);
    if (J == nullptr) continue;
    jacobian_.topRows(rows).setZero();
    if (residual.user.jacobian) {
      residual.user.jacobian(view_, jacobian_.topRows(rows));
    } else {
      const auto copy = [l](const S* from, std::vector<double>& to, std::size_t at,
                            std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) to[at + i] = Lanes<S>::get(from[i], l);
      };
      const StateLayout& layout = problem_->layout;
      const auto nq = to_size(layout.nq), nv = to_size(layout.nv);
      copy(knot.q, x_, 0, nq);
      copy(knot.v, x_, nq, nv);
      copy(knot.torque_state, x_, nq + nv, x_.size() - nq - nv);
      copy(knot.u, u_, 0, u_.size());
      copy(knot.targets, targets_, 0, to_size(stage.targets));
      moved_.turn(stage, targets_.data());
      moved_.set_step(Lanes<S>::get(knot.per_second, l), Lanes<S>::get(knot.step_ratio, l),
                      Lanes<S>::get(knot.decaying, l));
      differences(stage, residual, times[l]);
    }
    for (int i = 0; i < rows; ++i)
      for (int c = 0; c < nz; ++c) Lanes<S>::set(J[i * nz + c], l, jacobian_(i, c));
  }
}

template <class S>
void CustomLanes<S>::moved_value(const CompiledStage& stage, const CustomResidual& residual,
                                 double time, int z, double by, Eigen::VectorXd& out) {
  const StateLayout& layout = problem_->layout;
  const double u_before = z < layout.nu ? u_[z] : 0.0;
  std::fill(dx_.begin(), dx_.end(), 0.0);
  if (z < layout.nu) {
    u_[z] += by;
  } else {
    dx_[z - layout.nu] = by;
  }
  integrate_configuration(problem_->tree, x_.data(), dx_.data(), x_moved_.data());
  for (int i = 0; i < layout.ndx() - layout.nv; ++i)
    x_moved_[layout.nq + i] = x_[layout.nq + i] + dx_[layout.nv + i];
  moved_.values(stage, x_moved_.data(), u_.data());
  moved_view_.load(moved_.knot(), residual, 0, time);
  residual.user.value(moved_view_, out.head(residual.user.rows));
  if (z < layout.nu) u_[z] = u_before;
}

template <class S>
void CustomLanes<S>::differences(const CompiledStage& stage, const CustomResidual& residual,
                                 double time) {
  constexpr double h = 1e-5;  // step of central differences, in units of z; chosen by hand
  const int rows = residual.user.rows;
  for (int z = 0; z < problem_->layout.nz(); ++z) {
    moved_value(stage, residual, time, z, h, plus_);
    moved_value(stage, residual, time, z, -h, minus_);
    jacobian_.topRows(rows).col(z) = (plus_.head(rows) - minus_.head(rows)) / (2.0 * h);
  }
}

}  // namespace burnish::ocp
