#include "solver/box_qp.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"

namespace burnish {
namespace {

double entry(const BoxProblem& p, int i, int j) {
  return p.hessian[i < j ? i * p.stride + j : j * p.stride + i];
}

// Limits of the Newton iteration and of its line search, chosen by hand.
constexpr int max_steps = 100;
constexpr double sufficient_decrease = 0.1;  // cost - trial >= this * step * |slope|
constexpr double shrink = 0.6;
constexpr int max_shrinks = 60;

}  // namespace

BoxQp::BoxQp(int capacity)
    : gradient_(to_size(capacity)),
      direction_(gradient_.size()),
      trial_(gradient_.size()),
      factor_(gradient_.size() * gradient_.size()),
      clamped_(gradient_.size()),
      capacity_(capacity) {
  free_.reserve(gradient_.size());
}

void BoxQp::update_gradient(const BoxProblem& p, const double* x) {
  for (int i = 0; i < p.size; ++i) {
    double sum = p.gradient[i * p.gradient_step];
    for (int j = 0; j < p.size; ++j) sum += entry(p, i, j) * x[j];
    gradient_[i] = sum;
  }
}

double BoxQp::cost(const BoxProblem& p, const double* x) {
  update_gradient(p, x);
  double sum = 0.0;
  for (int i = 0; i < p.size; ++i)
    sum += 0.5 * x[i] * (gradient_[i] + p.gradient[i * p.gradient_step]);
  return sum;
}

/// Updates the set of clamped entries. Returns whether the set changed.
bool BoxQp::update_clamped(const BoxProblem& p, const double* x) {
  bool changed = false;
  free_.clear();
  for (int i = 0; i < p.size; ++i) {
    const bool held =
        (x[i] <= p.lower[i] && gradient_[i] > 0.0) || (x[i] >= p.upper[i] && gradient_[i] < 0.0);
    changed = changed || held != (clamped_[i] != 0);
    clamped_[i] = held ? 1 : 0;
    if (!held) free_.push_back(i);
  }
  return changed;
}

bool BoxQp::factorize(const BoxProblem& p) {
  const int n = static_cast<int>(free_.size());
  for (int i = 0; i < n; ++i) {
    double* row = factor_.data() + i * capacity_;
    for (int j = 0; j <= i; ++j) {
      const double* other = factor_.data() + j * capacity_;
      double sum = entry(p, free_[i], free_[j]);
      for (int k = 0; k < j; ++k) sum -= row[k] * other[k];
      if (j < i) {
        row[j] = sum / other[j];
      } else {
        if (!(sum > 1e-14 * entry(p, free_[i], free_[i])) || !std::isfinite(sum)) return false;
        row[i] = std::sqrt(sum);
      }
    }
  }
  return true;
}

void BoxQp::newton_direction(const BoxProblem& p) {
  const int n = static_cast<int>(free_.size());
  std::fill_n(direction_.begin(), p.size, 0.0);
  for (int i = 0; i < n; ++i) {
    const double* row = factor_.data() + i * capacity_;
    double sum = -gradient_[free_[i]];
    for (int k = 0; k < i; ++k) sum -= row[k] * direction_[free_[k]];
    direction_[free_[i]] = sum / row[i];
  }
  for (int i = n - 1; i >= 0; --i) {
    double sum = direction_[free_[i]];
    for (int k = i + 1; k < n; ++k) sum -= factor_[k * capacity_ + i] * direction_[free_[k]];
    direction_[free_[i]] = sum / factor_[i * capacity_ + i];
  }
}

/// Moves x along the projected direction. Returns false if no step length lowers the cost.
bool BoxQp::search(const BoxProblem& p, double* x, bool& whole_step) {
  double slope = 0.0;
  for (int i = 0; i < p.size; ++i) slope += gradient_[i] * direction_[i];
  const double before = cost(p, x);
  double length = 1.0;
  for (int s = 0; s < max_shrinks; ++s, length *= shrink) {
    whole_step = length == 1.0;
    for (int i = 0; i < p.size; ++i) {
      const double wanted = x[i] + length * direction_[i];
      trial_[i] = std::min(std::max(wanted, p.lower[i]), p.upper[i]);
      whole_step = whole_step && trial_[i] == wanted;
    }
    if (whole_step || before - cost(p, trial_.data()) > -sufficient_decrease * length * slope) {
      std::copy_n(trial_.begin(), p.size, x);
      return true;
    }
  }
  return false;
}

BoxQpResult BoxQp::solve(const BoxProblem& p, double* x) {
  BoxQpResult result;
  for (int i = 0; i < p.size; ++i)
    x[i] = std::min(std::max(std::isfinite(x[i]) ? x[i] : 0.0, p.lower[i]), p.upper[i]);
  bool whole_step = false;
  for (int step = 0; step <= max_steps; ++step) {
    update_gradient(p, x);
    const bool changed = update_clamped(p, x);
    if (free_.empty() || (whole_step && !changed)) return result;
    if ((step == 0 || changed) && !factorize(p)) {
      result.positive_definite = false;
      return result;
    }
    newton_direction(p);
    if (!search(p, x, whole_step)) {
      update_gradient(p, x);
      return result;
    }
    ++result.iterations;
  }
  return result;
}

}  // namespace burnish
