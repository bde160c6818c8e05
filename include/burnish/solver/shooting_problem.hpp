// What a solver asks of a problem over time: sizes, arithmetic on states, roll out, expand.
// There is no robot here: a state is a point x of nx numbers that moves along tangents dx of ndx.
//
// A horizon has N knots with a state, a control and a cost each, and a terminal state with a cost:
//   minimise sum over k < N of l_k(x_k, u_k) + l_N(x_N)  subject to  x_(k+1) = f_k(x_k, u_k)
// A knot may have rows with limits beside its cost, lower <= c_k(x_k, u_k) <= upper.
// Derivatives are by z = (du, dx), controls first, dx the right tangent increment.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"

namespace burnish {

/// Entries of a configuration's tangent that belong together and whose sum is not plain addition
/// (the six of a free-flyer, the three of a planar joint).
struct LeadBlock {
  int first;  ///< entry of dx
  int size;
};

/// The state along the whole horizon. With second-order structure dx = (dq, dv, dtau): nv, nv and
/// `filtered` entries; without it nv and filtered are zero.
struct StateShape {
  int nx = 0;
  int ndx = 0;
  int nv = 0;
  int filtered = 0;               ///< torques that follow the control through a first-order filter
  std::vector<LeadBlock> blocks;  ///< within dq
};

/// How the next state depends on z.
enum class DynamicsForm {
  Dense,  ///< dx' = F z, F: ndx x nz
  /// dv' = P z with P: nv x nz, dq' = A dq + step B dv', dtau' = decay dtau + (1 - decay) du; A and
  /// B are identities but for the lead blocks. Semi-implicit Euler, and impacts with step = 0.
  SecondOrder,
};

/// How a row with limits bends, of one sign only: of its second derivative by z the part
/// sign sum b^T b, over some rows b of KnotExpansion::bends.
struct RowBend {
  int row = 0;        ///< of the knot's rows with limits
  int first = 0;      ///< of its b in the expansion's
  int count = 0;      ///< of its b
  double sign = 1.0;  ///< 1: convex; -1: concave
};

/// First and second order of one knot, in memory that the solver owns and the problem fills.
/// Matrices are row-major with `stride` between rows. nz = nu + ndx.
struct KnotExpansion {
  int stride = 0;
  double* gradient = nullptr;  ///< nz: d(cost)/dz
  double* hessian = nullptr;   ///< nz x nz, Gauss-Newton; only the lower triangle is read
  double* dynamics = nullptr;  ///< P (nv x nz) or F (ndx x nz)
  /// SecondOrder: per lead block, size x size each: A, then B (without step).
  double* lead = nullptr;
  double* decay = nullptr;  ///< SecondOrder: `filtered` entries
  /// rows(knot) values of c; null: not asked for.
  double* row_values = nullptr;
  double* rows = nullptr;  ///< d(c)/dz of those that are no entry of z
  /// b of the knot's bends, nz each, in units of (row)^(1/2) per z; null: not asked for.
  double* bends = nullptr;
  double step = 0.0;  ///< s
  DynamicsForm form = DynamicsForm::Dense;
};

/// Outcome of one knot's values.
struct KnotValue {
  double cost = 0.0;
  Status status = Status::Ok;
  /// Cost term that is not finite, an index into term_names(knot); -1: none, a row or the dynamics.
  int term = -1;
  int row = -1;  ///< Row that is not finite, an index into row_names(knot); -1: none.
};

/// Knots begin to end - 1, evaluated together.
struct KnotRange {
  int begin, end;
};

/// States and controls of a horizon. x of knot k starts at k * nx, u at k * max_controls().
struct TrajectoryView {
  const double* x;
  const double* u;
};

/// Functions of a problem are called with the number of the worker that calls, from 0 to workers -
/// 1; different workers may call at the same time. None of them allocates. What one throws (a
/// function of a user's that it calls, say) ends the solve and reaches its caller.
class ShootingProblem {
 public:
  virtual ~ShootingProblem() = default;

  virtual const StateShape& state() const = 0;
  virtual int knots() const = 0;             ///< N; there are N + 1 states
  virtual int controls(int knot) const = 0;  ///< nu of a knot; 0 at impacts and at the end (N)
  virtual int max_controls() const = 0;
  virtual const double* initial_state() const = 0;  ///< nx

