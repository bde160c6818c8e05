// Check that every joint of a compiled tree moves some mass.
#pragma once

#include <string>

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Warns of joints that make the mass matrix singular or indefinite at all postures. Such a joint
/// moves a negative inertia, or moves no inertia (at most 1e-12 kg m^2 or kg) and has no armature,
/// while all joints beyond it move freely. Reports inertias that overflow as a problem.
void check_inertia_along_joints(const Model& model, Findings& findings);

/// Returns the reason why the robot cannot be simulated: all moving links lack mass, or the
/// warnings of check_inertia_along_joints(). Returns an empty text if the robot can be simulated.
std::string simulation_problem(const Model& model);

/// Throws Error("robot '<name>': <simulation_problem>") unless simulation_problem() is empty.
void require_simulable(const Model& model);

}  // namespace burnish
