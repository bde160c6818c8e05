#include "burnish/identify/excitation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "model/followers.hpp"
#include "sim/random.hpp"

namespace burnish {
namespace {

constexpr double fade = 1.0;           // Time from rest to the full motion, chosen by hand [s]
constexpr double check_period = 0.02;  // Time between checked instants, chosen by hand [s]

/// Smooth step from 0 to 1 for x from 0 to 1. Its first and second derivative vanish at the ends.
struct Fade {
  double value = 1.0, slope = 0.0, curvature = 0.0;
};
Fade fade_at(double x) {
  if (x >= 1.0) return {};
  if (x <= 0.0) return {0.0, 0.0, 0.0};
  return {x * x * x * (10.0 + x * (-15.0 + 6.0 * x)), 30.0 * x * x * (1.0 + x * (-2.0 + x)),
          60.0 * x * (1.0 + x * (-3.0 + 2.0 * x))};
}

void check(const Model& model, const Eigen::VectorXd& q_start, const ExcitationSpec& spec) {
  check_configuration(model, q_start, "the excitation's start");
  const auto want = [](const char* what, double value, bool good, const char* wanted) {
    if (!good)
      throw Error(std::string("excitation: ") + what + " is " + number(value) + "; wanted " +
                  wanted);
  };
  want("duration", spec.duration, spec.duration >= 4.0 * fade && spec.duration <= 1e4,
       "4 to 10000 s");
  want("highest", spec.highest, spec.highest * spec.duration >= 1.0 && spec.highest <= 20.0,
       "1/duration to 20 Hz");
  want("range", spec.range, spec.range > 0.0, "more than 0");
  want("margin", spec.margin, spec.margin >= 0.0, "at least 0");
  want("speed_share", spec.speed_share, spec.speed_share > 0.0 && spec.speed_share <= 1.0,
       "0 to 1");
  want("speed", spec.speed, spec.speed > 0.0, "more than 0");
  want("effort_share", spec.effort_share, spec.effort_share > 0.0 && spec.effort_share <= 1.0,
       "0 to 1");
  want("candidates", spec.candidates, spec.candidates >= 1, "at least 1");
  if (!model.loops.empty())
    throw Error("excitation: " + in_quotes(model.name) + " has the loop " +
                in_quotes(model.loops.front().name) +
                ", whose forces the search for a motion does not compute; wanted a robot without "
                "loops, or the joints of the loop locked (--lock)");
  for (const Joint& joint : model.joints)
    if (joint_nv(joint.kind) > 1)
      throw Error("excitation: joint " + in_quotes(joint.name) + " is " +
                  std::string(name_of(joint.kind)) + "; wanted joints with one coordinate");
}

/// Joint torque that is the largest fraction of its effort limit.
struct Load {
  int entry = 0;
  double torque = 0.0;    ///< Absolute value [Nm, N]
  double fraction = 0.0;  ///< Fraction of the effort limit
};
Load heaviest_load(const Model& model, const Eigen::VectorXd& tau) {
  constexpr double none = 1e-9;  // torques up to this value are rounding errors [Nm, N]
  Load worst;
  for (int k = 0; k < model.nv; ++k) {
    const double torque = std::abs(tau[k]);
    const double fraction = torque > none ? torque / model.effort_limit[k] : 0.0;
    if (fraction > worst.fraction) worst = {k, torque, fraction};
  }
  return worst;
}

const char* torque_unit(const Model& model, int entry) {
  const int joint = model.joint_of_v[to_size(entry)];
  return model.joints[to_size(joint)].kind == JointKind::Prismatic ? " N" : " Nm";
}
std::string torque_text(const Model& model, int entry, double torque) {
  return number(torque) + torque_unit(model, entry);
}
/// Returns a text such as "0.8 of its effort limit of 39 Nm".
std::string limit_text(const Model& model, int entry, double effort_share) {
  return (effort_share < 1.0 ? number(effort_share) + " of " : "") + "its effort limit of " +
         torque_text(model, entry, model.effort_limit[entry]);
}

/// Throws Error if the start cannot be held within the allowed efforts.
void check_efforts(const Model& model, const Eigen::VectorXd& q_start, double effort_share) {
  ContactDynamics dynamics(model);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv), none(0);
  if (!is_usable(dynamics.inverse(q_start, rest, rest, none))) return;
  const Load load = heaviest_load(model, dynamics.tau());
  if (load.fraction <= effort_share) return;
  const bool holds = load.fraction <= 1.0;
  throw Error("excitation: joint " + in_quotes(model.v_name(load.entry)) + " needs " +
              torque_text(model, load.entry, load.torque) +
              " to hold the start posture, more than " +
              limit_text(model, load.entry, holds ? effort_share : 1.0) +
              "; wanted another start (--posture)" +
              (holds ? " or a larger effort_share (--effort-share)"
                     : " or a corrected effort limit in robot.yaml"));
}

/// Allowed displacement from the start and allowed speed, per entry of v; 0 for joints at rest.
struct Room {
  Eigen::VectorXd displacement, speed;
};
Room room_of(const Model& model, const Eigen::VectorXd& q_start, const ExcitationSpec& spec) {
  std::vector<char> moves(to_size(model.nv), spec.joints.empty() ? 1 : 0);
  for (const std::string& name : spec.joints)
    moves[to_size(model.joints[to_size(model.joint_index(name))].v_index)] = 1;
  Room room{Eigen::VectorXd::Zero(model.nv), Eigen::VectorXd::Zero(model.nv)};
  for (const Joint& joint : model.joints) {
    const int k = joint.v_index;
    if (joint.follows || moves[to_size(k)] == 0) continue;
    double displacement = spec.range;
    if (joint.nq == 1) {
      const double q = q_start[joint.q_index];
      displacement = std::min({displacement, q - model.q_lower[joint.q_index] - spec.margin,
                               model.q_upper[joint.q_index] - q - spec.margin});
      if (displacement < 0.02)
        throw Error("excitation: joint " + in_quotes(joint.name) + " starts at " + number(q) +
                    ", closer to a position limit than the margin of " + number(spec.margin) +
                    "; wanted a start posture farther from the limit, a smaller margin or other "
                    "joints");
    }
    room.displacement[k] = displacement;
    room.speed[k] = std::min(spec.speed_share * model.velocity_limit[k], spec.speed);
  }
  return room;
}

}  // namespace

