// When the knots of a horizon are, seen from its first one.
#pragma once

#include <span>
#include <vector>

namespace burnish {

/// Allocates when made, never afterwards.
class KnotTimes {
 public:
  /// One step per knot, s; the time after the last one is the end. Throws Error for no steps and
  /// for one that is not positive.
  explicit KnotTimes(std::span<const double> steps);

  int knots() const { return static_cast<int>(after_.size()) - 1; }
  /// All steps are alike: knot k is k steps after the first one.
  bool is_even() const { return is_even_; }
  /// s after the first knot; of 0 to knots().
  double after(int knot) const { return after_[static_cast<std::size_t>(knot)]; }
  double step(int knot) const { return is_even_ ? step_ : after(knot + 1) - after(knot); }  ///< s

  /// Moves a knot that is neither the first one nor the end; between its neighbours.
  void move(int knot, double after) noexcept;
  /// Those of as many first knots of others, which has at least as many.
  void copy_first(const KnotTimes& others) noexcept;

  /// Where a time after the first knot falls, as a knot and the share of its step that is over:
  /// 2.25 is a quarter of the step after knot 2. Within 0 and knots().
  double place(double after) const noexcept;

 private:
  std::vector<double> after_;
  double step_;
  bool is_even_;
};

}  // namespace burnish
