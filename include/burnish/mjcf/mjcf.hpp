// Reader of MJCF files, the description format of MuJoCo.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/base/error.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Reads an MJCF file, the files that it includes, and the meshes from which masses are computed.
/// Relative file names start at the folder of the MJCF file. Throws Error if the file or an
/// included file is missing or malformed, or if the file does not describe a tree. The Error lists
/// all problems, each with the line and the element.
///
/// The order of joints and the joint positions, including `ref`, are as in MuJoCo's qpos.
/// Exception: the quaternions of free and ball joints are x, y, z, w here, and w, x, y, z in
/// MuJoCo. JointOrder::mujoco() converts whole vectors.
///
/// The root link is "world". A body with several joints becomes a chain of joints, with massless
/// links between them. If a joint is not at the origin of its body, a fixed joint is added behind
/// it. With this fixed joint, the link has the same placement as the body in MuJoCo.
///
/// Content that a TreeSpec cannot represent is reported in `warnings`: one sentence per kind of
/// content, with the number of elements and an example. Content that does not affect dynamics is
/// reported in `notes` instead. docs/robots.md lists the content of both kinds.
///
/// Keyframes of the file become named postures. The initial configuration of the file is added as
/// posture "qpos0" if it differs from zero.
TreeSpec read_mjcf(const std::filesystem::path& file);

/// Reads MJCF from the text `xml`. No other file is opened: an <include> is an Error, and meshes
/// count as missing. Error messages refer to the text by the name `source`. A model without a name
/// gets the stem of `source` as its name.
TreeSpec parse_mjcf(const std::string& xml, const std::string& source = "<string>");

}  // namespace burnish
