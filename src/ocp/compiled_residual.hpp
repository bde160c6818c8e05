// Residuals as the kernels read them. Each has
//   evaluate(scene, target, r, J): r (rows) and, unless J is null, its derivative by z, block by
//   block in the order of the term's blocks.
#pragma once

#include <variant>
#include <vector>

#include "burnish/ocp/residual.hpp"
#include "dynamics/integration.hpp"
#include "ocp/scene.hpp"

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
  int nq, filtered;
  std::vector<int> diagonal_rows;
  std::vector<TangentBlock> tangent;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};

/// Entries of one part of the state or of the control.
struct Selection {
  enum class Source { Q, V, TorqueState, U } source;
  std::vector<int> entries;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};

/// `frame` counts in Scene::frames.
struct FramePositionError {
  int frame;
  Mat3<double> axes;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};
/// Targets are nine entries of a rotation by columns; with placement three of a position before.
struct FrameRotationError {
  int frame;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};
struct FramePlacementError {
  int frame;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};
struct FrameVelocityError {
  int frame;
  FrameAxes axes;
  Mat3<double> rotation;
  bool turned;  ///< rotation is not the identity
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};

/// Rows of lambda.
struct OwnForceError {
  int contact, rows;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};
/// The six rows of a contact's wrench in any reference.
struct WrenchError {
  int contact;
  Reference reference;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};
struct ConeMargin {
  int contact;
  Reference reference;
  double friction;
  int normal;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};
struct PressureMargin {
  int contact;
  double half_x, half_y;
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};

struct ComError {
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};
struct MomentumError {
  template <class S>
  void evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const;
};

/// Evaluated by CustomLanes, one lane at a time.
struct CustomResidual {
  residual::Custom user;
  std::vector<int> frames, contacts;
};

using CompiledResidual =
    std::variant<StateDifference, Selection, FramePositionError, FrameRotationError,
                 FramePlacementError, FrameVelocityError, OwnForceError, WrenchError, ConeMargin,
                 PressureMargin, ComError, MomentumError, CustomResidual>;

}  // namespace burnish::ocp
