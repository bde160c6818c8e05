// Linear-quadratic problems with limits, as in the plans of a robot that follows a reference. The
// limits are ranges of torques, positions and speeds, bands of the feet's normal forces, friction
// pyramids, and centres of pressure. All numbers are random with a fixed seed.
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "burnish/base/views.hpp"
#include "solver/limited_lq.hpp"

namespace burnish::bench {

struct RobotSize {
  int nv, filtered, nu, feet;
  bool soles;  ///< True for planar feet, with limits of the centre of pressure.
};

/// Stage with z = (u, x): limits of the entries of z first, then of the rows.
struct LimitedStage {
  RowMatrix hessian, velocity, rows;
  Eigen::VectorXd gradient, lower, upper, scale;
};

class LimitedRobot {
 public:
  static constexpr double knot_step = 0.01, filter_decay = 0.6;

  /// `load`: scale of the motion. No limit is active at 0.1, about 1 in 40 at 1.
  LimitedRobot(const RobotSize& size, double load);

  int ndx() const { return 2 * size.nv + size.filtered; }
  int nz() const { return size.nu + ndx(); }
  int rows() const { return size.feet * (size.soles ? 9 : 5); }
  LimitedStage stage(double time, bool first, bool last) const;
  std::vector<LimitedStage> horizon(double time, int knots) const;
  Eigen::VectorXd start() const;
  /// Returns x after one knot.
  Eigen::VectorXd next(const LimitedStage& stage, const Eigen::VectorXd& z) const;

  const RobotSize size;

 private:
  Eigen::VectorXd reference(double time) const;
  void follow(double time, LimitedStage& stage) const;
  void stand(double time, LimitedStage& stage) const;
  void bound(LimitedStage& stage, bool first, bool last) const;

  double load_;
  RowMatrix inverse_mass_, stiffness_, force_by_torque_, force_by_position_, force_by_velocity_;
  Eigen::VectorXd amplitude_, frequency_, phase_;
};

/// Horizon in the memory layout of LimitedLq.
class LimitedHorizon {
 public:
  LimitedHorizon(const LimitedRobot& robot, int knots);

  /// Loads the problem that starts at x; it stays unchanged until the next call.
  void load(const std::vector<LimitedStage>& stages, const Eigen::VectorXd& x);
  /// Solves from the last solution, shifted by `knots`: 0 or 1.
  LimitedLqResult solve_warm(const LimitedLqBudget& budget, int knots);
  LimitedLqResult solve_cold(const LimitedLqBudget& budget);
  /// Runs the recursion alone, without limits. Keeps the data from which a warm solve starts.
  double recursion();
  const double* z(int knot) const { return limited_.z(knot); }
  int active();  ///< Number of active rows.

 private:
  LqHorizon view();
  void limits(const std::vector<LimitedStage>& stages);
  void remember();

  const LimitedRobot& robot_;
  int N_;
  StateShape state_;
  RiccatiRecursion recursion_;
  LimitedLq limited_;
  std::vector<Buffer> memory_;
  Buffer gaps_, hessian_gaps_, feedforwards_;
  std::vector<KnotExpansion> expansions_;
  std::vector<int> controls_, rows_;
  std::vector<ValueStorage> values_;
  std::vector<PolicyStorage> policies_;
};

}  // namespace burnish::bench
