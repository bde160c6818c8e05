#include "identify/record_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "burnish/model/state.hpp"
#include "identify/signal_check.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double at_rest = 1e-3;           // Largest range of any joint of an arm at rest [rad, m]
constexpr int min_outliers = 3;            // Outlying samples accepted in a record of any length
constexpr double outlier_fraction = 1e-3;  // Fraction of samples that may be outliers

const Joint& joint_of_q(const Model& model, int entry) {
  for (const Joint& joint : model.joints)
    if (joint.nq > 0 && entry >= joint.q_index && entry < joint.q_index + joint.nq) return joint;
  throw Error("identify: q has no entry " + std::to_string(entry));
}
const char* unit_of_q(const Joint& joint) {
  return joint.kind == JointKind::Prismatic ? "m" : "rad";
}

void check_numbers(const Model& model, const MotionRecord& record) {
  const auto look = [&](const RowMatrix& values, const auto& name) {
    if (values.allFinite()) return;
    for (Eigen::Index i = 0; i < values.rows(); ++i)
      for (int k = 0; k < values.cols(); ++k)
        if (!std::isfinite(values(i, k)))
          throw Error("identify: " + in_quotes(name(model, k)) + " holds a NaN or an infinity at " +
                      time_text(record, i) + " (sample " + std::to_string(i) +
                      "); wanted a number in every row");
  };
  look(record.q, q_column);
  look(record.tau, tau_column);
}

/// Unwraps a turning angle and removes the wraps from `steps`. Returns the number of wraps.
int unwrap(Eigen::VectorXd& signal, Steps& steps, Eigen::Index& first) {
  std::vector<SuddenStep> left;
  int wraps = 0;
  for (const SuddenStep& step : steps.sudden) {
    const double turns = std::round(step.size / turn);
    if (turns == 0.0 || std::abs(step.size - turns * turn) > steps.tolerance) {
      left.push_back(step);
      continue;
    }
    if (wraps++ == 0) first = step.at;
    signal.tail(signal.size() - step.at).array() -= turns * turn;
  }
  steps.sudden = left;
  return wraps;
}

/// Shifts a turning angle by whole turns towards the middle of its limits, if it has limits.
void centre(Eigen::VectorXd& signal, double lower, double upper) {
  const double middle = 0.5 * (lower + upper);
  if (std::isfinite(middle)) signal.array() += turn * std::round((middle - signal.mean()) / turn);
}

/// Returns the outliers. At the start and at the end of a signal, a single step makes an outlier.
std::vector<Outlier> outliers_of(Steps& steps, Eigen::Index samples) {
  std::vector<Outlier> result = take_outliers(steps);
  constexpr Eigen::Index edge = 5;  // Length of the start and of the end [samples]
  std::vector<SuddenStep> left;
  for (const SuddenStep& step : steps.sudden) {
    if (step.at <= edge)
      result.push_back({0, step.at, std::abs(step.size)});
    else if (step.at >= samples - edge)
      result.push_back({step.at, samples - step.at, std::abs(step.size)});
    else
      left.push_back(step);
  }
  steps.sudden = left;
  return result;
}

/// Bridges the outliers of a column. Throws Error if there are too many of them.
void mend(CheckedRecord& checked, Eigen::VectorXd& signal, const std::vector<Outlier>& outliers,
          const std::string& column, const char* unit) {
  if (outliers.empty()) return;
  Eigen::Index count = 0;
  const Outlier* largest = outliers.data();
  for (const Outlier& one : outliers) {
    count += one.count;
    if (one.size > largest->size) largest = &one;
    bridge(signal, one);
  }
  const auto samples = static_cast<double>(signal.size());
  const std::string what = in_quotes(column) + " has outliers of up to " + number(largest->size) +
                           " " + unit + " in " + std::to_string(count) +
                           (count == 1 ? " sample, at " : " samples, the largest at ") +
                           time_text(checked.record, largest->at);
  if (static_cast<double>(count) > std::max<double>(min_outliers, outlier_fraction * samples))
    throw Error("identify: " + what + "; wanted outliers in at most " +
                number(100.0 * outlier_fraction) + " % of the samples: is a connection loose?");
  checked.warnings.push_back(
      what + (count == 1 ? "; this outlier is replaced" : "; these outliers are replaced") +
      " by interpolation");
}

std::string jump_sentence(const MotionRecord& record, const std::string& column,
                          const SuddenStep& step, const char* unit) {
  std::string guess =
      "was the encoder reset, are samples missing, or were two records joined there?";
  const auto near = [&](double size) { return std::abs(std::abs(step.size) - size) < 0.02 * size; };
  if (near(360.0)) guess = "is it an angle in degrees that wraps? wanted radians";
  if (near(180.0)) guess = "is it an angle in degrees that wraps at half a turn? wanted radians";
  if (near(0.5 * turn)) guess = "is it an angle that wraps at half a turn?";
  return "identify: " + in_quotes(column) + " jumps by " + number(step.size) + " " + unit + " at " +
         time_text(record, step.at) + " and stays at the new value; " + guess;
}

