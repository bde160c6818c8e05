// Conversion of a trace to a motion record: positions and torques.
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/sentence.hpp"
#include "burnish/identify/identification.hpp"
#include "identify/even_times.hpp"
#include "identify/joint_angles.hpp"

namespace burnish {
namespace {

using identify_detail::is_circle;

/// Prefixes of position columns; measured positions have priority.
constexpr std::array<const char*, 2> position_prefixes{"measured_q_", "q_"};

/// Returns the column with the angle of a continuous joint; none if the trace has cosine and sine.
std::optional<std::string> angle_column(const Trace& trace, const std::string& joint) {
  bool has_part = false;
  for (const char* prefix : position_prefixes) {
    const std::string name = prefix + joint;
    const bool has_cos = trace.has(name + ".cos"), has_sin = trace.has(name + ".sin");
    if (has_cos && has_sin) return {};
    if (trace.has(name)) return name;
    has_part = has_part || has_cos || has_sin;
  }
  if (has_part) return {};  // position_column() reports the missing column
  throw Error("the record has no position of the continuous joint " + in_quotes(joint) +
              "; wanted its angle in rad as " + in_quotes("q_" + joint) + ", or " +
              in_quotes("q_" + joint + ".cos") + " and " + in_quotes("q_" + joint + ".sin"));
}

/// Returns the column `measured_q_...` of an entry of q, or `q_...` if the trace lacks it.
Trace::Column position_column(const Trace& trace, const std::string& entry) {
  const std::string measured = position_prefixes[0] + entry;
  return trace.column(trace.has(measured) ? measured : position_prefixes[1] + entry);
}

/// Returns q with an angle for each continuous joint.
RowMatrix angles_of(const Model& angles, const Trace& trace) {
  RowMatrix q(trace.rows(), angles.nq);
  for (int k = 0; k < angles.nq; ++k) q.col(k) = position_column(trace, angles.q_name(k));
  return q;
}

/// Returns q in the format of the model.
RowMatrix entries_of(const Model& model, const Trace& trace) {
  RowMatrix q(trace.rows(), model.nq);
  for (const Joint& joint : model.joints) {
    const std::optional<std::string> angle =
        is_circle(joint) ? angle_column(trace, joint.name) : std::nullopt;
    if (angle) {
      const Eigen::ArrayXd values = trace.column(*angle);
      q.col(joint.q_index) = values.cos();
      q.col(joint.q_index + 1) = values.sin();
      continue;
    }
    for (int k = joint.q_index; k < joint.q_index + joint.nq; ++k)
      q.col(k) = position_column(trace, model.q_name(k));
  }
  return q;
}

}  // namespace

MotionRecord motion_record(const Model& model, const Trace& trace) {
  const Eigen::VectorXd time = trace.column("time");
  // Angles are not converted to cosines, in which a wrong unit would no longer be visible.
  bool any_circle = false, all_angles = true;
  for (const Joint& joint : model.joints) {
    if (!is_circle(joint)) continue;
    any_circle = true;
    all_angles = angle_column(trace, joint.name).has_value() && all_angles;
  }
  const bool by_angles = any_circle && all_angles;
  const Model held = by_angles ? identify_detail::angle_model(model) : model;
  MotionRecord record;
  record.q = by_angles ? angles_of(held, trace) : entries_of(model, trace);
  record.tau.resize(time.size(), model.nv);
  for (int k = 0; k < model.nv; ++k) {
    const std::string measured = "tau_measured_" + model.v_name(k);
    record.tau.col(k) = trace.column(trace.has(measured) ? measured : "tau_" + model.v_name(k));
  }
  identify_detail::make_even(held, time, record);
  return record;
}

}  // namespace burnish
