// A quantity over time, or constant: what a cost aims at, how a reference is turned.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "burnish/base/views.hpp"

namespace burnish {

/// A vector, or a function of time that gives one. Empty unless given: what that means is said
/// where the signal is used.
class Signal {
 public:
  using Function = std::function<void(double time, Eigen::Ref<Eigen::VectorXd> out)>;

  Signal() = default;
  /// Constant, of one entry.
  Signal(double value) : constant_(Eigen::VectorXd::Constant(1, value)) {}
  /// Constant.
  template <class Vector>
  requires std::is_base_of_v<Eigen::MatrixBase<Vector>, Vector> Signal(const Vector& value) {
    hold(value);
  }
  /// `function` writes `size` entries for a time in s. It is called when a knot is given its time,
  /// and should not allocate where that happens in a control tick.
  static Signal over_time(int size, Function function);

  bool empty() const { return constant_.size() == 0 && !function_; }
  bool is_constant() const { return !function_; }
  int size() const { return function_ ? size_ : static_cast<int>(constant_.size()); }
  /// What over_time() was given; empty if constant.
  const Function& function() const { return function_; }
  /// Writes size() entries.
  void at(double time, Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  void hold(const ConstVectorRef& value);

  Eigen::VectorXd constant_;
  Function function_;
  int size_ = 0;
};

}  // namespace burnish
