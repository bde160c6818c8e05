// Faults of what the torques are compared with: positions, times, gravity, the payload, friction.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "identify/faults.hpp"
#include "identify/record_check.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double degree = std::numbers::pi / 180.0;  // rad

Rows with_column(const Rows& rows, const Eigen::MatrixXd& columns) {
  Rows result{Eigen::MatrixXd(rows.A.rows(), rows.A.cols() + columns.cols()), rows.b};
  result.A << rows.A, columns;
  return result;
}

}  // namespace

/// Residuals are linear in gravity except for its product with the masses: Gauss-Newton steps.
void FaultSearch::try_gravity() {
  std::vector<Regression> along;
  for (int i = 0; i < 3; ++i) {
    Model other = model_;
    other.gravity += Eigen::Vector3d::Unit(i);
    along.push_back(regression(other, record_, spec_));
  }
  Eigen::VectorXd of_robot = Eigen::VectorXd::Zero(base_.rest.size());
  for (int i = 0; i < 3; ++i)
    of_robot += model_.gravity[i] * (base_.rest - along[static_cast<std::size_t>(i)].rest);
  Rows without = rows(base_);
  without.b += of_robot;
  consider(
      "torques lack the part that holds the robot's own links against gravity; wanted the total "
      "torques of the joints: does the robot's controller compensate gravity?",
      left(without));

  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  Eigen::VectorXd x = solution_;
  double squares = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 8; ++iteration) {
    Rows now = rows(base_);
    Eigen::MatrixXd columns(now.b.size(), 3);
    const Eigen::Index masses = base_.Y.cols();
    for (int i = 0; i < 3; ++i) {
      const Regression& one = along[static_cast<std::size_t>(i)];
      const Eigen::MatrixXd dY = one.Y - base_.Y;
      now.A.leftCols(masses) += change[i] * dY;
      now.b += change[i] * (one.rest - base_.rest);
      columns.col(i) = dY * x.head(masses) - (one.rest - base_.rest);
    }
    squares = left(now, &x);
    Eigen::VectorXd all;
    (void)left(with_column(now, columns), &all);
    if (iteration < 7) change += all.tail<3>();
  }
  const Eigen::Vector3d gravity = model_.gravity + change;
  const auto text = [](const Eigen::Vector3d& g) {
    return "(" + number(g[0]) + ", " + number(g[1]) + ", " + number(g[2]) + ")";
  };
  constexpr double vanishing = 0.05;  // of the model's gravity
  if (gravity.norm() < vanishing * model_.gravity.norm())
    consider(
        "torques are those of a robot and payload without gravity; wanted the total torques of the "
        "joints",
        squares);
  else
    consider("gravity looks like " + text(gravity) +
                 " m/s^2 in the model's base, where the model has " + text(model_.gravity) +
                 "; is the base mounted otherwise?",
             squares);
}

/// Other masses from an instant on.
void FaultSearch::try_payload_change() {
  constexpr int places = 20;
  const Rows plain = rows(base_);
  const Eigen::Index masses = base_.Y.cols(), nv = base_.nv;
  double best = std::numeric_limits<double>::infinity();
  int where = 0;
  for (int place = 2; place < places - 1; ++place) {
    const Eigen::Index split = static_cast<Eigen::Index>(base_.samples) * place / places * nv;
    Eigen::MatrixXd later = Eigen::MatrixXd::Zero(plain.b.size(), masses);
    later.bottomRows(plain.b.size() - split) = base_.Y.bottomRows(plain.b.size() - split);
    const double squares = left(with_column(plain, later));
    if (squares < best) best = squares, where = place;
  }
  const Eigen::Index sample = windows_.first + windows_.count * windows_.stride * where / places;
  consider("the masses seem to change at about " + time_text(record_, sample) +
               "; wanted a record with one payload, that touches nothing",
           best);
}

void FaultSearch::try_position_columns() {
  for (int i = 0; i < base_.nv; ++i) {
    const Joint& first =
        model_.joints[static_cast<std::size_t>(model_.joint_of_v[static_cast<std::size_t>(i)])];
    if (first.nq != 1) continue;
    const int a = first.q_index;
    const Regression flipped = with_positions([&](RowMatrix& q) { q.col(a) *= -1.0; });
    const std::string name = in_quotes(q_column(model_, a));
    consider("does " + name + " have the opposite sign?", left(rows(flipped)));
    consider("do " + name + " and " + in_quotes(tau_column(model_, i)) +
                 " have the opposite sign? wanted those of the model's axis",
             left(rows_with_torques(flipped, [&](RowMatrix& tau) { tau.col(i) *= -1.0; })));
    for (int j = i + 1; j < base_.nv; ++j) {
      const Joint& second =
          model_.joints[static_cast<std::size_t>(model_.joint_of_v[static_cast<std::size_t>(j)])];
      if (second.nq != 1) continue;
      const int b = second.q_index;
      const Regression swapped = with_positions([&](RowMatrix& q) { q.col(a).swap(q.col(b)); });
      consider("are the columns " + name + " and " + in_quotes(q_column(model_, b)) + " swapped?",
               left(rows(swapped)));
      consider(
          "are the columns of the joints " + in_quotes(first.name) + " and " +
              in_quotes(second.name) + " swapped, positions and torques?",
          left(rows_with_torques(swapped, [&](RowMatrix& tau) { tau.col(i).swap(tau.col(j)); })));
    }
  }
}

