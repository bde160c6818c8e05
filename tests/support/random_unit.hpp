// Random directions.
#pragma once

#include <Eigen/Core>
#include <random>

namespace burnish::test {

/// Random unit vector, uniform over all directions.
inline Eigen::Vector3d random_unit(std::mt19937_64& generator) {
  std::normal_distribution<double> draw;
  Eigen::Vector3d u(draw(generator), draw(generator), draw(generator));
  return u.normalized();
}

}  // namespace burnish::test
