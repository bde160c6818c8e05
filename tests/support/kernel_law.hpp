// Laws of every kernel with derivatives: it agrees with automatic differentiation through itself
// and with central differences, and every lane of a pack gives the result of a single state.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "math/pack.hpp"
#include "support/autodiff.hpp"
#include "support/robots.hpp"

namespace burnish::test {

/// Derivatives of n values, row-major n x nv.
template <class S>
struct Blocks {
  std::vector<S> dq, dv;
};

/// Largest difference of two matrices, relative to their largest entry (at least 1).
template <class A, class B>
double relative_error(const Eigen::MatrixBase<A>& got, const Eigen::MatrixBase<B>& wanted) {
  if (got.size() == 0) return 0.0;
  return (got - wanted).cwiseAbs().maxCoeff() / std::max(1.0, wanted.cwiseAbs().maxCoeff());
}

inline Eigen::MatrixXd as_matrix(const std::vector<double>& entries, int columns) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(entries.data(), static_cast<Eigen::Index>(entries.size()) / columns,
                                columns);
}
inline Eigen::VectorXd as_vector(const std::vector<double>& entries) {
  return Eigen::Map<const Eigen::VectorXd>(entries.data(),
                                           static_cast<Eigen::Index>(entries.size()));
}

/// State: q (nq), v and a (nv).
struct KernelState {
  Eigen::VectorXd q, v, a;
};
inline KernelState random_kernel_state(const Model& model, std::mt19937_64& generator) {
  return {random_configuration(model, generator), random_vector(model.nv, 1.0, generator),
          random_vector(model.nv, 1.0, generator)};
}

/// Returns a vector with x[i] of state l in lane l of entry i.
template <class S>
std::vector<S> packed(const std::vector<Eigen::VectorXd>& x) {
  std::vector<S> result(static_cast<std::size_t>(x[0].size()), S(0.0));
  for (std::size_t i = 0; i < result.size(); ++i)
    for (int l = 0; l < Lanes<S>::count; ++l)
      Lanes<S>::set(result[i], l, x[static_cast<std::size_t>(l)][static_cast<Eigen::Index>(i)]);
  return result;
}
template <class S>
std::vector<double> lane_values(const std::vector<S>& x, int lane) {
  std::vector<double> result;
  for (const S& entry : x) result.push_back(Lanes<S>::get(entry, lane));
  return result;
}

/// `Kernel` has, for any scalar S and a state q, v, a:
///   std::vector<S> values(q, v, a) const;     values to differentiate
///   Blocks<S> derivatives(q, v, a) const;     their derivatives with respect to q and v
template <class Kernel>
void expect_kernel_law(const Model& model, const Kernel& kernel, int states = 10) {
  std::mt19937_64 generator(20250);
  const int n = model.nv;
  const double step = 1e-6;
  for (int state = 0; state < states; ++state) {
    const KernelState s = random_kernel_state(model, generator);
    const Blocks<double> blocks =
        kernel.template derivatives<double>(s.q.data(), s.v.data(), s.a.data());
    const Eigen::MatrixXd dq = as_matrix(blocks.dq, n), dv = as_matrix(blocks.dv, n);

    const Duals a = constant_duals(s.a);
    const ByState by = differentiate(model, s.q, s.v, [&](const Duals& q, const Duals& v) {
      return kernel.template values<Dual>(q.data(), v.data(), a.data());
    });
    EXPECT_LE(relative_error(dq, by.dq), 1e-12) << "d/dq, automatic differentiation";
    EXPECT_LE(relative_error(dv, by.dv), 1e-12) << "d/dv, automatic differentiation";

    const auto values = [&](const Eigen::VectorXd& at_q, const Eigen::VectorXd& at_v) {
      return as_vector(kernel.template values<double>(at_q.data(), at_v.data(), s.a.data()));
    };
    Eigen::MatrixXd by_q(dq.rows(), n), by_v(dv.rows(), n);
    for (int k = 0; k < n; ++k) {
      const Eigen::VectorXd h = step * Eigen::VectorXd::Unit(n, k);
      by_q.col(k) =
          (values(integrate(model, s.q, h), s.v) - values(integrate(model, s.q, -h), s.v)) /
          (2.0 * step);
      by_v.col(k) = (values(s.q, s.v + h) - values(s.q, s.v - h)) / (2.0 * step);
    }
    EXPECT_LE(relative_error(dq, by_q), 1e-7) << "d/dq, central differences";
    EXPECT_LE(relative_error(dv, by_v), 1e-7) << "d/dv, central differences";
  }
}

/// Expects the values and blocks of every lane to equal those of its state alone.
template <class Kernel>
void expect_lanes_alike(const Model& model, const Kernel& kernel) {
  using S = NativePack;
  std::mt19937_64 generator(77);
  std::vector<KernelState> states;
  std::vector<Eigen::VectorXd> q, v, a;
  for (int l = 0; l < native_lanes; ++l) {
    states.push_back(random_kernel_state(model, generator));
    q.push_back(states.back().q);
    v.push_back(states.back().v);
    a.push_back(states.back().a);
  }
  const std::vector<S> Q = packed<S>(q), V = packed<S>(v), A = packed<S>(a);
  const std::vector<S> values = kernel.template values<S>(Q.data(), V.data(), A.data());
  const Blocks<S> blocks = kernel.template derivatives<S>(Q.data(), V.data(), A.data());
  for (int l = 0; l < native_lanes; ++l) {
    const KernelState& s = states[static_cast<std::size_t>(l)];
    const auto one = kernel.template values<double>(s.q.data(), s.v.data(), s.a.data());
    const auto one_d = kernel.template derivatives<double>(s.q.data(), s.v.data(), s.a.data());
    const auto error = [&](const std::vector<S>& pack, const std::vector<double>& alone) {
      return relative_error(as_vector(lane_values(pack, l)), as_vector(alone));
    };
    EXPECT_LE(error(values, one), 1e-13) << "lane " << l;
    EXPECT_LE(error(blocks.dq, one_d.dq), 1e-13) << "lane " << l;
    EXPECT_LE(error(blocks.dv, one_d.dv), 1e-13) << "lane " << l;
  }
}

/// Test suite over test_robots().
class OnRobots : public ::testing::TestWithParam<TestRobot> {
 protected:
  Model model = GetParam().model();
};
inline std::string robot_label(const ::testing::TestParamInfo<TestRobot>& info) {
  return info.param.label();
}

}  // namespace burnish::test
