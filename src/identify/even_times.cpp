#include "identify/even_times.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double even_within = 0.01;  // Largest jitter of even times [periods]
/// Longest gap that a cubic bridges [s]. The error for a motion of 4 Hz is 1e-3 of its amplitude.
constexpr double max_gap = 0.03;
constexpr double min_bridged_periods = 3.5;  // Gaps up to this length are always bridged [periods]
constexpr double missing_above = 1.75;       // Steps above this length miss a sample [periods]
constexpr double max_missing_fraction = 0.05;  // Largest fraction of missing samples
/// Minimum distance of a cubic's outer node from its inner neighbour; limits noise [periods].
constexpr double node_distance = 0.5;

std::string ms_text(double seconds) { return number(1e3 * seconds) + " ms"; }

void check_order(const Eigen::Ref<const Eigen::VectorXd>& time) {
  if (time.size() < 2) throw Error("the record has fewer than two samples");
  if (!time.allFinite()) throw Error("'time' contains a NaN or an infinity; wanted seconds");
  for (Eigen::Index i = 1; i < time.size(); ++i) {
    const std::string sample = "sample " + std::to_string(i);
    if (time[i] == time[i - 1])
      throw Error(sample + " of the record repeats the time of the sample before, " +
                  number(time[i]) + " s; wanted increasing times");
    if (!(time[i] > time[i - 1]))
      throw Error("the record's time does not increase: " + number(time[i]) + " s at " + sample +
                  " after " + number(time[i - 1]) + " s; wanted rows in the order of their times");
  }
}

double middle_of(Eigen::VectorXd values) {
  auto* const middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle;
}

/// Deviation of a record's times from even times.
struct Unevenness {
  double period = 0.0;  ///< Sampling period [s]
  double jitter = 0.0;  ///< Largest deviation of a step without a gap from `period` [s]
  double gap = 0.0;     ///< Largest step over missing samples [s]; 0: no sample is missing
  double gap_at = 0.0;  ///< Time of the sample before the gap [s]
  Eigen::Index missing = 0;
};

/// Returns the number of samples that are missing within a step of `step` periods.
Eigen::Index missing_in(double step) {
  const double samples = std::floor(step + 1.0 - missing_above);
  return std::max<Eigen::Index>(0, static_cast<Eigen::Index>(samples));
}

Unevenness unevenness(const Eigen::VectorXd& time, const Eigen::VectorXd& steps) {
  Unevenness result;
  const double usual = middle_of(steps);
  for (Eigen::Index i = 0; i < steps.size(); ++i) {
    const Eigen::Index missing = missing_in(steps[i] / usual);
    result.missing += missing;
    if (missing == 0 || steps[i] <= result.gap) continue;
    result.gap = steps[i];
    result.gap_at = time[i];
  }
  result.period =
      (time[time.size() - 1] - time[0]) / static_cast<double>(steps.size() + result.missing);
  for (const double step : steps)
    if (missing_in(step / usual) == 0)
      result.jitter = std::max(result.jitter, std::abs(step - result.period));
  return result;
}

void check_gaps(const Unevenness& uneven, Eigen::Index samples) {
  if (uneven.gap > std::max(max_gap, min_bridged_periods * uneven.period))
    throw Error("the record has a gap of " + ms_text(uneven.gap) + " that begins at " +
                number(uneven.gap_at) + " s; wanted gaps of at most " +
                ms_text(std::max(max_gap, 3.0 * uneven.period)) +
                ", or a part of the record without this gap");
  const double fraction =
      static_cast<double>(uneven.missing) / static_cast<double>(samples + uneven.missing);
  if (fraction > max_missing_fraction)
    throw Error("the record lacks " + number(100.0 * fraction) +
                " % of the samples expected at a period of " + ms_text(uneven.period) +
                "; wanted at most " + number(100.0 * max_missing_fraction) + " %");
}

