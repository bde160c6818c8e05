// Pack of doubles (SIMD vector): one lane per state. Arithmetic acts on all lanes at once.
#pragma once

#include <bit>
#include <utility>

#include "math/scalar.hpp"

namespace burnish {

/// Number of lanes in one register of the target: 8 with AVX-512, 4 with AVX2, 2 with SSE2 or NEON.
#if defined(__AVX512F__)
inline constexpr int native_lanes = 8;
#elif defined(__AVX2__)
inline constexpr int native_lanes = 4;
#elif defined(__SSE2__) || defined(__ARM_NEON)
inline constexpr int native_lanes = 2;
#else
inline constexpr int native_lanes = 1;
#endif

namespace detail {
// Separate trait for the vector types. If Pack defined a vector_size type that depends on N, GCC 12
// would confuse this type with its element type in overload resolution.
template <int N>
struct Vector {
  using Value [[gnu::vector_size(sizeof(double) * N)]] = double;
  using Mask [[gnu::vector_size(sizeof(double) * N)]] = long long;
};
}  // namespace detail

/// Boolean for each lane: all bits set for true, none for false.
template <int N>
struct PackMask {
  typename detail::Vector<N>::Mask bits;
};

/// Vector of N doubles.
template <int N>
struct Pack {
  using Vector = typename detail::Vector<N>::Value;
  Vector v;

  Pack() = default;
  BURNISH_INLINE Pack(Vector lanes) : v(lanes) {}
  BURNISH_INLINE Pack(double all_lanes) : v(all_lanes - Vector{}) {}

  BURNISH_INLINE friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.v + b.v); }
  BURNISH_INLINE friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.v - b.v); }
  BURNISH_INLINE friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.v * b.v); }
  BURNISH_INLINE friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.v / b.v); }
  BURNISH_INLINE Pack operator-() const { return Pack(-v); }
  BURNISH_INLINE Pack& operator+=(const Pack& b) {
    v += b.v;
    return *this;
  }
  BURNISH_INLINE Pack& operator-=(const Pack& b) {
    v -= b.v;
    return *this;
  }
  BURNISH_INLINE Pack& operator*=(const Pack& b) {
    v *= b.v;
    return *this;
  }
  BURNISH_INLINE double lane(int i) const { return v[i]; }
};

template <int N>
struct Lanes<Pack<N>> {
  static constexpr int count = N;
  BURNISH_INLINE static double get(const Pack<N>& s, int lane) { return s.v[lane]; }
  BURNISH_INLINE static void set(Pack<N>& s, int lane, double value) { s.v[lane] = value; }
};

template <int N>
BURNISH_INLINE PackMask<N> less(const Pack<N>& a, const std::type_identity_t<Pack<N>>& b) {
  return {a.v < b.v};
}
template <int N>
BURNISH_INLINE PackMask<N> mask_and(const PackMask<N>& a, const PackMask<N>& b) {
  return {a.bits & b.bits};
}
template <int N>
BURNISH_INLINE PackMask<N> mask_or(const PackMask<N>& a, const PackMask<N>& b) {
  return {a.bits | b.bits};
}
template <int N>
BURNISH_INLINE PackMask<N> mask_not(const PackMask<N>& a) {
  return {~a.bits};
}
template <int N>
BURNISH_INLINE bool any(const PackMask<N>& mask) {
  bool result = false;
  for (int i = 0; i < N; ++i) result = result || mask.bits[i] != 0;
  return result;
}
template <int N>
BURNISH_INLINE bool lane_of(const PackMask<N>& mask, int lane) {
  return mask.bits[lane] != 0;
}
template <int N>
BURNISH_INLINE Pack<N> select(const PackMask<N>& mask, const Pack<N>& a,
                              const std::type_identity_t<Pack<N>>& b) {
  return Pack<N>(mask.bits ? a.v : b.v);
}
template <int N>
BURNISH_INLINE Pack<N> square_root(const Pack<N>& a) {
  Pack<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = __builtin_sqrt(a.v[i]);
  return r;
}
template <int N>
BURNISH_INLINE Pack<N> arc_tangent2(const Pack<N>& y, const Pack<N>& x) {
  Pack<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = std::atan2(y.v[i], x.v[i]);
  return r;
}
template <int N>
BURNISH_INLINE Pack<N> hyperbolic_tangent(const Pack<N>& a) {
  Pack<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = std::tanh(a.v[i]);
  return r;
}

template <int N>
BURNISH_INLINE Pack<N> natural_logarithm(const Pack<N>& a) {
  Pack<N> r;
  for (int i = 0; i < N; ++i) r.v[i] = std::log(a.v[i]);
  return r;
}

