#include "cases.hpp"

#include <map>
#include <random>

#include "burnish/model/state.hpp"
#include "burnish/robots/robot.hpp"

namespace burnish::bench {

namespace {

const Robot& robot_of(const std::string& name) {
  static std::map<std::string, Robot> loaded;
  const auto found = loaded.find(name);
  return found != loaded.end() ? found->second
                               : loaded.emplace(name, load_robot(name)).first->second;
}

}  // namespace

std::vector<ContactSpec> Case::specs(const std::string& reference) const {
  std::vector<ContactSpec> result;
  for (const std::string& tool : tools) {
    ContactSpec spec;
    spec.tool = tool;
    spec.directions = directions;
    spec.reference = reference == "surface" ? Reference::surface_with_normal({0.2, -0.4, 0.9})
                                            : Reference::parse(reference);
    spec.with_gains(0.0, 50.0);
    result.push_back(spec);
  }
  return result;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"talos:right_arm", "talos_right_arm", "1D", {"tool"}, Directions::z()},
      {"talos:right_arm", "talos_right_arm", "3D", {"tool"}, Directions::linear()},
      {"talos:right_arm", "talos_right_arm", "6D", {"tool"}, Directions::all()},
      {"arm7", "arm7", "3D", {"tool"}, Directions::linear()},
      {"arm7", "arm7", "6D", {"tool"}, Directions::all()},
      {"talos", "talos", "2x6D", {"left_sole_link", "right_sole_link"}, Directions::all()},
  };
  return all;
}

const std::vector<std::string>& references() {
  static const std::vector<std::string> all{"local", "centered", "surface", "world"};
  return all;
}

const Model& model_of(const std::string& robot) { return robot_of(robot).model; }

States states_near_reference(const std::string& robot, int count) {
  const Model& model = model_of(robot);
  const Eigen::VectorXd q0 = robot_of(robot).reference_configuration();
  std::mt19937_64 generator(20);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto random = [&](double scale) -> Eigen::VectorXd {
    return Eigen::VectorXd::NullaryExpr(model.nv, [&] { return scale * unit(generator); });
  };
  States states{Eigen::MatrixXd(model.nq, count), Eigen::MatrixXd(model.nv, count),
                Eigen::MatrixXd(model.nv, count)};
  for (int i = 0; i < count; ++i) {
    states.q.col(i) = integrate(model, q0, random(0.3));
    states.v.col(i) = random(1.0);
    states.tau.col(i) = random(10.0);
  }
  return states;
}

}  // namespace burnish::bench
