// Automatic differentiation through the kernels: states whose derivatives are seeded along the
// tangent of q and along v, and the blocks d/dq and d/dv of what a kernel makes of them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <initializer_list>
#include <span>
#include <vector>

#include "burnish/model/state.hpp"
#include "math/spatial.hpp"
#include "support/dual.hpp"

namespace burnish::test {

using Duals = std::vector<Dual>;

/// Values with zero derivatives.
inline Duals constant_duals(const Eigen::VectorXd& x) {
  Duals result;
  for (const double value : x) result.emplace_back(value);
  return result;
}

/// A vector and its derivative along every direction (a column each).
struct Seeded {
  Eigen::VectorXd values;
  Eigen::MatrixXd directions;
};

/// The derivative, along every direction of the seeds x and y, of the Duals that `evaluate` makes
/// of x and y: as many columns as they have.
template <class Evaluate>
Eigen::MatrixXd differentiate(const Seeded& x, const Seeded& y, Evaluate&& evaluate) {
  const auto columns = static_cast<int>(x.directions.cols());
  Eigen::MatrixXd result;
  for (int first = 0; first < columns; first += dual_directions) {
    const int count = std::min(dual_directions, columns - first);
    const auto seeded = [&](const Seeded& vector) {
      Duals duals = constant_duals(vector.values);
      for (std::size_t i = 0; i < duals.size(); ++i)
        for (int k = 0; k < count; ++k)
          duals[i].set(k, vector.directions(static_cast<Eigen::Index>(i), first + k));
      return duals;
    };
    const Duals values = evaluate(seeded(x), seeded(y));
    if (first == 0) result.resize(static_cast<Eigen::Index>(values.size()), columns);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (int k = 0; k < count; ++k)
        result(static_cast<Eigen::Index>(i), first + k) = values[i].derivative(k);
  }
  return result;
}

/// Derivatives of one thing by q (along the tangent, at q (+) 0) and by another vector of nv
/// entries.
struct ByState {
  Eigen::MatrixXd dq, dv;

  /// Those of some of the entries.
  ByState of(Eigen::Index first, Eigen::Index count) const {
    return {dq.middleRows(first, count), dv.middleRows(first, count)};
  }
};

/// The derivatives of what `evaluate` makes of q (nq) and v (nv).
template <class Evaluate>
ByState differentiate(const Model& model, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                      Evaluate&& evaluate) {
  const int n = model.nv;
  Seeded by_q{q, Eigen::MatrixXd::Zero(model.nq, 2 * n)}, by_v{v, Eigen::MatrixXd::Zero(n, 2 * n)};
  by_q.directions.leftCols(n) = tangent_map(model, q);
  by_v.directions.rightCols(n).setIdentity();
  const Eigen::MatrixXd both = differentiate(by_q, by_v, evaluate);
  return {both.leftCols(n), both.rightCols(n)};
}

inline Eigen::VectorXd values_of(std::span<const Dual> duals) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(duals.size()));
  Eigen::Index row = 0;
  for (const Dual& dual : duals) result[row++] = dual.value();
  return result;
}

/// The entries of vectors one after the other, as the functions above take them.
inline Duals entries(std::initializer_list<Vec3<Dual>> vectors) {
  Duals result;
  for (const Vec3<Dual>& v : vectors) result.insert(result.end(), {v.x, v.y, v.z});
  return result;
}
inline Duals entries(const Motion<Dual>& m) { return entries({m.linear, m.angular}); }
inline Duals entries(const Force<Dual>& f) { return entries({f.linear, f.angular}); }

}  // namespace burnish::test
