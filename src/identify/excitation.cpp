#include "burnish/identify/excitation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "model/followers.hpp"
#include "sim/random.hpp"

namespace burnish {
namespace {

constexpr double fade = 1.0;         // s from rest to the full motion
constexpr double look_every = 0.02;  // s, between instants at which limits are looked at

/// 0 to 1 over x in 0 to 1 with two derivatives that vanish at the ends.
struct Fade {
  double value = 1.0, slope = 0.0, bend = 0.0;
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
                ", whose forces are not known here; wanted a robot without loops, as with their "
                "joints locked (--lock)");
  for (const Joint& joint : model.joints)
    if (joint_nv(joint.kind) > 1)
      throw Error("excitation: joint " + in_quotes(joint.name) + " is " +
                  std::string(name_of(joint.kind)) + "; wanted joints of one coordinate");
}

/// The torque that is nearest to its limit.
struct Load {
  int entry = 0;
  double torque = 0.0;  ///< Nm (N)
  double share = 0.0;   ///< of its limit
};
Load heaviest_load(const Model& model, const Eigen::VectorXd& tau) {
  constexpr double none = 1e-9;  // torque of a joint that has none to give, by rounding [Nm, N]
  Load worst;
  for (int k = 0; k < model.nv; ++k) {
    const double torque = std::abs(tau[k]);
    const double share = torque > none ? torque / model.effort_limit[k] : 0.0;
    if (share > worst.share) worst = {k, torque, share};
  }
  return worst;
}

const char* torque_unit(const Model& model, int entry) {
  const int joint = model.joint_of_v[static_cast<std::size_t>(entry)];
  return model.joints[static_cast<std::size_t>(joint)].kind == JointKind::Prismatic ? " N" : " Nm";
}
std::string torque_text(const Model& model, int entry, double torque) {
  return number(torque) + torque_unit(model, entry);
}
/// "0.8 of its effort limit of 39 Nm".
std::string limit_text(const Model& model, int entry, double effort_share) {
  return (effort_share < 1.0 ? number(effort_share) + " of " : "") + "its effort limit of " +
         torque_text(model, entry, model.effort_limit[entry]);
}

/// Refuses a start that cannot be held within the efforts that a motion may take.
void check_efforts(const Model& model, const Eigen::VectorXd& q_start, double effort_share) {
  ContactDynamics dynamics(model);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv), none(0);
  if (dynamics.inverse(q_start, rest, rest, none) > Status::NotConverged) return;
  const Load load = heaviest_load(model, dynamics.tau());
  if (load.share <= effort_share) return;
  const bool holds = load.share <= 1.0;
  throw Error("excitation: joint " + in_quotes(model.v_name(load.entry)) + " takes " +
              torque_text(model, load.entry, load.torque) + " to hold the start, more than " +
              limit_text(model, load.entry, holds ? effort_share : 1.0) +
              "; wanted another start (--posture)" +
              (holds ? " or a larger effort_share (--effort-share)"
                     : " or, where the description is wrong, its effort in robot.yaml"));
}

