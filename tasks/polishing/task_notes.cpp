#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "polishing/verdict.hpp"
#include "pressing/task_checks.hpp"
#include "pressing/task_form.hpp"

namespace burnish::polishing {
namespace {

/// What the plan knows of the motors' lag against what they have; a cutoff of 0 is no lag. Less
/// than a factor of two, or 2.5 ms, does not show.
void note_lag(const Task& task, std::vector<std::string>& notes) {
  const double planned = task.torque_cutoff, real = task.disturbances.torque_cutoff;
  const auto lag = [](double cutoff) { return cutoff > 0.0 ? 1.0 / cutoff : 0.0; };  // s
  const double longer = std::max(lag(planned), lag(real));
  const double shorter = std::min(lag(planned), lag(real));
  if (longer - shorter <= 2.5e-3 || longer < 2.0 * shorter) return;
  const auto words = [](double cutoff) {
    return cutoff > 0.0 ? "lag by " + number(cutoff) + " rad/s" : std::string("do not lag");
  };
  const bool imagined = lag(planned) > lag(real);
  notes.push_back("the controller plans with motors that " + words(planned) +
                  " (controller.torque_cutoff), and the plant's " + words(real) +
                  " (disturbances.torque_cutoff): " +
                  (imagined ? "planning with a lag that is not there overshoots"
                            : "torques that come later than planned oscillate") +
                  "; set both alike unless that is the experiment");
}

/// The estimate of the force's error is a loop around the controller's delays.
void note_force_error(const Task& task, std::vector<std::string>& notes) {
  constexpr double most = 50.0;  // rad/s, see ModelErrorOptions
  const ModelErrorOptions& error = task.model_error;
  if (error.kind != ModelErrorKind::Force || !error.bandwidth || *error.bandwidth <= most) return;
  notes.push_back("model_error.kind is force with a bandwidth of " + number(*error.bandwidth) +
                  " rad/s: behind a filtered force sensor that rings; " + number(most) +
                  " rad/s are well");
}

/// A path that ends, but not in the time that it is given.
void note_short_time(const Task& task, std::vector<std::string>& notes) {
  const double whole = path_time(task);
  if (whole <= (1.0 + 1e-9) * task.polish_duration) return;
  const std::string wanted = number(std::ceil(10.0 * whole) / 10.0);
  notes.push_back("the path takes " + wanted + " s, and phases.polish_duration is " +
                  number(task.polish_duration) +
                  " s: the run is cut short and judged by that part; " + wanted +
                  " s are the whole path");
}

}  // namespace

std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant) {
  std::vector<std::string> notes;
  if (!ideal_is_meant) pressing::note_ideal_world(task.disturbances, notes);
  pressing::note_delays({task.command_delay, task.measurement_delay}, task.disturbances, notes);
  note_lag(task, notes);
  note_force_error(task, notes);
  note_short_time(task, notes);
  pressing::note_friction("surface.friction", task.friction, Task{}.friction, task.disturbances,
                          notes);
  return notes;
}

}  // namespace burnish::polishing
