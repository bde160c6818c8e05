// A cost of your own: keep two points of an arm apart. Written once with values alone (derivatives
// come from differences) and once with its own derivative, which the checker compares.
#include <cmath>
#include <cstdio>

#include "burnish/ocp/check.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/solver/ddp.hpp"

using namespace burnish;

/// Distance between the origins of two frames, m.
struct Distance {
  std::string name = "distance";
  int rows = 1;
  std::vector<std::string> frames{"tool", "link_2"};
  void value(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    out[0] = (at.placement(0).translation() - at.placement(1).translation()).norm();
  }
};

/// The same with d(distance)/dz: only q matters. Linear rows of the Centered Jacobian are dp/dq.
struct DistanceWithDerivative : Distance {
  void jacobian(const NodeView& at, Eigen::Ref<RowMatrix> out) const {
    const Eigen::Vector3d apart = at.placement(0).translation() - at.placement(1).translation();
    const Eigen::RowVector3d direction = apart.normalized().transpose();
    auto dq = out.middleCols(at.layout().column_q(), at.layout().nv);
    dq = direction * at.jacobian(0, Reference::centered()).topRows(3);  // a view is read before the
    dq -= direction * at.jacobian(1, Reference::centered()).topRows(3);  // next one is asked for
  }
};

/// Solves with this residual and returns the cost.
double solve(const Robot& robot, const Residual& distance) {
  ProblemSpec spec{.model = robot.model};
  spec.initial_state = Eigen::VectorXd::Zero(robot.model.nq + robot.model.nv);
  spec.initial_state.head(robot.model.nq) = robot.reference_configuration();
  Stage fold{.name = "fold"};
  fold.costs = {{.residual = residual::State{}, .weight = 1.0},
                {.residual = residual::Control{}, .weight = 1e-4},
                {.residual = distance, .weight = 1e3, .penalty = Penalty::at_least(0.5)}};
  spec.stages = {fold};
  spec.horizon = {{"fold", 50}};
  Problem problem(spec);
  const ProblemReport report = check_problem(problem);
  DdpSolver solver(problem);
  solver.solve();
  std::printf("%s\n%s\n", report.pass ? "derivatives agree with differences" : "wrong derivatives",
              solver.text().c_str());
  return report.pass ? solver.summary().cost : std::nan("");
}

int main() {
  const Robot robot = load_robot("arm7");
  const double without = solve(robot, residual::custom(Distance{}));
  const double with = solve(robot, residual::custom(DistanceWithDerivative{}));
  std::printf("both ways %s\n",
              std::abs(with - without) < 1e-6 ? "the same cost" : "single differ");
}
