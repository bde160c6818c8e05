// Interface between an optimal control problem and its solver: sizes, arithmetic on states, costs,
// dynamics and their derivatives. The interface is not specific to robots: a state is a point x of
// nx numbers. A change of state is a tangent vector dx of ndx numbers.
//
// A horizon has N knots, each with a state, a control and a cost, and a terminal state with a cost:
//   minimise sum over k < N of l_k(x_k, u_k) + l_N(x_N)  subject to  x_(k+1) = f_k(x_k, u_k)
// A knot may also have constraint rows, lower <= c_k(x_k, u_k) <= upper.
// Derivatives are with respect to z = (du, dx): controls first, then the right tangent increment
// dx.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"

namespace burnish {

/// Consecutive entries of dx that are not simply added to entries of the state (a non-Euclidean
/// tangent block). Examples are the six entries of a free-flyer and the three entries of a planar
/// joint.
struct NonEuclideanBlock {
  int first;  ///< First entry of dx in the block
  int size;
};

/// Layout of the state, equal at all knots. With DynamicsForm::SecondOrder, dx = (dq, dv, dtau) has
/// nv, nv and `filtered` entries. With DynamicsForm::Dense, nv and filtered are zero.
struct StateShape {
  int nx = 0;
  int ndx = 0;
  int nv = 0;
  /// Number of torques in the state, which follow the control through a low-pass filter
  int filtered = 0;
  std::vector<NonEuclideanBlock> blocks;  ///< Non-Euclidean tangent blocks within dq
};

/// Structure of the linearized dynamics: how the change dx' of the next state depends on
/// z = (du, dx).
enum class DynamicsForm {
  Dense,  ///< dx' = F z with F of size ndx x nz

  /// dv' = P z, dq' = A dq + step B dv', dtau' = decay dtau + (1 - decay) du, with P of size
  /// nv x nz. A and B are identities except in the non-Euclidean tangent blocks. Semi-implicit
  /// Euler has this form. An impact has this form with step = 0.
  SecondOrder,
};

/// Low-rank curvature of one constraint row c: d2(c)/dz2 is about sign * sum b^T b. The sum is over
/// `count` row vectors b in KnotExpansion::curvatures.
struct RowCurvature {
  int row = 0;        ///< Index of the row among the knot's constraint rows
  int first = 0;      ///< Index of the first b in KnotExpansion::curvatures
  int count = 0;      ///< Number of rows b
  double sign = 1.0;  ///< 1: the row is convex; -1: the row is concave
};

/// Values and derivatives of one knot. The solver owns the memory, and the problem writes the
/// values. Matrices are row-major; a row starts `stride` entries after the row before. The size of
/// z is nz = nu + ndx.
struct KnotExpansion {
  int stride = 0;
  double* gradient = nullptr;  ///< Gradient of the cost with respect to z, nz entries

  /// Gauss-Newton Hessian of the cost, nz x nz; only the lower triangle is read
  double* hessian = nullptr;
  double* dynamics = nullptr;  ///< Matrix P (nv x nz) or F (ndx x nz), see DynamicsForm

  /// Matrices A and B of each non-Euclidean tangent block, size x size each (SecondOrder only). In
  /// each block, B follows A. B does not contain the factor `step`.
  double* tangent_blocks = nullptr;
  double* decay = nullptr;  ///< Decay factor of each filtered torque over a step (SecondOrder only)

  /// Values c of the constraint rows, rows(knot) entries; null: not requested.
  double* row_values = nullptr;
  /// Derivatives d(c)/dz of the constraint rows, without rows that equal an entry of z (see
  /// row_entry())
  double* rows = nullptr;

  /// Vectors b of the constraint curvature (RowCurvature), nz entries each; null: not requested.
  /// The unit of b is the square root of the row's unit, per unit of z.
  double* curvatures = nullptr;
  double step = 0.0;  ///< Duration of the knot's step [s]
  DynamicsForm form = DynamicsForm::Dense;
};

/// Cost of one knot and status of its evaluation.
struct KnotValue {
  double cost = 0.0;
  Status status = Status::Ok;

  /// Index in term_names(knot) of the cost term that is not finite; -1: none. If -1, the cause can
  /// be a constraint row or the dynamics.
  int term = -1;
  int row = -1;  ///< Index in row_names(knot) of the row that is not finite; -1: none
};

/// Range of knots that are evaluated together: begin to end - 1.
struct KnotRange {
  int begin, end;
};

/// States and controls of a horizon in raw memory. The state of knot k starts at x + k * nx, the
/// control at u + k * max_controls().
struct TrajectoryView {
  const double* x;
  const double* u;
};

/// Interface of an optimal control problem that a DdpSolver solves. The argument `worker` is the
/// number of the calling thread, 0 to workers - 1. Functions with this argument do not allocate,
/// and may be called by different workers at the same time. An exception from any function, for
/// example from a user's own cost, ends the solve and reaches the caller of the solver.
class ShootingProblem {
 public:
  virtual ~ShootingProblem() = default;

  virtual const StateShape& state() const = 0;
  virtual int knots() const = 0;  ///< Number N of knots; there are N + 1 states

  /// Number nu of a knot's controls; 0 at impacts and at knot N
  virtual int controls(int knot) const = 0;
  virtual int max_controls() const = 0;
  virtual const double* initial_state() const = 0;  ///< Initial state, nx entries

