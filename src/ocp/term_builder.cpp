// Parts that several kinds of residuals share: targets, Jacobian columns, frames, references and
// contacts.
#include "ocp/term_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/model/state.hpp"
#include "dynamics/reference.hpp"

namespace burnish::ocp {

void TermBuilder::target(const Signal& signal, int size, const Eigen::VectorXd& fallback,
                         CompiledTerm::Load load) {
  term.signal = signal;
  if (signal.empty()) {
    if (fallback.size() == 0)
      refuse("the target is missing; wanted " + std::to_string(size) + " entries");
    term.signal = Signal(fallback);
  }
  if (term.signal.size() == 1 && size > 1 && term.signal.is_constant()) {
    Eigen::VectorXd one(1);
    term.signal.at(0.0, one);
    term.signal = Signal(Eigen::VectorXd::Constant(size, one[0]));
  }
  if (term.signal.size() != size)
    refuse("the target has " + std::to_string(term.signal.size()) + " entries; wanted " +
           std::to_string(size));
  if (term.signal.is_constant()) {
    Eigen::VectorXd value(size);
    term.signal.at(0.0, value);
    if (!value.allFinite()) refuse("the target holds a NaN or an infinity");
  }
  term.signal_size = size;
  term.load = load;
  term.target_size = load == CompiledTerm::Load::Rotation    ? 9
                     : load == CompiledTerm::Load::Placement ? 12
                                                             : size;
}

void TermBuilder::zero_target(const Signal& signal, int size) {
  target(signal, size, Eigen::VectorXd::Zero(size));
}

void TermBuilder::dense_block(int rows, std::vector<int> columns) {
  if (!columns.empty()) term.blocks.push_back({0, rows, std::move(columns), false});
}

std::vector<int> TermBuilder::all_columns() const {
  std::vector<int> columns(to_size(layout().nz()));
  std::iota(columns.begin(), columns.end(), 0);
  return columns;
}

std::vector<int> TermBuilder::columns(int first, const std::vector<int>& entries) {
  std::vector<int> result;
  for (const int k : entries) result.push_back(first + k);
  return result;
}

std::vector<int> TermBuilder::support_columns(int frame) const {
  std::vector<int> result;
  for (const MovingAxis& k : stage.frames[frame].support)
    result.push_back(layout().column_q() + k.v);
  return result;
}

int TermBuilder::frame(const std::string& name) {
  const auto found = std::find(stage.frame_names.begin(), stage.frame_names.end(), name);
  if (found != stage.frame_names.end()) return static_cast<int>(found - stage.frame_names.begin());
  try {
    stage.frames.push_back(compile_frame(problem.model, name));
  } catch (const Error& error) {
    refuse(error.what());
  }
  stage.frame_names.push_back(name);
  return static_cast<int>(stage.frames.size()) - 1;
}

TurningReference TermBuilder::turning(const Reference& reference, const CompiledFrame& tool,
                                      const CompiledFrame& base) {
  reference.check(where);
  try {
    TurningReference result{
        compile_reference(problem.model, reference.at(spec.start_time), tool, base)};
    result.turning = add_turning(reference, -1, "reference", stage);
    if (result.turning >= 0) result.is_aligned = false;
    const int term_index = static_cast<int>(stage.terms.size());
    result.followed = add_surface(reference, {.surface = {}, .term = term_index}, stage);
    return result;
  } catch (const Error& error) {
    refuse("reference: " + std::string(error.what()));
  }
}

FrameView TermBuilder::view(int frame, const Reference& reference) {
  const CompiledFrame& seen = stage.frames[frame];
  FrameView result;
  result.reference = turning(reference, seen, world_frame());
  const auto others = [&](int body) {
    return body == seen.body ? std::vector<MovingAxis>{} : moving_axes(problem.model, body);
  };
  result.origin = others(result.reference.origin_body);
  result.axes = others(result.reference.axes_body);
  std::set<int> entries;
  for (const std::span<const MovingAxis> moved :
       {std::span<const MovingAxis>(seen.support), std::span<const MovingAxis>(result.origin),
        std::span<const MovingAxis>(result.axes)})
    for (const MovingAxis& k : moved) entries.insert(k.v);
  result.entries.assign(entries.begin(), entries.end());
  return result;
}

WrenchView TermBuilder::wrench(int contact, const std::optional<Reference>& reference) {
  WrenchView result{contact, {}, {}};
  if (!reference) return result;
  const CompiledContact& compiled = problem.contacts.contacts()[contact];
  result.reference = turning(*reference, tool_of(compiled), base_of(compiled));
  wrench_entries(problem.tree, compiled, *result.reference, result.entries);
  return result;
}

int TermBuilder::surface() const {
  const int index = static_cast<int>(stage.terms.size());
  for (const CompiledSurface& followed : stage.surfaces)
    if (followed.term == index) return followed.target;
  return -1;
}

int TermBuilder::contact(const std::string& name) {
  int index = -1;
  try {
    index = problem.contacts.index(name);
  } catch (const Error& error) {
    refuse(error.what());
  }
  if (stage.impact) refuse("an impact stage has impulses, but no contact forces");
  if (stage.terminal && !layout().acts_from_state())
    refuse(
        "the terminal state has no control, so contact forces are unknown there; wanted a torque "
        "model with a cut-off, which adds the acting torques to the state");
  if (stage.active[to_size(index)] == 0)
    refuse("contact " + in_quotes(name) + " is not active in this stage, so it has no force");
  stage.solves_contacts = true;
  return index;
}

void TermBuilder::unit_quaternion(int first) const {
  if (!term.signal.is_constant()) return;
  Eigen::VectorXd value(term.signal.size());
  term.signal.at(0.0, value);
  const double length = value.segment(first, 4).norm();
  if (std::abs(length - 1.0) > 1e-6)
    refuse("the target's quaternion has length " + number(length) + "; wanted 1");
}

void TermBuilder::unit_configuration() const {
  if (!term.signal.is_constant()) return;
  Eigen::VectorXd value(term.signal.size());
  term.signal.at(0.0, value);
  try {
    check_configuration(problem.model, value.head(layout().nq), "the target");
  } catch (const Error& error) {
    refuse(error.what());
  }
}

}  // namespace burnish::ocp
