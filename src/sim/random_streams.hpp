// Which stream of the seed each disturbance draws from.
#pragma once

#include <cstdint>

namespace burnish::streams {

enum : std::uint64_t {
  torque_scale,
  torque_bias,
  torque_noise,
  torque_loop,
  torque_sensor,
  position,
  velocity,
  force
};

}  // namespace burnish::streams
