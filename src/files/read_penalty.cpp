#include "files/read_penalty.hpp"

#include <cmath>
#include <limits>

namespace burnish::files {
namespace {

/// Sets `limits` to the robot's limits, with each range scaled by `fraction` about its centre.
void set_robot_limits(const ocp::ResidualRows& rows, double fraction, const Reader& reader,
                      RowLimits& limits) {
  if (rows.lower.size() == 0)
    reader.refuse("the robot states no limits for this residual; wanted 'lower' or 'upper'");
  limits = {rows.lower, rows.upper};
  for (Eigen::Index i = 0; i < rows.lower.size(); ++i) {
    const double middle = 0.5 * (rows.lower[i] + rows.upper[i]);
    if (!std::isfinite(middle)) continue;
    limits.lower[i] = middle + fraction * (rows.lower[i] - middle);
    limits.upper[i] = middle + fraction * (rows.upper[i] - middle);
  }
}

RowLimits read_penalty_limits(const ocp::ResidualRows& rows, const Reader& reader, bool log) {
  if (reader.is("limits")) {
    RowLimits limits;
    set_robot_limits(rows, 1.0, reader, limits);
    return limits;
  }
  reader.allow_only(log ? std::vector<std::string>{"lower", "upper", "limits", "width"}
                        : std::vector<std::string>{"lower", "upper", "limits"});
  const RowLimits limits = read_limits(rows, reader);
  if (limits.lower.size() == 0 && limits.upper.size() == 0)
    reader.refuse("the penalty has no limits; wanted 'lower', 'upper' or 'limits'");
  return limits;
}

}  // namespace

RowLimits read_limits(const ocp::ResidualRows& rows, const Reader& reader) {
  RowLimits limits;
  if (const auto fraction = reader.find("limits"))
    set_robot_limits(rows, fraction->positive(), *fraction, limits);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (const auto lower = reader.find("lower"))
    limits.lower = read_rows(*lower, rows.groups, -infinity);
  if (const auto upper = reader.find("upper"))
    limits.upper = read_rows(*upper, rows.groups, infinity);
  return limits;
}

Penalty read_penalty(const ocp::ResidualRows& rows, const Reader& reader) {
  Penalty penalty;
  if (!reader.is_map()) {
    penalty.kind = reader.named([&] { return parse_penalty(reader.text()); });
    if (penalty.kind != Penalty::Kind::Quadratic)
      reader.refuse(
          "the penalty has no parameters; wanted a map, such as {barrier: {lower: 0}} or "
          "{smooth_absolute: 0.01}");
    return penalty;
  }
  reader.allow_only({"quadratic", "barrier", "smooth_absolute", "log_barrier"});
  const auto items = reader.items();
  if (items.size() != 1)
    reader.refuse("the map has " + std::to_string(items.size()) + " penalties; wanted one penalty");
  const auto& [name, value] = items.front();
  penalty.kind = parse_penalty(name);
  if (penalty.kind == Penalty::Kind::Quadratic)
    value.refuse("the quadratic penalty has no parameters; wanted the word 'quadratic' alone");
  if (penalty.kind == Penalty::Kind::SmoothAbsolute) {
    penalty.width = value.positive();
    return penalty;
  }
  const bool log = penalty.kind == Penalty::Kind::LogBarrier;
  const RowLimits limits = read_penalty_limits(rows, value, log);
  penalty.lower = limits.lower;
  penalty.upper = limits.upper;
  if (log) penalty.width = value["width"].positive();
  return penalty;
}

}  // namespace burnish::files