/// Per entry of v: how far a joint may leave its start, and how fast it may be; 0 of those at rest.
struct Room {
  Eigen::VectorXd way, speed;
};
Room room_of(const Model& model, const Eigen::VectorXd& q_start, const ExcitationSpec& spec) {
  std::vector<char> moves(static_cast<std::size_t>(model.nv), spec.joints.empty() ? 1 : 0);
  for (const std::string& name : spec.joints)
    moves[static_cast<std::size_t>(
        model.joints[static_cast<std::size_t>(model.joint_index(name))].v_index)] = 1;
  Room room{Eigen::VectorXd::Zero(model.nv), Eigen::VectorXd::Zero(model.nv)};
  for (const Joint& joint : model.joints) {
    const int k = joint.v_index;
    if (joint.follows || moves[static_cast<std::size_t>(k)] == 0) continue;
    double way = spec.range;
    if (joint.nq == 1) {
      const double q = q_start[joint.q_index];
      way = std::min({way, q - model.q_lower[joint.q_index] - spec.margin,
                      model.q_upper[joint.q_index] - q - spec.margin});
      if (way < 0.02)
        throw Error("excitation: joint " + in_quotes(joint.name) + " starts at " + number(q) +
                    ", within " + number(spec.margin) +
                    " of a limit; wanted a start further inside, a smaller margin or other joints");
    }
    room.way[k] = way;
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
  Drawn best, heaviest;
  double most = -std::numeric_limits<double>::infinity();
  Eigen::VectorXd way, v, a;
  for (int candidate = 0; candidate < spec.candidates; ++candidate) {
    drawn_ = {Eigen::MatrixXd(model.nv, harmonics), Eigen::MatrixXd(model.nv, harmonics)};
    for (Eigen::MatrixXd* matrix : {&drawn_.sine, &drawn_.cosine})
      for (int k = 0; k < model.nv; ++k)
        for (int h = 0; h < harmonics; ++h) (*matrix)(k, h) = random.normal();
    Eigen::ArrayXd farthest = Eigen::ArrayXd::Constant(model.nv, 1e-12), fastest = farthest;
    for (double t = 0.0; t <= duration_; t += look_every) {
      way_at(t, way, v, a);
      farthest = farthest.max(way.array().abs());
      fastest = fastest.max(v.array().abs());
    }
    const Eigen::VectorXd scale =
        (room.way.array() / farthest).min(room.speed.array() / fastest).matrix();
    drawn_.sine = scale.asDiagonal() * drawn_.sine;
    drawn_.cosine = scale.asDiagonal() * drawn_.cosine;
    if (!limit(spec.effort_share)) {
      heaviest = drawn_;
      continue;
    }
    const double told = information(frame);
    if (told > most) most = told, best = drawn_;
  }
  if (!std::isfinite(most) && heaviest.size == 1.0)
    throw Error("excitation: no motion was found that moves " + in_quotes(frame) +
                "; wanted a smaller range, or other joints");
  if (!std::isfinite(most))
    throw Error("excitation: no motion was found that stays within the effort limits: " +
                effort_text(heaviest, spec.effort_share) + ", and too much even at " +
                number(std::round(100.0 * heaviest.size)) +
                " % of that size; wanted another start (--posture), fewer joints (--joints) or a "
                "larger effort_share (--effort-share)");
  drawn_ = best;
  if (drawn_.size < 1.0)
    warnings_.push_back("the motion is reduced to " + number(std::round(100.0 * drawn_.size)) +
                        " % of the size that range and speeds allow: at full size " +
                        effort_text(drawn_, spec.effort_share));
}

/// Smaller until the efforts fit: a smaller motion about the same posture. Returns whether they do.
bool Excitation::limit(double effort_share) {
  constexpr double smaller = 0.8;  // of the motion before, at each attempt
  constexpr int attempts = 12;
  ContactDynamics dynamics(model_);
  const Eigen::VectorXd none(0);
  Eigen::VectorXd q, v, a;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Load worst;
    for (double t = 0.0; t <= duration_; t += 2.0 * look_every) {
      at(t, q, v, a);
      if (dynamics.inverse(q, v, a, none) > Status::NotConverged) continue;
      const Load load = heaviest_load(model_, dynamics.tau());
      if (load.share > worst.share) worst = load;
    }
    if (attempt == 0) drawn_.heaviest = worst.entry, drawn_.torque = worst.torque;
    if (worst.share <= effort_share) return true;
    drawn_.sine *= smaller;
    drawn_.cosine *= smaller;
    drawn_.size *= smaller;
  }
  return false;
}

/// Whose effort limit the motion would exceed at full size.
std::string Excitation::effort_text(const Drawn& drawn, double effort_share) const {
  return "joint " + in_quotes(model_.v_name(drawn.heaviest)) + " would need " +
         torque_text(model_, drawn.heaviest, drawn.torque) + ", more than " +
         limit_text(model_, drawn.heaviest, effort_share);
}