void FaultSearch::try_position_units() {
  const auto scaled = [&](int only, bool straight, double factor) {
    return with_positions([&](RowMatrix& q) {
      for (const Joint& joint : model_.joints)
        if (joint.nq == 1 && (joint.kind == JointKind::Prismatic) == straight &&
            (only < 0 || joint.q_index == only))
          q.col(joint.q_index) *= factor;
    });
  };
  consider("positions look like degrees; wanted radians", left(rows(scaled(-1, false, degree))));
  consider("positions look like turns; wanted radians",
           left(rows(scaled(-1, false, 2.0 * std::numbers::pi))));
  bool any_straight = false;
  for (const Joint& joint : model_.joints) {
    if (joint.nq != 1) continue;
    const bool straight = joint.kind == JointKind::Prismatic;
    any_straight = any_straight || straight;
    consider(in_quotes(q_column(model_, joint.q_index)) +
                 (straight ? " looks like millimetres; wanted metres"
                           : " looks like degrees; wanted radians"),
             left(rows(scaled(joint.q_index, straight, straight ? 1e-3 : degree))));
  }
  if (!any_straight) return;
  consider("positions of joints that slide look like millimetres; wanted metres",
           left(rows(scaled(-1, true, 1e-3))));
  consider("positions of joints that slide look like centimetres; wanted metres",
           left(rows(scaled(-1, true, 1e-2))));
}

void FaultSearch::try_period() {
  for (const double factor : {0.1, 0.2, 0.25, 0.5, 2.0, 4.0, 5.0, 10.0}) {
    MotionRecord other = record_;
    other.period *= factor;
    consider("the period looks like " + number(other.period) + " s, not " + number(record_.period) +
                 " s; wanted times in seconds",
             left(rows(regression(model_, other, spec_))));
  }
}

/// An encoder that reads the angle plus a constant.
void FaultSearch::try_encoder_offsets() {
  constexpr double step = 0.01, largest = 2.0;  // rad (m)
  struct Trial {
    double offset = 0.0, squares = std::numeric_limits<double>::infinity();
  };
  const auto improve = [&](int entry, double offset, Trial& trial) {
    const auto at = [&](double by) {
      return with_positions([&](RowMatrix& q) { q.col(entry).array() += by; });
    };
    const Regression here = at(offset), there = at(offset + step);
    const Rows now = rows(here);
    Eigen::VectorXd x, all;
    trial = {offset, left(now, &x)};
    const Eigen::MatrixXd slope =
        ((there.Y - here.Y) * x.head(here.Y.cols()) - (there.rest - here.rest)) / step;
    const double expected = left(with_column(now, slope), &all);
    return std::pair{offset + all.tail<1>()[0], expected};
  };
  // Far from the truth there is no slope that leads to it: quarters of a turn.
  constexpr double quarter = 0.5 * std::numbers::pi;
  for (const Joint& joint : model_.joints) {
    if (joint.nq != 1 || joint.kind == JointKind::Prismatic) continue;
    for (const double by : {-quarter, quarter, 2.0 * quarter})
      consider(
          in_quotes(q_column(model_, joint.q_index)) + " looks off by " + number(-by) +
              " rad; is the encoder's zero the model's?",
          left(rows(with_positions([&](RowMatrix& q) { q.col(joint.q_index).array() += by; }))));
  }
  int best = -1;
  double least = std::numeric_limits<double>::infinity(), offset = 0.0;
  for (const Joint& joint : model_.joints) {
    if (joint.nq != 1) continue;
    Trial trial;
    const auto [next, expected] = improve(joint.q_index, 0.0, trial);
    if (expected < least) least = expected, best = joint.q_index, offset = next;
  }
  if (best < 0) return;
  Trial trial;
  for (int iteration = 0; iteration < 4 && std::abs(offset) < largest; ++iteration)
    offset = improve(best, offset, trial).first;
  constexpr double mild = 0.01;  // rad (m) that a calibration may be off by
  consider(in_quotes(q_column(model_, best)) + " looks off by a constant " + number(-trial.offset) +
               " rad (m); is that encoder calibrated?",
           trial.squares, std::abs(trial.offset) < mild);
}

void FaultSearch::try_options() {
  const auto with = [&](bool IdentificationSpec::*option, const char* what, const char* flag) {
    if (spec_.*option) return;
    IdentificationSpec other = spec_;
    other.*option = true;
    consider(std::string(what) + " explains it: " + flag,
             left(rows(regression(model_, record_, other))), true);
  };
  with(&IdentificationSpec::offset, "a constant error of each torque", "offset (--offset)");
  with(&IdentificationSpec::friction, "joint friction", "friction (--friction)");
  with(&IdentificationSpec::armature, "the inertia of the rotors", "armature (--armature)");
}

}  // namespace burnish::identify_detail
