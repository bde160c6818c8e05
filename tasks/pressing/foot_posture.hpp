// Postures of a robot whose feet stay where they are, while its trunk is somewhere else.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// A frame of the body that the floating base carries, a link of the description where there is
/// one. Throws Error for a fixed base.
std::string base_frame(const Model& model);

/// Where feet and trunk are to be.
struct FootPosture {
  std::vector<Eigen::Isometry3d> feet = {};  ///< world, in the order of Standing::feet
  Eigen::Matrix3d R_base;                    ///< of base_frame(), world
  Eigen::Vector3d com;                       ///< centre of mass, m, world
  std::optional<double> base_height = {};    ///< m, of base_frame(), in the place of com.z()
  /// Part of their way that joints outside the legs go; 1: as far as those of the legs.
  double others = 1.0;
};

/// nq: by damped least squares from q on, joints within their ranges; nothing where feet or trunk
/// stay off their places by more than `tolerance`, m and rad. `last`: set to where it ended, unless
/// null.
std::optional<Eigen::VectorXd> posture_on_feet(const Model& model, const Standing& standing,
                                               const FootPosture& wanted, const Eigen::VectorXd& q,
                                               double tolerance = 1e-4,
                                               Eigen::VectorXd* last = nullptr);

/// nq: a posture to stand in. The search begins at `from`, where joints outside the legs stay if
/// the legs alone suffice. The base is upright as in the neutral configuration, the feet are where
/// they are there seen from above, with soles turned by the smallest angle until they are level,
/// the centre of mass is above their middle, and the base lower than there by `crouch` of its
/// height above the feet, or by less where that leaves a joint of the legs no room to its limits.
/// Legs may bend to either side: of the postures that are found it is the one that takes the least
/// torque. Joints outside the legs move where the legs alone do not get there. Throws Error where
/// none is found.
Eigen::VectorXd crouched_posture(const Model& model, const Standing& standing,
                                 const Eigen::VectorXd& from, double crouch);

/// How much lower the base is at q (nq) than in the neutral configuration, as a fraction of its
/// height above the lowest foot there.
double crouch_at(const Model& model, const Standing& standing, const Eigen::VectorXd& q);

}  // namespace burnish::pressing
