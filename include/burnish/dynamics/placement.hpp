// Placements of a robot's frames in the world.
#pragma once

#include <string_view>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Returns the placements of all frames in the world at the configuration q (nq entries), in the
/// order of Model::frames. Throws Error for an invalid q.
std::vector<Eigen::Isometry3d> frame_placements(const Model& model,
                                                const Eigen::Ref<const Eigen::VectorXd>& q);

/// Returns the placement of one frame in the world at the configuration q (nq entries). The frame
/// "world" always exists. Throws Error with the nearest known name if there is no such frame.
Eigen::Isometry3d frame_placement(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                  std::string_view frame);

}  // namespace burnish
