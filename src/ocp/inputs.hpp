// Inputs of a compiled problem: their state, and their use in target entries.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "burnish/dynamics/quadric.hpp"
#include "burnish/ocp/input.hpp"
#include "burnish/ocp/problem_spec.hpp"

namespace burnish::ocp {

struct CompiledStage;
struct CompiledTerm;

/// Use of an input in the target entries of a stage.
struct CompiledUse {
  enum class How {
    Offset,       ///< Adds the input to the entries
    Turn,         ///< Multiplies a rotation matrix by the input from the right
    Ratio,        ///< Multiplies a coefficient of friction by the input; values above 1 count as 1
    Coefficient,  ///< Replaces a coefficient of friction
    Surface,      ///< Replaces the numbers of a surface
    Depth,        ///< Moves a target position into the surface by InputState::depth
  };
  How how;
  int input;
  int target;  ///< First entry in the stage's targets
  int size;    ///< Number of target entries that change
};

/// An input: what its specification states, and what set_input() has set.
struct InputState {
  InputSpec spec;
  int size = 0;              ///< Number of entries at a knot; 0 for a surface and an inertia
  bool is_friction = false;  ///< True if the value must not be negative
  bool is_bias = false;      ///< True if the input is ProblemSpec::torque_bias_input
  bool is_set = false;       ///< True if set_input() has set a value
  Eigen::VectorXd value = {}, decaying = {};  ///< Set by set_input(); used if is_set
  double decay_time = 0.0;                    ///< Time constant of `decaying` [s]; 0: none
  Quadric surface = {};
  double depth = 0.0;  ///< Depth by which the surface yields [m]

  bool has_value() const { return is_set || !spec.value.empty(); }
};

/// Writes the value of an input at `time` [s], without the decaying part; zeros if the input has no
/// value. Writes NaN for an invalid value at this time: a quaternion whose length is not 1, or a
/// negative coefficient of friction.
void evaluate_value(const InputState& state, double time, double* out);

/// Inputs of a problem. Values at the knots are kept by the problem.
class Inputs {
 public:
  /// Throws Error for a specification with invalid inputs.
  explicit Inputs(const ProblemSpec& spec);

  int count() const { return static_cast<int>(states_.size()); }
  InputState& operator[](int input) { return states_[static_cast<std::size_t>(input)]; }
  const InputState& operator[](int input) const { return states_[static_cast<std::size_t>(input)]; }
  /// Index of each input's first entry at a knot, followed by the number of all entries.
  const std::vector<int>& first() const { return first_; }
  int entries() const { return first_.back(); }
  /// Returns the index of an input. Throws Error with the nearest known name if it does not exist.
  int index(const std::string& name) const;
  /// Like index(), and throws Error if the input is of another kind.
  int index(const std::string& name, InputKind kind) const;
  /// Like index(), with `key` in error messages: the entry that names the input ("surface_input").
  int index_of(const char* key, const std::string& name, InputKind kind) const;
  /// Throws Error if the kind of the input is not in `wanted`.
  void check_kind(int input, std::initializer_list<InputKind> wanted) const;

  /// Adds the uses of a contact's inputs to the stage. `friction` and `surface` are the first
  /// target entries of its coefficient and its surface; -1: none.
  void use(const ContactSpec& contact, int friction, int surface, CompiledStage& stage) const;
  /// Adds the uses of a term's inputs to the stage. Throws Error if a term cannot use its input.
  void use(const CostTerm& given, const CompiledTerm& term, int surface,
           CompiledStage& stage) const;
  void use(const Constraint& given, const CompiledTerm& term, int surface,
           CompiledStage& stage) const;
  /// Sets InputState::is_friction for the inputs that a stage uses as friction. Throws Error for a
  /// negative constant.
  void mark_friction(const CompiledStage& stage);

  /// Applies one use to the target entries. `values`: values of all inputs at the knot.
  void apply(const CompiledUse& use, const double* values, double* targets) const;

 private:
  std::vector<InputState> states_;
  std::vector<int> first_ = {0};
};

}  // namespace burnish::ocp
