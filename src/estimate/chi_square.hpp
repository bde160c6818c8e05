// The distribution of a sum of squares of normal numbers.
#pragma once

namespace burnish {

/// Share of the sums of `freedom` squares, at least 1, that are at most x >= 0.
double chi_square_share(int freedom, double x);

/// The x that the share `share`, in (0, 1), of them stays below, to 1e-9 of it.
double chi_square_quantile(int freedom, double share);

}  // namespace burnish
