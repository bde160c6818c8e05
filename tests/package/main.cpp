// Uses an installed burnish as a user does. Eigen objects cross the boundary of the library both
// ways: allocated in the library and freed in the program, and the reverse.
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/model/state.hpp"
#include "burnish/robots/robot.hpp"

namespace {

void require(bool holds, const char* message) {
  if (holds) return;
  std::fprintf(stderr, "consumer: %s\n", message);
  std::exit(1);
}

}  // namespace

int main() {
  const char* installed = std::getenv("BURNISH_ROBOTS");
  require(!installed || burnish::robot_search_path().front() == installed,
          "the robots come from the wrong folder");
  burnish::Robot robot = burnish::load_robot("talos:right_arm");
  require(robot.model.nv == 6, "talos:right_arm should have 6 joints");

  // Freed here, allocated in the library, with sizes that no allocator rounds to the same block.
  std::mt19937_64 generator(7);
  Eigen::VectorXd q;
  for (int i = 0; i < 1000; ++i) {
    q = burnish::random_configuration(robot.model, generator);
    const Eigen::MatrixXd map = burnish::tangent_map(robot.model, q);
    require(map.rows() == robot.model.nq && map.cols() == robot.model.nv,
            "the tangent map has the wrong size");
  }
  // Allocated here, freed in the library: members are replaced and moved into objects of the
  // library.
  burnish::Model copy = robot.model;
  copy.q_neutral = Eigen::VectorXd::Zero(copy.nq);
  std::vector<burnish::ContactSpec> specs(1);
  specs[0].name = "board";
  specs[0].tool = "tool";
  specs[0].directions = burnish::Directions::z();
  specs[0].reference = burnish::Reference::surface_with_normal({-1.0, 0.0, 1.0});
  burnish::ContactDynamics dynamics(copy, specs);
  burnish::ContactDynamics moved = std::move(dynamics);

  q = robot.posture("tilt_45");
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(robot.model.nv);
  require(moved.inverse(q, still, still, Eigen::VectorXd::Constant(1, 30.0)) == burnish::Status::Ok,
          "inverse dynamics failed");
  const Eigen::VectorXd tau = moved.tau();
  require(moved.forward(q, still, tau) == burnish::Status::Ok, "forward dynamics failed");
  require(moved.forward_derivatives() == burnish::Status::Ok, "derivatives failed");
  require(moved.a().cwiseAbs().maxCoeff() < 1e-9, "the arm should be at rest");

  // Products large enough for the blocked kernels of Eigen, which both sides instantiate.
  const Eigen::MatrixXd m = Eigen::MatrixXd::Random(150, 150);
  const Eigen::MatrixXd square = m * m.transpose();
  double worst = 0.0;
  for (int i = 0; i < 150; ++i) {
    for (int j = 0; j < 150; ++j) {
      double entry = 0.0;
      for (int k = 0; k < 150; ++k) entry += m(i, k) * m(j, k);
      worst = std::max(worst, std::abs(entry - square(i, j)));
    }
  }
  require(worst < 1e-11, "a matrix product is wrong");

  burnish::ContactDynamicsBatch batch(robot.model, specs, 5);
  const Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(robot.model.nv, 5);
  require(batch.forward_with_derivatives(q.replicate(1, 5), columns, tau.replicate(1, 5)) ==
              burnish::Status::Ok,
          "batch failed");
  for (int i = 0; i < 5; ++i) {
    require((batch.da_dq(i) - moved.da_dq()).cwiseAbs().maxCoeff() <
                1e-9 * (1.0 + moved.da_dq().cwiseAbs().maxCoeff()),
            "batch and single state differ");
  }
  std::printf("%s\n", moved.force("board").text().c_str());
  std::printf("batch and single agree, in packs of %d\n", burnish::pack_width());
  return 0;
}
