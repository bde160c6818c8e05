#include "pressing/found_standing.hpp"

#include <algorithm>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/tasks/pressing/find_feet.hpp"
#include "pressing/arm.hpp"
#include "pressing/foot_shape.hpp"

namespace burnish::pressing {
namespace {

/// Adds a note for each foot that is a wheel.
void note_wheels(const Model& model, const std::vector<std::string>& feet,
                 std::vector<std::string>& notes) {
  for (const std::string& foot : feet) {
    if (!model.has_frame(foot)) continue;
    const int body = model.frames[to_size(model.frame_index(foot))].body;
    if (turns_freely(model, body))
      notes.push_back(foot + " turns freely about " + model.joints[to_size(body)].name +
                      ": lock this joint to stand on the foot");
  }
}

}  // namespace

Standing standing_on(Robot& robot, const Standing& standing, std::vector<std::string>& notes) {
  const std::vector<std::string>& stated = standing.feet;
  const bool is_auto = stated == std::vector<std::string>{"auto"};
  const bool is_of_another =
      !stated.empty() && std::none_of(stated.begin(), stated.end(), [&](const std::string& foot) {
        return robot.model.has_frame(foot);
      });
  if (!is_auto && !is_of_another) {
    note_wheels(robot.model, stated, notes);
    return standing;
  }
  std::string why;
  const auto feet = find_feet(robot, &why);
  if (!feet)
    throw EntryError(
        "standing.feet",
        (is_auto ? "no feet were found on robot " + in_quotes(robot.model.name)
                 : "frame " + none_of(robot.model, stated.front()) + ", and no feet were found") +
            ": " + why + "; wanted the frames that the robot stands on");
  robot = with_feet(std::move(robot), *feet);
  notes.push_back((is_auto ? "feet: "
                           : "standing.feet: " + in_quotes(stated.front()) +
                                 " and the other feet are not frames of robot " +
                                 in_quotes(robot.model.name) + "; feet used instead: ") +
                  feet_text(*feet));
  notes.insert(notes.end(), feet->notes.begin(), feet->notes.end());
  note_wheels(robot.model, feet->frames, notes);
  return with_feet(standing, *feet);
}

}  // namespace burnish::pressing