  /// x (+) dx and the dx with x0 (+) dx = x1. `out` may be x.
  virtual void integrate(const double* x, const double* dx, double* out) const = 0;
  virtual void difference(const double* x0, const double* x1, double* dx) const = 0;

  /// Bounds of the controls of a knot, nu entries each, or null where there are none.
  virtual const double* control_lower(int /*knot*/) const { return nullptr; }
  virtual const double* control_upper(int /*knot*/) const { return nullptr; }
  /// What counts as much of a control that has no bounds, in its unit, above zero; null: 1.
  virtual const double* control_scale(int /*knot*/) const { return nullptr; }

  /// Rows with limits of a knot, and the limits, rows(knot) entries each, infinite where there is
  /// none; null where there are no rows.
  virtual int rows(int /*knot*/) const { return 0; }
  virtual int max_rows() const { return 0; }
  virtual const double* row_lower(int /*knot*/) const { return nullptr; }
  virtual const double* row_upper(int /*knot*/) const { return nullptr; }
  /// Per row: the entry of z that it is, up to a constant (d(row)/dz has a one there and is zero
  /// elsewhere), or -1; null: -1 for all. No two of a knot are the same, and none is a control with
  /// bounds.
  virtual const int* row_entry(int /*knot*/) const { return nullptr; }
  /// In a row's own unit, above zero: what counts as much of it. A tolerance is a share of it.
  virtual const double* row_scale(int /*knot*/) const { return nullptr; }
  /// What a violation v of a row costs, price |v| + 1/2 square v^2. An infinite price: none is
  /// accepted as long as there is a trajectory without any.
  virtual const double* row_price(int /*knot*/) const { return nullptr; }
  virtual const double* row_square(int /*knot*/) const { return nullptr; }
  /// Rows of the knot that say how they bend: where a limit pushes against it the solver adds
  /// |multiplier| b^T b to the cost's Hessian, which is no more than a row's share in that of the
  /// Lagrangian. A problem that has none leaves the bend of rows to the iterations.
  virtual std::span<const RowBend> row_bends(int /*knot*/) const { return {}; }
  /// The most b of a knot.
  virtual int max_bends() const { return 0; }

  /// Makes room for this many workers. May allocate and throw.
  virtual void prepare(int workers) = 0;

  /// The knots 0 to N cut into ranges that do not depend on the number of workers; the last one
  /// holds the terminal knot alone.
  virtual std::span<const KnotRange> ranges() const = 0;

  /// Cost and next state of one knot; `next` is not written at the end (knot N). `rows` receives
  /// the values of the knot's rows; null: they are not asked for.
  virtual KnotValue roll(int worker, int knot, const double* x, const double* u, double* next,
                         double* rows = nullptr) = 0;

  /// The same for a range: knot k of it writes next + k * nx, values[k] and rows + k * max_rows(),
  /// all counted from the start of the horizon.
  virtual void evaluate(int worker, KnotRange range, TrajectoryView at, double* next,
                        KnotValue* values, double* rows = nullptr) = 0;

  /// Like evaluate, rows in the expansions, and the expansion of each knot, out[k] counted from the
  /// start of the horizon.
  virtual void expand(int worker, KnotRange range, TrajectoryView at, double* next,
                      KnotValue* values, KnotExpansion* out) = 0;

  /// For people: not called inside an iteration. Entries of dx, controls, cost terms.
  virtual std::vector<std::string> state_names() const = 0;
  virtual std::vector<std::string> control_names() const = 0;
  virtual std::vector<std::string> term_names(int knot) const = 0;
  virtual std::vector<std::string> row_names(int /*knot*/) const { return {}; }
  /// Cost of each term of a knot, in the order of term_names.
  virtual std::vector<double> term_costs(int knot, const double* x, const double* u) = 0;
  /// Values of a knot's rows, in the order of row_names.
  virtual std::vector<double> row_values(int /*knot*/, const double* /*x*/, const double* /*u*/) {
    return {};
  }
  virtual std::string knot_name(int knot) const = 0;  ///< such as "press, knot 12"
};

}  // namespace burnish
