// Inputs of an optimal control problem: named values that change between solves.
#pragma once

#include <string>

#include "burnish/base/signal.hpp"

namespace burnish {

/// Kind of value of a problem's input.
/// @described ocp
enum class InputKind {
  Scalar,    ///< A number
  Vector,    ///< Several numbers
  Rotation,  ///< A unit quaternion x, y, z, w
  Surface,   ///< A curved surface, and the depth by which it yields along its normal
  Inertia,   ///< The inertia of a payload that the robot carries at `frame`
};

/// Input of a problem: a named value to which costs, constraints and contacts refer. Estimators and
/// tasks set the value between solves. An input changes values only: terms, rows and contacts stay
/// the same.
/// @described ocp
/// An input is used where an entry of the specification names it: CostTerm::offset_input,
/// friction_ratio_input and surface_input, the same entries of Constraint,
/// ContactSpec::surface_input, SlidingFriction::coefficient_input and
/// ProblemSpec::torque_bias_input. A term of another stage can use the same input.
struct InputSpec {
  std::string name = {};  ///< Unique name @required
  InputKind kind = InputKind::Scalar;
  /// Value of the input until Problem::set_input() sets one, constant or over time; empty: none
  /// @more While a scalar, a rotation, a surface or an inertia has no value, its uses keep the
  /// values of the specification. A vector needs a value, which defines its number of entries
  Signal value = {};
  /// Frame of the robot that carries the payload; only for an inertia
  std::string frame = {};
};

}  // namespace burnish
