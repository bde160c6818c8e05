// Operations that kernels require of their scalar type. Kernels branch on the model only, never on
// values. A choice that depends on values uses select(), separately for each lane of a pack.
#pragma once

#include <cmath>
#include <type_traits>

#if defined(__GNUC__)
#define BURNISH_INLINE [[gnu::always_inline]] inline
#else
#define BURNISH_INLINE inline
#endif

namespace burnish {

/// Number of states in a scalar, and access to each of them. The specialisation for Pack has
/// several lanes. Every other scalar (double, automatic differentiation) has one lane.
template <class S>
struct Lanes {
  static constexpr int count = 1;
  static double get(const S& s, int /*lane*/) {
    if constexpr (std::is_arithmetic_v<S>) {
      return s;
    } else {
      return s.value();
    }
  }
  static void set(S& s, int /*lane*/, double value) { s = S(value); }
};

/// Compares a < b. The result is a mask: bool for one lane, one boolean per lane for packs.
template <class S>
BURNISH_INLINE bool less(const S& a, const std::type_identity_t<S>& b) {
  return a < b;
}
BURNISH_INLINE bool mask_and(bool a, bool b) { return a && b; }
BURNISH_INLINE bool mask_or(bool a, bool b) { return a || b; }
BURNISH_INLINE bool mask_not(bool a) { return !a; }
BURNISH_INLINE bool any(bool mask) { return mask; }
BURNISH_INLINE bool lane_of(bool mask, int /*lane*/) { return mask; }

/// Returns a if the mask is true, otherwise b. Both are always evaluated.
template <class S>
BURNISH_INLINE S select(bool mask, const S& a, const std::type_identity_t<S>& b) {
  return mask ? a : b;
}

/// Computes sine and cosine of an angle [rad].
template <class S>
BURNISH_INLINE void sine_cosine(const S& angle, S& sine, S& cosine) {
  using std::cos;
  using std::sin;
  sine = sin(angle);
  cosine = cos(angle);
}

template <class S>
BURNISH_INLINE S square_root(const S& a) {
  using std::sqrt;
  return sqrt(a);
}

template <class S>
BURNISH_INLINE S absolute(const S& a) {
  return select(less(a, S(0.0)), S(-a), a);
}

/// Angle of the point (x, y) with y >= 0, in [0, pi] [rad].
template <class S>
BURNISH_INLINE S arc_tangent2(const S& y, const S& x) {
  using std::atan2;
  return atan2(y, x);
}

template <class S>
BURNISH_INLINE S hyperbolic_tangent(const S& a) {
  using std::tanh;
  return tanh(a);
}

/// Natural logarithm of a positive number.
template <class S>
BURNISH_INLINE S natural_logarithm(const S& a) {
  using std::log;
  return log(a);
}

}  // namespace burnish
