// Motion of a robot model to a surface and along it, for check_reach() of a task.
#pragma once

#include <memory>

#include "burnish/sim/scene.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {

/// Target position of the tool, with the force at this position.
struct ReachStop {
  Eigen::Vector3d p_world;
  double s;                ///< Path length at this position, see ReachReport [m].
  double force;            ///< Force along the normal [N].
  std::string where = {};  ///< Name of this position in the report; empty: derived from `s`.
};

/// Posture that is moved from stop to stop along a path, and checked at every stop. Model, scene
/// and start must outlive this object. Damped least squares moves the tool to its position. In the
/// null space, the tool's orientation and the posture return to the start. Checks at every stop:
/// - Joint limits.
/// - Torques: the torques that hold the robot still, tau = b(q, 0) - J^T f n, are within the effort
///   limits, with and without the force.
/// - Collisions: the arm is outside the surface and the material behind it. The material is as wide
///   as the surface and infinitely deep. The arm consists of straight segments, `link_radius`
///   thick, between the origins of the joints that carry the tool. Joints on the world, the tool
///   link, and a last joint with its origin at the tip are not checked.
class ReachWalk {
 public:
  /// `has_path`: true if the report should name positions along the path.
  ReachWalk(const Model& model, const SceneSpec& scene, const Eigen::VectorXd& q_start,
            const ReachOptions& options, bool has_path = true);
  ~ReachWalk();
  /// States the force on a support, in world axes [N]. Throws Error for an unknown support.
  /// Forces on supports without a stated force are chosen such that joint torques are smallest.
  void load(const std::string& support, const Eigen::Vector3d& force_world);
  /// Moves to a stop and checks it. Returns false at the first problem, which report() describes.
  bool visit(const ReachStop& stop);
  /// Visits points on a straight line, including both ends. `s_end`: path length at `to` [m].
  bool visit_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double s_end);
  /// Checks the posture `q` with the tool in the air: the centre of the tool must be at least
  /// `tip.radius` outside the surface. `where`: name of the posture in the report, such as "at
  /// home".
  bool pass(const Eigen::VectorXd& q, const std::string& where);
  const Eigen::VectorXd& posture() const;  ///< Posture at the last stop (nq).
  ReachReport& report();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
  double spacing_;
};

}  // namespace burnish::pressing
