// Chi-square distribution: the distribution of a sum of squares of independent standard normal
// numbers.
#pragma once

namespace burnish {

/// Returns the probability that a chi-square variable is at most `x` >= 0. `freedom`: number of
/// degrees of freedom, at least 1.
double chi_square_share(int freedom, double x);

/// Returns the `x` for which chi_square_share() returns `probability`, with a relative error of
/// 1e-9. `probability`: between 0 and 1, both excluded.
double chi_square_quantile(int freedom, double probability);

}  // namespace burnish
