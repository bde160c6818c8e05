// What a contact does to a robot: Talos presses its tool on a tilted board with 30 N.
// Shows: a robot by name, a contact along one direction, torques for a wanted force, the force as a
// sentence and in other references, and how the force reacts to the joints.
#include <cstdio>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/robots/robot.hpp"

int main() {
  const burnish::Robot robot = burnish::load_robot("talos:right_arm");
  const Eigen::VectorXd q = robot.posture("tilt_45");
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(robot.model.nv);

  // A tip that slides on the board: one direction is held, along the normal.
  burnish::ContactSpec tip;
  tip.name = "board";
  tip.tool = "tool";
  tip.reference = burnish::Reference::surface_with_normal({-1.0, 0.0, 1.0});
  tip.directions = burnish::Directions::z();
  burnish::ContactDynamics dynamics(robot.model, {tip});

  // Torques that hold the arm still while it presses with 30 N, and what they do.
  const Eigen::VectorXd wanted = Eigen::VectorXd::Constant(1, 30.0);
  if (dynamics.inverse(q, still, still, wanted) != burnish::Status::Ok) return 1;
  const Eigen::VectorXd tau = dynamics.tau();
  const burnish::Status status = dynamics.forward(q, still, tau);
  if (status != burnish::Status::Ok) {
    std::puts(std::string(burnish::describe(status)).c_str());
    return 1;
  }

  const burnish::ContactForce force = dynamics.force("board");
  std::printf("%s\n", force.text().c_str());
  std::printf("  the same: %s\n", force.in(burnish::Reference::local()).text().c_str());
  std::printf("  the same: %s\n", force.in(burnish::Reference::world()).text().c_str());

  // The torques stay, one joint moves: the force changes by
  if (dynamics.forward_derivatives() != burnish::Status::Ok) return 1;
  for (int k = 0; k < robot.model.nv; ++k) {
    std::printf("  %+8.2f N/rad  %+6.2f N/Nm  %s\n", dynamics.dlambda_dq()(0, k),
                dynamics.dlambda_dtau()(0, k), robot.model.v_name(k).c_str());
  }
}
