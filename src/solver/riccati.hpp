// The Riccati recursion: from the value function of the rest of a horizon to that of one knot
// earlier, and the policy in between.
//
// With z = (du, dx), the knot's quadratic cost (h, H), dx' = F z + gap, and V'(dx') = vx'^T dx' +
// 1/2 dx'^T Vxx' dx':
//   w = vx' + Vxx' gap,   Q = H + F^T Vxx' F,   q = h + F^T w,
//   du = k + K dx minimises 1/2 z^T Q z + q^T z  (within the bounds, where there are any),
//   Vxx = Qxx - L^T L,  vx = qx - L^T l,  R^T R = Quu,  L = R^-T Qux,  l = R^-T qu.
// SecondOrder dynamics are F = T P + E, T: dv' -> dx' = (step B; 1; 0), E the parts of z that pass
// through. With U = Vxx' T, W = T^T U and M = U^T E, only P, which has nv rows, meets a dense
// product: F^T V F = P^T (W P + M) + M^T P + E^T V E.
//
// A crew shares one knot: each worker has columns of Y and G, rows of Qxx and columns of the gains.
// What is small, U, W and M and the factor of Quu, each makes for itself: to hand it from core to
// core would take longer. They meet three times a knot (four with bounds). Every entry is the same
// sum whoever makes it.
#pragma once

#include <vector>

#include "base/crew.hpp"
#include "burnish/solver/shooting_problem.hpp"
#include "solver/box_qp.hpp"
#include "solver/buffer.hpp"

namespace burnish {

/// Sizes of the memory that a recursion reads and writes; rows are padded to whole vectors.
struct RiccatiLayout {
  RiccatiLayout(const StateShape& state, int max_controls);

  int expansion_stride;  ///< entries between rows of hessian and dynamics
  int expansion_rows;    ///< rows of the hessian's memory, more than nz
  int value_stride;      ///< of Vxx, and entries of vx
  int gain_stride;       ///< of K
  int spare;             ///< entries that every block of memory is longer than its rows
};

/// V(dx) = gradient^T dx + 1/2 dx^T hessian dx (and a constant), dx = x (-) the iterate's x.
struct ValueStorage {
  double* gradient;  ///< value_stride entries
  double* hessian;   ///< ndx x value_stride, both triangles
};

/// u = u of the iterate + feedforward + gain dx. Beware of signs elsewhere: many write u - K dx.
struct PolicyStorage {
  double* feedforward;  ///< k: nu entries
  double* gain;         ///< K: nu x gain_stride
};

/// Bounds of u at a knot, nu entries each, and the iterate's u. Null: unbounded.
struct ControlBox {
  const double* lower = nullptr;
  const double* upper = nullptr;
  const double* u = nullptr;
};

/// Rows C z that a knot's cost has squared, 1/2 sum w (C z)^2, beside its expansion.
struct WeightedRows {
  const double* rows = nullptr;      ///< C: count x nz
  const double* weighted = nullptr;  ///< w C
  int stride = 0;                    ///< of both
  int count = 0;
  const double* diagonal = nullptr;  ///< nz entries that come to the diagonal of the Hessian
  const double* gradient = nullptr;  ///< nz entries that take the place of the expansion's
};

/// What one step says about the cost that its policy saves.
struct RiccatiStep {
  /// First control at which Quu is not positive definite (or not a number); -1: none.
  int failed_control = -1;
  double slope = 0.0;          ///< qu^T k
  double curvature = 0.0;      ///< k^T Quu k
  double gap_slope = 0.0;      ///< vx'^T gap
  double gap_curvature = 0.0;  ///< gap^T Vxx' gap
};

/// R of Quu = R^T R, upper triangle, and the inverses of its diagonal.
struct RiccatiFactor {
  const double* r;
  int stride;
  const double* inverse_diagonal;
};

/// One recursion's workspace. Nothing is allocated after construction.
class RiccatiRecursion {
 public:
  /// For crews of up to so many workers.
  RiccatiRecursion(const StateShape& state, int max_controls, int workers = 1);

