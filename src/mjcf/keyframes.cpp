// <keyframe>: keyframes as postures.
#include <cmath>

#include "base/sentence.hpp"
#include "mjcf/reading.hpp"
#include "model/posture.hpp"

namespace burnish::mjcf {
namespace {

/// Returns whether the joint is neither held nor a follower. Postures list only such joints.
bool moves_by_itself(const JointSpec& joint) {
  return joint.type != JointType::Fixed && !joint.mimic;
}

/// Reorders a quaternion from w x y z to x y z w and normalises it.
void turn_quaternion(double* wxyz, const XMLElement& key) {
  const Eigen::Quaterniond r = quaternion_of({wxyz[0], wxyz[1], wxyz[2], wxyz[3]}, key);
  wxyz[0] = r.x(), wxyz[1] = r.y(), wxyz[2] = r.z(), wxyz[3] = r.w();
}

Posture read_posture(const XMLElement& key, const std::vector<double>& qpos, Reading& reading) {
  Posture posture;
  auto from = qpos.begin();
  for (const Coordinate& coordinate : reading.coordinates) {
    const auto size = static_cast<std::ptrdiff_t>(coordinate.start.size());
    std::vector<double> values(from, from + size);
    from += size;
    if (size == 7) turn_quaternion(values.data() + 3, key);
    if (size == 4) turn_quaternion(values.data(), key);
    const JointSpec& joint = reading.tree.joints[coordinate.joint];
    if (moves_by_itself(joint)) posture.emplace(joint.name, std::move(values));
  }
  return posture;
}

Posture posture_at_start(const Reading& reading) {
  Posture posture;
  for (const Coordinate& coordinate : reading.coordinates) {
    const JointSpec& joint = reading.tree.joints[coordinate.joint];
    if (moves_by_itself(joint)) posture.emplace(joint.name, coordinate.start);
  }
  return posture;
}

/// Returns whether the values are zero or the identity rotation.
bool is_neutral(const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_w = values.size() > 1 && i + 1 == values.size();
    if (values[i] != (is_w ? 1.0 : 0.0)) return false;
  }
  return true;
}

void read_key(const XMLElement& key, Names& names, std::size_t size, Reading& reading) {
  const char* stated = key.Attribute("name");
  const std::string name =
      stated == nullptr || *stated == '\0' ? names.unique("keyframe") : std::string(stated);
  if (key.Attribute("qpos") == nullptr) return;  // Such a keyframe is qpos0, which is added anyway
  const std::vector<double> qpos = all_numbers(key, "qpos", place_of(key));
  if (qpos.size() != size)
    refuse_at(key, "qpos has " + std::to_string(qpos.size()) + " numbers; wanted " +
                       std::to_string(size));
  if (!reading.tree.postures.emplace(name, read_posture(key, qpos, reading)).second)
    refuse_at(key, "an earlier keyframe has the same name");
}

}  // namespace

void read_keyframes(const std::vector<const XMLElement*>& elements, Reading& reading) {
  std::size_t size = 0;
  bool all_neutral = true;
  for (const Coordinate& coordinate : reading.coordinates) {
    size += coordinate.start.size();
    all_neutral = all_neutral && is_neutral(coordinate.start);
  }
  Names names;
  for (const XMLElement* key : elements)
    if (const char* name = key->Attribute("name")) names.take(name);
  for (const XMLElement* key : elements)
    reading.findings.attempt_or_warn([&] { read_key(*key, names, size, reading); },
                                     "; this posture is left out");
  if (!all_neutral) reading.tree.postures.emplace("qpos0", posture_at_start(reading));
}

}  // namespace burnish::mjcf
