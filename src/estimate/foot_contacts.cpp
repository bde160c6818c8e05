#include "burnish/estimate/foot_contacts.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "estimate/descriptions.gen.hpp"

namespace burnish {
namespace {

/// Throws Error if noise of the smoothed force could switch a contact. A first-order low-pass has
/// the two-sided noise bandwidth 1/(2 smoothing). White noise after this low-pass has the standard
/// deviation density / sqrt(2 smoothing).
void check_noise(const FootContactOptions& options, double weight) {
  if (options.smoothing == 0.0) return;
  const double deviation = options.force_noise / std::sqrt(2.0 * options.smoothing);
  const double gap = (options.touch - options.lift) * weight;
  if (4.0 * deviation <= gap) return;
  throw Error("foot contacts: force_noise of " + number(options.force_noise) +
              " N/sqrt(Hz), smoothed over " + number(options.smoothing) +
              " s, has a standard deviation of " + number(deviation) + " N; wanted at most " +
              number(0.25 * gap) + " N, a quarter of the difference between 'touch' and 'lift' (" +
              number(gap) + " N)");
}

}  // namespace

FootContacts::FootContacts(const Model& model, int feet, const FootContactOptions& options)
    : smoothing_(options.smoothing) {
  check_ranges(description_of(&options), &options,
               [](const std::string& entry) { return "foot contacts: " + in_quotes(entry); });
  if (feet < 1 || feet > 32)
    throw Error("foot contacts: " + std::to_string(feet) + " feet; wanted 1 to 32");
  if (!(options.lift < options.touch))
    throw Error("foot contacts: 'lift' is " + number(options.lift) + " and 'touch' is " +
                number(options.touch) + "; wanted lift below touch");
  const double weight = model.total_mass() * model.gravity.norm();
  check_noise(options, weight);
  touch_ = options.touch * weight;
  lift_ = options.lift * weight;
  forces_.setZero(feet);
}

void FootContacts::reset(Feet standing) noexcept {
  forces_.setZero();
  started_ = false;
  standing_ = standing;
}

Status FootContacts::update(const ConstVectorRef& normal_forces, double dt) noexcept {
  if (normal_forces.size() != forces_.size()) return Status::WrongSize;
  if (!normal_forces.allFinite() || !(dt > 0.0) || !std::isfinite(dt)) return Status::NotFinite;
  const double weight = started_ && smoothing_ > 0.0 ? -std::expm1(-dt / smoothing_) : 1.0;
  started_ = true;
  forces_ += weight * (normal_forces - forces_);
  for (Eigen::Index k = 0; k < forces_.size(); ++k) {
    const Feet bit = Feet{1} << k;
    if (forces_[k] > touch_) standing_ |= bit;
    if (forces_[k] < lift_) standing_ &= ~bit;
  }
  return Status::Ok;
}

}  // namespace burnish
