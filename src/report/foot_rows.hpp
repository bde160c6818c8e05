// Feet and whole-body quantities in the rows of a trace.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// q and v in the rows of a trace of ClosedLoop.
class StateRows {
 public:
  /// Throws Error for a missing column.
  StateRows(const Trace& trace, const Model& model);
  /// Puts the body into the state of a row. Whatever RigidBody::update() says of it.
  [[nodiscard]] Status look(int row);
  const RigidBody& body() const { return body_; }

 private:
  const Trace* trace_;
  std::vector<int> q_columns_, v_columns_;
  Eigen::VectorXd q_, v_;
  RigidBody body_;
};

/// N, below which a share of friction and a centre of pressure say nothing.
constexpr double least_bearing = 20.0;

/// What a foot bears, of the wrench that a trace has.
struct FootLoad {
  double normal = 0.0;      ///< N, along the normal of its ground
  double tangential = 0.0;  ///< N, across it
  /// m, where the force acts in the plane of the sole, frame's x and y; zero of a ball and without
  /// a force
  Eigen::Vector2d pressure = Eigen::Vector2d::Zero();
};

/// A support in the rows of a trace.
class FootRows {
 public:
  /// Throws Error for a missing column, an unknown frame and a normal without direction.
  FootRows(const Trace& trace, const RigidBody& body, const SupportSpec& support);
  const SupportSpec& support() const { return support_; }
  const Eigen::Vector3d& normal() const { return support_.normal; }  ///< of length one
  /// The wrench is in the frame's axes, the normal in the world's.
  FootLoad load(int row, const Eigen::Isometry3d& foot) const;
  Eigen::Isometry3d placement(const RigidBody& body) const { return body.placement(frame_); }
  /// The corners of a sole or a ball's centre, world, m.
  std::vector<Eigen::Vector3d> points(const Eigen::Isometry3d& foot) const;
  /// Share of the friction cone, |f_t| / (mu f_n), of a foot that bears something.
  double friction_used(const FootLoad& load) const;
  /// m from the edge of the sole, negative outside.
  double margin(const FootLoad& load) const;

 private:
  const Trace* trace_;
  SupportSpec support_;
  int frame_;
  std::array<int, 6> columns_;
};

}  // namespace burnish
