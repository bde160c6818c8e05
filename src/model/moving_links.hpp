// The links of a description that move against the world: their places, sizes and masses.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// A link that moves.
struct MovingLink {
  const LinkSpec* link = nullptr;
  const JointSpec* joint = nullptr;  ///< above it; nullptr of a floating root
  double path = 0.0;                 ///< sum of offsets from the first joint that moves it [m]
  double extent = 0.0;               ///< of its shapes from its origin, meshes left out [m]
  double volume = 0.0;               ///< of its shapes, meshes left out [m^3]
  double mass_beyond = 0.0;          ///< of the link and all links beyond [kg]
};

/// What moves of a robot.
struct MovingLinks {
  std::vector<MovingLink> links;  ///< parents before children
  int joints_in_a_part = 0;       ///< most joints that move what hangs on one joint of the world
  double mass = 0.0;              ///< kg
  double skeleton = 0.0;          ///< reach of joints and shapes from the first joint [m]
  double reach = 0.0;             ///< the same with centres of mass that are not far off [m]

  /// Whether the centre of mass is several times the skeleton away.
  bool is_far_off(const MovingLink& link) const;
};

/// Of a tree that passed check_topology and check_values.
MovingLinks moving_links(const TreeSpec& tree, const ModelOptions& options);

}  // namespace burnish
