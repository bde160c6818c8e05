// A vector that is constant or a function of time, such as the target of a cost.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>

#include "burnish/base/views.hpp"

namespace burnish {

/// Values of the inputs of an optimal control problem at one knot, in the order of
/// ProblemSpec::inputs.
class InputValues {
 public:
  InputValues() = default;
  /// `first` holds the index in `values` of the first entry of each input, and then the total
  /// number of entries. `values` and `first` must outlive this object.
  InputValues(const double* values, std::span<const int> first) : values_(values), first_(first) {}

  /// Returns the entries of an input. Surface and inertia inputs, and inputs that do not exist,
  /// have no entries. All entries of a scalar or rotation input without a value are zero.
  Eigen::Map<const Eigen::VectorXd> operator[](int input) const;
  /// Returns the value of a scalar input; NaN if the input has no entries.
  double scalar(int input) const;

 private:
  const double* values_ = nullptr;
  std::span<const int> first_ = {};
};

/// A vector that is constant or a function of time. By default, a Signal is empty. Functions and
/// members that use a Signal document the meaning of an empty Signal.
class Signal {
 public:
  using Function = std::function<void(double time, Eigen::Ref<Eigen::VectorXd> out)>;
  using FunctionOfInputs =
      std::function<void(double time, const InputValues& inputs, Eigen::Ref<Eigen::VectorXd> out)>;

  Signal() = default;
  /// Constant signal with one entry.
  Signal(double value) : constant_(Eigen::VectorXd::Constant(1, value)) {}
  /// Constant signal with the entries of `value`.
  template <class Vector>
  requires std::is_base_of_v<Eigen::MatrixBase<Vector>, Vector> Signal(const Vector& value) {
    hold(value);
  }
  /// Returns a signal that is a function of time. `function` receives a time [s] and writes `size`
  /// entries. An optimal control problem calls `function` each time that it sets the time of a
  /// knot. A `function` that is used in a control loop should not allocate memory. Throws Error if
  /// `size` is below 1 or `function` is empty.
  static Signal over_time(int size, Function function);
  /// Returns a signal that is a function of time and of the inputs of an optimal control problem.
  /// Besides a time, `function` receives the values of the inputs at this time. Evaluations outside
  /// of a Problem's knots pass no inputs; InputValues::scalar() is then NaN. All other rules are
  /// those of over_time().
  static Signal of_inputs(int size, FunctionOfInputs function);

  bool empty() const { return constant_.size() == 0 && is_constant(); }
  bool is_constant() const { return !function_ && !of_inputs_; }
  bool depends_on_inputs() const { return of_inputs_ != nullptr; }
  int size() const { return is_constant() ? static_cast<int>(constant_.size()) : size_; }
  /// Returns the function that was passed to over_time(), or an empty function for other signals.
  const Function& function() const { return function_; }
  /// Writes the value at `time` [s] to `out`, which must have size() entries.
  void at(double time, Eigen::Ref<Eigen::VectorXd> out, const InputValues& inputs = {}) const;

 private:
  void hold(const ConstVectorRef& value);

  Eigen::VectorXd constant_;
  Function function_;
  FunctionOfInputs of_inputs_;
  int size_ = 0;
};

}  // namespace burnish