/// Indices of up to four samples about a time: the two adjacent samples and one beyond each.
struct Nodes {
  Eigen::Index at[4] = {};
  int count = 0;
};
Nodes nodes_about(const Eigen::VectorXd& time, double t, double distance) {
  const auto above = std::upper_bound(time.data(), time.data() + time.size(), t);
  const Eigen::Index after = std::clamp<Eigen::Index>(above - time.data(), 1, time.size() - 1);
  Nodes nodes;
  Eigen::Index outer = after - 2;
  while (outer >= 0 && time[after - 1] - time[outer] < distance) --outer;
  if (outer >= 0) nodes.at[nodes.count++] = outer;
  nodes.at[nodes.count++] = after - 1;
  nodes.at[nodes.count++] = after;
  outer = after + 1;
  while (outer < time.size() && time[outer] - time[after] < distance) ++outer;
  if (outer < time.size()) nodes.at[nodes.count++] = outer;
  return nodes;
}

/// Evaluates the polynomial through the nodes at t. An `angle` turns the shorter way between nodes.
double between(const Eigen::VectorXd& time, const RowMatrix& values, Eigen::Index column,
               const Nodes& nodes, double t, bool angle) {
  constexpr double turn = 2.0 * std::numbers::pi;
  double result = 0.0, before = 0.0;
  for (int i = 0; i < nodes.count; ++i) {
    double value = values(nodes.at[i], column);
    if (angle && i > 0) value -= turn * std::round((value - before) / turn);
    before = value;
    double weight = 1.0;
    for (int k = 0; k < nodes.count; ++k)
      if (k != i) weight *= (t - time[nodes.at[k]]) / (time[nodes.at[i]] - time[nodes.at[k]]);
    result += weight * value;
  }
  return result;
}

void resample(const Model& model, const Eigen::VectorXd& time, MotionRecord& record) {
  std::vector<bool> turns(to_size(model.nq), false);
  for (const Joint& joint : model.joints)
    if (joint.kind == JointKind::Revolute && joint.nq == 1) turns[to_size(joint.q_index)] = true;
  const double span = time[time.size() - 1] - time[0];
  const auto rows = static_cast<Eigen::Index>(std::floor(span / record.period + 1e-6)) + 1;
  RowMatrix q(rows, model.nq), tau(rows, model.nv);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double t = time[0] + static_cast<double>(i) * record.period;
    const Nodes nodes = nodes_about(time, t, node_distance * record.period);
    for (int k = 0; k < model.nq; ++k)
      q(i, k) = between(time, record.q, k, nodes, t, turns[to_size(k)]);
    for (int k = 0; k < model.nv; ++k) tau(i, k) = between(time, record.tau, k, nodes, t, false);
  }
  record.q = std::move(q);
  record.tau = std::move(tau);
}

}  // namespace

void make_even(const Model& model, const Eigen::Ref<const Eigen::VectorXd>& time,
               MotionRecord& record) {
  check_order(time);
  const Eigen::Index n = time.size();
  const Eigen::VectorXd steps = time.tail(n - 1) - time.head(n - 1);
  const Unevenness uneven = unevenness(time, steps);
  check_gaps(uneven, n);
  record.first_time = time[0];
  if (uneven.missing == 0 && uneven.jitter <= even_within * uneven.period) {
    record.period = (time[n - 1] - time[0]) / static_cast<double>(n - 1);
    return;
  }
  record.period = uneven.period;
  resample(model, time, record);
  std::string what;
  if (uneven.jitter > even_within * uneven.period)
    what = "steps of 'time' differ from " + ms_text(uneven.period) + " by up to " +
           ms_text(uneven.jitter);
  if (uneven.missing > 0)
    what += (what.empty() ? "" : ", and ") + std::to_string(uneven.missing) +
            (uneven.missing == 1 ? " sample is" : " samples are") +
            " missing (the longest gap lasts " + ms_text(uneven.gap) + " and begins at " +
            number(uneven.gap_at) + " s)";
  record.warnings.push_back(what + "; the record is resampled every " + ms_text(record.period) +
                            " by cubic interpolation");
}

}  // namespace burnish::identify_detail
