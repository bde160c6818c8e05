// Residuals as the kernels read them. Each has
//   evaluate(knot, target, r, J): r (rows) and, unless J is null, its derivative by z, block by
//   block in the order of the term's blocks.
// Those whose first row is a length, or less one, also have
//   bend_rows(), bend_sign and evaluate(knot, target, r, J, bends): unless null, rows b as wide as
//   J's with bend_sign sum b^T b the second derivative of that row (RowBend).
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "burnish/ocp/residual.hpp"
#include "derivatives/frame_kinematics.hpp"
#include "derivatives/wrench_transport.hpp"
#include "dynamics/integration.hpp"
#include "ocp/knot_state.hpp"

namespace burnish::ocp {

/// Rows row to row + rows - 1 depend on these columns of z, ascending. Diagonal: row i on column i
/// alone, kept as `rows` numbers; otherwise rows x columns, row-major.
struct JacobianBlock {
  int row, rows;
  std::vector<int> columns;
  bool diagonal;
  int size() const { return diagonal ? rows : rows * static_cast<int>(columns.size()); }
};

/// x (-) target. Diagonal first, then a dense block per joint of several entries.
struct StateDifference {
  const Tree* tree;
  int nq, beside;  ///< torques and forces in the state
  std::vector<int> diagonal_rows;
  std::vector<TangentBlock> tangent;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// Entries of one part of the state or of the control.
struct Selection {
  enum class Source { Q, V, TorqueState, U } source;
  std::vector<int> entries;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// per_second (u - tau) of actuators: with a torque model.
struct TorqueRate {
  double per_second;  ///< the cut-off, rad/s, or one over the stage's step of held torques
  bool by_step;       ///< held torques: what counts is one over the knot's step
  std::vector<int> entries;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// A reference that may turn from knot to knot, or follow another surface on each.
struct TurningReference : CompiledReference {
  int turning = -1;  ///< first entry of its rotation in the targets; -1: it has its own
  int followed = 0;  ///< first entry of its surface there, if it is curved
  template <class S>
  ReferencePose<S> pose(const KnotState<S>& knot) const {
    const Kinematics<S>& kinematics = knot.dynamics->kinematics();
    if (is_curved) return reference_pose(*this, surface_of(knot.targets + followed), kinematics);
    if (turning < 0) return reference_pose(*this, kinematics);
    return reference_pose(*this, rotation_of(knot.targets + turning), kinematics);
  }
};

/// A reference that a frame is seen in, and the entries of v that move it or the frame.
struct FrameView {
  TurningReference reference;
  std::vector<MovingAxis> origin, axes;  ///< of other bodies than the frame's
  std::vector<int> entries;              ///< of v, ascending
  template <class S>
  FrameReference<S> at(const KnotState<S>& knot, int frame) const;
};

/// `frame` counts in KnotState::frames.
struct FramePositionError {
  int frame;
  FrameView view;
  bool is_in_world = false;  ///< targets are in the world's own coordinates
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Length of the entries of `position` along the directions.
struct FrameDistance {
  FramePositionError position;
  Directions directions;
  static constexpr double bend_sign = 1.0;
  /// Across two directions there is one more, across three there are two, written as three.
  int bend_rows() const;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J, S* bends = nullptr) const;
};
/// Targets are nine entries of a rotation by columns; with placement three of a position before.
struct FrameRotationError {
  int frame;
  FrameView view;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
struct FrameInclinationError {
  int frame;
  FrameView view;
  Vec3<double> axis;  ///< of unit length, in the frame
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
struct FrameHeightError {
  int frame;
  FrameView view;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
struct FramePlacementError {
  int frame;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
struct FrameVelocityError {
  int frame;
  FrameView view;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// Rows of lambda.
struct OwnForceError {
  int contact, rows;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// (lambda - what the state remembers of it) / step of the knot.
struct ForceRate {
  int contact, rows;
  int first;          ///< entry among what is remembered
  double per_second;  ///< one over the stage's step, for scales
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// A reference that a contact's wrench is asked in; none: the contact's own.
struct WrenchView {
  int contact;
  std::optional<TurningReference> reference;
  std::vector<WrenchEntry> entries;
  /// Six rows w and, unless J is null, dw/dz (6 x nz).
  template <class S>
  void evaluate(const KnotState<S>& knot, S* w, S* J) const;
};
/// The six rows of a contact's wrench in any reference.
struct WrenchError {
  WrenchView wrench;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Its target is the coefficient of friction; a pyramid's likewise.
struct ConeMargin {
  WrenchView wrench;
  int normal;
  static constexpr double bend_sign = -1.0;
  static int bend_rows() { return 1; }
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J, S* bends = nullptr) const;
};
/// The sides of a pyramid in place of the cone.
struct PyramidMargin {
  /// friction inner f_n - (c f_1 + s f_2) is the margin, N; (c, s) is of unit length and points
  /// outwards.
  struct Side {
    double c, s;
  };
  WrenchView wrench;
  int normal;
  double inner;  ///< of the cone's radius, that the sides are from its middle
  std::vector<Side> sides;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Its target is the coefficient of friction, where that has its eight rows.
struct PressureMargin {
  WrenchView wrench;
  double half_x, half_y;
  bool has_friction;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

struct ComError {
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
struct SupportMargin {
  /// x c_x + y c_y - offset is the margin, m; (x, y) is of unit length and points inwards.
  struct Edge {
    double x, y, offset;
    double half_width;  ///< of the polygon, across the edge, m
  };
  std::vector<Edge> edges;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
struct MomentumError {
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// Evaluated by CustomLanes, one lane at a time.
struct CustomResidual {
  residual::Custom user;
  std::vector<int> frames, contacts;
};

inline int FrameDistance::bend_rows() const {
  const int measured = directions.has(0) + directions.has(1) + directions.has(2);
  return measured == 3 ? 3 : measured - 1;
}

using CompiledResidual =
    std::variant<StateDifference, Selection, TorqueRate, FramePositionError, FrameDistance,
                 FrameRotationError, FrameInclinationError, FrameHeightError, FramePlacementError,
                 FrameVelocityError, OwnForceError, ForceRate, WrenchError, ConeMargin,
                 PyramidMargin, PressureMargin, ComError, SupportMargin, MomentumError,
                 CustomResidual>;

}  // namespace burnish::ocp
