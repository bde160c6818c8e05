#include "ocp/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/model/inertia.hpp"
#include "dynamics/reference.hpp"
#include "ocp/compiled_problem.hpp"
#include "ocp/descriptions.gen.hpp"

namespace burnish::ocp {
namespace {

/// Returns the name of a kind of input with its article, such as "a scalar".
std::string text_of(InputKind kind) {
  return (kind == InputKind::Inertia ? "an " : "a ") +
         words_of(kind).words[static_cast<std::size_t>(kind)].word;
}

[[noreturn]] void refuse(const std::string& input, const std::string& what) {
  throw Error("input " + in_quotes(input) + ": " + what);
}

/// Returns the number of entries of an input at a knot, after checks of its specification.
int checked_size(const InputSpec& spec) {
  const int stated = spec.value.size();
  const auto wanted = [&](int size) {
    if (stated != 0 && stated != size)
      refuse(spec.name, "the value has " + std::to_string(stated) + " entries; wanted " +
                            std::to_string(size));
    return size;
  };
  if (!spec.frame.empty() && spec.kind != InputKind::Inertia)
    refuse(spec.name,
           text_of(spec.kind) + " cannot have a frame; wanted no frame, or the kind inertia");
  switch (spec.kind) {
    case InputKind::Scalar:
      return wanted(1);
    case InputKind::Vector:
      if (stated == 0) refuse(spec.name, "the vector has no value; wanted a value, such as zeros");
      return stated;
    case InputKind::Rotation:
      return wanted(4);
    case InputKind::Surface:
    case InputKind::Inertia:
      if (stated != 0)
        refuse(spec.name, "the value has " + std::to_string(stated) +
                              " entries; wanted no value, because " + text_of(spec.kind) +
                              " gets its value only from set_input()");
  }
  return 0;
}

/// Throws Error for a constant value that is not finite, or a rotation not of length 1.
void check_constant(const InputSpec& spec) {
  if (spec.value.depends_on_inputs())
    refuse(spec.name, "the value depends on inputs; wanted a constant or a function of time");
  if (spec.value.empty() || !spec.value.is_constant()) return;
  Eigen::VectorXd value(spec.value.size());
  spec.value.at(0.0, value);
  if (!value.allFinite()) refuse(spec.name, "the value holds a NaN or an infinity");
  if (spec.kind == InputKind::Rotation && !is_unit_quaternion(value))
    refuse(spec.name,
           "the value is not a quaternion of length 1; wanted a unit quaternion x, y, z, w");
}

/// Throws Error if an inertia input has no valid frame, or shares its body with an earlier one.
void check_frame(const InputSpec& given, const ProblemSpec& spec) {
  if (given.frame.empty())
    refuse(given.name, "the inertia has no frame; wanted a frame of the robot");
  const std::string call = "input " + in_quotes(given.name);
  const int body = frame_on_body(call, spec.model, given.frame).body;
  for (const InputSpec& other : spec.inputs) {
    if (&other == &given) return;
    if (other.kind == InputKind::Inertia &&
        frame_on_body(call, spec.model, other.frame).body == body)
      refuse(given.name, "frame " + in_quotes(given.frame) + " and the frame of input " +
                             in_quotes(other.name) +
                             " are on one body; wanted at most one inertia for each body");
  }
}

/// Returns true if the only target of the residual is a coefficient of friction.
bool is_friction_margin(const CompiledResidual& residual) {
  const auto* pressure = std::get_if<PressureMargin>(&residual);
  return std::holds_alternative<ConeMargin>(residual) ||
         std::holds_alternative<PyramidMargin>(residual) ||
         (pressure != nullptr && pressure->has_friction);
}

bool has_target_point(const CompiledResidual& residual) {
  return std::holds_alternative<FramePositionError>(residual) ||
         std::holds_alternative<FrameDistance>(residual) ||
         std::holds_alternative<FramePlacementError>(residual);
}

using How = CompiledUse::How;

/// Returns the use of an input as the offset of a term's target.
CompiledUse offset_of(const CompiledTerm& term, int input, const InputState& state) {
  const bool has_offset = term.target_size > 0 && !is_friction_margin(term.residual) &&
                          !std::holds_alternative<StateDifference>(term.residual);
  if (!has_offset)
    throw Error("an input cannot change the target of this residual; wanted no offset_input");
  const InputKind kind = state.spec.kind;
  const bool has_rotation = term.load != CompiledTerm::Load::Plain;
  const bool has_point = term.load == CompiledTerm::Load::Placement;
  if (has_rotation && kind == InputKind::Rotation)
    return {How::Turn, input, term.target + (has_point ? 3 : 0), 9};
  const int entries = has_point ? 3 : has_rotation ? 0 : term.target_size;
  if (state.size != entries || kind == InputKind::Rotation)
    throw Error(
        "input " + in_quotes(state.spec.name) + " is " + text_of(kind) +
        (kind == InputKind::Vector ? " of " + std::to_string(state.size) + " entries" : "") +
        "; wanted " + (has_point ? "a rotation or " : "") +
        (entries == 0   ? "a rotation"
         : entries == 1 ? "a scalar"
                        : "a vector of " + std::to_string(entries) + " entries"));
  return {How::Offset, input, term.target, entries};
}

/// Adds the uses of the inputs that a cost or a constraint names.
template <class Given>
void add_uses(const Inputs& inputs, const Given& given, const CompiledTerm& term, int surface,
              CompiledStage& stage) {
  const auto named = [](const char* key, const std::string& name, const auto& add) {
    if (name.empty()) return;
    try {
      add();
    } catch (const Error& error) {
      throw Error(std::string(key) + ": " + error.what());
    }
  };
  named("offset_input", given.offset_input, [&] {
    const int input = inputs.index(given.offset_input);
    stage.uses.push_back(offset_of(term, input, inputs[input]));
  });
  named("friction_ratio_input", given.friction_ratio_input, [&] {
    if (!is_friction_margin(term.residual))
      throw Error(
          "the residual has no coefficient of friction; wanted a friction cone, or a centre of "
          "pressure with friction");
    const int input = inputs.index(given.friction_ratio_input, InputKind::Scalar);
    stage.uses.push_back({How::Ratio, input, term.target, 1});
  });
  named("surface_input", given.surface_input, [&] {
    const int input = inputs.index(given.surface_input, InputKind::Surface);
    if (surface >= 0) {
      stage.uses.push_back({How::Surface, input, surface, surface_size});
      return;
    }
    if (!has_target_point(term.residual))
      throw Error(
          "the residual has neither a curved reference nor a target position; wanted one of them");
    stage.uses.push_back({How::Depth, input, term.target, 3});
  });
}

}  // namespace

Inputs::Inputs(const ProblemSpec& spec) {
  for (const InputSpec& given : spec.inputs) {
    if (given.name.empty()) throw Error("an input has no name; wanted a name");
    for (const InputState& other : states_)
      if (other.spec.name == given.name)
        refuse(given.name, "the name is used twice; wanted unique names");
    InputState state{.spec = given, .size = checked_size(given)};
    check_constant(given);
    if (given.kind == InputKind::Inertia) check_frame(given, spec);
    state.value = state.decaying = Eigen::VectorXd::Zero(state.size);
    first_.push_back(first_.back() + state.size);
    states_.push_back(std::move(state));
  }
  // Contacts that are active in no stage are checked, too.
  CompiledStage unused;
  for (const ContactSpec& contact : spec.contacts)
    use(contact, contact.friction ? 0 : -1, contact.reference.quadric ? 0 : -1, unused);
  if (spec.torque_bias_input.empty()) return;
  const int found = index_of("torque_bias_input", spec.torque_bias_input, InputKind::Vector);
  InputState& bias = states_[to_size(found)];
  if (bias.size != spec.model.nv || !bias.spec.value.is_constant())
    refuse(bias.spec.name,
           "the value does not suit torque_bias_input; wanted a constant value of " +
               std::to_string(spec.model.nv) + " entries");
  bias.is_bias = true;
}

int Inputs::index(const std::string& name) const {
  std::vector<std::string> known;
  for (const InputState& state : states_) known.push_back(state.spec.name);
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end())
    throw Error("unknown input " + in_quotes(name) +
                (known.empty() ? "; the problem has no inputs" : did_you_mean(name, known)));
  return static_cast<int>(found - known.begin());
}

