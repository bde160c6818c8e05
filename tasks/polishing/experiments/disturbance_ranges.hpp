// Ranges from which the disturbances of a run are drawn at random.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// Ranges of uniform distributions. The default ranges are for a robot arm with torque sensors or
/// good current control, ordinary encoders and a force sensor at the wrist. Delays are typical of a
/// fieldbus at 1 kHz.
struct DisturbanceRanges {
  struct Span {
    double low, high;
  };
  /// Half range of the joints' torque factors; 0.1: factors 0.9 to 1.1.
  Span torque_scale{0.0, 0.10};
  Span torque_bias{0.0, 1.0};     ///< Half range of the joints' torque biases [Nm].
  Span torque_noise{0.0, 0.10};   ///< Noise of torques [Nm].
  Span command_delay{0.0, 2e-3};  ///< Delay of commands [s].
  Span solver_delay{0.0, 1e-3};   ///< Delay of plans, which the controller compensates [s].
  Span joint_coulomb{0.0, 1.0};   ///< Coulomb friction of joints [Nm].
  Span joint_viscous{0.0, 1.0};   ///< Viscous friction of joints [Nms/rad].
  /// Encoder resolution; the drawn value is rounded down [bit per turn].
  Span encoder_bits{16.0, 19.99};
  Span position_noise{0.0, 2e-5};  ///< Noise of positions [rad].
  Span velocity_noise{0.0, 5e-3};  ///< Noise of velocities [rad/s].
  /// Cut-off frequency of the velocity filter, 40 to 100 Hz [rad/s].
  Span velocity_cutoff{250.0, 630.0};
  Span force_noise{0.0, 0.5};       ///< Noise of the force sensor [N].
  Span force_cutoff{250.0, 630.0};  ///< Cut-off frequency of the force sensor's filter [rad/s].
  Span mass_scale{0.93, 1.07};
  Span surface_friction{0.0, 0.4};
  Span surface_tilt{-4.0, 4.0};      ///< Tilt about each tangent [deg].
  Span surface_height{-4e-3, 4e-3};  ///< Height error of the surface [m].
  Span push_force{0.0, 8.0};         ///< Force of a push, in any direction [N].
  Span push_duration{0.05, 0.25};    ///< Duration of a push [s].
  Span push_start{0.3, 0.8};         ///< Start of a push, as a fraction of the time on the path.
  Span surface_curvature{1.0, 1.0};  ///< Ratio of the true to the modelled curvature.
};

/// Named ranges, with upper limits for the force error under such disturbances.
struct NamedRanges {
  std::string name;
  std::string summary;  ///< Description, as part of a sentence.
  DisturbanceRanges ranges;
  /// Shapes of the surface, used in turn by successive seeds; empty: shape of the task.
  std::vector<SurfaceShape> shapes = {};
  /// Aims (upper limits) of the rms force error: median and maximum over the seeds [N].
  double median_force = 0.0, worst_force = 0.0;
};

/// Returns the predefined ranges: usual, wide and curved.
const std::vector<NamedRanges>& named_ranges();
/// Returns the ranges of this name, or `usual` for an empty name. Throws Error for unknown names.
const NamedRanges& ranges_named(const std::string& name);

/// Draws the disturbances of a seed and sets them in the task; task.solver_delay is drawn too. Each
/// disturbance has its own random stream, so that changing one range leaves the other disturbances
/// unchanged. One push acts while the tool is on the path.
void draw_disturbances(const DisturbanceRanges& ranges, std::uint64_t seed, Task& task);

}  // namespace burnish::polishing
