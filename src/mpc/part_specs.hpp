// Specifications of a controller's parts and estimators, derived from the controller's
// specification.
#pragma once

#include <vector>

#include "burnish/mpc/mpc_spec.hpp"
#include "estimate/error_estimate.hpp"
#include "estimate/support_grip.hpp"
#include "mpc/holding.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/policy.hpp"

namespace burnish {

LoopTimes loop_times(const MpcSpec& spec);
StageContacts stage_contacts(const MpcSpec& spec);
/// ToolSpec::normal_base must be a unit vector. It becomes the initial normal in world axes. For a
/// surface on a frame of the robot, call ErrorEstimate::set_normal() afterwards.
ErrorEstimateSpec error_estimate_spec(const MpcSpec& spec);
/// Returns the supports that are in contact in every stage, in the order of supports_of().
std::vector<GripSpec> grip_specs(const MpcSpec& spec);
GateSpec gate_spec(const MpcSpec& spec);
PolicySpec policy_spec(const MpcSpec& spec);
HoldingSpec holding_spec(const MpcSpec& spec);

}  // namespace burnish
