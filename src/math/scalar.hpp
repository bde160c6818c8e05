// What a kernel may ask of its scalar. Kernels branch on the model only, never on values: a choice
// that depends on a value goes through select(), so that each lane of a pack makes its own.
#pragma once

#include <cmath>
#include <type_traits>

#if defined(__GNUC__)
#define BURNISH_INLINE [[gnu::always_inline]] inline
#else
#define BURNISH_INLINE inline
#endif

namespace burnish {

/// Lanes of a scalar: how many states it carries and how to reach one of them.
/// Specialised for Pack; every other scalar (double, automatic differentiation) has one lane.
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

/// Comparisons give a mask: bool for one lane, a vector of lanes for packs.
template <class S>
BURNISH_INLINE bool less(const S& a, const std::type_identity_t<S>& b) {
  return a < b;
}
BURNISH_INLINE bool mask_and(bool a, bool b) { return a && b; }
BURNISH_INLINE bool mask_or(bool a, bool b) { return a || b; }
BURNISH_INLINE bool mask_not(bool a) { return !a; }
BURNISH_INLINE bool any(bool mask) { return mask; }
BURNISH_INLINE bool lane_of(bool mask, int /*lane*/) { return mask; }

/// a where the mask holds, b elsewhere; both are evaluated.
template <class S>
BURNISH_INLINE S select(bool mask, const S& a, const std::type_identity_t<S>& b) {
  return mask ? a : b;
}

/// Sine and cosine of an angle in radians.
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

/// Angle of the point (x, y) with y >= 0, in [0, pi].
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

/// Of a positive number.
template <class S>
BURNISH_INLINE S natural_logarithm(const S& a) {
  using std::log;
  return log(a);
}

}  // namespace burnish
