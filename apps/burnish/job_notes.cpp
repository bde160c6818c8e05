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
    fmt::print(
        stderr,
        "burnish: {}: note: without a force sensor the force is told from the torques of the "
        "joints. What they are wrong by in the air just before is taken off; of what changes "
        "after that, as friction does where a joint turns around, 1 Nm in every joint is {:.1f} N "
        "along the normal ({} has most part in it)\n",
        job.place, reach.force_per_torque, reach.force_joint);
  if (!talks || reach.points == 0) return;
  fmt::print("{}: {:.3f} m of path; joints keep {:.2f} rad ({})", job.place, reach.path_length,
             reach.joint_margin, reach.tightest_joint);
  if (reach.tightest_torque.empty())
    fmt::print(", no torque is limited");
  else
    fmt::print(", statics take {:.0f} % of the torque limits ({})", 100.0 * reach.torque_share,
               reach.tightest_torque);
  if (!reach.tightest_clearance.empty())
    fmt::print(", the arm keeps {:.2f} m off the surface ({})", reach.clearance,
               reach.tightest_clearance);
  fmt::print("\n");
}

void describe_way(const std::string& place, const std::optional<HomeMove>& home,
                  const std::vector<polishing::FreeHome>& free_homes) {
  if (home)
    return fmt::print("{}: moves there from home in {:.2g} s{} (joint '{}' by {:.2g})\n", place,
                      home->duration(),
                      home->corners.size() > 2 ? ", at last down to the surface" : "",
                      home->farthest_joint, home->farthest);
  if (free_homes.empty()) return;
  constexpr std::size_t most = 3;
  std::string homes;
  for (std::size_t i = 0; i < std::min(most, free_homes.size()); ++i)
    homes += fmt::format("{}{} ({:.2g} s)", i == 0 ? "" : ", ", free_homes[i].posture,
                         free_homes[i].duration);
  fmt::print(
      "{}: the run begins at its start; `--set home=POSTURE` begins it elsewhere and moves there: "
      "the way is free from {}\n",
      place, homes);
}

}  // namespace burnish::app
