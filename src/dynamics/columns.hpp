// Writing spatial vectors into columns of row-major matrices.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// Three rows of a column: out[0], out[stride], out[2 stride].
template <class S>
BURNISH_INLINE void store_column(const Vec3<S>& x, S* out, int stride) {
  out[0] = x.x;
  out[stride] = x.y;
  out[2 * stride] = x.z;
}

/// Six rows, linear part first.
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

/// Adds to a column of as many rows.
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
