#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "polishing/verdict.hpp"
#include "pressing/task_checks.hpp"
#include "pressing/task_form.hpp"

namespace burnish::polishing {
namespace {

/// Adds a note if the motor lag of plans differs from that of the plant. A cutoff of 0 means no
/// lag. Differences by less than a factor of two, or by less than 2.5 ms, have no visible effect.
void note_lag(const Task& task, std::vector<std::string>& notes) {
  const double planned = task.torque_cutoff, real = task.disturbances.torque_cutoff;
  const auto lag = [](double cutoff) { return cutoff > 0.0 ? 1.0 / cutoff : 0.0; };  // lag [s]
  const double longer = std::max(lag(planned), lag(real));
  const double shorter = std::min(lag(planned), lag(real));
  if (longer - shorter <= 2.5e-3 || longer < 2.0 * shorter) return;
  const auto words = [](double cutoff) {
    return cutoff > 0.0 ? "have a cutoff of " + number(cutoff) + " rad/s"
                        : std::string("have no lag");
  };
  const bool plans_more_lag = lag(planned) > lag(real);
  notes.push_back("the motors in the controller's model " + words(planned) +
                  " (controller.torque_cutoff), but the plant's motors " + words(real) +
                  " (disturbances.torque_cutoff), which causes " +
                  (plans_more_lag ? "overshoot" : "oscillation") +
                  "; set both keys to the same value unless the difference is intended");
}

/// Adds a note if the bandwidth of the force-error estimate is too large for the delays in its
/// loop.
void note_force_error(const Task& task, std::vector<std::string>& notes) {
  constexpr double max_bandwidth = 50.0;  // largest bandwidth, see ModelErrorOptions [rad/s]
  const ModelErrorOptions& error = task.model_error;
  if (error.kind != ModelErrorKind::Force || !error.bandwidth || *error.bandwidth <= max_bandwidth)
    return;
  notes.push_back("model_error.bandwidth of " + number(*error.bandwidth) +
                  " rad/s causes oscillation if model_error.kind is force and the force sensor is "
                  "filtered; use at most " +
                  number(max_bandwidth) + " rad/s");
}

/// Adds a note if the path takes longer than Task::polish_duration.
void note_short_time(const Task& task, std::vector<std::string>& notes) {
  const double whole = path_time(task);
  if (whole <= (1.0 + 1e-9) * task.polish_duration) return;
  const std::string wanted = number(std::ceil(10.0 * whole) / 10.0);
  notes.push_back("the path takes " + wanted + " s, but phases.polish_duration is " +
                  number(task.polish_duration) +
                  " s, so the verdict covers only the first part of the path; set " + wanted +
                  " s for the whole path");
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
