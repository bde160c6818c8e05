// Matrix product C = A^T B as a sum over selected rows k: sum of A_k^T B_k, computed in register
// tiles. The list of rows expresses sparsity. Matrices are row-major.
#pragma once

#include <span>

#include "math/scalar.hpp"

namespace burnish {

/// Assignment of the sum: C = sum, C += sum or C = -sum.
enum class Gram { Set, Add, SetNegative };

/// Row-major matrix in memory: first entry, and distance between rows in entries.
template <class S>
struct StridedView {
  S* data;
  int stride;
};

namespace gram_detail {

// Tile size for which the sums, one row of B and one entry of A fit into the vector registers of
// the target: 32 registers with AVX-512 and NEON, 16 otherwise.
#if defined(__AVX512F__) || defined(__aarch64__)
inline constexpr int tile_rows = 6, tile_columns = 4;
#else
inline constexpr int tile_rows = 4, tile_columns = 3;
#endif

template <Gram mode, int R, int C, class S>
BURNISH_INLINE void tile(StridedView<const S> a, StridedView<const S> b, std::span<const int> rows,
                         int i, int j, StridedView<S> c) {
  S sum[R][C];
#pragma GCC unroll 8
  for (int r = 0; r < R; ++r)
#pragma GCC unroll 8
    for (int s = 0; s < C; ++s) sum[r][s] = S(0.0);
  for (const int k : rows) {
    const S* ak = a.data + k * a.stride + i;
    const S* bk = b.data + k * b.stride + j;
    S right[C];
#pragma GCC unroll 8
    for (int s = 0; s < C; ++s) right[s] = bk[s];
#pragma GCC unroll 8
    for (int r = 0; r < R; ++r) {
      const S left = ak[r];
#pragma GCC unroll 8
      for (int s = 0; s < C; ++s) sum[r][s] += left * right[s];
    }
  }
#pragma GCC unroll 8
  for (int r = 0; r < R; ++r)
#pragma GCC unroll 8
    for (int s = 0; s < C; ++s) {
      S& out = c.data[(i + r) * c.stride + j + s];
      if constexpr (mode == Gram::Set) out = sum[r][s];
      if constexpr (mode == Gram::Add) out += sum[r][s];
      if constexpr (mode == Gram::SetNegative) out = -sum[r][s];
    }
}

/// Computes R rows of C from row i on, in the columns from j0 up to, but not including, j1.
template <Gram mode, int R, class S>
void tile_row(StridedView<const S> a, StridedView<const S> b, std::span<const int> rows, int i,
              int j0, int j1, StridedView<S> c) {
  int j = j0;
  for (; j + tile_columns <= j1; j += tile_columns)
    tile<mode, R, tile_columns>(a, b, rows, i, j, c);
  if constexpr (tile_columns > 3) {
    if (j + 3 == j1) tile<mode, R, 3>(a, b, rows, i, j, c);
  }
  if (j + 2 == j1) tile<mode, R, 2>(a, b, rows, i, j, c);
  if (j + 1 == j1) tile<mode, R, 1>(a, b, rows, i, j, c);
}

}  // namespace gram_detail

/// Computes C(i, j) for i0 <= i < i1 and j0 <= j < j1: column i of A times column j of B, summed
/// over `rows`.
template <Gram mode, class S>
void gram(StridedView<const S> a, StridedView<const S> b, std::span<const int> rows, int i0, int i1,
          int j0, int j1, StridedView<S> c) {
  using namespace gram_detail;
  int i = i0;
  for (; i + tile_rows <= i1; i += tile_rows) tile_row<mode, tile_rows>(a, b, rows, i, j0, j1, c);
  for (; i + 3 <= i1; i += 3) tile_row<mode, 3>(a, b, rows, i, j0, j1, c);
  if (i + 2 == i1) tile_row<mode, 2>(a, b, rows, i, j0, j1, c);
  if (i + 1 == i1) tile_row<mode, 1>(a, b, rows, i, j0, j1, c);
}

}  // namespace burnish
