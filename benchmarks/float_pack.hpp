// Pack of floats with twice the lanes of a Pack, to measure the gain of single precision. The
// library computes with doubles; see "Tried, and did not help" in docs/performance.md.
#pragma once

#include <bit>

#include "math/pack.hpp"

namespace burnish::bench {

namespace detail {
template <int N>
struct FloatVector {
  using Value [[gnu::vector_size(sizeof(float) * N)]] = float;
  using Mask [[gnu::vector_size(sizeof(float) * N)]] = int;
};
}  // namespace detail

template <int N>
struct FloatMask {
  typename detail::FloatVector<N>::Mask bits;
};

/// Scalar of the kernels of contact dynamics, with only the operations that they need.
template <int N>
struct FloatPack {
  using Vector = typename detail::FloatVector<N>::Value;
  Vector v;

  FloatPack() = default;
  BURNISH_INLINE FloatPack(Vector lanes) : v(lanes) {}
  BURNISH_INLINE FloatPack(double all_lanes) : v(static_cast<float>(all_lanes) - Vector{}) {}

  BURNISH_INLINE friend FloatPack operator+(const FloatPack& a, const FloatPack& b) {
    return FloatPack(a.v + b.v);
  }
  BURNISH_INLINE friend FloatPack operator-(const FloatPack& a, const FloatPack& b) {
    return FloatPack(a.v - b.v);
  }
  BURNISH_INLINE friend FloatPack operator*(const FloatPack& a, const FloatPack& b) {
    return FloatPack(a.v * b.v);
  }
  BURNISH_INLINE friend FloatPack operator/(const FloatPack& a, const FloatPack& b) {
    return FloatPack(a.v / b.v);
  }
  BURNISH_INLINE FloatPack operator-() const { return FloatPack(-v); }
  BURNISH_INLINE FloatPack& operator+=(const FloatPack& b) {
    v += b.v;
    return *this;
  }
  BURNISH_INLINE FloatPack& operator-=(const FloatPack& b) {
    v -= b.v;
    return *this;
  }
  BURNISH_INLINE FloatPack& operator*=(const FloatPack& b) {
    v *= b.v;
    return *this;
  }
};

template <int N>
BURNISH_INLINE FloatMask<N> less(const FloatPack<N>& a,
                                 const std::type_identity_t<FloatPack<N>>& b) {
  return {a.v < b.v};
}
template <int N>
BURNISH_INLINE FloatMask<N> mask_and(const FloatMask<N>& a, const FloatMask<N>& b) {
  return {a.bits & b.bits};
}
template <int N>
BURNISH_INLINE FloatMask<N> mask_or(const FloatMask<N>& a, const FloatMask<N>& b) {
  return {a.bits | b.bits};
}
template <int N>
BURNISH_INLINE FloatMask<N> mask_not(const FloatMask<N>& a) {
  return {~a.bits};
}
template <int N>
BURNISH_INLINE bool any(const FloatMask<N>& mask) {
  bool result = false;
  for (int i = 0; i < N; ++i) result = result || mask.bits[i] != 0;
  return result;
}
template <int N>
BURNISH_INLINE bool lane_of(const FloatMask<N>& mask, int lane) {
  return mask.bits[lane] != 0;
}
template <int N>
BURNISH_INLINE FloatPack<N> select(const FloatMask<N>& mask, const FloatPack<N>& a,
                                   const std::type_identity_t<FloatPack<N>>& b) {
  return FloatPack<N>(mask.bits ? a.v : b.v);
}
template <int N>
BURNISH_INLINE FloatPack<N> square_root(const FloatPack<N>& a) {
  FloatPack<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = __builtin_sqrtf(a.v[i]);
  return r;
}
template <int N>
BURNISH_INLINE FloatPack<N> arc_tangent2(const FloatPack<N>& y, const FloatPack<N>& x) {
  FloatPack<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = std::atan2(y.v[i], x.v[i]);
  return r;
}

/// Computes sine and cosine as for Pack, but with the single-precision polynomials of the Cephes
/// library, which are shorter. Accurate for angles of a few turns.
template <int N>
BURNISH_INLINE void sine_cosine(const FloatPack<N>& angle, FloatPack<N>& sine,
                                FloatPack<N>& cosine) {
  using Vector = typename detail::FloatVector<N>::Value;
  using Integer = typename detail::FloatVector<N>::Mask;
  // Adding 1.5 * 2^23 rounds to an integer in the low bits of the sum.
  constexpr float shift = 12582912.0F;
  const Vector shifted = angle.v * 0.636619772F + shift;
  const auto quadrant = std::bit_cast<Integer>(shifted);
  const Vector k = shifted - shift;
  Vector r = angle.v - k * 1.5703125F;
  r = r - k * 4.83751296997e-4F;
  r = r - k * 7.54978995489e-8F;
  const Vector z = r * r;
  Vector s = -1.9515295891e-4F * z + 8.3321608736e-3F;
  s = s * z - 1.6666654611e-1F;
  s = r + r * z * s;
  Vector c = 2.443315711809948e-5F * z - 1.388731625493765e-3F;
  c = c * z + 4.166664568298827e-2F;
  c = 1.0F - 0.5F * z + z * z * c;
  const Integer swapped = (quadrant & 1) != 0;
  const Vector s_abs = swapped ? c : s;
  const Vector c_abs = swapped ? s : c;
  const Integer s_bits = std::bit_cast<Integer>(s_abs) ^ ((quadrant & 2) << 30);
  const Integer c_bits = std::bit_cast<Integer>(c_abs) ^ (((quadrant + 1) & 2) << 30);
  sine.v = std::bit_cast<Vector>(s_bits);
  cosine.v = std::bit_cast<Vector>(c_bits);
}

/// Pack of floats that fills the registers of a NativePack.
using NativeFloatPack = FloatPack<2 * native_lanes>;

}  // namespace burnish::bench

namespace burnish {
template <int N>
struct Lanes<bench::FloatPack<N>> {
  static constexpr int count = N;
  BURNISH_INLINE static double get(const bench::FloatPack<N>& s, int lane) {
    return static_cast<double>(s.v[lane]);
  }
  BURNISH_INLINE static void set(bench::FloatPack<N>& s, int lane, double value) {
    s.v[lane] = static_cast<float>(value);
  }
};
}  // namespace burnish
