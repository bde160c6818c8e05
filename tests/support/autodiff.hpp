// Automatic differentiation through the kernels. States are seeded with derivatives along the
// tangent of q and along v; the results are the derivatives with respect to q and v.
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

/// A vector with its derivative along every direction, one column each.
struct Seeded {
  Eigen::VectorXd values;
  Eigen::MatrixXd directions;
};

/// Returns the derivative of evaluate(x, y) along every direction of the seeds x and y, one column
/// each.
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

/// Derivatives with respect to q (along the tangent, at q (+) 0) and to another vector of nv
/// entries.
struct ByState {
  Eigen::MatrixXd dq, dv;

  /// Derivatives of some of the entries.
  ByState of(Eigen::Index first, Eigen::Index count) const {
    return {dq.middleRows(first, count), dv.middleRows(first, count)};
  }
};

/// Returns the derivatives of evaluate(q, v), with q (nq) and v (nv).
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

/// Concatenates the entries of vectors to a result of `evaluate`.
inline Duals entries(std::initializer_list<Vec3<Dual>> vectors) {
  Duals result;
  for (const Vec3<Dual>& v : vectors) result.insert(result.end(), {v.x, v.y, v.z});
  return result;
}
inline Duals entries(const Motion<Dual>& m) { return entries({m.linear, m.angular}); }
inline Duals entries(const Force<Dual>& f) { return entries({f.linear, f.angular}); }

}  // namespace burnish::test
