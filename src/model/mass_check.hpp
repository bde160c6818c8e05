// Whether every joint of a compiled tree moves some mass.
#pragma once

#include <string>

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Warns of joints that make the mass matrix singular or indefinite at every posture: that, all
/// joints beyond them being free to give way, meet no inertia (<= 1e-12 kg m^2 or kg) and have no
/// armature, or meet a negative one. Figures whose inertias overflow are a problem.
void check_inertia_along_joints(const Model& model, Findings& findings);

/// Why nothing can simulate or control the robot: joints that check_inertia_along_joints warns of,
/// by name, or a robot of which nothing that moves has a mass. Empty: it can be.
std::string simulation_problem(const Model& model);

/// Throws Error("robot '<name>': <simulation_problem>") where there is one.
void require_simulable(const Model& model);

}  // namespace burnish
