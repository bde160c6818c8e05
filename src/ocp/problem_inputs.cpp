// Inputs of a Problem: setting them, and their effect on the targets of the knots.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "dynamics/reference.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish {
namespace {

/// Returns Ok, or the reason why an input cannot have this value.
Status check_value(const ocp::InputState& input, const ConstVectorRef& value) {
  if (value.size() != input.size) return Status::WrongSize;
  if (!value.allFinite()) return Status::NotFinite;
  if (input.is_friction && value.minCoeff() < 0.0) return Status::NotFinite;
  if (input.spec.kind == InputKind::Rotation && !is_unit_quaternion(value))
    return Status::NotNormalized;
  return Status::Ok;
}

}  // namespace

ocp::InputState& Problem::Impl::input(const char* call, int index,
                                      std::initializer_list<InputKind> kinds) {
  const int count = compiled.inputs.count();
  if (index < 0 || index >= count)
    throw Error(std::string(call) + ": input " + std::to_string(index) +
                " does not exist; wanted " +
                (count == 0 ? "a problem with inputs" : "0 to " + std::to_string(count - 1)));
  try {
    if (kinds.size() > 0) compiled.inputs.check_kind(index, kinds);
  } catch (const Error& error) {
    throw Error(std::string(call) + ": " + error.what());
  }
  return compiled.inputs[index];
}

void Problem::Impl::evaluate_input(int index, int knot) {
  const ocp::InputState& state = compiled.inputs[index];
  const double time = times[to_size(knot)];
  double* const out = inputs_of(knot) + compiled.inputs.first()[to_size(index)];
  ocp::evaluate_value(state, time, out);
  if (!(state.decay_time > 0.0)) return;
  const double remaining = std::exp((times[0] - time) / state.decay_time);
  for (int i = 0; i < state.size; ++i) out[i] += remaining * state.decaying[i];
}

void Problem::Impl::check_inputs(int knot) {
  const InputValues values(inputs_of(knot), compiled.inputs.first());
  for (int i = 0; i < compiled.inputs.count(); ++i) {
    if (values[i].allFinite()) continue;
    const ocp::InputState& state = compiled.inputs[i];
    throw Error("input " + in_quotes(state.spec.name) + ": its value at " +
                number(times[to_size(knot)]) + " s is not valid; wanted " +
                (state.is_friction                        ? "a friction of at least 0"
                 : state.spec.kind == InputKind::Rotation ? "a quaternion of length 1"
                                                          : "finite numbers"));
  }
}

void Problem::Impl::load_targets(int knot) {
  const ocp::CompiledStage& at = stage(knot);
  for (int i = 0; i < compiled.inputs.count(); ++i) evaluate_input(i, knot);
  const InputValues values(inputs_of(knot), compiled.inputs.first());
  double* const out = targets_of(knot);
  ocp::load_targets(at, times[to_size(knot)], values, signal_scratch, out);
  if (at.uses.empty()) return;
  std::copy_n(out, at.targets, signals_of(knot));
  for (const ocp::CompiledUse& use : at.uses) compiled.inputs.apply(use, inputs_of(knot), out);
}

void Problem::Impl::load_input(int index) {
  for (int knot = 0; knot < static_cast<int>(stage_of.size()); ++knot) {
    evaluate_input(index, knot);
    double* const out = targets_of(knot);
    for (const ocp::CompiledUse& use : stage(knot).uses) {
      if (use.input != index) continue;
      std::copy_n(signals_of(knot) + use.target, use.size, out + use.target);
      for (const ocp::CompiledUse& other : stage(knot).uses)
        if (other.target < use.target + use.size && use.target < other.target + other.size)
          compiled.inputs.apply(other, inputs_of(knot), out);
    }
  }
}

std::vector<std::string> Problem::input_names() const {
  std::vector<std::string> names;
  for (const InputSpec& input : spec().inputs) names.push_back(input.name);
  return names;
}

int Problem::input_index(const std::string& name) const {
  return impl_->compiled.inputs.index(name);
}

Status Problem::set_input(int input, const ConstVectorRef& value) {
  ocp::InputState& state =
      impl_->input("set_input", input, {InputKind::Scalar, InputKind::Vector, InputKind::Rotation});
  const Status status = check_value(state, value);
  if (status != Status::Ok) return status;
  state.value = value;
  state.decay_time = 0.0;
  impl_->accept_input(input);
  return Status::Ok;
}

Status Problem::set_input(int input, double value) {
  return set_input(input, Eigen::Matrix<double, 1, 1>(value));
}

Status Problem::set_input(int input, const ConstVectorRef& value, const ConstVectorRef& decaying,
                          double decay_time) {
  ocp::InputState& state = impl_->input("set_input", input, {InputKind::Scalar, InputKind::Vector});
  const Status status = check_value(state, value);
  if (status != Status::Ok) return status;
  if (decaying.size() != state.size) return Status::WrongSize;
  if (!decaying.allFinite() || !(decay_time > 0.0)) return Status::NotFinite;
  if (state.is_friction && (value + decaying).minCoeff() < 0.0) return Status::NotFinite;
  state.value = value;
  state.decaying = decaying;
  state.decay_time = decay_time;
  impl_->accept_input(input);
  return Status::Ok;
}

void Problem::Impl::accept_input(int index) {
  ocp::InputState& state = compiled.inputs[index];
  state.is_set = true;
  if (state.is_bias) load_bias(state);
  load_input(index);
}

void Problem::Impl::load_bias(const ocp::InputState& state) {
  ocp::evaluate_value(state, 0.0, compiled.torque_bias.data());
  std::copy_n(state.decaying.data(), state.size, compiled.decaying_torque.data());
  decay_time = state.decay_time;
}

Status Problem::set_input(int input, const Quadric& surface, double depth) {
  ocp::InputState& state = impl_->input("set_input", input, {InputKind::Surface});
  if (!surface.is_finite() || !std::isfinite(depth) || depth < 0.0) return Status::NotFinite;
  state.surface = surface;
  state.depth = depth;
  impl_->accept_input(input);
  return Status::Ok;
}

Status Problem::set_input(int input, const InertiaSpec& payload) {
  return set_payload(impl_->input("set_input", input, {InputKind::Inertia}).spec.frame, payload);
}

void Problem::reset_input(int input) {
  ocp::InputState& state = impl_->input("reset_input", input, {});
  state.is_set = false;
  state.decay_time = 0.0;
  if (state.spec.kind == InputKind::Inertia) (void)set_payload(state.spec.frame, InertiaSpec{});
  if (state.is_bias) impl_->load_bias(state);
  impl_->load_input(input);
}

Eigen::VectorXd Problem::input_at(int input, int knot) const {
  const ocp::InputState& state = impl_->input("input_at", input, {});
  if (knot < 0 || knot > knots())
    throw Error("input_at: knot " + std::to_string(knot) + " does not exist; wanted 0 to " +
                std::to_string(knots()));
  if (!state.has_value()) return {};
  return InputValues(impl_->inputs_of(knot), impl_->compiled.inputs.first())[input];
}

}  // namespace burnish
