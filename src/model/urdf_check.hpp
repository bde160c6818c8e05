// The pass before urdfdom: names what urdfdom drops silently or refuses without saying where.
#pragma once

#include <string>

#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// A checked description.
struct UrdfOutline {
  /// Names, topology, joint types, limits and armatures; everything else is left at its default.
  TreeSpec tree;
  /// The description reduced to what urdfdom shall read, with every number in plain notation.
  std::string xml;
};

/// Throws Error with a sentence naming the source, the element and the reason.
UrdfOutline check_urdf(const std::string& xml, const std::string& source);

}  // namespace burnish
