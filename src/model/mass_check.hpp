// Whether every joint of a compiled tree moves some mass.
#pragma once

#include <string>

#include "burnish/model/model.hpp"

namespace burnish {

/// Throws Error naming the joint if the mass matrix is singular at every posture: if a joint, all
/// joints beyond it being free to give way, meets no inertia (<= 1e-12 kg m^2 or kg) and has no
/// armature.
void check_inertia_along_joints(const Model& model, const std::string& origin);

}  // namespace burnish
