// Definitions of stage_dynamics.hpp.
#pragma once

#include <algorithm>

#include "base/to_size.hpp"
#include "ocp/stage_dynamics.hpp"

namespace burnish::ocp {

template <class S>
StageDynamics<S>::Impact::Impact(const CompiledProblem& problem)
    : dynamics(problem.model, problem.contacts, problem.contact_solver), derivatives(dynamics) {}

template <class S>
StageDynamics<S>::StageDynamics(const CompiledProblem& problem)
    : problem_(&problem),
      dynamics_(problem.model, problem.contacts, problem.contact_solver),
      derivatives_(dynamics_),
      active_(to_size(problem.contacts.size()), 1),
      impact_active_(active_),
      momentum_(problem.tree),
      momentum_derivatives_(problem.tree),
      status_(to_size(Lanes<S>::count), Status::Ok) {
  const StateLayout& layout = problem.layout;
  const auto room = [](int count) { return to_size(count); };
  if (problem.has_impacts) impact_.emplace(problem);
  std::size_t frames = 0;
  for (const CompiledStage& stage : problem.stages) frames = std::max(frames, stage.frames.size());
  frames_.resize(frames);
  x_.assign(room(layout.nx()), S(0.0));
  u_.assign(room(layout.nu), S(0.0));
  for (auto* vector : {&tau_, &total_, &passive_, &dpassive_})
    vector->assign(room(layout.nv), S(0.0));
  if (problem.passive) slopes_.assign(problem.passive->springs.places.size(), S(0.0));
  scratch_.assign(room(6 * layout.nz()), S(0.0));
  stacked_.assign(room((layout.nv + problem.contacts.rows()) * layout.nz()), S(0.0));
  knot_.layout = &problem.layout;
  knot_.q = x_.data();
  knot_.v = x_.data() + layout.nq;
  knot_.torque_state = x_.data() + layout.nq + layout.nv;
  knot_.force_before = knot_.torque_state + layout.filtered;
  knot_.u = u_.data();
  knot_.tau = tau_.data();
  knot_.dynamics = &dynamics_;
  knot_.frames = frames_.data();
  knot_.momentum = &momentum_;
  knot_.scratch = scratch_.data();
}

template <class S>
void StageDynamics<S>::activate(const std::vector<char>& wanted, std::vector<char>& now,
                                ConstrainedDynamics<S>& dynamics) {
  for (std::size_t c = 0; c < wanted.size(); ++c)
    if (now[c] != wanted[c]) {
      dynamics.set_active(static_cast<int>(c), wanted[c] != 0);
      now[c] = wanted[c];
    }
}

template <class S>
void StageDynamics<S>::apply_torques(const CompiledStage& stage) {
  const StateLayout& layout = problem_->layout;
  std::fill(tau_.begin(), tau_.end(), S(0.0));
  const S* const driving = layout.acts_from_state() ? knot_.torque_state : u_.data();
  const bool driven = layout.acts_from_state() || stage.nu > 0;
  if (driven)
    for (int i = 0; i < layout.nu; ++i) tau_[layout.actuated[i]] = driving[i];
  if (problem_->passive) {
    passive_torque(*problem_->passive, knot_.v, passive_.data(), dpassive_.data(),
                   knot_.step_ratio);
    add_spring_torque(problem_->passive->springs, knot_.q, knot_.v, passive_.data());
  }
  for (int k = 0; k < layout.nv; ++k)
    total_[k] = tau_[k] + passive_[k] + S(problem_->torque_bias[k]) +
                knot_.decaying * S(problem_->decaying_torque[k]);
}

template <class S>
void StageDynamics<S>::turn(const CompiledStage& stage, const S* targets) {
  knot_.targets = targets;
  for (const CompiledTurning& turning : stage.turnings) {
    if (turning.contact < 0) continue;
    const Mat3<S> rotation = rotation_of(targets + turning.target);
    dynamics_.set_reference_rotation(turning.contact, rotation);
    if (stage.impact) impact_->dynamics.set_reference_rotation(turning.contact, rotation);
  }
  for (const CompiledSurface& followed : stage.surfaces) {
    if (followed.contact < 0) continue;
    const CurvedSurface<S> surface = surface_of(targets + followed.target);
    dynamics_.set_surface(followed.contact, surface);
    if (stage.impact) impact_->dynamics.set_surface(followed.contact, surface);
  }
  for (const CompiledFriction& friction : stage.frictions)
    dynamics_.set_friction(friction.contact, targets[friction.target]);
}

template <class S>
void StageDynamics<S>::values(const CompiledStage& stage, const S* x, const S* u) {
  std::copy_n(x, x_.size(), x_.data());
  if (stage.nu > 0) {
    std::copy_n(u, u_.size(), u_.data());
  } else {
    std::fill(u_.begin(), u_.end(), S(0.0));
  }
  activate(stage.active, active_, dynamics_);
  dynamics_.set_state(knot_.q, knot_.v);
  apply_torques(stage);
  if (stage.solves_contacts) dynamics_.forward(total_.data());
  for (int l = 0; l < Lanes<S>::count; ++l) status_[l] = dynamics_.status(l);
  for (std::size_t f = 0; f < stage.frames.size(); ++f)
    update_frame(stage.frames[f], dynamics_.kinematics(), frames_[f]);
  knot_.compiled_frames = stage.frames.data();
  knot_.solved = stage.solves_contacts;
  if (stage.has_momentum)
    update_momentum(problem_->tree, dynamics_.kinematics(), knot_.v, momentum_);
  knot_.da_dz = nullptr;
  knot_.dlambda_dz = nullptr;
  knot_.momentum_derivatives = nullptr;
}

template <class S>
void StageDynamics<S>::stack_by_z(const CompiledStage& stage) {
  const StateLayout& layout = problem_->layout;
  const int nv = layout.nv, nz = layout.nz();
  const int rows = nv + dynamics_.rows();
  const bool from_state = layout.acts_from_state();
  const int torque_column = from_state ? layout.column_tau() : 0;
  const int idle = from_state ? layout.column_force() : layout.column_tau();  // first zero column
  const bool driven = from_state || stage.nu > 0;
  if (problem_->passive) spring_slopes(problem_->passive->springs, knot_.q, slopes_.data());
  for (int i = 0; i < rows; ++i) {
    S* const out = stacked_.data() + i * nz;
    const S* const by_tau = derivatives_.d_dtau.data() + i * nv;
    if (from_state || !driven) std::fill_n(out, layout.nu, S(0.0));
    std::fill(out + idle, out + nz, S(0.0));
    if (driven)
      for (int c = 0; c < layout.nu; ++c) out[torque_column + c] = by_tau[layout.actuated[c]];
    std::copy_n(derivatives_.d_dq.data() + i * nv, nv, out + layout.column_q());
    const S* const by_v = derivatives_.d_dv.data() + i * nv;
    S* const out_v = out + layout.column_v();
    if (problem_->passive) {
      for (int k = 0; k < nv; ++k) out_v[k] = by_v[k] + by_tau[k] * dpassive_[k];
      const std::vector<Springs::Place>& places = problem_->passive->springs.places;
      for (std::size_t s = 0; s < places.size(); ++s) {
        const S& torque = by_tau[places[s].row];
        out[layout.column_q() + places[s].column] += torque * slopes_[s];
        out_v[places[s].column] += torque * S(places[s].by_v);
      }
    } else {
      std::copy_n(by_v, nv, out_v);
    }
  }
}

template <class S>
void StageDynamics<S>::derivatives(const CompiledStage& stage) {
  if (stage.solves_contacts) {
    derivatives_.forward(dynamics_);
    stack_by_z(stage);
    knot_.da_dz = stacked_.data();
    knot_.dlambda_dz = stacked_.data() + problem_->layout.nv * problem_->layout.nz();
  }
  if (stage.has_momentum) {
    momentum_derivatives(problem_->tree, dynamics_.kinematics(), momentum_, knot_.v,
                         momentum_derivatives_);
    knot_.momentum_derivatives = &momentum_derivatives_;
  }
}

template <class S>
void StageDynamics<S>::impact(const CompiledStage& stage, bool with_derivatives) {
  ConstrainedDynamics<S>& jump = impact_->dynamics;
  activate(stage.active, impact_active_, jump);
  jump.impact(knot_.q, knot_.v);
  for (int l = 0; l < Lanes<S>::count; ++l) status_[l] = worst(status_[l], jump.status(l));
  if (!with_derivatives) return;
  impact_->derivatives.impact(jump);
  const StateLayout& layout = problem_->layout;
  const int nv = layout.nv, nz = layout.nz();
  for (int i = 0; i < nv; ++i) {
    S* const out = stacked_.data() + i * nz;
    std::fill_n(out, nz, S(0.0));
    std::copy_n(impact_->derivatives.d_dq.data() + i * nv, nv, out + layout.column_q());
    std::copy_n(impact_->derivatives.d_dv.data() + i * nv, nv, out + layout.column_v());
  }
}

}  // namespace burnish::ocp
