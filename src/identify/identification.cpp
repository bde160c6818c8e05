#include "burnish/identify/identification.hpp"

#include <algorithm>
#include <cmath>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/model/state.hpp"
#include "identify/estimate.hpp"
#include "identify/faults.hpp"
#include "identify/joint_angles.hpp"
#include "identify/misfit.hpp"
#include "identify/record_check.hpp"
#include "identify/smoothed_motion.hpp"

namespace burnish {
namespace {

using identify_detail::LogCholesky;
using identify_detail::Matrix10;
using identify_detail::Unknown;

/// Returns the prior of a payload in a hand: about 0.5 to 3 kg, within decimetres of the frame.
Unknown unknown_payload(const Model& model, const std::string& name) {
  const Frame& frame = frame_on_body("payload", model, name);
  Unknown result{name, frame.body, inertia_transform(frame.placement), {}, {}};
  InertiaSpec thing;
  thing.mass = 1.0;
  constexpr double radius = 0.04;  // Radius of gyration of the prior [m]
  thing.inertia_at_com = 2.0 * radius * radius * Eigen::Matrix3d::Identity();
  result.eta = LogCholesky::of(thing);
  result.sigma << 1.0, 0.5, 0.5, 0.5, 0.02, 0.02, 0.02, 0.15, 0.15, 0.15;
  return result;
}

/// Returns the prior of a link's own inertia: the nominal inertia with a relative uncertainty.
Unknown unknown_body(const Model& model, const std::string& link) {
  const Frame& frame = frame_on_body("bodies", model, link);
  Unknown result{link, frame.body, inertia_transform(frame.placement), {}, {}};
  const InertiaSpec own = placed(inertia_of_body(model, frame.body), frame.placement.inverse());
  result.eta = LogCholesky::of(own);
  const double radius = std::exp(result.eta.segment<3>(1).maxCoeff());
  result.sigma << 0.5, 0.5, 0.5, 0.5, 0.3 * radius, 0.3 * radius, 0.3 * radius, 0.1, 0.1, 0.1;
  result.replaces = true;
  return result;
}

std::vector<Unknown> unknowns_of(const Model& model, const IdentificationSpec& spec) {
  if (spec.bodies.empty()) return {unknown_payload(model, spec.payload)};
  std::vector<Unknown> result;
  for (const std::string& link : spec.bodies) {
    result.push_back(unknown_body(model, link));
    for (std::size_t i = 0; i + 1 < result.size(); ++i)
      if (result[i].body == result.back().body)
        throw Error("bodies: " + in_quotes(result[i].frame) + " and " + in_quotes(link) +
                    " are fixed to each other and form one body; wanted one of them");
  }
  return result;
}

/// Returns d(values)/d(eta) by central differences; the function is smooth and cheap.
Matrix10 derivative_of_values(const Vector10& eta) {
  Matrix10 result;
  constexpr double step = 1e-5;
  for (int k = 0; k < 10; ++k) {
    const auto at = [&](double h) {
      return estimate_values(inertia_of(LogCholesky::parameters(eta + h * Vector10::Unit(k))));
    };
    result.col(k) = (at(step) - at(-step)) / (2.0 * step);
  }
  return result;
}

EstimatedInertia estimated(const Unknown& before, const Vector10& eta, const Matrix10& covariance) {
  EstimatedInertia result;
  result.frame = before.frame;
  result.inertia = inertia_of(LogCholesky::parameters(eta));
  result.values = estimate_values(result.inertia);
  const Matrix10 D = derivative_of_values(eta);
  result.sigma = (D * covariance * D.transpose()).diagonal().cwiseSqrt();
  const Matrix10 prior = before.sigma.cwiseAbs2().asDiagonal();
  result.prior_sigma = (D * prior * D.transpose()).diagonal().cwiseSqrt();
  return result;
}

void warn_of(Identification& result) {
  constexpr double max_delay = 0.02;  // Largest delay without a warning; chosen by hand [s]
  if (std::abs(result.delay.value) > max_delay)
    result.warnings.push_back("the torques are " + number(1e3 * result.delay.value) +
                              " ms behind the positions, and this delay is not corrected; were "
                              "torques and positions measured at the same instants?");
  if (!result.converged)
    result.warnings.emplace_back(
        "the estimate did not converge: the motion hardly distinguishes the "
        "bodies; wanted fewer bodies");
  for (const EstimatedInertia& one : result.inertias) {
    const std::vector<int> missing = one.not_shown();
    if (missing.empty()) continue;
    std::string list;
    for (const int i : missing)
      list += (list.empty() ? "" : ", ") + std::string(estimate_names[to_size(i)]);
    result.warnings.push_back("the motion does not determine these parameters of " +
                              in_quotes(one.frame) + ": " + list +
                              "; their estimates come mostly from the prior");
  }
}

/// Returns the phrases, each preceded by "; ".
std::string joined(const std::vector<std::string>& phrases) {
  std::string text;
  for (const std::string& phrase : phrases) text += "; " + phrase;
  return text;
}

/// Throws Error if the record cannot be right, and warns if it may be wrong.
void judge(Identification& result, const identify_detail::Misfit& misfit,
           const std::optional<identify_detail::Fault>& fault,
           const std::vector<std::string>& oddities, const std::string& column) {
  // Maximum ratio of the residual to the torques of the unknown masses, chosen by hand. A residual
  // of this size can hide a mass error of about 30 %.
  constexpr double max_unexplained = 0.3;
  if (!misfit.is_suspicious) {
    for (const std::string& oddity : oddities)
      result.warnings.push_back(oddity + "; the torques still fit the motion");
    return;
  }
  const std::string left = in_quotes(column) + " has a residual of " +
                           number(result.rms_after[misfit.joint]) +
                           " Nm (N) rms, but noise explains only " +
                           number(result.rms_expected[misfit.joint]) + " Nm (N)";
  const std::string guess = fault ? "; " + fault->sentence : std::string();
  if (fault && !fault->is_mild)
    throw Error("identify: the torques do not fit the motion: " + left + guess + joined(oddities));
  if (!(misfit.unexplained < max_unexplained))
    throw Error(
        "identify: the torques do not fit the motion: " + left + guess + joined(oddities) +
        (fault ? ""
               : "; wanted positions in rad (m) and torques in Nm (N), recorded on this robot "
                 "with one payload and without contacts"));
  const char* enlarged =
      result.coulomb.empty() ? ", so the standard deviations of the estimates are enlarged" : "";
  result.warnings.push_back(left + enlarged + guess + joined(oddities));
}

/// Returns the record without the samples before spec.start, which are not used.
MotionRecord cropped(const MotionRecord& record, Eigen::Index left_out) {
  MotionRecord result = record;
  result.q = record.q.bottomRows(record.q.rows() - left_out);
  result.tau = record.tau.bottomRows(record.tau.rows() - left_out);
  result.first_time += static_cast<double>(left_out) * record.period;
  return result;
}

/// Writes the results, converted from the coordinates of the regression.
void fill(Identification& result, const std::vector<Unknown>& unknowns,
          const identify_detail::Regression& regression, const identify_detail::Fit& fit) {
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(10 * i);
    result.inertias.push_back(
        estimated(unknowns[i], fit.x.segment<10>(at), fit.covariance.block<10, 10>(at, at)));
  }
  const auto estimates = [&](int first) {
    std::vector<Estimate> list;
    for (int k = 0; first >= 0 && k < regression.nv; ++k)
      list.push_back({fit.x[first + k], std::sqrt(fit.covariance(first + k, first + k))});
    return list;
  };
  result.viscous = estimates(regression.layout.viscous);
  result.coulomb = estimates(regression.layout.coulomb);
  result.armature = estimates(regression.layout.armature);
  result.offset = estimates(regression.layout.offset);
  if (const int k = regression.layout.delay; k >= 0)
    result.delay = {fit.x[k], std::sqrt(fit.covariance(k, k))};
}

/// Throws Error if standard deviations are not finite, because the motion does not determine the
/// parameters.
void check_finite(const identify_detail::Fit& fit) {
  if (fit.x.allFinite() && fit.covariance.allFinite() &&
      (fit.covariance.diagonal().array() >= 0.0).all())
    return;
  throw Error(
      "identify: the motion does not determine the parameters: their standard deviations are not "
      "finite; wanted a motion that excites the masses more, such as one that burnish identify "
      "--excite writes, or fewer bodies");
}

/// Runs identify() for a robot without continuous joints.
Identification identify_by_angles(const Model& model, const MotionRecord& record,
                                  const IdentificationSpec& spec) {
  using namespace identify_detail;
  Windows windows(model, record, spec);
  const std::vector<Unknown> unknowns = unknowns_of(model, spec);
  const auto left_out = static_cast<Eigen::Index>(spec.start / record.period);
  const CheckedRecord checked = checked_record(model, cropped(record, left_out));
  windows.first -= left_out;
  windows.samples -= left_out;
  const auto regression_over = [&](int half) {
    const SmoothedMotion motion(model, checked.record, windows, half);
    return Regression(model, motion, windows, unknowns, spec);
  };
  const Regression regression = regression_over(windows.motion);
  const Regression longer = regression_over(windows.longer);
  // The error of an acceleration from polynomials of degree five grows with the fourth power of the
  // window.
  const double growth = std::pow(static_cast<double>(windows.longer) / windows.motion, 4);
  const double fraction = 1.0 / (growth - 1.0);
  Fit fit = identify_detail::fit(regression);
  const Eigen::VectorXd expected = expected_rms(
      {model, checked.record, windows, regression, longer, fraction, spec.torque_noise}, fit.x);
  const Misfit misfit = misfit_of(regression, fit, expected);
  add_bias(regression, longer, fraction, fit);
  // Real friction differs from the estimated form, so with estimated friction a residual is normal.
  if (misfit.is_suspicious && !spec.friction) add_misfit(regression, fit);

  Identification result;
  result.samples = regression.samples;
  result.converged = fit.converged;
  result.rms_before = fit.rms_before;
  result.rms_after = fit.rms_after;
  result.rms_expected = expected;
  result.warnings = record.warnings;
  result.warnings.insert(result.warnings.end(), checked.warnings.begin(), checked.warnings.end());
  std::vector<std::string> oddities = beyond_limits(model, checked.record);
  oddities.insert(oddities.end(), checked.oddities.begin(), checked.oddities.end());
  for (const int k : checked.constant_torques)
    if (misfit.is_suspicious_at(k))
      throw Error("identify: " + in_quotes(tau_column(model, k)) + " is " +
                  number(checked.record.tau(0, k)) + " throughout, but the motion requires " +
                  number(fit.rms_after[k]) + " Nm (N) rms; is the torque sensor connected?");
  std::optional<Fault> fault;
  if (misfit.is_suspicious)
    fault = FaultSearch(model, checked.record, windows, unknowns, spec).best(fit.x, expected);
  fill(result, unknowns, regression, fit);
  judge(result, misfit, fault, oddities, tau_column(model, misfit.joint));
  check_finite(fit);
  warn_of(result);
  return result;
}

}  // namespace

Vector10 estimate_values(const InertiaSpec& inertia) {
  const Eigen::Matrix3d& I = inertia.inertia_at_com;
  Vector10 result;
  result << inertia.mass, inertia.com, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2);
  return result;
}

std::vector<int> EstimatedInertia::not_shown() const {
  std::vector<int> result;
  for (int i = 0; i < 10; ++i)
    if (!is_shown(i)) result.push_back(i);
  return result;
}

Identification identify(const Model& model, const MotionRecord& record,
                        const IdentificationSpec& spec) {
  using namespace identify_detail;
  const double before_start = spec.start / record.period;
  const bool has_start = before_start > 0.0 && before_start < static_cast<double>(record.q.rows());
  const auto first = has_start ? static_cast<Eigen::Index>(before_start) : 0;
  return identify_by_angles(angle_model(model), with_angles(model, record, first), spec);
}

}  // namespace burnish
