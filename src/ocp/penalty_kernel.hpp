// The penalty of one residual entry, with its slope and curvature, for doubles and packs.
#pragma once

#include "burnish/ocp/problem_spec.hpp"
#include "math/scalar.hpp"

namespace burnish {

/// Value of the penalty phi and its derivatives at one residual entry.
template <class S>
struct PenaltyValue {
  S value, slope, curvature;
};

/// Evaluates a penalty at the residual r. Only barriers use `lower` and `upper`.
template <class S>
BURNISH_INLINE PenaltyValue<S> evaluate_penalty(Penalty::Kind kind, double lower, double upper,
                                                double width, const S& r) {
  switch (kind) {
    case Penalty::Kind::Quadratic:
      return {S(0.5) * r * r, r, S(1.0)};
    case Penalty::Kind::Barrier: {
      // An infinite limit is never violated. The excess of a NaN is a NaN.
      const auto below = less(r, S(lower)), above = less(S(upper), r);
      const S excess =
          select(below, S(r - S(lower)), select(above, S(r - S(upper)), S(r * S(0.0))));
      const S outside = select(mask_or(below, above), S(1.0), S(0.0));
      return {S(0.5) * excess * excess, excess, outside};
    }
    case Penalty::Kind::SmoothAbsolute: {
      const S root = square_root(S(r * r + S(width * width)));
      const S inverse = S(1.0) / root;
      return {root - S(width), r * inverse, S(width * width) * inverse * inverse * inverse};
    }
    case Penalty::Kind::LogBarrier:
      break;
  }
  PenaltyValue<S> sum{S(r * S(0.0)), S(0.0), S(0.0)};
  const auto add = [&](double limit, double sign) {
    if (!(limit > -1e300 && limit < 1e300)) return;
    const S s = (r - S(limit)) * S(sign / width);  // distance in widths
    const auto far = less(S(1.0), s);
    const S safe = select(far, s, S(1.0));
    const S inverse = S(1.0) / safe;
    const S near = s - S(2.0);
    sum.value += select(far, S(-natural_logarithm(safe)), S(S(0.5) * (near * near - S(1.0))));
    sum.slope += select(far, S(-inverse), near) * S(sign / width);
    sum.curvature += select(far, S(inverse * inverse), S(1.0)) * S(1.0 / (width * width));
  };
  add(lower, 1.0);
  add(upper, -1.0);
  return sum;
}

}  // namespace burnish
