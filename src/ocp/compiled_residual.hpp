// Compiled residuals, as the kernels read them. Each residual has
//   evaluate(knot, target, r, J): writes the rows r and, unless J is null, the derivative by z,
//   block by block in the order of the term's blocks.
// FrameDistance and ConeMargin also offer the curvature of their first row (RowCurvature):
//   curvature_rows(), curvature_sign and evaluate(knot, target, r, J, curvatures). Unless null,
//   `curvatures` receives vectors b with as many columns as J. The second derivative of the row is
//   approximately the sum of curvature_sign b^T b.
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

/// Block of a Jacobian: rows `row` to row + rows - 1, and the columns of z on which they depend, in
/// ascending order. A diagonal block has one number per row: row i depends only on columns[i].
/// Other blocks are rows x columns, row-major.
struct JacobianBlock {
  int row, rows;
  std::vector<int> columns;
  bool diagonal;
  int size() const { return diagonal ? rows : rows * static_cast<int>(columns.size()); }
};

/// Difference x (-) target. The diagonal blocks come first, then a dense block for each joint with
/// several entries.
struct StateDifference {
  const Tree* tree;
  int nq;
  int beside;  ///< Number of torque and force entries in the state
  std::vector<int> diagonal_rows;
  std::vector<TangentBlock> tangent;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// Selected entries of q, of v, of the torque state or of the control.
struct Selection {
  enum class Source { Q, V, TorqueState, U } source;
  std::vector<int> entries;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// Torque rate `per_second` (u - tau) of actuators. Requires a torque model.
struct TorqueRate {
  double per_second;  ///< Filter cut-off [rad/s], or 1 / stage step for held torques [1/s]
  bool by_step;       ///< True if evaluate() divides by the step of the knot (held torques)
  std::vector<int> entries;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// A reference whose rotation or surface may differ from knot to knot.
struct TurningReference : CompiledReference {
  int turning = -1;  ///< First target entry of the rotation; -1: constant rotation
  int followed = 0;  ///< First target entry of the surface, if the reference is curved
  template <class S>
  ReferencePose<S> pose(const KnotState<S>& knot) const {
    const Kinematics<S>& kinematics = knot.dynamics->kinematics();
    if (is_curved) return reference_pose(*this, surface_of(knot.targets + followed), kinematics);
    if (turning < 0) return reference_pose(*this, kinematics);
    return reference_pose(*this, rotation_of(knot.targets + turning), kinematics);
  }
};

/// Reference in which a frame is expressed, and the entries of v that move the reference or the
/// frame.
struct FrameView {
  TurningReference reference;
  /// Joint axes that move the reference's origin (`origin`) or turn its axes (`axes`). A list is
  /// empty if the origin or the axes are on the frame's own body.
  std::vector<MovingAxis> origin, axes;
  std::vector<int> entries;  ///< Entries of v, ascending
  template <class S>
  FrameReference<S> at(const KnotState<S>& knot, int frame) const;
};

/// Position of a frame minus its target. In all residuals, `frame` is an index of
/// KnotState::frames.
struct FramePositionError {
  int frame;
  FrameView view;
  bool is_in_world = false;  ///< Whether targets are in world coordinates
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Length of the position error along the given directions.
struct FrameDistance {
  FramePositionError position;
  Directions directions;
  static constexpr double curvature_sign = 1.0;
  /// Returns the number of curvature vectors b (RowCurvature): 0, 1 or 3 for one, two or three
  /// directions. The three vectors have rank two.
  int curvature_rows() const;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J,
                S* curvatures = nullptr) const;
};
/// Rotation of a frame relative to its target. The target is a rotation matrix, stored by columns.
struct FrameRotationError {
  int frame;
  FrameView view;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Angles by which `axis` is inclined to the reference's z axis.
struct FrameInclinationError {
  int frame;
  FrameView view;
  Vec3<double> axis;  ///< Unit vector in the frame's axes
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Height of a frame above the surface that the reference follows.
struct FrameHeightError {
  int frame;
  FrameView view;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Placement of a frame relative to its target. The target has three entries of a position, then
/// nine of a rotation by columns.
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

/// Force of a contact in the contact's own reference, minus its target. The force is the contact's
/// rows of lambda.
struct OwnForceError {
  int contact, rows;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Force rate (lambda - force state) / knot step.
struct ForceRate {
  int contact, rows;
  int first;          ///< Index of the contact's first entry among the force states
  double per_second;  ///< 1 / stage step, for the scale of constraint rows [1/s]
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Wrench of a contact in `reference`, or in the contact's own reference if there is none.
struct WrenchView {
  int contact;
  std::optional<TurningReference> reference;
  std::vector<WrenchEntry> entries;
  /// Writes the wrench w (6) and, unless J is null, dw/dz (6 x nz).
  template <class S>
  void evaluate(const KnotState<S>& knot, S* w, S* J) const;
};
/// Wrench of a contact in any reference, minus its target.
struct WrenchError {
  WrenchView wrench;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Margin of the friction cone, and the normal force. The target is the coefficient of friction.
struct ConeMargin {
  WrenchView wrench;
  int normal;
  static constexpr double curvature_sign = -1.0;
  static int curvature_rows() { return 1; }
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J,
                S* curvatures = nullptr) const;
};
/// Margins of the sides of a pyramid inside the friction cone. The target is the coefficient of
/// friction.
struct PyramidMargin {
  /// Side of the pyramid. The unit vector (c, s) points outwards. With the normal force f_n and the
  /// tangential forces f_1 and f_2, the margin is friction inner f_n - (c f_1 + s f_2) [N].
  struct Side {
    double c, s;
  };
  WrenchView wrench;
  int normal;
  double inner;  ///< Distance of the sides from the axis, as a fraction of the cone's radius
  std::vector<Side> sides;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Margins of the centre of pressure and, if has_friction, of the moment about the normal. The
/// target is then the coefficient of friction, and there are 12 rows instead of 4.
struct PressureMargin {
  WrenchView wrench;
  double half_x, half_y;
  bool has_friction;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// Centre of mass minus its target.
struct ComError {
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Distances of the centre of mass c from the edges of a support polygon, in the horizontal plane.
struct SupportMargin {
  /// Edge of the polygon. The unit vector (x, y) points inwards. The margin of the centre of mass c
  /// is x c_x + y c_y - offset [m].
  struct Edge {
    double x, y, offset;
    double half_width;  ///< Half the width of the polygon perpendicular to the edge [m]
  };
  std::vector<Edge> edges;
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};
/// Centroidal momentum minus its target.
struct MomentumError {
  template <class S>
  void evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const;
};

/// A user's own residual, which CustomLanes evaluates one lane at a time.
struct CustomResidual {
  residual::Custom user;
  std::vector<int> frames, contacts;
};

inline int FrameDistance::curvature_rows() const {
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
