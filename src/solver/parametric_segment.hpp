// Riccati recursion over a segment of the horizon whose end is a parameter.
//
// Let theta be the multiplier of the segment's final state x+. The cost to go of the segment is
//   V(x, theta) = vx^T x + 1/2 x^T Vxx x + theta^T (X^T x - 1/2 D theta + r).
// At the end V is theta^T x+: vx = Vxx = 0, X = 1, D = 0, r = 0. One knot backwards, vx and Vxx
// follow the usual recursion with the policy du = k + K x. With Z = Fu^T X and Quu = R^T R,
//   X <- Fx^T X + K^T Z,   D <- D + (R^-T Z)^T R^-T Z,   r <- r + X^T gap + Z^T k.
// The rest of the horizon has a value function P, p. With theta = P x+ + p and x+ = X^T x - D theta
// + r, theta(x) follows from one dense system,
//   (1 + P D) theta = P (X^T x + r) + p,
// and vx + X theta(0), Vxx + X dtheta/dx are the value function at the start of the segment.
//
// The method follows Wright (1991) and Nielsen and Axehill (2015), who condense segments in this
// way. Here, a second sweep of each segment starts from its computed end. A second sweep costs less
// than correcting the gains of the knots.
#pragma once

#include "solver/riccati.hpp"

namespace burnish {

/// A recursion over one segment. Does not allocate after construction.
class ParametricSegment {
 public:
  ParametricSegment(const StateShape& state, int max_controls);

  RiccatiRecursion& recursion() { return recursion_; }
  /// Returns the zero value function, vx = Vxx = 0, for the end of the segment.
  ValueStorage nothing() { return nothing_.storage(layout_.value_stride); }
  /// Returns the value function that join() computed.
  ValueStorage joined() { return joined_.storage(layout_.value_stride); }

  void start();
  /// Extends X, D and r by one knot, after recursion() made the step of this knot.
  void extend(const KnotExpansion& expansion, int controls, const double* gap,
              const PolicyStorage& policy);
  /// Joins two value functions at the start of the segment: `segment`, of the segment alone, and
  /// `following`, of the rest of the horizon. Returns false if the system is singular or not
  /// finite.
  bool join(const ValueStorage& segment, const ValueStorage& following);

 private:
  struct Value {
    Buffer memory;
    ValueStorage storage(int stride) { return {memory.data(), memory.data() + stride}; }
  };
  /// out = F^T X, with nu + ndx rows.
  void multiply_transposed(const KnotExpansion& expansion, int controls, const double* x,
                           double* out);
  void add_passed(const KnotExpansion& expansion, int controls, const double* x, double* out) const;

  StateShape state_;
  RiccatiLayout layout_;
  RiccatiRecursion recursion_;
  Value nothing_, joined_;
  Buffer fx_[2];       ///< Rows of Z, then rows of X, before and after a knot
  Buffer projected_;   ///< T^T X: nv rows
  Buffer d_, r_;       ///< D, lower triangle
  Buffer transposed_;  ///< X^T
  Buffer system_;      ///< [1 + P D | P X^T | P r + p]
  int system_stride_;
  int now_ = 0;       ///< Index of the latest entry of `fx_`
  int controls_ = 0;  ///< Number of rows of Z in the latest entry of `fx_`
};

}  // namespace burnish
