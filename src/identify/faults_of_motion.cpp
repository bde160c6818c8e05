// Faults of measured positions and times, and of assumed gravity, payload and joint friction.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "identify/faults.hpp"
#include "identify/record_check.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double degree = std::numbers::pi / 180.0;  // [rad]

Rows with_column(const Rows& rows, const Eigen::MatrixXd& columns) {
  Rows result{Eigen::MatrixXd(rows.A.rows(), rows.A.cols() + columns.cols()), rows.b};
  result.A << rows.A, columns;
  return result;
}

}  // namespace

/// Tries other gravity vectors. Takes Gauss-Newton steps, because the residuals contain products of
/// gravity and masses.
void FaultSearch::try_gravity() {
  std::vector<Regression> along;
  for (int i = 0; i < 3; ++i) {
    Model other = model_;
    other.gravity += Eigen::Vector3d::Unit(i);
    along.push_back(regression(other, record_, spec_));
  }
  Eigen::VectorXd of_robot = Eigen::VectorXd::Zero(base_.rest.size());
  for (int i = 0; i < 3; ++i) of_robot += model_.gravity[i] * (base_.rest - along[to_size(i)].rest);
  Rows without = rows(base_);
  without.b += of_robot;
  consider(
      "the torques do not contain the weight of the robot's own links; wanted the total torques of "
      "the joints: does the robot's controller compensate gravity?",
      left(without));

  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  Eigen::VectorXd x = solution_;
  double squares = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < 8; ++iteration) {
    Rows now = rows(base_);
    Eigen::MatrixXd columns(now.b.size(), 3);
    const Eigen::Index masses = base_.Y.cols();
    for (int i = 0; i < 3; ++i) {
      const Regression& one = along[to_size(i)];
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
  constexpr double vanishing = 0.05;  // Smallest gravity, as a fraction of the model's gravity
  if (gravity.norm() < vanishing * model_.gravity.norm())
    consider(
        "the torques do not contain the weight of the robot and its payload; wanted the total "
        "torques of the joints",
        squares);
  else
    consider("the torques fit a gravity of " + text(gravity) +
                 " m/s^2 in the axes of the model's base, but the model has " +
                 text(model_.gravity) + "; is the base mounted differently?",
             squares);
}

/// Tries a single change of the masses, at each of several instants.
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
               "; wanted a record with one payload and without contacts",
           best);
}

void FaultSearch::try_position_columns() {
  for (int i = 0; i < base_.nv; ++i) {
    const Joint& first = model_.joints[to_size(model_.joint_of_v[to_size(i)])];
    if (first.nq != 1) continue;
    const int a = first.q_index;
    const Regression flipped = with_positions([&](RowMatrix& q) { q.col(a) *= -1.0; });
    const std::string name = in_quotes(q_column(model_, a));
    consider("does " + name + " have the opposite sign?", left(rows(flipped)));
    consider("do " + name + " and " + in_quotes(tau_column(model_, i)) +
                 " have the opposite sign? wanted the signs of the model's axis",
             left(rows_with_torques(flipped, [&](RowMatrix& tau) { tau.col(i) *= -1.0; })));
    for (int j = i + 1; j < base_.nv; ++j) {
      const Joint& second = model_.joints[to_size(model_.joint_of_v[to_size(j)])];
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
  const auto scaled = [&](int only, bool prismatic, double factor) {
    return with_positions([&](RowMatrix& q) {
      for (const Joint& joint : model_.joints)
        if (joint.nq == 1 && (joint.kind == JointKind::Prismatic) == prismatic &&
            (only < 0 || joint.q_index == only))
          q.col(joint.q_index) *= factor;
    });
  };
  consider("positions look like degrees; wanted radians", left(rows(scaled(-1, false, degree))));
  consider("positions look like turns; wanted radians",
           left(rows(scaled(-1, false, 2.0 * std::numbers::pi))));
  bool has_prismatic = false;
  for (const Joint& joint : model_.joints) {
    if (joint.nq != 1) continue;
    const bool prismatic = joint.kind == JointKind::Prismatic;
    has_prismatic = has_prismatic || prismatic;
    consider(in_quotes(q_column(model_, joint.q_index)) +
                 (prismatic ? " looks like millimetres; wanted metres"
                            : " looks like degrees; wanted radians"),
             left(rows(scaled(joint.q_index, prismatic, prismatic ? 1e-3 : degree))));
  }
  if (!has_prismatic) return;
  consider("positions of prismatic joints look like millimetres; wanted metres",
           left(rows(scaled(-1, true, 1e-3))));
  consider("positions of prismatic joints look like centimetres; wanted metres",
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

/// Tries a constant offset of one encoder.
void FaultSearch::try_encoder_offsets() {
  constexpr double step = 0.01, largest = 2.0;  // Finite difference, largest offset [rad, m]
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
  // Gauss-Newton steps do not converge to large offsets, so multiples of `quarter` are tried first.
  constexpr double quarter = 0.5 * std::numbers::pi;
  for (const Joint& joint : model_.joints) {
    if (joint.nq != 1 || joint.kind == JointKind::Prismatic) continue;
    for (const double by : {-quarter, quarter, 2.0 * quarter})
      consider(
          in_quotes(q_column(model_, joint.q_index)) + " seems to have a constant error of " +
              number(-by) + " rad; does the encoder's zero match the model's zero?",
          left(rows(with_positions([&](RowMatrix& q) { q.col(joint.q_index).array() += by; }))));
  }
  int best = -1;
  double min_squares = std::numeric_limits<double>::infinity(), offset = 0.0;
  for (const Joint& joint : model_.joints) {
    if (joint.nq != 1) continue;
    Trial trial;
    const auto [next, expected] = improve(joint.q_index, 0.0, trial);
    if (expected < min_squares) min_squares = expected, best = joint.q_index, offset = next;
  }
  if (best < 0) return;
  Trial trial;
  for (int iteration = 0; iteration < 4 && std::abs(offset) < largest; ++iteration)
    offset = improve(best, offset, trial).first;
  constexpr double mild = 0.01;  // Offset below which the fault is mild [rad, m]
  consider(in_quotes(q_column(model_, best)) + " seems to have a constant error of " +
               number(-trial.offset) + " rad (m); is that encoder calibrated?",
           trial.squares, std::abs(trial.offset) < mild);
}

void FaultSearch::try_options() {
  const auto with = [&](bool IdentificationSpec::*option, const char* what, const char* flag) {
    if (spec_.*option) return;
    IdentificationSpec other = spec_;
    other.*option = true;
    consider(std::string(what) + " would explain the torques; wanted the option " + flag,
             left(rows(regression(model_, record_, other))), true);
  };
  with(&IdentificationSpec::offset, "a constant error of each torque", "offset (--offset)");
  with(&IdentificationSpec::friction, "joint friction", "friction (--friction)");
  with(&IdentificationSpec::armature, "the inertia of the rotors", "armature (--armature)");
}

}  // namespace burnish::identify_detail
