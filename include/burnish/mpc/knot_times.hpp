// Times of the knots of a horizon, relative to the first knot.
#pragma once

#include <span>
#include <vector>

namespace burnish {

/// Times of the knots of a horizon, relative to the first knot. Only the constructor allocates.
class KnotTimes {
 public:
  /// `steps` contains the time from each knot to the next one [s]. Its last entry is the time from
  /// the last knot to the end of the horizon. Throws Error if `steps` is empty or an entry is not
  /// positive.
  explicit KnotTimes(std::span<const double> steps);

  int knots() const { return static_cast<int>(after_.size()) - 1; }
  /// Returns true if all steps have the same length. Knot k is then k steps after the first knot.
  bool is_even() const { return is_even_; }
  /// Returns the time from the first knot to `knot` [s]. `knot` is between 0 and knots(). The value
  /// knots() means the end of the horizon.
  double after(int knot) const { return after_[static_cast<std::size_t>(knot)]; }
  /// Returns the length of the step that begins at `knot` [s].
  double step(int knot) const { return is_even_ ? step_ : after(knot + 1) - after(knot); }

  /// Sets the time of `knot`, counted from the first knot, to `after` [s]. `after` must lie between
  /// the times of the neighbouring knots. The first knot and the end of the horizon cannot be
  /// moved.
  void move(int knot, double after) noexcept;
  /// Copies the first knots() steps of `others`. `others` must have at least knots() steps.
  void copy_first(const KnotTimes& others) noexcept;

  /// Converts a time counted from the first knot [s] to a fractional knot index, 0 to knots(). For
  /// example, the index 2.25 means that a quarter of the step after knot 2 has passed.
  double place(double after) const noexcept;

 private:
  std::vector<double> after_;
  double step_;
  bool is_even_;
};

}  // namespace burnish
