// The walk of a tool to a surface and along it, as check_reach() of a task makes it.
#pragma once

#include <memory>

#include "burnish/sim/scene.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {

/// Where the tool shall be, and whether it presses.
struct ReachStop {
  Eigen::Vector3d p_world;
  double s;                ///< m, see ReachReport
  double force;            ///< N
  std::string where = {};  ///< for refusals; empty: as `s` says
};

/// A posture that is carried from stop to stop. Model, scene and start outlive it. At every stop: a
/// posture by damped least squares from the one before, the tool's position first, then its
/// orientation at the start and the starting posture; joint limits; the torques that hold the robot
/// still there with the force and without, tau = b(q, 0) - J^T f n, against the effort limits; and
/// the arm outside the surface and the material behind it, which is as wide as the surface and as
/// deep as can be. For that the arm is a skeleton of straight segments, `link_radius` thick,
/// between the origins of the joints that carry the tool. Joints fixed to the world and the tool
/// link, which is to come near, do not count, nor does a last joint whose origin the tip is at.
class ReachWalk {
 public:
  /// `has_path`: what is along the path is said to be there.
  ReachWalk(const Model& model, const SceneSpec& scene, const Eigen::VectorXd& q_start,
            const ReachOptions& options, bool has_path = true);
  ~ReachWalk();
  /// False at the first problem, which is in the report.
  bool visit(const ReachStop& stop);
  /// From one point straight to another, both included; s_end: m, at the second.
  bool visit_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double s_end);
  /// Looks at a posture of its own, with the tool in the air. The tool's centre stays `tip.radius`
  /// outside the surface. `where`: for refusals, such as "at home".
  bool pass(const Eigen::VectorXd& q, const std::string& where);
  const Eigen::VectorXd& posture() const;  ///< nq, at the last stop
  ReachReport& report();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
  double spacing_;
};

}  // namespace burnish::pressing
