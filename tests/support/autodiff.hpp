// Automatic differentiation through the kernels: states whose derivatives are seeded along the
// tangent of q and along v, and the blocks d/dq and d/dv read back from results.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <span>
#include <string>
#include <unsupported/Eigen/AutoDiff>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/model/state.hpp"
#include "math/spatial.hpp"

namespace burnish::test {

/// Directions that one evaluation differentiates along: room for d/dq and d/dv of 40 joints.
inline constexpr int dual_directions = 80;

/// A value and its derivatives: d/d(dq) in entries 0 to nv - 1, d/dv in entries nv to 2 nv - 1.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, dual_directions, 1>>;

/// Values with zero derivatives.
inline std::vector<Dual> constant_duals(const Eigen::VectorXd& x) {
  std::vector<Dual> result;
  for (const double value : x) result.emplace_back(value);
  return result;
}

inline void check_room(const Model& model) {
  if (2 * model.nv > dual_directions)
    throw Error("automatic differentiation has room for " + std::to_string(dual_directions / 2) +
                " entries of v; the model has " + std::to_string(model.nv));
}

/// q (nq) with the derivatives of q (+) dq at dq = 0.
inline std::vector<Dual> seeded_q(const Model& model, const Eigen::VectorXd& q) {
  check_room(model);
  const Eigen::MatrixXd map = tangent_map(model, q);
  std::vector<Dual> result = constant_duals(q);
  for (int i = 0; i < model.nq; ++i)
    result[static_cast<std::size_t>(i)].derivatives().head(model.nv) = map.row(i);
  return result;
}

/// v (nv) with unit derivatives along v.
inline std::vector<Dual> seeded_v(const Model& model, const Eigen::VectorXd& v) {
  check_room(model);
  std::vector<Dual> result = constant_duals(v);
  for (int k = 0; k < model.nv; ++k)
    result[static_cast<std::size_t>(k)].derivatives()[model.nv + k] = 1.0;
  return result;
}

/// Row i: derivatives `first` to `first + count - 1` of value i.
inline Eigen::MatrixXd derivative_block(std::span<const Dual> values, int first, int count) {
  Eigen::MatrixXd block(static_cast<Eigen::Index>(values.size()), count);
  Eigen::Index row = 0;
  for (const Dual& value : values) block.row(row++) = value.derivatives().segment(first, count);
  return block;
}
/// values.size() x nv.
inline Eigen::MatrixXd d_dq(const Model& model, std::span<const Dual> values) {
  return derivative_block(values, 0, model.nv);
}
inline Eigen::MatrixXd d_dv(const Model& model, std::span<const Dual> values) {
  return derivative_block(values, model.nv, model.nv);
}

inline Eigen::VectorXd values_of(std::span<const Dual> duals) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(duals.size()));
  Eigen::Index row = 0;
  for (const Dual& dual : duals) result[row++] = dual.value();
  return result;
}

/// The entries of vectors one after the other, as the functions above take them.
inline std::vector<Dual> entries(std::initializer_list<Vec3<Dual>> vectors) {
  std::vector<Dual> result;
  for (const Vec3<Dual>& v : vectors) result.insert(result.end(), {v.x, v.y, v.z});
  return result;
}
inline std::vector<Dual> entries(const Motion<Dual>& m) { return entries({m.linear, m.angular}); }
inline std::vector<Dual> entries(const Force<Dual>& f) { return entries({f.linear, f.angular}); }

}  // namespace burnish::test
