// One contact in the four references and in the axes of a third body: the same motion and the same
// force, in different numbers.
// Then the trap: as soon as some directions are free, the reference decides which ones are held.
#include <cmath>
#include <cstdio>
#include <utility>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/robots/robot.hpp"

namespace {

/// Acceleration of a robot at rest whose motors are off, with its tool held by the contact.
Eigen::VectorXd sag(const burnish::Robot& robot, const burnish::ContactSpec& contact,
                    burnish::Vector6* lambda) {
  burnish::ContactDynamics dynamics(robot.model, {contact});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(robot.model.nv);
  if (dynamics.forward(robot.posture("bent"), zero, zero) != burnish::Status::Ok) return zero;
  *lambda = dynamics.force(0).value;
  return dynamics.a();
}

}  // namespace

int main() {
  const burnish::Robot robot = burnish::load_robot("arm7");
  const burnish::Reference references[] = {
      burnish::Reference::local(), burnish::Reference::centered(),
      burnish::Reference::surface_with_normal({0.0, -1.0, 1.0}), burnish::Reference::world(),
      burnish::Reference{.axes = "link_4"}};  // at the tool, turning with the elbow

  for (const auto& [title, directions] : {std::pair{"All six held", burnish::Directions::all()},
                                          std::pair{"Only z held", burnish::Directions::z()}}) {
    std::printf("%s\n%-25s %29s %30s\n", title, "", "force (N)  and  moment (Nm)", "a (rad/s^2)");
    double spread = 0.0;
    Eigen::VectorXd first;
    for (const burnish::Reference& reference : references) {
      burnish::Vector6 lambda = burnish::Vector6::Zero();
      const Eigen::VectorXd a =
          sag(robot, {.name = {}, .tool = "tool", .reference = reference, .directions = directions},
              &lambda);
      if (first.size() == 0) first = a;
      spread = std::max(spread, (a - first).cwiseAbs().maxCoeff());
      std::printf("%-25s", reference.name().c_str());
      for (const double entry : lambda) std::printf(" %6.1f", std::abs(entry) < 0.05 ? 0.0 : entry);
      std::printf("  |");
      for (const double entry : a.head<4>()) std::printf(" %6.2f", entry);
      std::printf(" ...\n");
    }
    std::printf("-> %s accelerations\n\n", spread < 1e-8 ? "the same" : "different");
  }
}
