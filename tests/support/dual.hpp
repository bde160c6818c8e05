// Number with its derivatives along some directions: forward automatic differentiation as a scalar
// of the kernels. Every operation computes a value immediately, which compiles faster than the
// expression templates of Eigen's AutoDiffScalar.
#pragma once

#include <cmath>

#include "math/pack.hpp"

namespace burnish::test {

/// Directions per evaluation. A small number keeps the working set of a kernel in the nearest
/// cache; more directions need more evaluations.
inline constexpr int dual_directions = 8;

class Dual {
 public:
  Dual() = default;
  // Implicit, because kernels write constants as double.
  Dual(double value) : value_(value) {}  // NOLINT(google-explicit-constructor)
  /// Variable of direction `along`.
  Dual(double value, int along) : value_(value) { set(along, 1.0); }

  double value() const { return value_; }
  double derivative(int along) const { return by_.lane(along); }
  void set(int along, double derivative) { by_.v[along] = derivative; }

  /// Applies a function with the given value and slope at this number.
  Dual through(double value, double slope) const { return {value, Directions(slope) * by_}; }

  BURNISH_INLINE friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value_ + b.value_, a.by_ + b.by_};
  }
  BURNISH_INLINE friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value_ - b.value_, a.by_ - b.by_};
  }
  BURNISH_INLINE friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value_ * b.value_, Directions(a.value_) * b.by_ + Directions(b.value_) * a.by_};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double value = a.value_ / b.value_;
    return {value, (a.by_ - Directions(value) * b.by_) * Directions(1.0 / b.value_)};
  }
  friend Dual operator*(double a, const Dual& b) { return b.through(a * b.value_, a); }
  BURNISH_INLINE friend Dual operator*(const Dual& a, double b) { return b * a; }
  BURNISH_INLINE Dual operator-() const { return {-value_, -by_}; }
  BURNISH_INLINE Dual& operator+=(const Dual& b) { return *this = *this + b; }
  BURNISH_INLINE Dual& operator-=(const Dual& b) { return *this = *this - b; }
  BURNISH_INLINE Dual& operator*=(const Dual& b) { return *this = *this * b; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value_ < b.value_; }

  friend Dual sin(const Dual& a) { return a.through(std::sin(a.value_), std::cos(a.value_)); }
  friend Dual cos(const Dual& a) { return a.through(std::cos(a.value_), -std::sin(a.value_)); }
  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value_);
    return a.through(root, 0.5 / root);
  }
  friend Dual log(const Dual& a) { return a.through(std::log(a.value_), 1.0 / a.value_); }
  friend Dual tanh(const Dual& a) {
    const double value = std::tanh(a.value_);
    return a.through(value, 1.0 - value * value);
  }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double square = x.value_ * x.value_ + y.value_ * y.value_;
    return {std::atan2(y.value_, x.value_),
            Directions(x.value_ / square) * y.by_ - Directions(y.value_ / square) * x.by_};
  }

 private:
  using Directions = Pack<dual_directions>;
  Dual(double value, const Directions& by) : value_(value), by_(by) {}

  double value_ = 0.0;
  Directions by_ = 0.0;
};

}  // namespace burnish::test
