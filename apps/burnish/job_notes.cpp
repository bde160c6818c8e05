#include "job_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pressing/task_form.hpp"

namespace burnish::app {

void describe_job(const polishing::PolishJob& job, const polishing::ReachReport& reach,
                  const std::vector<document::Reader>& said, bool talks) {
  const bool states = pressing::states_disturbances(said);
  for (const std::string& note : polishing::task_notes(job.spec.task, states))
    fmt::print(stderr, "burnish: {}: note: {}\n", job.place, note);
  if (!job.spec.task.force_sensor && reach.points > 0)
    fmt::print(stderr,
               "burnish: {}: note: without a force sensor, the force is estimated from joint "
               "torques. The torque errors measured in free air are subtracted. Later changes, "
               "such as friction where a joint reverses, remain: an error of 1 Nm in every joint "
               "corresponds to {:.1f} N along the normal ({} contributes most)\n",
               job.place, reach.force_per_torque, reach.force_joint);
  if (!talks || reach.points == 0) return;
  fmt::print("{}: {:.3f} m of path; margin to joint limits {:.2f} rad ({})", job.place,
             reach.path_length, reach.joint_margin, reach.tightest_joint);
  if (reach.tightest_torque.empty())
    fmt::print(", no torque limits");
  else
    fmt::print(", static torque {:.0f} % of the limit ({})", 100.0 * reach.torque_share,
               reach.tightest_torque);
  if (!reach.tightest_clearance.empty())
    fmt::print(", clearance to the surface {:.2f} m ({})", reach.clearance,
               reach.tightest_clearance);
  fmt::print("\n");
}

void describe_home_move(const std::string& place, const std::optional<HomeMove>& home,
                        const std::vector<polishing::FreeHome>& free_homes) {
  if (home)
    return fmt::print(
        "{}: moves from home to the start in {:.2g} s{} (joint '{}' moves farthest, by {:.2g})\n",
        place, home->duration(), home->corners.size() > 2 ? ", finally down to the surface" : "",
        home->farthest_joint, home->farthest);
  if (free_homes.empty()) return;
  constexpr std::size_t max_listed = 3;
  std::string homes;
  for (std::size_t i = 0; i < std::min(max_listed, free_homes.size()); ++i)
    homes += fmt::format("{}{} ({:.2g} s)", i == 0 ? "" : ", ", free_homes[i].posture,
                         free_homes[i].duration);
  fmt::print(
      "{}: the run begins with the tool at the start of the path; with `--set home=POSTURE`, it "
      "begins at another posture, from which the robot moves to the start; postures free of "
      "collisions: {}\n",
      place, homes);
}

}  // namespace burnish::app
