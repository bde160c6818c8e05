// Linear-quadratic problems with limits, as a robot that follows a reference meets them from tick
// to tick: torques, positions and speeds within their ranges, a band for the normal force of each
// foot, friction cones of four sides, and centres of pressure of soles. Drawn with a fixed seed.
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "burnish/base/views.hpp"
#include "solver/limited_lq.hpp"

namespace burnish::bench {

struct RobotSize {
  int nv, filtered, nu, feet;
  bool soles;  ///< feet have centres of pressure
};

/// z = (u, x); limits of the entries of z, then of the rows.
struct LimitedStage {
  RowMatrix hessian, velocity, rows;
  Eigen::VectorXd gradient, lower, upper, scale;
};

class LimitedRobot {
 public:
  static constexpr double knot_step = 0.01, filter_decay = 0.6;

  /// `load`: 0.1 and no limit pushes; at 1 about 1 in 40 does.
  LimitedRobot(const RobotSize& size, double load);

  int ndx() const { return 2 * size.nv + size.filtered; }
  int nz() const { return size.nu + ndx(); }
  int rows() const { return size.feet * (size.soles ? 9 : 5); }
  LimitedStage stage(double time, bool first, bool last) const;
  std::vector<LimitedStage> horizon(double time, int knots) const;
  Eigen::VectorXd start() const;
  /// x after one knot.
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

/// A horizon in the memory that LimitedLq works on.
class LimitedHorizon {
 public:
  LimitedHorizon(const LimitedRobot& robot, int knots);

  /// The problem from x on; it stays as it is until the next.
  void load(const std::vector<LimitedStage>& stages, const Eigen::VectorXd& x);
  /// From the last solution, shifted by `knots`: none or one.
  LimitedLqResult solve_warm(const LimitedLqBudget& budget, int knots);
  LimitedLqResult solve_cold(const LimitedLqBudget& budget);
  /// The recursion alone, without limits. What a warm solve starts from is kept.
  double recursion();
  const double* z(int knot) const { return limited_.z(knot); }
  int active();  ///< rows that push

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
