// Trials of the identification: a random payload is carried in simulation and then identified.
#pragma once

#include "burnish/identify/excitation.hpp"

namespace burnish {

/// Returns a random payload at `frame`: a mass of 0.5 to 3 kg, a centre of mass within about 0.1 m
/// of the frame's origin, and the inertia of an ellipsoid with semi-axes of 3 to 10 cm.
Payload drawn_payload(const std::string& frame, std::uint64_t seed);

struct Trial {
  Payload carried;
  Identification found;
  Vector10 error = Vector10::Zero();  ///< Error of each entry of EstimatedInertia::values
  std::vector<std::string> warnings;  ///< Warnings of check_followed()
};

/// Draws a payload from `seed`, simulates the motion with this payload, and identifies the payload
/// at the frame `spec.payload`. The noise of the simulation also comes from `seed`. Returns the
/// payload, its estimate and the error. Throws Error in the same cases as record_motion(),
/// check_followed() and identify().
Trial try_identification(const Model& model, const Excitation& motion,
                         const Disturbances& disturbances, const IdentificationSpec& spec,
                         std::uint64_t seed);

/// Statistics of the errors of many trials.
struct TrialSummary {
  int trials = 0;
  /// Largest error of a mass, as a fraction of the true mass
  double mass_error = 0.0;
  /// Largest distance between estimated and true centre of mass [m]
  double centre_error = 0.0;
  /// rms_error and rms_sigma are the root mean squares, over all trials, of the errors and of the
  /// estimated standard deviations. Each has one value per entry of EstimatedInertia::values.
  Vector10 rms_error = Vector10::Zero(), rms_sigma = Vector10::Zero();
  /// within_two_sigma is the fraction of all errors within two estimated standard deviations.
  /// largest_in_sigma is the largest ratio of an error to its estimated standard deviation.
  double within_two_sigma = 0.0, largest_in_sigma = 0.0;
};
TrialSummary summary_of(const std::vector<Trial>& trials);

}  // namespace burnish