Excitation::Excitation(const Model& model, const Eigen::VectorXd& q_start, const std::string& frame,
                       const ExcitationSpec& spec)
    : model_(model), q_start_(q_start), duration_(spec.duration) {
  check(model, q_start, spec);
  (void)frame_on_body("excitation", model, frame);
  check_efforts(model, q_start, spec.effort_share);
  const Room room = room_of(model, q_start, spec);
  const int harmonics = std::max(1, static_cast<int>(spec.highest * spec.duration));
  RandomStream random(spec.seed, 0);
  Amplitudes best, heaviest;
  double best_information = -std::numeric_limits<double>::infinity();
  Eigen::VectorXd displacement, v, a;
  for (int candidate = 0; candidate < spec.candidates; ++candidate) {
    amplitudes_ = {Eigen::MatrixXd(model.nv, harmonics), Eigen::MatrixXd(model.nv, harmonics)};
    for (Eigen::MatrixXd* matrix : {&amplitudes_.sine, &amplitudes_.cosine})
      for (int k = 0; k < model.nv; ++k)
        for (int h = 0; h < harmonics; ++h) (*matrix)(k, h) = random.normal();
    Eigen::ArrayXd farthest = Eigen::ArrayXd::Constant(model.nv, 1e-12), fastest = farthest;
    for (double t = 0.0; t <= duration_; t += check_period) {
      displacement_at(t, displacement, v, a);
      farthest = farthest.max(displacement.array().abs());
      fastest = fastest.max(v.array().abs());
    }
    const Eigen::VectorXd scale =
        (room.displacement.array() / farthest).min(room.speed.array() / fastest).matrix();
    amplitudes_.sine = scale.asDiagonal() * amplitudes_.sine;
    amplitudes_.cosine = scale.asDiagonal() * amplitudes_.cosine;
    if (!limit(spec.effort_share)) {
      heaviest = amplitudes_;
      continue;
    }
    const double value = information(frame);
    if (value > best_information) best_information = value, best = amplitudes_;
  }
  if (!std::isfinite(best_information) && heaviest.size == 1.0)
    throw Error("excitation: no motion was found that moves " + in_quotes(frame) +
                "; wanted a smaller range, or other joints");
  if (!std::isfinite(best_information))
    throw Error(
        "excitation: no motion was found that stays within the effort limits, not even at " +
        number(std::round(100.0 * heaviest.size)) + " % of the full size: at full size, " +
        effort_text(heaviest, spec.effort_share) +
        "; wanted another start (--posture), fewer joints (--joints) or "
        "a larger effort_share (--effort-share)");
  amplitudes_ = best;
  if (amplitudes_.size < 1.0)
    warnings_.push_back("the motion is reduced to " + number(std::round(100.0 * amplitudes_.size)) +
                        " % of the size that the range and the speed limits allow: at full size, " +
                        effort_text(amplitudes_, spec.effort_share));
}

/// Reduces the motion until the efforts are within their limits. Returns false if this fails.
bool Excitation::limit(double effort_share) {
  constexpr double shrink = 0.8;  // Factor on the motion at each attempt, chosen by hand
  constexpr int attempts = 12;
  ContactDynamics dynamics(model_);
  const Eigen::VectorXd none(0);
  Eigen::VectorXd q, v, a;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Load worst;
    for (double t = 0.0; t <= duration_; t += 2.0 * check_period) {
      at(t, q, v, a);
      if (!is_usable(dynamics.inverse(q, v, a, none))) continue;
      const Load load = heaviest_load(model_, dynamics.tau());
      if (load.fraction > worst.fraction) worst = load;
    }
    if (attempt == 0) amplitudes_.heaviest = worst.entry, amplitudes_.torque = worst.torque;
    if (worst.fraction <= effort_share) return true;
    amplitudes_.sine *= shrink;
    amplitudes_.cosine *= shrink;
    amplitudes_.size *= shrink;
  }
  return false;
}

