#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

std::vector<TouchSensor> touch_sensors(const MpcSpec& spec) {
  std::vector<TouchSensor> result;
  bool has_tool = spec.tool.empty();
  for (const TouchSensor& touch : spec.touches) has_tool = has_tool || touch.frame == spec.tool;
  if (!has_tool) result.push_back({spec.tool});
  result.insert(result.end(), spec.touches.begin(), spec.touches.end());
  for (TouchSensor& touch : result)
    if (touch.sensor == WrenchSensor::Automatic)
      touch.sensor = touch.frame == spec.tool ? WrenchSensor::Force : WrenchSensor::Wrench;
  return result;
}

std::vector<std::string> touches_of(const MpcSpec& spec) {
  std::vector<std::string> frames;
  for (const TouchSensor& touch : touch_sensors(spec)) frames.push_back(touch.frame);
  return frames;
}

int wrench_column(const MpcSpec& spec, std::string_view frame) {
  const std::vector<TouchSensor> touches = touch_sensors(spec);
  for (std::size_t i = 0; i < touches.size(); ++i)
    if (touches[i].frame == frame)
      return touches[i].sensor == WrenchSensor::None ? -1 : static_cast<int>(i);
  return -1;
}

}  // namespace burnish
