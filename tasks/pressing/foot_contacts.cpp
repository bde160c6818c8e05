#include "pressing/foot_contacts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/sentence.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/derivatives/diagnosis.hpp"

namespace burnish::pressing {
namespace {

/// A constraint row counts as dependent on the preceding rows if the ratio of its independent
/// component to its length is below this limit. Dependent rows have ratios up to 1e-4, because
/// soles in found postures are level to 1e-4 rad. Rows along which the leg can move its foot have
/// ratios of at least 0.05.
constexpr double min_independent_fraction = 3e-3;

Directions held_by(const Standing& standing) {
  return standing.has_soles() ? Directions::all() : Directions::linear();
}

Directions without(Directions directions, const std::string& left_out) {
  directions.bits = static_cast<std::uint8_t>(directions.bits & ~Directions::parse(left_out).bits);
  return directions;
}

struct DirectionWords {
  std::uint8_t bit;
  const char* words;
};
std::array<DirectionWords, 6> direction_words() {
  const auto bit = [](const char* name) { return Directions::parse(name).bits; };
  return {{{bit("x"), "moving along x"},
           {bit("y"), "moving along y"},
           {bit("z"), "moving along z"},
           {bit("rx"), "turning about x"},
           {bit("ry"), "turning about y"},
           {bit("rz"), "turning about z"}}};
}

}  // namespace

std::vector<ContactSpec> foot_contacts(const Model& model, const Standing& standing,
                                       const Eigen::VectorXd& q) {
  std::vector<ContactSpec> feet;
  for (const std::string& frame : standing.feet) {
    ContactSpec contact{.name = frame, .tool = frame, .directions = held_by(standing)};
    contact.reference = Reference::centered();
    feet.push_back(contact.with_gains(0.0, standing.contact_kd));
  }
  if (feet.empty()) return feet;
  // Puts loops before feet: diagnose() reports a row as redundant if the preceding rows imply it.
  std::vector<ContactSpec> all = loop_contacts(model);
  all.insert(all.end(), feet.begin(), feet.end());
  const ContactSet set(model, all);
  for (const RedundantRow& row : diagnose(model, set, q, {}, min_independent_fraction).redundant)
    for (ContactSpec& foot : feet)
      if (foot.name == row.contact) foot.directions = without(foot.directions, row.direction);
  return feet;
}

std::string directions_left_out(const Standing& standing, const std::vector<ContactSpec>& feet) {
  std::string text;
  for (const ContactSpec& foot : feet) {
    const Directions missing = without(held_by(standing), foot.directions.text());
    for (const auto& [bit, words] : direction_words())
      if ((missing.bits & bit) != 0)
        text += std::string(text.empty() ? "" : ", ") + words + " of " + in_quotes(foot.name);
  }
  return text;
}

}  // namespace burnish::pressing