void check_positions(const Model& model, CheckedRecord& checked) {
  RowMatrix& q = checked.record.q;
  for (int k = 0; k < model.nq; ++k) {
    const Joint& joint = joint_of_q(model, k);
    if (joint.nq != 1) continue;
    const std::string column = q_column(model, k);
    Eigen::VectorXd signal = q.col(k);
    Steps steps = sudden_steps(signal);
    Eigen::Index first = 0;
    if (joint.kind == JointKind::Revolute)
      if (const int wraps = unwrap(signal, steps, first); wraps > 0) {
        centre(signal, model.q_lower[k], model.q_upper[k]);
        checked.warnings.push_back(in_quotes(column) + " wraps by 2 pi rad at " +
                                   std::to_string(wraps) +
                                   (wraps == 1 ? " sample, at " : " samples, first at ") +
                                   time_text(checked.record, first) + "; the angle is unwrapped");
      }
    mend(checked, signal, outliers_of(steps, signal.size()), column, unit_of_q(joint));
    if (!steps.sudden.empty())
      throw Error(jump_sentence(checked.record, column, steps.sudden.front(), unit_of_q(joint)));
    q.col(k) = signal;
  }
}

void check_torques(const Model& model, CheckedRecord& checked) {
  RowMatrix& tau = checked.record.tau;
  std::vector<std::string> still;
  for (int k = 0; k < model.nv; ++k) {
    const std::string column = tau_column(model, k);
    Eigen::VectorXd signal = tau.col(k);
    if ((signal.array() == signal[0]).all()) {
      still.push_back(column);
      checked.constant_torques.push_back(k);
    }
    Steps steps = sudden_steps(signal);
    mend(checked, signal, take_outliers(steps), column, "Nm (N)");
    tau.col(k) = signal;
  }
  if (static_cast<int>(still.size()) == model.nv)
    throw Error("identify: no torque ever changes, although joints move: " + in_quotes(still[0]) +
                " is " + number(tau(0, 0)) + " throughout; wanted measured torques");
  for (const std::string& column : still)
    checked.oddities.push_back(in_quotes(column) +
                               " never changes: is the torque sensor connected?");
}

/// Throws Error for a frozen reading: a joint that stops abruptly for a long time within a motion.
void check_frozen(const Model& model, CheckedRecord& checked) {
  constexpr double max_standstill = 0.1;      // Longest run of equal samples in a motion [s]
  constexpr Eigen::Index before = 10;         // readings beside a frozen run, for its speed
  constexpr double min_speed_fraction = 0.1;  // Fraction of the fastest speed over 10 samples
  // Smallest motion beside the run of a frozen encoder [quanta]. At a turning point with the
  // acceleration a, a joint also stays within one quantum for a time T, with quantum = a T^2 / 8.
  // If T is at least 20 samples (max_standstill at 200 Hz or more), the joint moves by at most
  // three quanta in the 10 samples before this time.
  constexpr double quanta = 4.0;
  const MotionRecord& record = checked.record;
  for (int k = 0; k < model.nq; ++k) {
    const Eigen::VectorXd signal = record.q.col(k);
    const Eigen::Index n = signal.size();
    if (n < 2 * before) continue;
    if (signal.maxCoeff() - signal.minCoeff() == 0.0) {
      checked.oddities.push_back(in_quotes(q_column(model, k)) +
                                 " never changes: is the encoder stuck?");
      continue;
    }
    const Run run = longest_run(signal);
    if (static_cast<double>(run.count) * record.period < max_standstill || run.count < before)
      continue;
    const Eigen::VectorXd moved = signal.tail(n - before) - signal.head(n - before);
    const double fastest = moved.cwiseAbs().maxCoeff();
    const Eigen::Index end = run.at + run.count;
    const double into = run.at >= before ? moved[run.at - before] : 0.0;
    const double out = end + before - 1 < n ? moved[end - 1] : 0.0;
    const double min_move = std::max(min_speed_fraction * fastest, quanta * quantum_of(signal));
    if (std::max(std::abs(into), std::abs(out)) < min_move) continue;
    throw Error("identify: " + in_quotes(q_column(model, k)) + " stands still from " +
                time_text(record, run.at) + " to " + time_text(record, end - 1) +
                " in the middle of a motion; is the encoder stuck, or were readings lost?");
  }
}

