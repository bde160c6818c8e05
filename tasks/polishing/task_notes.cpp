#include "polishing/task_notes.hpp"

#include <cmath>

#include "model/sentence.hpp"

namespace burnish::polishing {
namespace {

/// m/s, highest along the path.
double speed_of(const PathSpec& path) {
  const bool turns = path.kind == PathKind::Circle || path.kind == PathKind::Spiral;
  return turns ? std::abs(path.rate) * path.radius : path.speed;
}

/// See SurfaceSpec::damping.
void note_lift(const Task& task, PlantKind plant, std::vector<std::string>& notes) {
  const double friction = task.disturbances.surface_friction.value_or(task.friction);
  const double lift = friction * task.damping * speed_of(task.path);
  if (plant != PlantKind::Mujoco || lift < 0.8 * task.force) return;
  notes.push_back("MuJoCo's friction lifts the sliding tip by surface friction " +
                  number(friction) + " x surface.damping " + number(task.damping) +
                  " Ns/m x speed " + number(speed_of(task.path)) + " m/s = " + number(lift) +
                  " N, which the force of " + number(task.force) +
                  " N hardly exceeds: contact will be lost; a third of it is clean");
}

void note_lag(const Task& task, std::vector<std::string>& notes) {
  const double planned = task.torque_cutoff, real = task.disturbances.torque_cutoff;
  if (planned == 0.0 || (real > 0.5 * planned && real < 2.0 * planned)) return;
  notes.push_back("the controller plans with a torque lag of " + number(planned) +
                  " rad/s, and the plant has " + (real == 0.0 ? "none" : number(real) + " rad/s") +
                  ": set disturbances.torque_cutoff to match unless that is the experiment");
}

}  // namespace

std::vector<std::string> task_notes(const Task& task, PlantKind plant) {
  std::vector<std::string> notes;
  note_lift(task, plant, notes);
  note_lag(task, notes);
  return notes;
}

}  // namespace burnish::polishing
