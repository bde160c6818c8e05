// Inputs of an optimal control problem: named values that change between solves.
#pragma once

#include <string>

#include "burnish/base/signal.hpp"

namespace burnish {

/// Kind of value that an input of a problem can have.
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
/// Entries of the specification name the input that they use. Costs and constraints have
/// offset_input, friction_ratio_input and surface_input. Contacts have ContactSpec::surface_input
/// and SlidingFriction::coefficient_input. The problem has ProblemSpec::torque_bias_input. Several
/// entries can name the same input. An inertia acts without being named.
struct InputSpec {
  std::string name = {};  ///< Unique name @required
  InputKind kind = InputKind::Scalar;
  /// Value until Problem::set_input() sets one: constant, or a function of time; empty: none
  /// @more While an input has no value, its uses keep the values of the specification. A vector
  /// needs this value, because the value defines the number of entries. A surface or an inertia
  /// cannot have this value
  Signal value = {};
  /// Frame of the robot that carries the payload; required for an inertia, empty for other kinds
  std::string frame = {};
};

}  // namespace burnish