  const RiccatiLayout& layout() const { return layout_; }

  /// Multiplications of a knot with so many controls, without those that grow with less than the
  /// third power of the sizes.
  double multiplications(int controls, DynamicsForm form) const;

  /// The value function of the end: the terminal cost's expansion.
  void terminal(const KnotExpansion& expansion, ValueStorage value) const;
  /// The same with rows of the end.
  void terminal(const KnotExpansion& expansion, const WeightedRows& rows, ValueStorage value);

  /// One knot backwards. `regularization` is added to the diagonal of Quu. `hessian_gap` receives
  /// Vxx' gap (value_stride entries). Where a box is given, policy.feedforward is read first: the
  /// guess from which its quadratic program starts; gains of clamped controls are zero.
  ///
  /// Every worker of a crew calls it with the same arguments but its own crew, and next may call it
  /// for the knot before. All learn of a failed control; the rest of the answer is the leader's.
  RiccatiStep step(const KnotExpansion& expansion, int controls, const double* gap,
                   ValueStorage next, double regularization, const ControlBox& box,
                   PolicyStorage policy, ValueStorage value, double* hessian_gap,
                   const Crew& crew = {}, const WeightedRows* rows = nullptr);

  /// Of the last step that a worker alone made, without bounds.
  RiccatiFactor factor() const { return {y_.data(), y_stride_, own_[0].inverse_diagonal.data()}; }

  /// The step again for another gradient, nz entries, with what it left: `factor` of Quu, the gains
  /// and Vxx' gap. Spoils the gradient; writes the feedforward and the value function's gradient.
  void resolve(const KnotExpansion& expansion, int controls, const RiccatiFactor& factor,
               const double* next_gradient, const double* hessian_gap, double* gradient,
               PolicyStorage policy, double* value_gradient);

 private:
  struct Knot;  ///< what a step is given, and a worker's shares of it
  /// What each worker has for itself: U^T: nv x ndx; W: nv x nv; M: nv x nz; rows that pass
  /// through; R and its part of L.
  struct Own {
    Buffer u, w, m, passed, inverse_diagonal, factor;
  };

  void load_cost(const Knot& knot);
  void project_value(const Knot& knot);
  void project_steps(const Knot& knot);
  void add_to_controls(const Knot& knot);
  void add_passed_to_controls(const Knot& knot);
  const double* pass_filtered(const Knot& knot, int c);
  void cross_gap(const Knot& knot, const double* gap, double* hessian_gap, RiccatiStep& result);
  void add_gradient(const Knot& knot, const double* gradient);
  void add_rows(const Knot& knot, const WeightedRows& rows);
  void add_to_states(const Knot& knot);
  void add_passed_to_states(const Knot& knot);
  void add_passed_controls_to_states(const Knot& knot);
  void clamp(const Knot& knot, const ControlBox& box, double* k, RiccatiStep& result);
  int factorize(const Knot& knot, const PolicyStorage& policy);
  void reduce(const Knot& knot, const ValueStorage& value);
  void conclude(const Knot& knot, bool bounded, const PolicyStorage& policy, RiccatiStep& result);

  StateShape state_;
  RiccatiLayout layout_;
  // Y = [Quu | Qux | qu], upper triangle of Quu; Qxx, lower; the gradient q.
  Buffer y_, qxx_, gradient_;
  int y_stride_;
  Buffer g_;       ///< G = W P + M: nv x nz. Dense: G = Vxx' F, ndx x nz
  Buffer w_next_;  ///< w = vx' + Vxx' gap
  Buffer l_;       ///< [L | l] of a crew; a worker alone has it in Y
  Buffer box_lower_, box_upper_;
  Buffer column_;  ///< a control's feedforward per vector
  std::vector<Own> own_;
  BoxQp box_qp_;
};

}  // namespace burnish
