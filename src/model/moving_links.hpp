// Links of a description that move relative to the world: their places, sizes and masses.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Link that moves.
struct MovingLink {
  const LinkSpec* link = nullptr;
  const JointSpec* joint = nullptr;  ///< Joint above the link, nullptr for a floating root
  double path = 0.0;         ///< Sum of joint offsets from the first joint that moves the link [m]
  double extent = 0.0;       ///< Largest distance of its shapes from its origin, without meshes [m]
  double volume = 0.0;       ///< Volume of its shapes, without meshes [m^3]
  double mass_beyond = 0.0;  ///< Mass of the link and of all links beyond it [kg]
};

/// Moving links of a robot.
struct MovingLinks {
  std::vector<MovingLink> links;  ///< Parents before children
  int joints_in_a_subtree = 0;    ///< Largest number of moving joints in a subtree of the world
  double mass = 0.0;              ///< Sum of the masses [kg]
  double skeleton = 0.0;          ///< Reach of joints and shapes from the first joint [m]
  double reach = 0.0;  ///< `skeleton`, extended to centres of mass that are not far off [m]

  /// Returns true if the link's centre of mass is farther than 5 times `skeleton` from its origin.
  bool is_far_off(const MovingLink& link) const;
};

/// Collects the moving links. The tree must have passed check_topology() and check_values().
MovingLinks moving_links(const TreeSpec& tree, const ModelOptions& options);

}  // namespace burnish
