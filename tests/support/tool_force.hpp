// Measured force at a tool, stated in world axes.
#pragma once

#include <string>

#include "burnish/dynamics/placement.hpp"
#include "burnish/estimate/measurement.hpp"

namespace burnish::test {

/// Sets the measured force on the frame `tool` at the configuration `m.q`. `force_world`: force in
/// world axes [N].
inline void set_tool_force(Measurement& m, const Model& model, const Eigen::Vector3d& force_world,
                           const std::string& tool = "tool") {
  m.tool_wrench.head<3>() = frame_placement(model, m.q, tool).linear().transpose() * force_world;
}

}  // namespace burnish::test