/// Computes sine and cosine of every lane, with errors of at most 2 units in the last place for
/// |angle| up to 1e5 rad. Method: three-part reduction by pi/2, then the minimax polynomials of the
/// Cephes library on [-pi/4, pi/4]. For larger angles, the standard library computes lane by lane.
template <int N>
BURNISH_INLINE void sine_cosine(const Pack<N>& angle, Pack<N>& sine, Pack<N>& cosine) {
  using Vector = typename detail::Vector<N>::Value;
  using Integer = typename detail::Vector<N>::Mask;
  // Adding 1.5 * 2^52 rounds to an integer, which is then in the low bits of the sum.
  constexpr double shift = 6755399441055744.0;
  const Vector shifted = angle.v * 0.63661977236758134308 + shift;
  const auto quadrant = std::bit_cast<Integer>(shifted);
  const Vector k = shifted - shift;
  Vector r = angle.v - k * 1.57079632673412561417e+00;
  r = r - k * 6.07710050630396597660e-11;
  r = r - k * 2.02226624879595063154e-21;
  const Vector z = r * r;
  Vector s = 1.58962301576546568060e-10 * z - 2.50507477628578072866e-8;
  s = s * z + 2.75573136213857245213e-6;
  s = s * z - 1.98412698295895385996e-4;
  s = s * z + 8.33333333332211858878e-3;
  s = s * z - 1.66666666666666307295e-1;
  s = r + r * z * s;
  Vector c = -1.13585365213876817300e-11 * z + 2.08757008419747316778e-9;
  c = c * z - 2.75573141792967388112e-7;
  c = c * z + 2.48015872888517045348e-5;
  c = c * z - 1.38888888888730564116e-3;
  c = c * z + 4.16666666666665929218e-2;
  c = 1.0 - 0.5 * z + z * z * c;
  const Integer swapped = (quadrant & 1) != 0;
  const Vector s_abs = swapped ? c : s;
  const Vector c_abs = swapped ? s : c;
  const Integer s_sign = (quadrant & 2) << 62;
  const Integer c_sign = ((quadrant + 1) & 2) << 62;
  const Integer s_bits = std::bit_cast<Integer>(s_abs) ^ s_sign;
  const Integer c_bits = std::bit_cast<Integer>(c_abs) ^ c_sign;
  sine.v = std::bit_cast<Vector>(s_bits);
  cosine.v = std::bit_cast<Vector>(c_bits);
  const PackMask<N> far = less(Pack<N>(1e5), absolute(angle));
  if (any(far)) [[unlikely]]
    for (int i = 0; i < N; ++i) {
      if (!lane_of(far, i)) continue;
      sine.v[i] = std::sin(angle.v[i]);
      cosine.v[i] = std::cos(angle.v[i]);
    }
}

namespace detail {
/// Exchanges the lanes of a and b whose index differs in the bit `step`.
template <int N, int step, int... lane>
BURNISH_INLINE void exchange(Pack<N>& a, Pack<N>& b, std::integer_sequence<int, lane...>) {
  const auto low =
      __builtin_shufflevector(a.v, b.v, ((lane & step) == 0 ? lane : N + lane - step)...);
  b.v = __builtin_shufflevector(a.v, b.v, ((lane & step) == 0 ? lane + step : N + lane)...);
  a.v = low;
}

template <int N, int step>
BURNISH_INLINE void exchange_rows(Pack<N>* rows) {
  for (int i = 0; i < N; ++i)
    if ((i & step) == 0)
      exchange<N, step>(rows[i], rows[i + step], std::make_integer_sequence<int, N>{});
}
}  // namespace detail

/// Transposes N packs of N lanes in place: swaps lane l of pack i with lane i of pack l.
template <int N>
BURNISH_INLINE void transpose(Pack<N>* rows) {
  if constexpr (N >= 2) detail::exchange_rows<N, 1>(rows);
  if constexpr (N >= 4) detail::exchange_rows<N, 2>(rows);
  if constexpr (N >= 8) detail::exchange_rows<N, 4>(rows);
}

namespace detail {
/// Vector type for unaligned stores.
template <int N>
struct LooseVector {
  using Value
      [[gnu::vector_size(sizeof(double) * N), gnu::aligned(alignof(double)), gnu::may_alias]] =
          double;
};
}  // namespace detail

/// Stores all lanes at `out`, which need not be aligned to the size of the pack.
template <int N>
BURNISH_INLINE void store_lanes(const Pack<N>& pack, double* out) {
  *reinterpret_cast<typename detail::LooseVector<N>::Value*>(out) = pack.v;
}

/// Copies lane l of N consecutive packs to N consecutive numbers at out_of(l), for each of the
/// first `lanes` lanes. Each pack is loaded as a whole into a register. A copy in pieces would
/// delay the next load until all pieces are written.
template <int N>
BURNISH_INLINE void unpack(const Pack<N>* from, int lanes, const auto& out_of) {
  Pack<N> rows[N];
#pragma GCC unroll 8
  for (int i = 0; i < N; ++i) rows[i] = from[i];
  transpose(rows);
#pragma GCC unroll 8
  for (int l = 0; l < N; ++l)
    if (l < lanes) store_lanes(rows[l], out_of(l));
}

/// Scalar type for the evaluation of horizons on this target.
using NativePack = Pack<native_lanes>;

}  // namespace burnish
