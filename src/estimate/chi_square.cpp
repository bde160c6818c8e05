#include "estimate/chi_square.hpp"

#include <cmath>

namespace burnish {

/// Computes the regularized lower incomplete gamma function P of a = freedom/2 at x/2. Uses the
/// series of P for small x, and P = 1 - Q with a continued fraction for Q for large x (Abramowitz
/// and Stegun, 6.5.29 and 6.5.31).
double chi_square_share(int freedom, double x) {
  if (!(x > 0.0)) return 0.0;
  const double a = 0.5 * freedom, y = 0.5 * x;
  const double scale = std::exp(a * std::log(y) - y - std::lgamma(a));
  constexpr double tiny = 1e-300, precision = 1e-15;
  if (y < a + 1.0) {
    double term = 1.0 / a, sum = term;
    for (double n = a + 1.0; term > precision * sum; n += 1.0) sum += term *= y / n;
    return scale * sum;
  }
  double b = y + 1.0 - a, c = 1.0 / tiny, d = 1.0 / b, fraction = d;
  for (int n = 1; n < 10000; ++n) {
    const double numerator = -n * (n - a);
    b += 2.0;
    d = numerator * d + b;
    d = 1.0 / (std::abs(d) < tiny ? tiny : d);
    c = b + numerator / c;
    if (std::abs(c) < tiny) c = tiny;
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < precision) break;
  }
  return 1.0 - scale * fraction;
}

double chi_square_quantile(int freedom, double probability) {
  double low = 0.0, high = freedom + 10.0;
  while (chi_square_share(freedom, high) < probability && high < 1e6) high *= 2.0;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (chi_square_share(freedom, middle) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace burnish
