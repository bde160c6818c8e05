#include "polishing/experiments/disturbance_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "sim/random.hpp"

namespace burnish::polishing {
namespace {

/// Number of the first random stream that draws sizes of disturbances. Streams with smaller numbers
/// draw the noise within a run.
constexpr std::uint64_t first_stream = 1000;

Eigen::Vector3d unit_vector(RandomStream& random) {
  const double z = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {across * std::cos(angle), across * std::sin(angle), z};
}

DisturbanceRanges wide() {
  DisturbanceRanges ranges;
  ranges.surface_tilt = {-6.0, 6.0};
  ranges.surface_height = {-5e-3, 5e-3};
  return ranges;
}

DisturbanceRanges wide_and_bent() {
  DisturbanceRanges ranges = wide();
  ranges.surface_curvature = {0.8, 1.2};
  return ranges;
}

}  // namespace

const std::vector<NamedRanges>& named_ranges() {
  static const std::vector<NamedRanges> all{
      {"usual", "planes", {}, {}, 0.3, 0.9},
      {"wide",
       "planes that are tilted by up to 6 degrees about each tangent and displaced by up to 5 mm",
       wide(),
       {},
       0.3,
       0.9},
      {"curved",
       "spheres, cylinders, tori, saddles and ellipsoids that are tilted by up to 6 degrees, "
       "displaced by up to 5 mm and curved by up to 20 % more or less than assumed",
       wide_and_bent(),
       {{.kind = SurfaceShape::Kind::Sphere, .radius = 0.2},
        {.kind = SurfaceShape::Kind::Cylinder, .radius = 0.2},
        {.kind = SurfaceShape::Kind::Torus, .radius = 0.2, .ring = 0.4},
        {.kind = SurfaceShape::Kind::Saddle, .curvature = {2.0, -3.0}},
        {.kind = SurfaceShape::Kind::Ellipsoid}},
       0.6,
       1.5}};
  return all;
}

const NamedRanges& ranges_named(const std::string& name) {
  if (name.empty()) return named_ranges().front();
  std::vector<std::string> names;
  for (const NamedRanges& ranges : named_ranges()) {
    if (ranges.name == name) return ranges;
    names.push_back(ranges.name);
  }
  throw Error("unknown ranges " + in_quotes(name) + "; wanted usual, wide or curved" +
              did_you_mean(name, names));
}

void draw_disturbances(const DisturbanceRanges& ranges, std::uint64_t seed, Task& task) {
  std::uint64_t stream = first_stream;
  const auto draw = [&](const DisturbanceRanges::Span& span) {
    RandomStream random(seed, stream++);
    return random.uniform(span.low, span.high);
  };
  Disturbances d;
  d.seed = seed;
  d.torque_scale_range = draw(ranges.torque_scale);
  d.torque_bias_range = draw(ranges.torque_bias);
  d.torque_noise = draw(ranges.torque_noise);
  d.command_delay = draw(ranges.command_delay);
  task.solver_delay = std::min(draw(ranges.solver_delay), 1.0 / task.update_rate);
  d.joint_coulomb = draw(ranges.joint_coulomb);
  d.joint_viscous = draw(ranges.joint_viscous);
  d.encoder_bits = static_cast<int>(draw(ranges.encoder_bits));
  d.position_noise = draw(ranges.position_noise);
  d.velocity_noise = draw(ranges.velocity_noise);
  d.finite_difference_velocity = true;
  d.velocity_cutoff = draw(ranges.velocity_cutoff);
  d.force_noise = draw(ranges.force_noise);
  d.force_cutoff = draw(ranges.force_cutoff);
  d.mass_scale = draw(ranges.mass_scale);
  d.surface_friction = draw(ranges.surface_friction);
  d.surface_tilt_deg = {draw(ranges.surface_tilt), draw(ranges.surface_tilt)};
  d.surface_height = draw(ranges.surface_height);
  Push push;
  const double before =
      task.reach_duration + task.clearance / task.approach_speed + task.ramp_duration;
  push.start = before + draw(ranges.push_start) * task.polish_duration;
  push.duration = draw(ranges.push_duration);
  const double force = draw(ranges.push_force);
  RandomStream random(seed, stream++);
  push.force_world = force * unit_vector(random);
  d.pushes = {push};
  d.surface_curvature = draw(ranges.surface_curvature);
  task.disturbances = d;
}

}  // namespace burnish::polishing
