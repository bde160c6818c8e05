// Actuators: their maximum forces give the effort limits of joints. Gains are not part of a model.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/sentence.hpp"
#include "mjcf/reading.hpp"

namespace burnish::mjcf {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Returns the larger bound of a range, by magnitude; infinity if the range is missing or does not
/// apply.
double bound(const Item& item, const char* limited, const char* range, Reading& reading,
             bool& is_even) {
  const auto stated = item.numbers(range, 2);
  const bool has_range = stated && ((*stated)[0] != 0.0 || (*stated)[1] != 0.0);
  if (!item.choice(limited).value_or(has_range && reading.compiler_of(item.xml()).autolimits))
    return infinity;
  if (!has_range)
    refuse_at(item.xml(), std::string("it is limited but has no ") + range + "; wanted this range");
  is_even = is_even && (*stated)[0] == -(*stated)[1];
  return std::max(std::abs((*stated)[0]), std::abs((*stated)[1]));
}

/// Returns whether the actuator is a servo. The force of a servo depends on its error, so its
/// control range does not limit the force.
bool is_servo(const Item& item) {
  const std::string_view kind = item.xml().Name();
  if (kind == "motor" || kind == "cylinder") return false;
  if (kind != "general") return true;
  return item.text("gaintype").value_or("fixed") != "fixed" ||
         item.text("biastype").value_or("none") != "none" ||
         item.text("dyntype").value_or("none") == "integrator" || item.stating("kp") != nullptr ||
         item.stating("kv") != nullptr;
}

double gain_of(const Item& item) {
  const std::string_view kind = item.xml().Name();
  if (kind == "general") return item.overlaid("gainprm", {1.0})[0];
  if (kind != "cylinder") return 1.0;
  const double diameter = item.number("diameter", 0.0);
  return diameter > 0.0 ? 0.25 * std::numbers::pi * diameter * diameter : item.number("area", 1.0);
}

/// Returns the largest force or torque of an actuator before its gear [N or Nm].
double largest_force(const Item& item, Reading& reading) {
  bool is_even = true;
  double force = bound(item, "forcelimited", "forcerange", reading, is_even);
  if (is_servo(item)) {
    reading.info_notes.note(
        "gains of servos and muscles are ignored; only their largest force is used",
        example_of(item.xml()));
  } else {
    const double control = bound(item, "ctrllimited", "ctrlrange", reading, is_even);
    const double gain = std::abs(gain_of(item));
    if (control < infinity) force = std::min(force, gain * control);
  }
  if (!is_even) reading.warning_notes.note(uneven_forces, example_of(item.xml()));
  return force;
}

/// For each joint, the sum of the largest torques of its actuators.
class Efforts {
 public:
  explicit Efforts(Reading& reading) : reading_(reading), sums_(reading.tree.joints.size(), 0.0) {}

  void add(const Item& item) {
    const std::vector<double> gear = item.overlaid("gear", {1.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    for (const char* attribute : {"joint", "jointinparent"}) {
      if (const auto joint = item.text(attribute)) {
        const std::size_t index = reading_.coordinate(*joint, item.xml()).joint;
        add_to(index, largest_gear(gear, reading_.tree.joints[index].type), item);
        return;
      }
    }
    if (const auto tendon = item.text("tendon")) return add_by_tendon(*tendon, gear[0], item);
    reading_.warning_notes.note(
        "actuators that act on neither a joint nor a fixed tendon are ignored",
        example_of(item.xml()));
  }

  void limit_joints() const {
    if (!has_actuator_) return;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      JointSpec& joint = reading_.tree.joints[i];
      if (joint.type != JointType::Fixed)
        joint.effort_limit = std::min(joint.effort_limit, sums_[i]);
    }
  }

 private:
  static double largest_gear(const std::vector<double>& gear, JointType type) {
    const std::ptrdiff_t entries = type == JointType::Floating ? 6
                                   : type == JointType::Ball   ? 3
                                                               : 1;
    double largest = 0.0;
    for (auto g = gear.begin(); g != gear.begin() + entries; ++g)
      largest = std::max(largest, std::abs(*g));
    return largest;
  }

  void add_to(std::size_t joint, double factor, const Item& item) {
    has_actuator_ = true;
    const double force = largest_force(item, reading_);
    // A gear of zero transmits nothing, but 0 times an infinite force would give NaN.
    if (factor != 0.0) sums_[joint] += std::abs(factor) * force;
  }

  void add_by_tendon(const std::string& name, double gear, const Item& item) {
    for (const TendonSpec& tendon : reading_.tree.tendons) {
      if (tendon.name != name) continue;
      for (const TendonSpec::Part& part : tendon.parts)
        add_to(reading_.coordinate(part.joint, item.xml()).joint, part.coefficient * gear, item);
      return;
    }
    reading_.warning_notes.note("actuators on ignored tendons are ignored", example_of(item.xml()));
  }

  Reading& reading_;
  std::vector<double> sums_;
  bool has_actuator_ = false;
};

}  // namespace

void read_actuators(const std::vector<const XMLElement*>& elements, Reading& reading) {
  Efforts efforts(reading);
  for (const XMLElement* element : elements)
    reading.findings.attempt([&] { efforts.add(reading.item(*element)); });
  efforts.limit_joints();
}

}  // namespace burnish::mjcf
