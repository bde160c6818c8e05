#include "solver/dense.hpp"

#include <cmath>

namespace burnish::dense {
namespace {

/// Loads the block of `lanes` rows at `from`, transposed.
BURNISH_INLINE void load_transposed(const double* from, int stride, Lane* rows) {
#pragma GCC unroll 8
  for (int r = 0; r < lanes; ++r) rows[r] = load(from + r * stride);
  transpose(rows);
}

}  // namespace

void transpose_copy(Rows a, int m, int n, MutableRows b) {
  for (int i = 0; i < m; i += lanes)
    for (int j = 0; j < n; j += lanes) {
      Lane rows[lanes];
      load_transposed(a.data + i * a.stride + j, a.stride, rows);
      const int high = std::min(lanes, n - j);
      for (int r = 0; r < high; ++r) store(b.data + (j + r) * b.stride + i, rows[r]);
    }
}

void mirror_lower(Rows a, Range rows_of_b, MutableRows b) {
  const int n = rows_of_b.end;
  for (int i = rows_of_b.begin; i < n; i += lanes) {
    const int high = std::min(lanes, n - i);
    for (int j = 0; j < i; j += lanes) {
      Lane rows[lanes];
      Lane turned[lanes];
#pragma GCC unroll 8
      for (int r = 0; r < lanes; ++r) turned[r] = rows[r] = load(a.data + (i + r) * a.stride + j);
      transpose(turned);
      for (int r = 0; r < high; ++r) store(b.data + (i + r) * b.stride + j, rows[r]);
#pragma GCC unroll 8
      for (int r = 0; r < lanes; ++r) store(b.data + (j + r) * b.stride + i, turned[r]);
    }
    Lane rows[lanes];
    Lane turned[lanes];
#pragma GCC unroll 8
    for (int r = 0; r < lanes; ++r) turned[r] = rows[r] = load(a.data + (i + r) * a.stride + i);
    transpose(turned);
    Lane column;
    for (int l = 0; l < lanes; ++l) Lanes<Lane>::set(column, l, l);
    for (int r = 0; r < high; ++r)
      store(b.data + (i + r) * b.stride + i,
            select(less(Lane(r + 0.5), column), turned[r], rows[r]));
  }
}

namespace {

/// Factors the diagonal block of R rows that starts at column `first`. Multiplies the columns
/// `near`, which contain the block, and the columns `far` by the inverse transposed factor. The
/// block is factored first, in scalars, so that the columns stay in registers and do not wait for
/// the chain of square roots.
template <int R>
int factor_rows(double* y, int stride, int first, Range near, Range far, double* inverse) {
  double t[R][R];
  for (int j = 0; j < R; ++j)
    for (int c = j; c < R; ++c) t[j][c] = y[j * stride + first + c];
#pragma GCC unroll 8
  for (int j = 0; j < R; ++j) {
    const double pivot = t[j][j];
    if (!(pivot > 1e-14 * inverse[j]) || !std::isfinite(pivot)) return j;
    inverse[j] = 1.0 / std::sqrt(pivot);
#pragma GCC unroll 8
    for (int c = j + 1; c < R; ++c) t[j][c] *= inverse[j];
#pragma GCC unroll 8
    for (int i = j + 1; i < R; ++i)
#pragma GCC unroll 8
      for (int c = i; c < R; ++c) t[i][c] -= t[j][i] * t[j][c];
  }
  const auto apply = [&](int begin, int end) {
    for (int c = begin; c < end; c += lanes) {
      Lane row[R];
#pragma GCC unroll 8
      for (int i = 0; i < R; ++i) {
        row[i] = load(y + i * stride + c);
#pragma GCC unroll 8
        for (int k = 0; k < i; ++k) row[i] -= Lane(t[k][i]) * row[k];
        row[i] *= Lane(inverse[i]);
        store(y + i * stride + c, row[i]);
      }
    }
  };
  apply(near.begin, near.end);
  apply(far.begin, far.end);
  return -1;
}

/// Back substitution X <- U^-1 X with the upper triangular block U of R rows at y.
template <int R>
void back_substitute(const double* y, int stride, const double* inverse, double* x, int x_stride,
                     int n) {
  for (int c = 0; c < n; c += lanes) {
    Lane row[R];
#pragma GCC unroll 8
    for (int i = R - 1; i >= 0; --i) {
      row[i] = load(x + i * x_stride + c);
#pragma GCC unroll 8
      for (int k = R - 1; k > i; --k) row[i] -= Lane(y[i * stride + k]) * row[k];
      row[i] *= Lane(inverse[i]);
      store(x + i * x_stride + c, row[i]);
    }
  }
}

/// Forward substitution X <- U^-T X with the upper triangular block U of R rows at y.
template <int R>
void forward_substitute(const double* y, int stride, const double* inverse, double* x, int x_stride,
                        int n) {
  for (int c = 0; c < n; c += lanes) {
    Lane row[R];
#pragma GCC unroll 8
    for (int i = 0; i < R; ++i) {
      row[i] = load(x + i * x_stride + c);
#pragma GCC unroll 8
      for (int k = 0; k < i; ++k) row[i] -= Lane(y[k * stride + i]) * row[k];
      row[i] *= Lane(inverse[i]);
      store(x + i * x_stride + c, row[i]);
    }
  }
}

using FactorRows = int (*)(double*, int, int, Range, Range, double*);
using Substitute = void (*)(const double*, int, const double*, double*, int, int);

template <int... index>
constexpr auto factor_table(std::integer_sequence<int, index...>) {
  return std::array<FactorRows, sizeof...(index)>{&factor_rows<index + 1>...};
}
template <int... index>
constexpr auto back_table(std::integer_sequence<int, index...>) {
  return std::array<Substitute, sizeof...(index)>{&back_substitute<index + 1>...};
}
template <int... index>
constexpr auto forward_table(std::integer_sequence<int, index...>) {
  return std::array<Substitute, sizeof...(index)>{&forward_substitute<index + 1>...};
}
constexpr auto row_counts = std::make_integer_sequence<int, detail::tile_rows>{};
constexpr auto factor_by_rows = factor_table(row_counts);
constexpr auto back_by_rows = back_table(row_counts);
constexpr auto forward_by_rows = forward_table(row_counts);

}  // namespace

int partial_cholesky(double* y, int stride, int nu, Range columns, double* inverse_diagonal) {
  const int square = round_up(nu);
  const int beside = round_down(columns.begin);
  const bool apart = beside > square;
  const Range far{beside, apart ? columns.end : beside};
  for (int i = 0; i < nu; ++i) inverse_diagonal[i] = y[i * stride + i];
  for (int first = 0; first < nu; first += detail::tile_rows) {
    const int rows = std::min(nu - first, detail::tile_rows);
    const int left = round_down(first);
    const Range near{left, apart ? square : columns.end};
    double* block = y + first * stride;
    const auto subtract = [&](Range span) {
      if (first > 0 && span.begin < span.end)
        product<Update::Subtract>({y + first, stride, 1}, {y + span.begin, stride}, first, rows,
                                  span.end - span.begin, {block + span.begin, stride});
    };
    subtract(near);
    subtract(far);
    const int failed =
        factor_by_rows[rows - 1](block, stride, first, near, far, inverse_diagonal + first);
    if (failed >= 0) return first + failed;
  }
  return -1;
}

void solve_gains(const Factor& factor, Rows z, int nu, int n, MutableRows x) {
  for (int i = 0; i < nu; ++i)
    for (int c = 0; c < n; c += lanes)
      store(x.data + i * x.stride + c, -load(z.data + i * z.stride + c));
  solve_upper(factor, nu, n, x);
}

void solve_upper(const Factor& factor, int nu, int n, MutableRows x) {
  const auto [r, stride, inverse_diagonal] = factor;
  for (int last = nu; last > 0;) {
    const int first = (last - 1) / detail::tile_rows * detail::tile_rows;
    const MutableRows block{x.data + first * x.stride, x.stride};
    if (last < nu)
      product<Update::Subtract, false>({r + first * stride + last, 1, stride},
                                       {x.data + last * x.stride, x.stride}, nu - last,
                                       last - first, n, block);
    back_by_rows[last - first - 1](r + first * stride + first, stride, inverse_diagonal + first,
                                   block.data, block.stride, n);
    last = first;
  }
}

void solve_transposed(const Factor& factor, int nu, int n, MutableRows x) {
  const auto [r, stride, inverse_diagonal] = factor;
  for (int first = 0; first < nu; first += detail::tile_rows) {
    const int rows = std::min(nu - first, detail::tile_rows);
    const MutableRows block{x.data + first * x.stride, x.stride};
    if (first > 0)
      product<Update::Subtract>({r + first, stride, 1}, {x.data, x.stride}, first, rows, n, block);
    forward_by_rows[rows - 1](r + first * stride + first, stride, inverse_diagonal + first,
                              block.data, block.stride, n);
  }
}

}  // namespace burnish::dense
