#include "burnish/contact/loops.hpp"

#include <algorithm>
#include <random>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/model/state.hpp"
#include "contact/loop_rows.hpp"

namespace burnish {
namespace {

/// Length below which a row counts as zero, relative to the longest lever arms of the joints.
constexpr double least_row = independence_tolerance;

/// Returns the directions of each loop that belong to the rows `rows`.
std::vector<Directions> directions_of(const Model& model, const std::vector<int>& rows) {
  std::vector<Directions> result(model.loops.size());
  int row = 0;
  for (std::size_t i = 0; i < model.loops.size(); ++i)
    for (int d = 0; d < 6; ++d) {
      if (!model.loops[i].directions.has(d)) continue;
      if (std::binary_search(rows.begin(), rows.end(), row))
        result[i].bits = static_cast<std::uint8_t>(result[i].bits | (1U << d));
      ++row;
    }
  return result;
}

Eigen::MatrixXd picked(const Eigen::MatrixXd& J, const std::vector<int>& rows) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), J.cols());
  for (std::size_t i = 0; i < rows.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) = J.row(rows[i]);
  return result;
}

/// Returns Jacobians at up to five postures with closed loops: one near the neutral posture, the
/// others near random postures with a fixed seed. Skips postures whose projection fails.
std::vector<Eigen::MatrixXd> jacobians_on_the_loops(const Model& model, LoopRows& rows) {
  constexpr int postures = 5;
  std::mt19937_64 generator(20260101);
  std::vector<Eigen::MatrixXd> result;
  for (int i = 0; i < postures; ++i) {
    const Eigen::VectorXd from = i == 0 ? model.q_neutral : random_configuration(model, generator);
    const LoopProjection on = project_onto_loops(model, from);
    if (on.status != Status::Ok) continue;
    rows.update(on.q);
    result.push_back(rows.by_reach());
  }
  return result;
}

/// Returns directions whose rows are independent except at dead points of the mechanism. Each
/// sample posture proposes a choice of rows, which is rated at all postures. The result is the
/// choice whose lowest rating is highest.
std::vector<Directions> independent_directions(const Model& model) {
  LoopRows rows(model);
  const std::vector<Eigen::MatrixXd> jacobians = jacobians_on_the_loops(model, rows);
  std::vector<IndependentRows> choices;
  std::size_t rank = 0;
  for (const Eigen::MatrixXd& J : jacobians) {
    choices.push_back(independent_rows(J, least_row));
    rank = std::max(rank, choices.back().rows.size());
  }
  std::vector<int> best;
  double best_rating = 0.0;
  for (const IndependentRows& choice : choices) {
    if (choice.rows.size() < rank) continue;  // the posture is a dead point
    double rating = 1.0;
    for (std::size_t i = 0; i < jacobians.size(); ++i) {
      if (choices[i].rows.size() < rank) continue;
      const IndependentRows kept = independent_rows(picked(jacobians[i], choice.rows), least_row);
      rating = std::min(rating, kept.rows.size() < rank ? 0.0 : kept.weakest);
    }
    if (rating <= best_rating) continue;
    best = choice.rows;
    best_rating = rating;
  }
  if (best.empty()) {  // no sample posture closes the loops, so redundancy cannot be detected
    std::vector<Directions> all;
    for (const Loop& loop : model.loops) all.push_back(loop.directions);
    return all;
  }
  return directions_of(model, best);
}

ContactSpec contact_of(const Loop& loop, const LoopGains& gains) {
  ContactSpec spec{.name = loop.name, .tool = loop.second, .base = loop.first};
  spec.reference = Reference::surface(Eigen::Matrix3d::Identity());
  spec.directions = loop.directions;
  return spec.with_gains(gains.kp, gains.kd);
}

bool connects(const ContactSpec& contact, const Loop& loop) {
  return contact.tool == loop.second && contact.base == loop.first;
}

}  // namespace

LoopGains LoopGains::for_step(double step) {
  const double rate = 1.0 / std::max(step, 1e-3);
  return {rate * rate, rate};
}

std::vector<ContactSpec> loop_contacts(const Model& model, const LoopGains& gains,
                                       bool all_directions) {
  std::vector<ContactSpec> contacts;
  for (const Loop& loop : model.loops) contacts.push_back(contact_of(loop, gains));
  if (all_directions || contacts.empty()) return contacts;
  const std::vector<Directions> held = independent_directions(model);
  for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].directions = held[i];
  std::erase_if(contacts, [](const ContactSpec& contact) { return contact.directions.bits == 0; });
  return contacts;
}

std::vector<ContactSpec> with_loops(const Model& model, std::vector<ContactSpec> contacts,
                                    const LoopGains& gains) {
  if (model.loops.empty()) return contacts;
  for (const ContactSpec& contact : contacts)
    for (const Loop& loop : model.loops)
      if (contact.name == loop.name && !connects(contact, loop))
        throw Error("contact " + in_quotes(contact.name) +
                    " has the same name as a loop, but connects other frames; wanted another name");
  for (ContactSpec& loop : loop_contacts(model, gains)) {
    const auto same = [&](const ContactSpec& contact) { return contact.name == loop.name; };
    if (std::none_of(contacts.begin(), contacts.end(), same)) contacts.push_back(std::move(loop));
  }
  return contacts;
}

bool is_loop(const Model& model, const ContactSpec& contact) {
  return std::any_of(model.loops.begin(), model.loops.end(), [&](const Loop& loop) {
    return contact.name == loop.name && connects(contact, loop);
  });
}

LoopFreedom loop_freedom(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& q) {
  check_configuration(model, q);
  LoopRows rows(model);
  rows.update(q);
  const std::vector<int> independent = independent_rows(rows.by_reach(), least_row).rows;
  LoopFreedom result;
  result.rows = rows.rows();
  result.rank = static_cast<int>(independent.size());
  result.freedom = model.nv - result.rank;
  const std::vector<Directions> held = directions_of(model, independent);
  for (std::size_t i = 0; i < model.loops.size(); ++i) {
    const Loop& loop = model.loops[i];
    const Directions redundant{static_cast<std::uint8_t>(loop.directions.bits & ~held[i].bits)};
    if (redundant.bits != 0) result.redundant.push_back({loop.name, redundant});
  }
  return result;
}

std::string LoopFreedom::text() const {
  std::string lines;
  for (const RedundantLoop& of : redundant) {
    lines += of.loop + ":";
    const char* before = " ";
    for (int d = 0; d < 6; ++d)
      if (of.directions.has(d)) {
        lines += before + std::string(direction_names[to_size(d)]);
        before = ", ";
      }
    lines += " redundant\n";
  }
  return lines;
}

}  // namespace burnish
