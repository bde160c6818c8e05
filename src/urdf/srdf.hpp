// Postures of an SRDF file, the companion of a URDF file that planners of motions use.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// The <group_state>s of an SRDF file as postures by their names; states of the same name, which
/// belong to several groups, are one posture. Joints that the tree has not, values that do not suit
/// their joint and contradictions are left out with a warning. Throws Error where the file is no
/// SRDF.
std::map<std::string, Posture> read_srdf(const std::filesystem::path& file, const TreeSpec& tree,
                                         Findings& findings);

/// The same from a text.
std::map<std::string, Posture> parse_srdf(const std::string& xml, const TreeSpec& tree,
                                          Findings& findings);

/// The SRDF file that belongs to a URDF file by its name: arm.srdf beside arm.urdf or in the folder
/// srdf beside the URDF's; empty where there is none.
std::filesystem::path srdf_of(const std::filesystem::path& urdf);

}  // namespace burnish
