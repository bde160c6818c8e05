// Small dense kernels for the Riccati recursion, written with SIMD vectors: one matrix product in
// register tiles, and a few vector operations.
//
// Matrices are row-major. Kernels process a row in whole vectors. Writes reach up to
// round_up(columns) entries of a row, so rows must be padded to this length. Reads may exceed the
// end of a row by less than a vector, so every buffer must end with `lanes` spare entries. Products
// are summed over k in ascending order, for every size.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "base/to_size.hpp"
#include "math/pack.hpp"

namespace burnish::dense {

using Lane = NativePack;
inline constexpr int lanes = native_lanes;
/// Number of entries that a buffer needs after its last row.
inline constexpr int spare = lanes;

/// Entries of a buffer for `rows` rows that are `stride` apart.
constexpr std::size_t block_size(int rows, int stride) {
  return to_size(rows) * to_size(stride) + spare;
}

constexpr int round_up(int n) { return (n + lanes - 1) / lanes * lanes; }
constexpr int round_down(int n) { return n / lanes * lanes; }

BURNISH_INLINE Lane load(const double* from) {
  Lane p;
  std::memcpy(&p.v, from, sizeof p.v);
  return p;
}
BURNISH_INLINE void store(double* to, const Lane& p) { std::memcpy(to, &p.v, sizeof p.v); }

/// How a kernel combines the product with the destination.
enum class Update { Set, Add, Subtract };

/// Left factor of a product: entry (k, i) is data[k * k_step + i * i_step].
struct Left {
  const double* data;
  int k_step;
  int i_step;
};
struct Rows {
  const double* data;
  int stride;
};
/// Rows that a kernel writes.
struct MutableRows {
  double* data;
  int stride;
};
/// Rows or columns from begin to end - 1.
struct Range {
  int begin;
  int end;
};

namespace detail {

// Tile size for which the sums, one row of B and one entry of A fill the vector registers: 32
// registers with AVX-512 and NEON, 16 otherwise.
#if defined(__AVX512F__) || defined(__aarch64__)
inline constexpr int tile_rows = 8, tile_vectors = 3;
#else
inline constexpr int tile_rows = 4, tile_vectors = 3;
#endif

template <Update update, bool unit_step, int R, int C>
void tile(Left a, Rows b, int count, double* c, int stride) {
  Lane sum[R][C];
#pragma GCC unroll 8
  for (int r = 0; r < R; ++r)
#pragma GCC unroll 8
    for (int s = 0; s < C; ++s)
      sum[r][s] = update == Update::Set ? Lane(0.0) : load(c + r * stride + s * lanes);
  const int i_step = unit_step ? 1 : a.i_step;
  for (int k = 0; k < count; ++k) {
    const double* ak = a.data + k * a.k_step;
    const double* bk = b.data + k * b.stride;
    Lane right[C];
#pragma GCC unroll 8
    for (int s = 0; s < C; ++s) right[s] = load(bk + s * lanes);
#pragma GCC unroll 8
    for (int r = 0; r < R; ++r) {
      const Lane left(ak[r * i_step]);
#pragma GCC unroll 8
      for (int s = 0; s < C; ++s)
        if constexpr (update == Update::Subtract)
          sum[r][s] -= left * right[s];
        else
          sum[r][s] += left * right[s];
    }
  }
#pragma GCC unroll 8
  for (int r = 0; r < R; ++r)
#pragma GCC unroll 8
    for (int s = 0; s < C; ++s) store(c + r * stride + s * lanes, sum[r][s]);
}

using Tile = void (*)(Left, Rows, int, double*, int);

template <Update update, bool unit_step, int... index>
constexpr auto tiles(std::integer_sequence<int, index...>) {
  return std::array<Tile, sizeof...(index)>{
      &tile<update, unit_step, index / tile_vectors + 1, index % tile_vectors + 1>...};
}

/// Kernels for all tiles of up to tile_rows rows and tile_vectors vectors.
template <Update update, bool unit_step>
inline constexpr auto tile_table =
    tiles<update, unit_step>(std::make_integer_sequence<int, tile_rows * tile_vectors>{});

}  // namespace detail

/// Sets C to A^T B, or adds or subtracts A^T B, with A: count x m, B: count x n, C: m x n. The
/// outer loop runs over columns, so that a panel of B stays in the first-level cache.
template <Update update, bool unit_step = true>
void product(Left a, Rows b, int count, int m, int n, MutableRows c) {
  using namespace detail;
  const int vectors = round_up(n) / lanes;
  for (int j = 0; j < vectors; j += tile_vectors) {
    const int wide = std::min(tile_vectors, vectors - j);
    for (int i = 0; i < m; i += tile_rows) {
      const int high = std::min(tile_rows, m - i);
      tile_table<update, unit_step>[(high - 1) * tile_vectors + wide - 1](
          {a.data + i * a.i_step, a.k_step, a.i_step}, {b.data + j * lanes, b.stride}, count,
          c.data + i * c.stride + j * lanes, c.stride);
    }
  }
}

namespace detail {

/// Adds x^T B to `C` SIMD vectors of `out`. With one sum per vector, each addition would wait for
/// the previous addition. The products of a vector are therefore spread over `parts` sums.
template <int C>
void row_tile(const double* x, Rows b, int count, double* out) {
  constexpr int parts = C == 1 ? 4 : 2;
  Lane sum[parts][C];
#pragma GCC unroll 4
  for (int p = 0; p < parts; ++p)
#pragma GCC unroll 4
    for (int s = 0; s < C; ++s) sum[p][s] = p == 0 ? load(out + s * lanes) : Lane(0.0);
  const auto add = [&](int k, int p) {
    const Lane left(x[k]);
#pragma GCC unroll 4
    for (int s = 0; s < C; ++s) sum[p][s] += left * load(b.data + k * b.stride + s * lanes);
  };
  int k = 0;
  for (; k + parts <= count; k += parts)
#pragma GCC unroll 4
    for (int p = 0; p < parts; ++p) add(k + p, p);
  for (; k < count; ++k) add(k, 0);
#pragma GCC unroll 4
  for (int s = 0; s < C; ++s) {
    Lane all = sum[0][s] + sum[1][s];
    if constexpr (parts == 4) all += sum[2][s] + sum[3][s];
    store(out + s * lanes, all);
  }
}

}  // namespace detail

/// Adds x^T B to `out`, with B: count x n. The sums stay in registers.
inline void add_row_times(const double* x, Rows b, int count, int n, double* out) {
  const int vectors = round_up(n) / lanes;
  int j = 0;
  for (; j + 3 <= vectors; j += 3)
    detail::row_tile<3>(x, {b.data + j * lanes, b.stride}, count, out + j * lanes);
  if (vectors - j == 2)
    detail::row_tile<2>(x, {b.data + j * lanes, b.stride}, count, out + j * lanes);
  else if (vectors - j == 1)
    detail::row_tile<1>(x, {b.data + j * lanes, b.stride}, count, out + j * lanes);
}

/// Size of the groups of rows or columns that are distributed over workers, so that no tile or SIMD
/// vector crosses the border between two workers.
inline constexpr int group = std::max(lanes, detail::tile_rows);

/// Sets C to A^T B, or adds or subtracts A^T B, for the entries on and below the diagonal in the
/// given rows of C. The first row must be a multiple of `group`. Entries above the diagonal are
/// overwritten up to the next tile border.
template <Update update>
void lower_product(Left a, Rows b, int count, Range rows, MutableRows c) {
  using namespace detail;
  const int vectors = round_up(rows.end) / lanes;
  for (int j = 0; j < vectors; j += tile_vectors) {
    const int diagonal = j * lanes / tile_rows * tile_rows;
    for (int i = std::max(rows.begin, diagonal); i < rows.end; i += tile_rows) {
      const int high = std::min(tile_rows, rows.end - i);
      const int needed = (i + high - j * lanes + lanes - 1) / lanes;
      const int wide = std::min({tile_vectors, vectors - j, needed});
      tile_table<update, true>[(high - 1) * tile_vectors + wide - 1](
          {a.data + i * a.i_step, a.k_step, a.i_step}, {b.data + j * lanes, b.stride}, count,
          c.data + i * c.stride + j * lanes, c.stride);
    }
  }
}

/// lower_product() for all n rows.
template <Update update>
void lower_product(Left a, Rows b, int count, int n, MutableRows c) {
  lower_product<update>(a, b, count, Range{0, n}, c);
}

/// Computes y += factor * x for the first n entries, rounded up to whole SIMD vectors.
BURNISH_INLINE void add_scaled(double factor, const double* x, int n, double* y) {
  const Lane f(factor);
  for (int i = 0; i < n; i += lanes) store(y + i, load(y + i) + f * load(x + i));
}

/// Computes y = a + factor * b for the first n entries, rounded up to whole SIMD vectors.
BURNISH_INLINE void sum_scaled(const double* a, double factor, const double* b, int n, double* y) {
  const Lane f(factor);
  for (int i = 0; i < n; i += lanes) store(y + i, load(a + i) + f * load(b + i));
}

BURNISH_INLINE void copy(const double* x, int n, double* y) {
  for (int i = 0; i < n; i += lanes) store(y + i, load(x + i));
}

/// Dot product. Does not read past entry n - 1.
BURNISH_INLINE double dot(const double* x, const double* y, int n) {
  Lane sum(0.0);
  int i = 0;
  for (; i + lanes <= n; i += lanes) sum += load(x + i) * load(y + i);
  double result = 0.0;
  for (int l = 0; l < lanes; ++l) result += sum.lane(l);
  for (; i < n; ++i) result += x[i] * y[i];
  return result;
}

/// y += A x with A: m x n.
BURNISH_INLINE void add_times(Rows a, const double* x, int m, int n, double* y) {
  for (int i = 0; i < m; ++i) y[i] += dot(a.data + i * a.stride, x, n);
}

/// B = A^T with A: m x n, B: n x m. Reads whole SIMD vectors of up to round_up(m) rows of A.
void transpose_copy(Rows a, int m, int n, MutableRows b);

/// Writes rows of the symmetric matrix B whose lower triangle is the lower triangle of A, and the
/// columns that mirror these rows. The first row must be a multiple of `group`. Reads up to `lanes`
/// rows of A at a time. B may be A if `rows` contains all rows.
void mirror_lower(Rows a, Range rows, MutableRows b);

/// Cholesky factorization of the nu x nu block Q of Y = [Q | Z]. Replaces Q by R in place, with
/// Q = R^T R and R upper triangular. Replaces Z by R^-T Z in the given `columns` of Y, rounded
/// outwards to whole SIMD vectors.
/// Returns the first row whose pivot is at most 1e-14 times its diagonal entry, or not finite; -1
/// if there is none.
int partial_cholesky(double* y, int stride, int nu, Range columns, double* inverse_diagonal);

/// Factor R of Q = R^T R from partial_cholesky(), upper triangular, and its inverse diagonal.
struct Factor {
  const double* r;
  int stride;
  const double* inverse_diagonal;
};

/// X = -R^-1 Z, with R: nu x nu, and Z and X: nu x n.
void solve_gains(const Factor& factor, Rows z, int nu, int n, MutableRows x);

/// X <- R^-1 X, with R: nu x nu and X: nu x n.
void solve_upper(const Factor& factor, int nu, int n, MutableRows x);

/// X <- R^-T X, with R: nu x nu and X: nu x n.
void solve_transposed(const Factor& factor, int nu, int n, MutableRows x);

}  // namespace burnish::dense