int Inputs::index(const std::string& name, InputKind kind) const {
  const int input = index(name);
  check_kind(input, {kind});
  return input;
}

int Inputs::index_of(const char* key, const std::string& name, InputKind kind) const {
  try {
    return index(name, kind);
  } catch (const Error& error) {
    throw Error(std::string(key) + ": " + error.what());
  }
}

void Inputs::check_kind(int input, std::initializer_list<InputKind> wanted) const {
  const InputSpec& given = (*this)[input].spec;
  if (std::find(wanted.begin(), wanted.end(), given.kind) != wanted.end()) return;
  std::string words;
  for (const InputKind kind : wanted)
    words += (words.empty()                      ? ""
              : kind == *std::prev(wanted.end()) ? " or "
                                                 : ", ") +
             text_of(kind);
  throw Error("input " + in_quotes(given.name) + " is " + text_of(given.kind) + "; wanted " +
              words);
}

void Inputs::use(const ContactSpec& contact, int friction, int surface,
                 CompiledStage& stage) const {
  try {
    if (friction >= 0 && !contact.friction->coefficient_input.empty())
      stage.uses.push_back(
          {How::Coefficient,
           index_of("coefficient_input", contact.friction->coefficient_input, InputKind::Scalar),
           friction, 1});
    if (contact.surface_input.empty()) return;
    if (surface < 0)
      throw Error("the reference follows no surface; wanted a reference on a curved surface");
    stage.uses.push_back({How::Surface,
                          index_of("surface_input", contact.surface_input, InputKind::Surface),
                          surface, surface_size});
  } catch (const Error& error) {
    throw Error("contact " + in_quotes(contact.name) + ": " + error.what());
  }
}