  /// integrate() writes x (+) dx to `out`; `out` and x may be the same memory. difference() writes
  /// the tangent vector dx for which x0 (+) dx = x1.
  virtual void integrate(const double* x, const double* dx, double* out) const = 0;
  virtual void difference(const double* x0, const double* x1, double* dx) const = 0;

  /// Return the lower and upper bounds of a knot's controls, nu entries each; null: no bounds.
  virtual const double* control_lower(int /*knot*/) const { return nullptr; }
  virtual const double* control_upper(int /*knot*/) const { return nullptr; }
  /// Returns the characteristic size of each control, > 0, in the control's unit; null: 1 for every
  /// control. The size of a control with bounds is not used.
  virtual const double* control_scale(int /*knot*/) const { return nullptr; }

  /// rows() returns the number of constraint rows of a knot. max_rows() returns the largest number
  /// of constraint rows at any knot. row_lower() and row_upper() return the limits of a knot's
  /// rows, rows(knot) entries each, or null if the knot has no rows. A missing limit is infinite.
  virtual int rows(int /*knot*/) const { return 0; }
  virtual int max_rows() const { return 0; }
  virtual const double* row_lower(int /*knot*/) const { return nullptr; }
  virtual const double* row_upper(int /*knot*/) const { return nullptr; }
  /// Returns an index for each constraint row of a knot. Index i >= 0 means that the row equals
  /// entry i of z plus a constant. Its derivative is then 1 at entry i and 0 elsewhere. Index -1
  /// stands for any other row. Null means -1 for every row. Two rows of a knot must not have the
  /// same index i >= 0. If the control i has bounds, no row may have the index i.
  virtual const int* row_entry(int /*knot*/) const { return nullptr; }
  /// Returns the characteristic size of each constraint row, > 0, in the row's unit. Tolerances are
  /// relative to this size.
  virtual const double* row_scale(int /*knot*/) const { return nullptr; }
  /// Return the L1 weight and the quadratic weight of each constraint row. A violation v costs l1
  /// |v| + 1/2 quadratic v^2. A row with an infinite L1 weight is hard: a violation is accepted
  /// only if no trajectory without violations exists.
  virtual const double* row_l1_weight(int /*knot*/) const { return nullptr; }
  virtual const double* row_quadratic_weight(int /*knot*/) const { return nullptr; }
  /// Returns the curvature of a knot's constraint rows: sign and vectors b of each curved row (see
  /// RowCurvature). Default: no curvature (Gauss-Newton). If sign times the multiplier of the row
  /// is positive, the solver adds |multiplier| b^T b to the Hessian of the cost. The sum of these
  /// terms is at most the row's part of the Hessian of the Lagrangian.
  virtual std::span<const RowCurvature> row_curvatures(int /*knot*/) const { return {}; }
  /// Returns the largest number of curvature vectors b (see RowCurvature) that a single knot has.
  virtual int max_curvatures() const { return 0; }

  /// Allocates the memory for `workers` concurrent callers. May throw.
  virtual void prepare(int workers) = 0;

  /// Returns ranges that together contain knots 0 to N once each. The ranges do not depend on the
  /// number of workers. The last range contains only the terminal knot.
  virtual std::span<const KnotRange> ranges() const = 0;

  /// Evaluates one knot and returns its cost. Writes the next state to `next`, except at the
  /// terminal knot N. Writes the values of the knot's constraint rows to `rows`, unless `rows` is
  /// null.
  virtual KnotValue roll(int worker, int knot, const double* x, const double* u, double* next,
                         double* rows = nullptr) = 0;

  /// Evaluates the knots of a range. For each knot k, writes the next state to next + k * nx, the
  /// cost to values[k], and the constraint rows to rows + k * max_rows(). Writes no constraint rows
  /// if `rows` is null. The number k counts from the start of the horizon, not of the range.
  virtual void evaluate(int worker, KnotRange range, TrajectoryView at, double* next,
                        KnotValue* values, double* rows = nullptr) = 0;

  /// Evaluates and linearizes the knots of a range. For each knot k, writes the next state to
  /// next + k * nx, the cost to values[k], and derivatives and constraint rows to out[k]. The
  /// number k counts from the start of the horizon, not of the range.
  virtual void expand(int worker, KnotRange range, TrajectoryView at, double* next,
                      KnotValue* values, KnotExpansion* out) = 0;

  /// Return names for messages: names of the entries of dx, of the controls, of a knot's cost
  /// terms, and of a knot's constraint rows. The solver does not call these functions inside an
  /// iteration.
  virtual std::vector<std::string> state_names() const = 0;
  virtual std::vector<std::string> control_names() const = 0;
  virtual std::vector<std::string> term_names(int knot) const = 0;
  virtual std::vector<std::string> row_names(int /*knot*/) const { return {}; }
  /// Returns the cost of each term of a knot, in the order of term_names().
  virtual std::vector<double> term_costs(int knot, const double* x, const double* u) = 0;
  /// Returns the values of a knot's constraint rows, in the order of row_names().
  virtual std::vector<double> row_values(int /*knot*/, const double* /*x*/, const double* /*u*/) {
    return {};
  }
  virtual std::string knot_name(int knot) const = 0;  ///< Name such as "press, knot 12"
};

}  // namespace burnish
