// Elements of a URDF file, each by itself.
#pragma once

#include <tinyxml2.h>

#include <map>
#include <string>

#include "base/findings.hpp"
#include "burnish/model/tree_spec.hpp"
#include "urdf/collisions.hpp"
#include "urdf/xml_element.hpp"

namespace burnish {

/// Colours by material name.
using Colours = std::map<std::string, Eigen::Vector4d>;

/// Those of the robot before those that a visual defines for others; the first of a name counts.
Colours read_colours(const tinyxml2::XMLElement& robot);

/// A link. What is wrong with its inertia is noted; a visual that cannot be drawn is left out, with
/// a warning unless it is empty. Throws Error where the link has no name.
LinkSpec read_link(const tinyxml2::XMLElement& element, const Colours& colours, Findings& findings);

/// Adds the solids of its <collision> elements to `solids`. Those that cannot be read are left out.
void read_collisions(const tinyxml2::XMLElement& element, std::vector<LinkSolid>& solids);

/// A joint. What is wrong with its figures is noted; of a fixed joint what it has none of is not
/// looked at. Throws Error where its name, its type or one of its links is missing.
JointSpec read_joint(const tinyxml2::XMLElement& element, Findings& findings);

/// What <origin> in `parent` says; the identity where there is none.
Eigen::Isometry3d read_origin(const tinyxml2::XMLElement& parent, const XmlPlace& place,
                              Findings& findings);

/// Warns of what xacro has left in an element.
void warn_of_macros(const tinyxml2::XMLElement& element, const XmlPlace& place, Findings& findings);

}  // namespace burnish
