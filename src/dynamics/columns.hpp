// Row-major matrices of derivatives, and functions that write spatial vectors into their columns.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// Derivatives by q and v: two row-major matrices whose rows are `stride` apart.
template <class S>
struct StateDerivatives {
  S *dq, *dv;
  int stride;
};

/// Writes three rows of a column: out[0], out[stride] and out[2 stride].
template <class S>
BURNISH_INLINE void store_column(const Vec3<S>& x, S* out, int stride) {
  out[0] = x.x;
  out[stride] = x.y;
  out[2 * stride] = x.z;
}

/// Writes six rows of a column, linear part first.
template <class S>
BURNISH_INLINE void store_column(const Motion<S>& m, S* out, int stride) {
  store_column(m.linear, out, stride);
  store_column(m.angular, out + 3 * stride, stride);
}
template <class S>
BURNISH_INLINE void store_column(const Force<S>& f, S* out, int stride) {
  store_column(f.linear, out, stride);
  store_column(f.angular, out + 3 * stride, stride);
}

/// Adds a vector to a column: three rows, or six with the linear part first.
template <class S>
BURNISH_INLINE void add_column(const Vec3<S>& x, S* out, int stride) {
  out[0] += x.x;
  out[stride] += x.y;
  out[2 * stride] += x.z;
}
template <class S>
BURNISH_INLINE void add_column(const Force<S>& f, S* out, int stride) {
  add_column(f.linear, out, stride);
  add_column(f.angular, out + 3 * stride, stride);
}

}  // namespace burnish
