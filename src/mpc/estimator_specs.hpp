// Specifications of estimators, derived from that of the controller.
#pragma once

#include <vector>

#include "burnish/mpc/mpc_spec.hpp"
#include "estimate/error_estimate.hpp"
#include "estimate/support_grip.hpp"

namespace burnish {

LoopTimes loop_times(const MpcSpec& spec);
StageContacts stage_contacts(const MpcSpec& spec);
/// `spec.normal_base` must be a unit vector. It is the initial normal in world axes, too; a surface
/// on a frame of the robot needs ErrorEstimate::set_normal().
ErrorEstimateSpec error_estimate_spec(const MpcSpec& spec);
/// Returns the supports that are in contact in every stage, in the order of supports_of().
std::vector<GripSpec> grip_specs(const MpcSpec& spec);

}  // namespace burnish
