#include "estimate/feet_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/to_size.hpp"

namespace burnish {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Normal equations M turn = b for a rotation of the IMU.
struct Turning {
  Matrix3d M = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();

  void add_place(const Vector3d& lever, const Vector3d& error) {
    M += lever.squaredNorm() * Matrix3d::Identity() - lever * lever.transpose();
    b += lever.cross(error);
  }
  void add_turn(double weight, const Vector3d& turn) {
    M.diagonal().array() += weight;
    b += weight * turn;
  }
  /// Solves for the rotation. Returns false if the rotation about some axis is undetermined.
  bool solve(Vector3d& turn) const {
    // Smallest allowed eigenvalue of M [m^2], chosen by hand. Point feet on a line give an
    // eigenvalue of zero, because they do not determine the rotation about this line.
    constexpr double min_eigenvalue = 0.02 * 0.02;
    Eigen::SelfAdjointEigenSolver<Matrix3d> eigen;
    eigen.computeDirect(M, Eigen::EigenvaluesOnly);
    if (!(eigen.eigenvalues()[0] > min_eigenvalue)) return false;
    turn = M.ldlt().solve(b);
    return turn.allFinite();
  }
};

}  // namespace

FeetFit::FeetFit(const std::vector<char>& soles, double length) : square_(length * length) {
  for (const char sole : soles)
    feet_.push_back({sole != 0, Vector3d::Zero(), Matrix3d::Identity()});
}

void FeetFit::put(FootSet feet, const UnitPose& unit, const std::vector<SeenFoot>& seen) noexcept {
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    if ((feet & foot_bit(static_cast<int>(k))) == 0) continue;
    feet_[k].d = unit.p + unit.R * to_eigen(seen[k].p);
    feet_[k].C = unit.R * to_eigen(seen[k].R);
  }
}

bool FeetFit::fit(FootSet feet, const std::vector<SeenFoot>& seen, UnitPose& unit) const noexcept {
  Vector3d h_middle = Vector3d::Zero();
  int count = 0;
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    if ((feet & foot_bit(static_cast<int>(k))) == 0) continue;
    h_middle += to_eigen(seen[k].p);
    ++count;
  }
  if (count == 0) return false;
  h_middle /= count;
  const Vector3d d_middle = middle(feet);
  Matrix3d R = unit.R;
  for (int iteration = 0; iteration < 2; ++iteration) {
    Turning turning;
    for (std::size_t k = 0; k < feet_.size(); ++k) {
      if ((feet & foot_bit(static_cast<int>(k))) == 0) continue;
      const Vector3d lever = R * (to_eigen(seen[k].p) - h_middle);
      turning.add_place(lever, feet_[k].d - d_middle - lever);
      if (feet_[k].sole)
        turning.add_turn(square_, turn_of(feet_[k].C * (R * to_eigen(seen[k].R)).transpose()));
    }
    Vector3d turn;
    if (!turning.solve(turn)) return false;
    R = turned_by(turn) * R;
  }
  const Vector3d p = d_middle - R * h_middle;
  if (!R.allFinite() || !p.allFinite()) return false;
  // Makes the rotation matrix orthonormal again, because rounding errors accumulate.
  unit.R = 0.5 * R * (3.0 * Matrix3d::Identity() - R.transpose() * R);
  unit.p = p;
  return true;
}

/// Solves 0 = v + w x h_k + dh_k/dt for the velocities v and w of the IMU. h_k: position of a foot
/// at rest, seen from the IMU. The angular velocity of a sole at rest relative to the IMU is -w.
bool FeetFit::fit_velocity(FootSet feet, const FootKinematics& kinematics, Vector3d& v,
                           Vector3d& w) const noexcept {
  Vector3d h_middle = Vector3d::Zero(), rate_middle = Vector3d::Zero();
  int count = 0;
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    const int foot = static_cast<int>(k);
    if ((feet & foot_bit(foot)) == 0) continue;
    h_middle += to_eigen(kinematics.seen(foot).p);
    rate_middle += to_eigen(kinematics.velocity(foot));
    ++count;
  }
  if (count == 0) return false;
  h_middle /= count;
  rate_middle /= count;
  Turning turning;
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    const int foot = static_cast<int>(k);
    if ((feet & foot_bit(foot)) == 0) continue;
    turning.add_place(to_eigen(kinematics.seen(foot).p) - h_middle,
                      rate_middle - to_eigen(kinematics.velocity(foot)));
    if (feet_[k].sole) turning.add_turn(square_, -to_eigen(kinematics.turning(foot)));
  }
  Vector3d turn;
  if (!turning.solve(turn)) return false;
  w = turn;
  v = -rate_middle - w.cross(h_middle);
  return v.allFinite();
}

FeetFit::Apart FeetFit::apart(int k, const SeenFoot& seen, const UnitPose& unit) const noexcept {
  const Anchor& foot = feet_[to_size(k)];
  Apart result{(unit.p + unit.R * to_eigen(seen.p) - foot.d).norm(), 0.0};
  if (foot.sole) result.turn = turn_of(foot.C * (unit.R * to_eigen(seen.R)).transpose()).norm();
  return result;
}

bool FeetFit::are_redundant(FootSet feet) const noexcept {
  int rows = 0;
  for (std::size_t k = 0; k < feet_.size(); ++k)
    if ((feet & foot_bit(static_cast<int>(k))) != 0) rows += feet_[k].sole ? 6 : 3;
  return rows >= 9;
}

Vector3d FeetFit::middle(FootSet feet) const noexcept {
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    if ((feet & foot_bit(static_cast<int>(k))) == 0) continue;
    sum += feet_[k].d;
    ++count;
  }
  return count == 0 ? sum : Vector3d(sum / count);
}

}  // namespace burnish
