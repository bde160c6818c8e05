#include "ocp/row_names.hpp"

#include "ocp/friction_pyramid.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish::ocp {
namespace {
struct RowNames {
  const Problem& problem;
  const CompiledTerm& term;
  using Names = std::vector<std::string>;
  static Names directions(int first, int count) {
    return {direction_names.begin() + first, direction_names.begin() + first + count};
  }
  Names operator()(const StateDifference&) const { return problem.state_names(); }
  Names operator()(const Selection& r) const {
    Names names;
    for (const int entry : r.entries) {
      const bool of_actuators =
          r.source == Selection::Source::U || r.source == Selection::Source::TorqueState;
      names.push_back(r.source == Selection::Source::Q ? problem.model().q_name(entry)
                      : of_actuators ? problem.control_names()[static_cast<std::size_t>(entry)]
                                     : problem.model().v_name(entry));
    }
    return names;
  }
  Names operator()(const TorqueRate& r) const {
    Names names;
    for (const int entry : r.entries)
      names.push_back(problem.control_names()[static_cast<std::size_t>(entry)]);
    return names;
  }
  Names operator()(const FramePositionError&) const { return directions(0, 3); }
  Names operator()(const FrameDistance&) const { return {"distance"}; }
  Names operator()(const FrameRotationError&) const { return directions(3, 3); }
  Names operator()(const FrameInclinationError&) const { return {"lead", "tilt"}; }
  Names operator()(const FrameHeightError&) const { return {"height"}; }
  Names held(int contact) const {
    Names names;
    const auto& contacts = ProblemInside::of(problem).compiled.contacts.contacts();
    for (const int d : contacts[static_cast<std::size_t>(contact)].directions)
      names.emplace_back(direction_names[static_cast<std::size_t>(d)]);
    return names;
  }
  Names operator()(const OwnForceError& r) const { return held(r.contact); }
  Names operator()(const ForceRate& r) const { return held(r.contact); }
  Names operator()(const ConeMargin&) const { return cone_row_names(0); }
  Names operator()(const PyramidMargin& r) const {
    return cone_row_names(static_cast<int>(r.sides.size()));
  }
  Names operator()(const PressureMargin& r) const {
    Names names{"x_above", "x_below", "y_below", "y_above"};
    if (r.has_friction)
      for (const std::string& name : turning_row_names()) names.push_back(name);
    return names;
  }
  Names operator()(const ComError&) const { return directions(0, 3); }
  Names operator()(const SupportMargin& r) const {
    Names names;
    for (std::size_t i = 0; i < r.edges.size(); ++i) names.push_back("edge_" + std::to_string(i));
    return names;
  }
  Names operator()(const CustomResidual&) const {
    Names names;
    for (int i = 0; i < term.rows; ++i) names.push_back("row " + std::to_string(i));
    return names;
  }
  Names operator()(const auto& /*six rows*/) const { return directions(0, 6); }
};
}  // namespace

std::vector<std::string> row_names(const Problem& problem, const CompiledTerm& term) {
  return std::visit(RowNames{problem, term}, term.residual);
}

}  // namespace burnish::ocp
