#include "pressing/descriptions.hpp"

namespace burnish {

const Description& description_of(const ToolLimits* /*of*/) {
  constexpr Range limit = range::positive_or_infinite;
  static const Description all =
      Describe<ToolLimits>("pressing", "ToolLimits",
                           "When a run is given up for what happens at the tool. Infinite: never.")
          .field("force", &ToolLimits::force, "{N} at the tool, mean over force_window", limit)
          .more(
              "A rigid impact's force at a single instant is its impulse over the sampling time "
              "and "
              "says little.")
          .field("force_window", &ToolLimits::force_window, "{s}", limit)
          .more("rounded to ticks, one at least")
          .field("tool_speed", &ToolLimits::tool_speed, "{m/s}", limit)
          .field("contact_lost", &ToolLimits::contact_lost, "{s} without force while it is wanted",
                 limit)
          .field("late_contact_travel", &ToolLimits::late_contact_travel,
                 "{m} that the tool may go on after contact was due", limit)
          .more(
              "Along the normal, from when the schedule's clock began to wait for it "
              "(SchedulePhase::hold before it was due): how far the surface may lie behind where "
              "it "
              "is thought to be.")
          .field("late_contact_time", &ToolLimits::late_contact_time,
                 "{s} that contact may come late", limit)
          .more("from the same moment")
          .field("unexpected_force", &ToolLimits::unexpected_force,
                 "{N} while moving through free space", limit)
          .more(
              "Mean over `force_window`, where nothing is to touch, and while leaving once the "
              "tool has "
              "come off (its force fell below the threshold of contact) or `release` s are over. "
              "More where noise reaches further: six deviations of that mean.")
          .field("release", &ToolLimits::release,
                 "{s} into the retreat after which it is free space at the latest", limit);
  return all;
}

const Description& description_of(const PostureLimits* /*of*/) {
  using P = PostureLimits;
  constexpr Range limit = range::not_negative;
  static const Description all =
      Describe<P>("pressing", "PostureLimits",
                  "What a posture that is searched has to keep to; see find_posture().")
          .field("tilt", &P::tilt, "{rad} between the tool's axis and the normal", limit)
          .field("joint_margin", &P::joint_margin,
                 "{rad} that joints keep from their limits at the start", limit)
          .more("m of prismatic joints")
          .field("body_distance", &P::body_distance,
                 "{m} between the last link and the robot's body; less where the arm is short",
                 limit);
  return all;
}

}  // namespace burnish