void check_motion(const Model& model, const MotionRecord& record) {
  double range = 0.0;
  for (int k = 0; k < model.nq; ++k)
    range = std::max(range, record.q.col(k).maxCoeff() - record.q.col(k).minCoeff());
  if (range < at_rest)
    throw Error("identify: the arm is at rest: no joint moves by more than " + number(range) +
                " rad (m); wanted a motion that excites the masses, such as one that burnish "
                "identify --excite writes");
}

struct Excess {
  std::string column;
  double value = 0.0, limit = 0.0, ratio = 1.0;
  Eigen::Index sample = 0;
  int columns = 0;  ///< Number of columns beyond their limits
};

std::string excess_text(const MotionRecord& record, const Excess& worst, const std::string& unit,
                        const char* verb) {
  std::string text = in_quotes(worst.column) + " " + verb + " " + number(worst.value) + unit +
                     " at " + time_text(record, worst.sample) + ", beyond its limit of " +
                     number(worst.limit) + unit;
  if (worst.columns > 1)
    text += " (and " + std::to_string(worst.columns - 1) + " more columns exceed their limits)";
  return text;
}

void note(Excess& worst, const Excess& one) {
  const int columns = worst.columns + 1;
  if (worst.columns == 0 || one.ratio > worst.ratio) worst = one;
  worst.columns = columns;
}

}  // namespace

std::string q_column(const Model& model, int entry_of_q) { return "q_" + model.q_name(entry_of_q); }
std::string tau_column(const Model& model, int entry_of_v) {
  return "tau_" + model.v_name(entry_of_v);
}
std::string time_text(const MotionRecord& record, Eigen::Index sample) {
  return number(record.first_time + static_cast<double>(sample) * record.period) + " s";
}

CheckedRecord checked_record(const Model& model, const MotionRecord& record) {
  check_numbers(model, record);
  check_motion(model, record);
  CheckedRecord result{record, {}, {}, {}};
  check_frozen(model, result);
  check_positions(model, result);
  check_torques(model, result);
  return result;
}

std::vector<std::string> beyond_limits(const Model& model, const MotionRecord& record) {
  // Accepted excess over a position limit, due to calibration; chosen by hand [rad, m]
  constexpr double position_slack = 0.02;
  // Accepted multiples of the limits. Noise exceeds torque limits. A swinging light wrist exceeds
  // speed limits: the wrist of a UR10 reached 2.1 times its limit in an excitation with a payload
  // that its controller did not model.
  constexpr double torque_slack = 1.25, speed_slack = 3.0;
  Excess position, speed, torque;
  for (const Joint& joint : model.joints) {
    if (joint.nv != 1) continue;
    if (joint.nq == 1) {
      const auto q = record.q.col(joint.q_index);
      const double low = model.q_lower[joint.q_index], high = model.q_upper[joint.q_index];
      Eigen::Index at_min = 0, at_max = 0;
      const double below = low - q.minCoeff(&at_min), above = q.maxCoeff(&at_max) - high;
      const Eigen::Index at = above > below ? at_max : at_min;
      if (std::max(below, above) > position_slack)
        note(position, {q_column(model, joint.q_index), q[at], above > below ? high : low,
                        1.0 + std::max(below, above), at});
      // Difference over ten samples, so that the noise of a converter does not count as speed.
      constexpr Eigen::Index over = 10;
      if (const Eigen::Index n = q.size(); n > over) {
        const Eigen::VectorXd v =
            (q.tail(n - over) - q.head(n - over)) / (static_cast<double>(over) * record.period);
        Eigen::Index fastest = 0;
        const double ratio = v.cwiseAbs().maxCoeff(&fastest) / model.velocity_limit[joint.v_index];
        if (model.velocity_limit[joint.v_index] > 0.0 && ratio > speed_slack)
          note(speed, {q_column(model, joint.q_index), std::abs(v[fastest]),
                       model.velocity_limit[joint.v_index], ratio, fastest});
      }
    }
    Eigen::Index strongest = 0;
    const auto tau = record.tau.col(joint.v_index);
    const double ratio = tau.cwiseAbs().maxCoeff(&strongest) / model.effort_limit[joint.v_index];
    if (model.effort_limit[joint.v_index] > 0.0 && ratio > torque_slack)
      note(torque, {tau_column(model, joint.v_index), tau[strongest],
                    model.effort_limit[joint.v_index], ratio, strongest});
  }
  std::vector<std::string> result;
  if (position.columns > 0) result.push_back(excess_text(record, position, "", "reaches"));
  if (speed.columns > 0) result.push_back(excess_text(record, speed, " per s", "moves at"));
  if (torque.columns > 0) result.push_back(excess_text(record, torque, "", "reaches"));
  return result;
}

}  // namespace burnish::identify_detail
