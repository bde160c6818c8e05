#include "draft_feet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/to_size.hpp"
#include "base/words_in.hpp"
#include "base/yaml_word.hpp"
#include "burnish/base/error.hpp"
#include "burnish/tasks/pressing/find_feet.hpp"
#include "pressing/arm.hpp"
#include "pressing/foot_posture.hpp"
#include "settings_posture.hpp"
#include "show_json.hpp"

namespace burnish::app {
namespace {

/// Distance by which the base is lowered in the drafted posture, as a fraction of the leg length.
/// It equals the default of `crouch` in the task `stand`.
constexpr double drafted_crouch = 0.2;

bool is_named_after_a_foot(const std::string& name) {
  return has_one_of(name, {"foot", "feet", "sole", "toe", "ankle"});
}

std::string numbers(const Eigen::Vector3d& v) {
  constexpr double digits = 1e6;
  const auto rounded = [](double x) { return std::round(digits * x) / digits + 0.0; };
  return fmt::format("[{:g}, {:g}, {:g}]", rounded(v.x()), rounded(v.y()), rounded(v.z()));
}

/// Returns the line of a settings file that defines a frame relative to a link of the same body.
std::string frame_line(const Model& model, const Frame& frame) {
  const auto parent =
      std::find_if(model.frames.begin(), model.frames.end(), [&](const Frame& other) {
        return other.body == frame.body && other.kind == FrameKind::Link;
      });
  if (parent == model.frames.end()) return "";
  const Eigen::Isometry3d at = parent->placement.inverse() * frame.placement;
  return fmt::format("  {}: {{parent: {}, xyz: {}, rpy: {}}}\n", yaml_word(frame.name),
                     yaml_word(parent->name), numbers(at.translation()),
                     numbers(roll_pitch_yaw(at.linear())));
}

std::string standing_keys(const Feet& feet) {
  std::string frames;
  for (const std::string& frame : feet.frames)
    frames += (frames.empty() ? "" : ", ") + yaml_word(frame);
  const std::string size =
      feet.has_soles() ? fmt::format("half_x: {:.4g}, half_y: {:.4g}", feet.half_x, feet.half_y)
                       : fmt::format("half_x: 0, half_y: 0, radius: {:.4g}", feet.radius);
  return fmt::format("standing: {{feet: [{}], {}}}", frames, size);
}

std::string standing_posture(const Robot& robot, const Feet& feet) {
  const Standing standing = with_feet(Standing{}, feet);
  const Model& model = robot.model;
  const Eigen::VectorXd from =
      robot.default_posture.empty() ? model.q_neutral : robot.reference_configuration();
  try {
    return posture_text(
        posture_of(model, pressing::crouched_posture(model, standing, from, drafted_crouch)));
  } catch (const Error&) {
    return "";
  }
}

/// Returns the robot, loaded with a floating base. Returns nothing if the robot cannot be
/// simulated, for example because a joint moves no mass.
std::optional<Robot> floating(const std::string& file) {
  try {
    return pressing::load_floating(file);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

DraftedFeet draft_feet(const std::string& file, bool floats) {
  DraftedFeet drafted;
  std::optional<Robot> loaded = floating(file);
  if (!loaded) return drafted;
  Robot robot = *std::move(loaded);
  const auto feet = find_feet(robot);
  if (!feet) return drafted;
  if (!floats && !std::all_of(feet->frames.begin(), feet->frames.end(), is_named_after_a_foot))
    return drafted;
  robot = with_feet(std::move(robot), *feet);
  drafted.comment = "# Feet: " + feet_text(*feet) + ".\n# Keys of tasks: `" + standing_keys(*feet) +
                    "`, or `standing.feet: auto`.\n";
  for (const Frame& frame : feet->added) drafted.frames += frame_line(robot.model, frame);
  const Model& model = robot.model;
  for (const std::string& foot : feet->frames)
    for (int body = model.frames[to_size(model.frame_index(foot))].body; body >= 0;
         body = model.joints[to_size(body)].parent)
      if (const Joint& joint = model.joints[to_size(body)]; joint.kind != JointKind::FreeFlyer)
        drafted.legs.insert(joint.name);
  drafted.posture = standing_posture(robot, *feet);
  return drafted;
}

}  // namespace burnish::app
