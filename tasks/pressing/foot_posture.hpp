// Inverse kinematics of a standing robot: the feet stay in place and the trunk moves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Returns the name of a frame on the body of the floating base, preferably a link's frame. Throws
/// Error for a fixed base.
std::string base_frame(const Model& model);

/// Targets for the feet and the trunk.
struct FootPosture {
  std::vector<Eigen::Isometry3d> feet = {};  ///< Placements in the world, as in Standing::feet.
  Eigen::Matrix3d R_base;                    ///< Rotation of base_frame() in the world.
  Eigen::Vector3d com;                       ///< Centre of mass in the world [m].
  /// Target height of base_frame(), used in place of com.z() [m].
  std::optional<double> base_height = {};
  /// Factor on the steps of joints outside the legs; 0: still, 1: as for joints of the legs.
  double others = 1.0;
};

/// Returns a posture (nq) by damped least squares from `q`, with all joints within their limits.
/// Returns nothing if feet or trunk miss their targets by more than `tolerance` [m, rad]. If `last`
/// is not null, it receives the last iterate.
std::optional<Eigen::VectorXd> posture_on_feet(const Model& model, const Standing& standing,
                                               const FootPosture& wanted, const Eigen::VectorXd& q,
                                               double tolerance = 1e-4,
                                               Eigen::VectorXd* last = nullptr);

/// Returns a standing posture (nq), searched from `from`, with these properties:
/// - The base has the orientation of the neutral configuration.
/// - The feet have the horizontal positions of the neutral configuration; soles are turned by the
///   smallest angle that makes them level.
/// - The centre of mass is above the midpoint of the feet.
/// - The base is lower than in the neutral configuration. `crouch` is the difference, as a fraction
///   of the base's height over the feet. A smaller fraction is used if a leg joint would come close
///   to its limits.
/// Joints outside the legs move only if no posture is found with the legs alone. Knees may bend to
/// either side: of all postures found, the one with the smallest torques is returned. Throws Error
/// if none is found.
Eigen::VectorXd crouched_posture(const Model& model, const Standing& standing,
                                 const Eigen::VectorXd& from, double crouch);

/// Returns the crouch at `q` (nq): the difference in base height from the neutral configuration, as
/// a fraction of the base's neutral height above the lowest foot.
double crouch_at(const Model& model, const Standing& standing, const Eigen::VectorXd& q);

}  // namespace burnish::pressing