void Inputs::use(const CostTerm& given, const CompiledTerm& term, int surface,
                 CompiledStage& stage) const {
  add_uses(*this, given, term, surface, stage);
}
void Inputs::use(const Constraint& given, const CompiledTerm& term, int surface,
                 CompiledStage& stage) const {
  add_uses(*this, given, term, surface, stage);
}

void Inputs::mark_friction(const CompiledStage& stage) {
  for (const CompiledUse& use : stage.uses)
    if (use.how == How::Ratio || use.how == How::Coefficient) {
      InputState& state = states_[to_size(use.input)];
      double value = 0.0;
      if (state.spec.value.is_constant()) evaluate_value(state, 0.0, &value);
      state.is_friction = true;
      if (value < 0.0)
        refuse(state.spec.name,
               "the value is " + number(value) +
                   ", but it is used as a friction coefficient or as a factor of a "
                   "friction coefficient; wanted at least 0");
    }
}

void evaluate_value(const InputState& state, double time, double* out) {
  Eigen::Map<Eigen::VectorXd> value(out, state.size);
  if (state.is_set) {
    value = state.value;
  } else if (!state.spec.value.empty()) {
    state.spec.value.at(time, value);
    const bool is_valid = state.spec.kind == InputKind::Rotation ? is_unit_quaternion(value)
                          : state.is_friction                    ? value[0] >= 0.0
                                                                 : true;
    if (!is_valid) value.setConstant(std::numeric_limits<double>::quiet_NaN());
  } else {
    value.setZero();
  }
}

void Inputs::apply(const CompiledUse& use, const double* values, double* targets) const {
  const InputState& state = (*this)[use.input];
  if (!state.has_value()) return;
  const double* const x = values + first_[to_size(use.input)];
  double* const out = targets + use.target;
  switch (use.how) {
    case How::Offset:
      for (int i = 0; i < use.size; ++i) out[i] += x[i];
      break;
    case How::Turn: {
      Eigen::Map<Eigen::Matrix3d> rotation(out, 3, 3);
      rotation = (rotation * rotation_matrix(Eigen::Map<const Eigen::Vector4d>(x))).eval();
      break;
    }
    case How::Ratio:
      *out *= std::min(1.0, *x);
      break;
    case How::Coefficient:
      *out = *x;
      break;
    case How::Surface:
      store_surface(state.surface, out);
      break;
    case How::Depth: {
      if (!(state.depth > 0.0)) break;
      Eigen::Map<Eigen::Vector3d> p(out);
      const Eigen::Vector3d gradient = state.surface.gradient(p);
      const double length = gradient.norm();
      if (length > 1e-9) p -= state.depth / length * gradient;
      break;
    }
  }
}

}  // namespace burnish::ocp
