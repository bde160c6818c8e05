// Reading MJCF, the description format of MuJoCo.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/base/error.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Reads an MJCF file with what it includes, and the meshes that masses are computed from; both are
/// looked for beside the file. Throws Error when it is missing, malformed or describes no tree: it
/// lists all problems, each with its line and its element.
///
/// Joints are in the order of the file, which is that of MuJoCo's qpos. Positions are MuJoCo's: q
/// of a joint is its qpos, `ref` included; of a free joint and a ball the quaternion is x, y, z, w
/// here. JointOrder::mujoco() maps whole vectors. The root link is "world". A body with several
/// joints is a chain of massless links; where a joint lies off its body's origin, a fixed joint
/// leads back to it, so that the body's link is where MuJoCo has the body. What a TreeSpec has no
/// place for is in `warnings`: one sentence for each kind, with their number and an example; where
/// that changes no dynamics, in `notes`. docs/robots.md has the table.
///
/// Postures are the keyframes, and "qpos0", how the file draws the robot, where that is not at
/// zero.
TreeSpec read_mjcf(const std::filesystem::path& file);

/// The same from a string, which opens no file: <include> is refused, and meshes count as absent.
/// `source` stands for the file's name in error sentences, and its stem for the name of a model
/// that has none.
TreeSpec parse_mjcf(const std::string& xml, const std::string& source = "<string>");

}  // namespace burnish
