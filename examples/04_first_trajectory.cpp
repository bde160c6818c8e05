// A first trajectory: an arm moves its tool to a point in one second and comes to rest there.
// Shows: a problem in code (what is measured, how much it counts, for how long), a solve, and what
// comes out: why the solver stopped, where the cost comes from, states, controls and gains.
#include <cstdio>

#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/solver/ddp.hpp"

using namespace burnish;

int main() {
  const Robot robot = load_robot("arm7");
  const Eigen::VectorXd q = robot.posture("ready");
  Eigen::VectorXd goal(3);  // m, world; the tool is at (0.45, 0.05, 0.25)
  goal << 0.55, -0.15, 0.35;

  ProblemSpec spec{.model = robot.model};
  spec.initial_state = Eigen::VectorXd::Zero(robot.model.nq + robot.model.nv);
  spec.initial_state.head(robot.model.nq) = q;  // at rest

  Stage move{.name = "move", .step = 0.01};
  move.costs = {{.residual = residual::State{}, .weight = 0.1},
                {.residual = residual::Control{}, .weight = 1e-4}};
  spec.stages = {move};
  spec.horizon = {{"move", 100}};  // 100 steps of 10 ms
  spec.terminal = {{.residual = residual::FramePosition{"tool", goal}, .weight = 1e4},
                   {.residual = residual::JointVelocity{}, .weight = 1e2}};

  Problem problem(spec);
  DdpSolver solver(problem);
  const DdpSummary& summary = solver.solve();
  std::printf("%s\n%s", solver.text().c_str(), solver.cost_report().text().c_str());
  if (summary.reason != StopReason::Converged) return 1;

  const Eigen::VectorXd last = solver.xs().row(100).head(robot.model.nq);
  const double miss = (frame_placement(robot.model, last, "tool").translation() - goal).norm();
  std::printf("the tool ends %.2f mm from the point, after %d iterations\n", 1e3 * miss,
              summary.iterations);

  // The same problem answers what to do next to the trajectory: u = u_0 + K (x (-) x_0).
  const NamedMatrix gain = solver.named_gain(0);
  std::printf("%s moves by %.1f Nm per rad of '%s'\n", gain.rows[1].c_str(), gain.values(1, 1),
              gain.columns[1].c_str());
}
