#include "pressing/run_descriptions.hpp"

#include "pressing/figures.hpp"

namespace burnish {

const Description& description_of(const TickTimes* /*of*/) {
  static const Description all = [] {
    Describe<TickTimes> figures("pressing", "TickTimes",
                                "Wall clock of a controller's ticks after the first, s.");
    pressing::each_tick_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

const Words& words_of(ReachProblem /*of*/) {
  static const Words all{
      "pressing",
      "ReachProblem",
      "What is in the way.",
      {{"none"},
       {"position", "no posture puts the tool there, whatever the limits"},
       {"joint", "the only postures found are beyond a joint's limit"},
       {"torque", "holding the tool there takes more than a joint's effort limit"},
       {"collision", "the arm itself would touch the surface"}}};
  return all;
}

const Description& description_of(const HomeMove* /*of*/) {
  using H = HomeMove;
  static const Description all =
      Describe<H>("pressing", "HomeMove",
                  "Move in joint space from where a run begins to its task's start, straight from "
                  "corner to corner and at rest at each.")
          .field("corners", &H::corners,
                 "nq each: home, the start lifted off the surface where the straight way would "
                 "touch it, the start")
          .field("durations", &H::durations, "{s}, from each corner to the next")
          .field("settle", &H::settle, "{s} at rest after it, until the task begins")
          .field("farthest_joint", &H::farthest_joint, "entry of v that moves most")
          .field("farthest", &H::farthest, "rad (m), how far");
  return all;
}

const Description& description_of(const ReachOptions* /*of*/) {
  using R = ReachOptions;
  static const Description all =
      Describe<R>("pressing", "ReachOptions", "How check_reach() looks.")
          .field("spacing", &R::spacing, "{m} between two points that are looked at")
          .field("tolerance", &R::tolerance, "{m} that the tool may be off")
          .field("joint_margin", &R::joint_margin, "{rad (m)} that joints keep from their limits")
          .field("torque_share", &R::torque_share,
                 "Of the effort limits that statics may take: the rest is for motion and feedback.")
          .field("link_radius", &R::link_radius,
                 "{m}, how thick links are taken to be; see check_reach()");
  return all;
}

const Description& description_of(const ReachReport* /*of*/) {
  using R = ReachReport;
  static const Description all =
      Describe<R>("pressing", "ReachReport",
                  "The first thing in the way of a task, and how much room there is elsewhere.")
          .field("problem", &R::problem)
          .field("text", &R::text,
                 "One sentence: where, which joint, what came and what is allowed; empty without a "
                 "problem.")
          .field("s", &R::s,
                 "{m} along the path in contact where the problem is; negative: so far before the "
                 "path's start, on the way to it. A point that is held is a path without length.")
          .field("p_world", &R::p_world, "of the tool there, m")
          .field("joint", &R::joint, "empty for Position")
          .field("value", &R::value,
                 "{m} that the tool is off, rad (m) of the joint, Nm (N), m of the joint's origin "
                 "from the surface.")
          .field("limit", &R::limit, "what is allowed, in the same unit")
          .field("points", &R::points, "that were looked at")
          .field("path_length", &R::path_length, "{m}, once around where the path repeats itself")
          .field("joint_margin", &R::joint_margin, "{rad (m)}, smallest of all points")
          .field("tightest_joint", &R::tightest_joint)
          .field("torque_share", &R::torque_share, "of the effort limit, largest of all points")
          .field("tightest_torque", &R::tightest_torque)
          .field("force_per_torque", &R::force_per_torque,
                 "{1/m}: N along the normal per Nm that every joint's torque is wrong by, "
                 "independent of each other, as told without a force sensor; largest of all points "
                 "on the surface")
          .field("force_joint", &R::force_joint, "the joint that has most part in it there")
          .field("clearance", &R::clearance,
                 "{m} between the surface and the arm without its tool link, smallest of all "
                 "points; infinite where nothing but the tool link moves.")
          .field("tightest_clearance", &R::tightest_clearance, "joint there");
  return all;
}

const Description& description_of(const PostureOptions* /*of*/) {
  using P = PostureOptions;
  static const Description all =
      Describe<P>("pressing", "PostureOptions", "How find_posture() searches.")
          .field("random_starts", &P::random_starts,
                 "besides the robot's named postures and the middle of the limits")
          .field("seed", &P::seed, "of those")
          .field("tilt_limit", &P::tilt_limit,
                 "{rad} between the pressing axis and the normal's opposite")
          .field("joint_margin", &P::joint_margin,
                 "{rad (m)} that joints keep from their limits at the start")
          .field("body_distance", &P::body_distance,
                 "{m} between the last link, for which stand three points on the line from its "
                 "joint to the tool, and the robot's body, for which stand the lines between the "
                 "joints before that one and the origins of all links that neither the last two "
                 "joints carry nor what hangs on them. Of parts of the arm that are near each "
                 "other along it, as in a compact wrist, no more is wanted than `bend` times the "
                 "arm's length between them. Coarse: no collision check.")
          .field("bend", &P::bend,
                 "see body_distance; of two equal links it lets 67 degrees between them")
          .field("checked", &P::checked, "best candidates whose whole path is looked at")
          .field("reach", &P::reach);
  return all;
}

const Description& description_of(const FoundPosture* /*of*/) {
  using F = FoundPosture;
  static const Description all =
      Describe<F>("pressing", "FoundPosture", "What find_posture() found.")
          .result()
          .field("q", &F::q, "nq")
          .field("score", &F::score, "lower is better")
          .field("tilt", &F::tilt, "{rad} between the pressing axis and the normal's opposite")
          .field("reach", &F::reach, "of the task from there")
          .field("candidates", &F::candidates, "postures that met all conditions at the start");
  return all;
}

}  // namespace burnish
