// The recursion over a part of a horizon whose end is a parameter.
//
// With theta the multiplier of the state x+ in which the part ends, its cost to go is
//   V(x, theta) = vx^T x + 1/2 x^T Vxx x + theta^T (X^T x - 1/2 D theta + r),
// which begins as theta^T x+: vx = Vxx = 0, X = 1, D = 0, r = 0. A knot backwards, vx and Vxx
// follow the recursion as ever, and with Z = Fu^T X and Quu = R^T R
//   X <- Fx^T X + K^T Z,   D <- D + (R^-T Z)^T R^-T Z,   r <- r + X^T gap + Z^T k.
// When the value function P, p of what follows is known, theta = P x+ + p and x+ = X^T x - D theta
// + r give theta(x) by one dense system,
//   (1 + P D) theta = P (X^T x + r) + p,
// and vx + X theta(0), Vxx + X dtheta/dx are the value function of the whole at the part's begin.
// After Wright (1991) and Nielsen and Axehill (2015), who condense parts in this way; here each
// part is swept again once its end is known, which is less work than to correct the gains of its
// knots.
#pragma once

#include "solver/riccati.hpp"

namespace burnish {

/// Nothing is allocated after construction.
class ParametricSegment {
 public:
  ParametricSegment(const StateShape& state, int max_controls);

  RiccatiRecursion& recursion() { return recursion_; }
  /// vx = Vxx = 0 at the end.
  ValueStorage nothing() { return nothing_.storage(layout_.value_stride); }
  /// What join() found.
  ValueStorage joined() { return joined_.storage(layout_.value_stride); }

  void start();
  /// After recursion() made the step of that knot.
  void extend(const KnotExpansion& expansion, int controls, const double* gap,
              const PolicyStorage& policy);
  /// The value function of the whole at the begin, from that of the segment alone and that of what
  /// follows; false if the system is singular or not finite.
  bool join(const ValueStorage& segment, const ValueStorage& following);

 private:
  struct Value {
    Buffer memory;
    ValueStorage storage(int stride) { return {memory.data(), memory.data() + stride}; }
  };
  /// F^T X into `out`: (nu + ndx) rows.
  void multiply_transposed(const KnotExpansion& expansion, int controls, const double* x,
                           double* out);
  void add_passed(const KnotExpansion& expansion, int controls, const double* x, double* out) const;

  StateShape state_;
  RiccatiLayout layout_;
  RiccatiRecursion recursion_;
  Value nothing_, joined_;
  Buffer fx_[2];       ///< Z above X, now and a knot later
  Buffer projected_;   ///< T^T X: nv rows
  Buffer d_, r_;       ///< D, lower triangle
  Buffer transposed_;  ///< X^T
  Buffer system_;      ///< [1 + P D | P X^T | P r + p]
  int system_stride_;
  int now_ = 0;       ///< of fx_
  int controls_ = 0;  ///< rows of Z above X
};

}  // namespace burnish
