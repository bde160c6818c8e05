#include "burnish/mpc/knot_times.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish {

KnotTimes::KnotTimes(std::span<const double> steps) {
  if (steps.empty()) throw Error("knot times: no steps; wanted at least one");
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (!(steps[k] > 0.0) || !std::isfinite(steps[k]))
      throw Error("knot times: knot " + std::to_string(k) + " has a step of " + number(steps[k]) +
                  " s; wanted a positive time");
  step_ = steps.front();
  is_even_ = std::all_of(steps.begin(), steps.end(), [&](double step) { return step == step_; });
  after_.push_back(0.0);
  for (std::size_t k = 0; k < steps.size(); ++k)
    after_.push_back(is_even_ ? static_cast<double>(k + 1) * step_ : after_.back() + steps[k]);
}

void KnotTimes::move(int knot, double after) noexcept {
  after_[to_size(knot)] = after;
  is_even_ = false;
}

void KnotTimes::copy_first(const KnotTimes& others) noexcept {
  std::copy_n(others.after_.begin(), after_.size(), after_.begin());
  step_ = others.step_;
  is_even_ = others.is_even_;
}

double KnotTimes::place(double after) const noexcept {
  const double last = knots();
  if (is_even_) return std::clamp(after / step_, 0.0, last);
  if (!(after > 0.0)) return 0.0;
  if (after >= after_.back()) return last;
  const auto next = std::upper_bound(after_.begin(), after_.end(), after);
  const double begin = *(next - 1);
  return static_cast<double>(next - after_.begin() - 1) + (after - begin) / (*next - begin);
}

}  // namespace burnish
