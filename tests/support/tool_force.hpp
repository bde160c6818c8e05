// Measured force at a tool, stated in world axes.
#pragma once

#include <string>

#include "burnish/dynamics/placement.hpp"
#include "burnish/estimate/measurement.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {

/// Sets the measured force on the frame `tool` at the configuration `m.q`, in the first column of
/// the wrenches. Without columns, a column without moments is added. `force_world`: force in world
/// axes [N].
inline void set_tool_force(Measurement& m, const Model& model, const Eigen::Vector3d& force_world,
                           const std::string& tool = "tool") {
  if (m.wrenches.cols() == 0) m.wrenches.setConstant(6, 1, nan);
  m.wrenches.col(0).head<3>() =
      frame_placement(model, m.q, tool).linear().transpose() * force_world;
}

}  // namespace burnish::test
