// A vector that is constant or a function of time, such as the target of a cost.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "burnish/base/views.hpp"

namespace burnish {

/// A vector that is constant or a function of time. By default, a Signal is empty. Functions and
/// members that use a Signal document the meaning of an empty one.
class Signal {
 public:
  using Function = std::function<void(double time, Eigen::Ref<Eigen::VectorXd> out)>;

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
  /// knot. If this happens in a control loop, `function` should not allocate memory. Throws Error
  /// if `size` is below 1 or `function` is empty.
  static Signal over_time(int size, Function function);

  bool empty() const { return constant_.size() == 0 && !function_; }
  bool is_constant() const { return !function_; }
  int size() const { return function_ ? size_ : static_cast<int>(constant_.size()); }
  /// Returns the function that was passed to over_time(), or an empty function for a constant
  /// signal.
  const Function& function() const { return function_; }
  /// Writes the value at `time` [s] to `out`, which must have size() entries.
  void at(double time, Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  void hold(const ConstVectorRef& value);

  Eigen::VectorXd constant_;
  Function function_;
  int size_ = 0;
};

}  // namespace burnish
