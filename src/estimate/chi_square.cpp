#include "estimate/chi_square.hpp"

#include <cmath>

namespace burnish {

/// The lower incomplete gamma function over Gamma(a), a = freedom/2, at x/2: below the middle by
/// its series, above it by one minus the continued fraction of the rest (Abramowitz and
/// Stegun, 6.5.29 and 6.5.31).
double chi_square_share(int freedom, double x) {
  if (!(x > 0.0)) return 0.0;
  const double a = 0.5 * freedom, y = 0.5 * x;
  const double scale = std::exp(a * std::log(y) - y - std::lgamma(a));
  constexpr double least = 1e-300, precision = 1e-15;
  if (y < a + 1.0) {
    double term = 1.0 / a, sum = term;
    for (double n = a + 1.0; term > precision * sum; n += 1.0) sum += term *= y / n;
    return scale * sum;
  }
  double b = y + 1.0 - a, c = 1.0 / least, d = 1.0 / b, fraction = d;
  for (int n = 1; n < 10000; ++n) {
    const double numerator = -n * (n - a);
    b += 2.0;
    d = numerator * d + b;
    d = 1.0 / (std::abs(d) < least ? least : d);
    c = b + numerator / c;
    if (std::abs(c) < least) c = least;
    fraction *= d * c;
    if (std::abs(d * c - 1.0) < precision) break;
  }
  return 1.0 - scale * fraction;
}

double chi_square_quantile(int freedom, double share) {
  double low = 0.0, high = freedom + 10.0;
  while (chi_square_share(freedom, high) < share && high < 1e6) high *= 2.0;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (chi_square_share(freedom, middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace burnish