/// Returns a text that names the joint whose effort limit the motion at full size would exceed.
std::string Excitation::effort_text(const Amplitudes& amplitudes, double effort_share) const {
  return "joint " + in_quotes(model_.v_name(amplitudes.heaviest)) + " would need " +
         torque_text(model_, amplitudes.heaviest, amplitudes.torque) + ", more than " +
         limit_text(model_, amplitudes.heaviest, effort_share);
}

/// Returns log det of the information about a payload's ten parameters, in units of 1 kg and 0.1 m.
double Excitation::information(const std::string& frame) const {
  ContactDynamics dynamics(model_);
  const std::vector<int> bodies{frame_on_body("excitation", model_, frame).body};
  const Eigen::VectorXd none(0);
  Eigen::VectorXd q, v, a;
  RowMatrix Y;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(10, 10);
  Vector10 unit;
  unit << 1.0, Eigen::Vector3d::Constant(0.1), Eigen::VectorXd::Constant(6, 0.01);
  for (double t = 0.0; t <= duration_; t += 5.0 * check_period) {
    at(t, q, v, a);
    (void)dynamics.inverse(q, v, a, none);
    (void)dynamics.regressor(bodies, Y);
    sum += unit.asDiagonal() * (Y.transpose() * Y) * unit.asDiagonal();
  }
  const Eigen::VectorXd values = symmetric_eigen(sum).values;
  // The lower bound makes directions that no motion excites count equally for all motions.
  return values.cwiseMax(1e-9).array().log().sum();
}

void Excitation::displacement_at(double time, Eigen::VectorXd& displacement, Eigen::VectorXd& v,
                                 Eigen::VectorXd& a) const {
  const double t = std::clamp(time, 0.0, duration_);
  const bool ends = t > 0.5 * duration_;
  const Fade f = fade_at((ends ? duration_ - t : t) / fade);
  const double slope = (ends ? -1.0 : 1.0) * f.slope / fade,
               curvature = f.curvature / (fade * fade);
  displacement.setZero(model_.nv), v.setZero(model_.nv), a.setZero(model_.nv);
  for (Eigen::Index h = 0; h < amplitudes_.sine.cols(); ++h) {
    const double w = 2.0 * std::numbers::pi * static_cast<double>(h + 1) / duration_;
    const double s = std::sin(w * t), c = std::cos(w * t);
    displacement += amplitudes_.sine.col(h) * s + amplitudes_.cosine.col(h) * (c - 1.0);
    v += w * (amplitudes_.sine.col(h) * c - amplitudes_.cosine.col(h) * s);
    a -= w * w * (amplitudes_.sine.col(h) * s + amplitudes_.cosine.col(h) * c);
  }
  a = f.value * a + 2.0 * slope * v + curvature * displacement;
  v = f.value * v + slope * displacement;
  displacement *= f.value;
}

void Excitation::at(double time, Eigen::VectorXd& q, Eigen::VectorXd& v, Eigen::VectorXd& a) const {
  Eigen::VectorXd displacement;
  displacement_at(time, displacement, v, a);
  q = integrate(model_, q_start_, displacement);
}

Trace Excitation::trace(double period) const {
  if (!(period > 0.0) || duration_ / period > 1e7)
    throw Error("excitation: period is " + number(period) +
                " s; wanted more than 0, and at most 1e7 periods in the excitation");
  // One position per entry of v, because check() allows only joints with one coordinate.
  Eigen::VectorXd start(model_.nv);
  std::vector<TraceColumn> columns{{"time", "s"}};
  for (const Joint& joint : model_.joints)
    if (!joint.follows) start[joint.v_index] = joint_value(model_, joint, q_start_);
  for (const auto& [prefix, rates] : {std::pair{"q_", ""}, {"v_", "/s"}, {"a_", "/s2"}})
    for (int k = 0; k < model_.nv; ++k) {
      const Joint& joint = model_.joints[to_size(model_.joint_of_v[to_size(k)])];
      const std::string unit = joint.kind == JointKind::Prismatic ? "m" : "rad";
      columns.push_back({prefix + joint.name, unit + rates});
    }
  const int rows = static_cast<int>(std::floor(duration_ / period)) + 1;
  Trace result(columns, rows);
  Eigen::VectorXd displacement, v, a;
  for (int i = 0; i < rows; ++i) {
    double* const row = result.add_row();
    const double t = i * period;
    displacement_at(t, displacement, v, a);
    row[0] = t;
    Eigen::Map<Eigen::VectorXd>(row + 1, 3 * model_.nv) << start + displacement, v, a;
  }
  return result;
}

}  // namespace burnish
