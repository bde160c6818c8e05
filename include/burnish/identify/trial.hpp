// How well an identification does: a payload that is drawn, carried in simulation and identified.
#pragma once

#include "burnish/identify/excitation.hpp"

namespace burnish {

/// 0.5 to 3 kg, its centre within a decimetre or so of the frame, with the inertia of an ellipsoid
/// of 3 to 10 cm.
Payload drawn_payload(const std::string& frame, std::uint64_t seed);

struct Trial {
  Payload carried;
  Identification found;
  Vector10 error = Vector10::Zero();  ///< of EstimatedInertia::values
  std::vector<std::string> warnings;  ///< sentences of check_followed()
};

/// The payload of that seed along the motion, with the seed's noise; found in `spec.payload`.
/// Throws Error as record_motion(), check_followed() and identify() do.
Trial try_identification(const Model& model, const Excitation& motion,
                         const Disturbances& disturbances, const IdentificationSpec& spec,
                         std::uint64_t seed);

/// What many trials show together.
struct TrialSummary {
  int trials = 0;
  double mass_error = 0.0;    ///< largest, as a share of the mass
  double centre_error = 0.0;  ///< largest distance, m
  Vector10 rms_error = Vector10::Zero(), rms_sigma = Vector10::Zero();
  /// Of all errors of all trials: the share within two stated standard deviations, and the largest
  /// in such deviations.
  double within_two_sigma = 0.0, largest_in_sigma = 0.0;
};
TrialSummary summary_of(const std::vector<Trial>& trials);

}  // namespace burnish
