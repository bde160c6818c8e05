// Where the frames of a robot are.
#pragma once

#include <string_view>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Placements in the world of all frames of the model, in their order, at the configuration q (nq
/// entries). Throws Error for a bad q.
std::vector<Eigen::Isometry3d> frame_placements(const Model& model,
                                                const Eigen::Ref<const Eigen::VectorXd>& q);

/// Of one frame by name; "world" is always known. Throws Error with the nearest known name.
Eigen::Isometry3d frame_placement(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q,
                                  std::string_view frame);

}  // namespace burnish
