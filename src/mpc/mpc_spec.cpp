#include "burnish/mpc/mpc_spec.hpp"

#include <algorithm>

namespace burnish {
namespace {

bool is_support(const MpcSpec& spec, const std::string& frame) {
  return std::any_of(
      spec.problem.contacts.begin(), spec.problem.contacts.end(), [&](const ContactSpec& contact) {
        return contact.tool == frame && std::find(spec.supports.begin(), spec.supports.end(),
                                                  contact.name) != spec.supports.end();
      });
}

}  // namespace

std::vector<TouchSensor> touch_sensors(const MpcSpec& spec) {
  std::vector<TouchSensor> result;
  for (const ToolSpec& tool : spec.tools)
    if (std::none_of(spec.touches.begin(), spec.touches.end(),
                     [&](const TouchSensor& touch) { return touch.frame == tool.frame; }))
      result.push_back({tool.frame});
  result.insert(result.end(), spec.touches.begin(), spec.touches.end());
  for (TouchSensor& touch : result)
    if (touch.sensor == WrenchSensor::Automatic)
      touch.sensor = is_support(spec, touch.frame) ? WrenchSensor::Wrench : WrenchSensor::Force;
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