/// log det of what the motion tells of a payload's ten parameters, in units of a kilogram and a
/// decimetre.
double Excitation::information(const std::string& frame) const {
  ContactDynamics dynamics(model_);
  const std::vector<int> bodies{frame_on_body("excitation", model_, frame).body};
  const Eigen::VectorXd none(0);
  Eigen::VectorXd q, v, a;
  RowMatrix Y;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(10, 10);
  Vector10 unit;
  unit << 1.0, Eigen::Vector3d::Constant(0.1), Eigen::VectorXd::Constant(6, 0.01);
  for (double t = 0.0; t <= duration_; t += 5.0 * look_every) {
    at(t, q, v, a);
    (void)dynamics.inverse(q, v, a, none);
    (void)dynamics.regressor(bodies, Y);
    sum += unit.asDiagonal() * (Y.transpose() * Y) * unit.asDiagonal();
  }
  const Eigen::VectorXd values = symmetric_eigen(sum).values;
  // What no motion shows counts for all motions alike.
  return values.cwiseMax(1e-9).array().log().sum();
}

void Excitation::way_at(double time, Eigen::VectorXd& way, Eigen::VectorXd& v,
                        Eigen::VectorXd& a) const {
  const double t = std::clamp(time, 0.0, duration_);
  const bool ends = t > 0.5 * duration_;
  const Fade f = fade_at((ends ? duration_ - t : t) / fade);
  const double slope = (ends ? -1.0 : 1.0) * f.slope / fade, bend = f.bend / (fade * fade);
  way.setZero(model_.nv), v.setZero(model_.nv), a.setZero(model_.nv);
  for (Eigen::Index h = 0; h < drawn_.sine.cols(); ++h) {
    const double w = 2.0 * std::numbers::pi * static_cast<double>(h + 1) / duration_;
    const double s = std::sin(w * t), c = std::cos(w * t);
    way += drawn_.sine.col(h) * s + drawn_.cosine.col(h) * (c - 1.0);
    v += w * (drawn_.sine.col(h) * c - drawn_.cosine.col(h) * s);
    a -= w * w * (drawn_.sine.col(h) * s + drawn_.cosine.col(h) * c);
  }
  a = f.value * a + 2.0 * slope * v + bend * way;
  v = f.value * v + slope * way;
  way *= f.value;
}

void Excitation::at(double time, Eigen::VectorXd& q, Eigen::VectorXd& v, Eigen::VectorXd& a) const {
  Eigen::VectorXd way;
  way_at(time, way, v, a);
  q = integrate(model_, q_start_, way);
}

Trace Excitation::trace(double period) const {
  if (!(period > 0.0) || duration_ / period > 1e7)
    throw Error("excitation: a period of " + number(period) + " s; wanted one above 0");
  // One position for each entry of v: check() allows joints of one coordinate only.
  Eigen::VectorXd start(model_.nv);
  std::vector<TraceColumn> columns{{"time", "s"}};
  for (const Joint& joint : model_.joints)
    if (!joint.follows) start[joint.v_index] = joint_value(model_, joint, q_start_);
  for (const auto& [prefix, rates] : {std::pair{"q_", ""}, {"v_", "/s"}, {"a_", "/s2"}})
    for (int k = 0; k < model_.nv; ++k) {
      const Joint& joint =
          model_.joints[static_cast<std::size_t>(model_.joint_of_v[static_cast<std::size_t>(k)])];
      const std::string unit = joint.kind == JointKind::Prismatic ? "m" : "rad";
      columns.push_back({prefix + joint.name, unit + rates});
    }
  const int rows = static_cast<int>(std::floor(duration_ / period)) + 1;
  Trace result(columns, rows);
  Eigen::VectorXd way, v, a;
  for (int i = 0; i < rows; ++i) {
    double* const row = result.add_row();
    const double t = i * period;
    way_at(t, way, v, a);
    row[0] = t;
    Eigen::Map<Eigen::VectorXd>(row + 1, 3 * model_.nv) << start + way, v, a;
  }
  return result;
}

}  // namespace burnish
