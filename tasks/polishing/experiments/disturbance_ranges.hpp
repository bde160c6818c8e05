// Everything that can disturb a run, at once, with sizes drawn from a seed.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// The ranges from which sizes are drawn, evenly: what a robot arm with torque sensors or good
/// current control, ordinary encoders and a wrist force sensor may have. Delays are what a fieldbus
/// at 1 kHz brings.
struct DisturbanceRanges {
  struct Span {
    double low, high;
  };
  Span torque_scale{0.0, 0.10};        ///< of the drawn factors' range: up to +-10 %
  Span torque_bias{0.0, 1.0};          ///< Nm, of the drawn biases' range
  Span torque_noise{0.0, 0.10};        ///< Nm
  Span command_delay{0.0, 2e-3};       ///< s
  Span solver_delay{0.0, 1e-3};        ///< s, known to the controller
  Span joint_coulomb{0.0, 1.0};        ///< Nm
  Span joint_viscous{0.0, 1.0};        ///< Nms/rad
  Span encoder_bits{16.0, 19.99};      ///< per turn, rounded down
  Span position_noise{0.0, 2e-5};      ///< rad
  Span velocity_noise{0.0, 5e-3};      ///< rad/s
  Span velocity_cutoff{250.0, 630.0};  ///< rad/s, of differences: 40 to 100 Hz
  Span force_noise{0.0, 0.5};          ///< N
  Span force_cutoff{250.0, 630.0};     ///< rad/s
  Span mass_scale{0.93, 1.07};
  Span surface_friction{0.0, 0.4};
  Span surface_tilt{-4.0, 4.0};      ///< degrees about each tangent
  Span surface_height{-4e-3, 4e-3};  ///< m
  Span push_force{0.0, 8.0};         ///< N, in any direction
  Span push_duration{0.05, 0.25};    ///< s
  Span push_start{0.3, 0.8};         ///< of the time on the path
  Span surface_curvature{1.0, 1.0};  ///< how much more the surface bends than believed
};

/// Ranges by a word, and what the force is held to within them.
struct NamedRanges {
  std::string name;
  std::string summary;  ///< what they are, for a sentence
  DisturbanceRanges ranges;
  /// Of the surface, in turn over the seeds; empty: as the task says.
  std::vector<SurfaceShape> shapes = {};
  double median_force = 0.0, worst_force = 0.0;  ///< N, rms error, aims over the seeds
};

/// usual, wide, curved.
const std::vector<NamedRanges>& named_ranges();
/// Empty: usual. Throws Error with the nearest known name.
const NamedRanges& ranges_named(const std::string& name);

/// The disturbances of a seed, each from a stream of its own: other ranges of one leave the others
/// as they were. One push comes while the tool is on its path. Sets solver_delay too.
void draw_disturbances(const DisturbanceRanges& ranges, std::uint64_t seed, Task& task);

}  // namespace burnish::polishing
