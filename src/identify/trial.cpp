#include "burnish/identify/trial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/random.hpp"

namespace burnish {
namespace {

constexpr std::uint64_t drawing = 100;  // Index of a random stream that no disturbance uses

}  // namespace

Payload drawn_payload(const std::string& frame, std::uint64_t seed) {
  RandomStream random(seed, drawing);
  Payload result;
  result.frame = frame;
  result.inertia.mass = random.uniform(0.5, 3.0);
  for (double& x : result.inertia.com) x = random.uniform(-0.06, 0.06);
  result.inertia.com.z() += 0.05;
  Eigen::Vector3d axes, turn;
  for (double& x : axes) x = random.uniform(0.03, 0.1);
  for (double& x : turn) x = random.normal();
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(random.uniform(0.0, std::numbers::pi), turn.normalized())
          .toRotationMatrix();
  const Eigen::Array3d s = axes.array().square() * (result.inertia.mass / 5.0);
  const Eigen::Vector3d moments(s[1] + s[2], s[0] + s[2], s[0] + s[1]);
  const Eigen::Matrix3d I = R * moments.asDiagonal() * R.transpose();
  result.inertia.inertia_at_com = 0.5 * (I + I.transpose());
  return result;
}

Trial try_identification(const Model& model, const Excitation& motion,
                         const Disturbances& disturbances, const IdentificationSpec& spec,
                         std::uint64_t seed) {
  Trial result;
  result.carried = drawn_payload(spec.payload, seed);
  Disturbances drawn = disturbances;
  drawn.seed = seed;
  IdentificationSpec of_payload = spec;
  of_payload.bodies.clear();
  const Trace trace = record_motion(model, result.carried, motion, drawn);
  result.warnings = check_followed(model, motion, trace);
  result.found = identify(model, motion_record(model, trace), of_payload);
  result.error = result.found.inertias.front().values - estimate_values(result.carried.inertia);
  return result;
}

TrialSummary summary_of(const std::vector<Trial>& trials) {
  TrialSummary result;
  result.trials = static_cast<int>(trials.size());
  int inside = 0;
  for (const Trial& trial : trials) {
    const EstimatedInertia& found = trial.found.inertias.front();
    result.mass_error =
        std::max(result.mass_error, std::abs(trial.error[0]) / trial.carried.inertia.mass);
    result.centre_error = std::max(result.centre_error, trial.error.segment<3>(1).norm());
    result.rms_error += trial.error.cwiseAbs2();
    result.rms_sigma += found.sigma.cwiseAbs2();
    for (int i = 0; i < 10; ++i) {
      const double in_sigma = std::abs(trial.error[i]) / found.sigma[i];
      inside += in_sigma <= 2.0 ? 1 : 0;
      result.largest_in_sigma = std::max(result.largest_in_sigma, in_sigma);
    }
  }
  const double count = std::max(1, result.trials);
  result.rms_error = (result.rms_error / count).cwiseSqrt();
  result.rms_sigma = (result.rms_sigma / count).cwiseSqrt();
  result.within_two_sigma = inside / (10.0 * count);
  return result;
}

}  // namespace burnish
