// Directions at random.
#pragma once

#include <Eigen/Core>
#include <random>

namespace burnish::test {

/// A unit vector, every direction as likely as any other.
inline Eigen::Vector3d random_unit(std::mt19937_64& generator) {
  std::normal_distribution<double> draw;
  Eigen::Vector3d u(draw(generator), draw(generator), draw(generator));
  return u.normalized();
}

}  // namespace burnish::test
