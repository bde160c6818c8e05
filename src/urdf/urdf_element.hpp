// Readers for single elements of a URDF file.
#pragma once

#include <tinyxml2.h>

#include <map>
#include <string>

#include "base/findings.hpp"
#include "burnish/model/tree_spec.hpp"
#include "urdf/collisions.hpp"
#include "urdf/xml_element.hpp"

namespace burnish {

/// Colours (red, green, blue, alpha) by material name.
using Colours = std::map<std::string, Eigen::Vector4d>;

/// Reads the colours of all materials. If a name occurs several times, the first colour is used;
/// materials of the robot come before materials of visuals.
Colours read_colours(const tinyxml2::XMLElement& robot);

/// Reads a link. Errors in its inertia are added to `findings`. A visual that cannot be drawn is
/// left out, with a warning unless it is empty. Throws Error if the link does not have a name.
LinkSpec read_link(const tinyxml2::XMLElement& element, const Colours& colours, Findings& findings);

/// Adds the solids of the <collision> elements of a link to `solids`. Solids that cannot be read
/// are left out.
void read_collisions(const tinyxml2::XMLElement& element, std::vector<LinkSolid>& solids);

/// Reads a joint. Errors in its type and its numbers are added to `findings`. Axis, limits,
/// dynamics and mimic of fixed joints are ignored. Throws Error if its name or one of its links is
/// missing.
JointSpec read_joint(const tinyxml2::XMLElement& element, Findings& findings);

/// Reads the placement of the <origin> element in `parent`, or the identity if there is none.
Eigen::Isometry3d read_origin(const tinyxml2::XMLElement& parent, const XmlPlace& place,
                              Findings& findings);

/// Warns of macros in an element that xacro did not expand.
void warn_of_macros(const tinyxml2::XMLElement& element, const XmlPlace& place, Findings& findings);

}  // namespace burnish
