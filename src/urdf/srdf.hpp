// Reads postures from SRDF files. An SRDF file accompanies a URDF file and is used by motion
// planners.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Reads the <group_state> elements of an SRDF file as postures, by name. States of several groups
/// with equal names form one posture. Unknown joints, values that do not fit their joint, and
/// contradictory values are left out with a warning. Throws Error if the file is not an SRDF file.
std::map<std::string, Posture> read_srdf(const std::filesystem::path& file, const TreeSpec& tree,
                                         Findings& findings);

/// Reads postures from SRDF text; see read_srdf().
std::map<std::string, Posture> parse_srdf(const std::string& xml, const TreeSpec& tree,
                                          Findings& findings);

/// Returns the SRDF file of a URDF file. For robot/urdf/arm.urdf, this is robot/urdf/arm.srdf or
/// robot/srdf/arm.srdf. Returns an empty path if neither exists.
std::filesystem::path srdf_of(const std::filesystem::path& urdf);

}  // namespace burnish
