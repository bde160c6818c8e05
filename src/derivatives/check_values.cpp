#include "derivatives/check_values.hpp"

#include <limits>
#include <numbers>

#include "base/decomposition.hpp"
#include "base/to_size.hpp"

namespace burnish {

extern template class ConstrainedDynamics<NativePack>;

namespace {

double size_of(const Vec3<NativePack>& v) {
  return Eigen::Vector3d(v.x.v[0], v.y.v[0], v.z.v[0]).norm();
}

/// Loads columns `first` to `first` + lanes - 1 of n columns. Lanes past the end repeat the last
/// column. If `from` has only one column, every lane gets it.
void load(const Eigen::MatrixXd& from, int first, int n, std::vector<NativePack>& to) {
  for (int l = 0; l < native_lanes; ++l) {
    const int column = from.cols() == 1 ? 0 : std::min(first + l, n - 1);
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i].v[l] = from(static_cast<Eigen::Index>(i), column);
  }
}

}  // namespace

CheckValues::CheckValues(const Model& model, const ContactSet& set, const ContactSolver& solver)
    : units_(model, set),
      dynamics_(model, set, solver),
      q_(to_size(model.nq)),
      v_(to_size(model.nv)),
      tau_(v_),
      a_(v_),
      lambda_(to_size(set.rows())) {}

void CheckValues::store(const std::vector<NativePack>& from, int count, int row, int first,
                        Eigen::MatrixXd& to) const {
  const int end = std::min(native_lanes, static_cast<int>(to.cols()) - first);
  for (int l = 0; l < end; ++l) {
    const bool good = dynamics_.status(l) == Status::Ok;
    for (int i = 0; i < count; ++i)
      to(row + i, first + l) =
          good ? from[to_size(i)].v[l] : std::numeric_limits<double>::quiet_NaN();
  }
}

Eigen::MatrixXd CheckValues::at(const CheckColumns& states, int n, const Evaluations& wanted) {
  const int m = rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * (nv() + m), n);
  for (int first = 0; first < n; first += native_lanes) {
    load(states.q, first, n, q_);
    load(states.v, first, n, v_);
    load(states.tau, first, n, tau_);
    load(states.a, first, n, a_);
    load(states.lambda, first, n, lambda_);
    dynamics_.set_state(q_.data(), v_.data());
    // Forward dynamics runs last, because a status SingularMass remains until set_state().
    if (wanted.inverse) {
      dynamics_.inverse(a_.data(), lambda_.data());
      store(dynamics_.tau, nv(), nv() + m, first, result);
    }
    if (wanted.acceleration) {
      dynamics_.acceleration(a_.data());
      store(dynamics_.alpha, m, 2 * nv() + m, first, result);
    }
    if (wanted.forward) {
      dynamics_.forward(tau_.data());
      store(dynamics_.a, nv(), 0, first, result);
      store(dynamics_.lambda, m, nv(), first, result);
    }
  }
  return result;
}

void CheckValues::set_surface(const Quadric& surface) {
  dynamics_.set_surface(
      0, {lift<NativePack>(from_eigen(surface.Q)), lift<NativePack>(from_eigen(surface.b))});
}

/// Returns bounds of the bias torques. A torque is a sum of scalar products. Its bound is the sum
/// of the products of the vectors' lengths.
Eigen::VectorXd CheckValues::bias_sizes() const {
  const Tree& tree = dynamics_.tree();
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(nv());
  for (int k = 0; k < tree.axes; ++k) {
    const auto& axis = dynamics_.kinematics().axes[k].axis;
    const auto& force = dynamics_.mass().composite_bias[tree.joint_of_axis[k]];
    sizes[tree.v_of_axis[k]] += size_of(axis.linear) * size_of(force.linear) +
                                size_of(axis.angular) * size_of(force.angular);
  }
  return sizes;
}

/// Returns bounds of the terms of the contact acceleration at zero joint accelerations: gravity
/// (which cancels), accelerations moved from the world's origin to the tool, and the gain terms.
Eigen::VectorXd CheckValues::drift_sizes() const {
  Eigen::VectorXd sizes(rows());
  int row = 0;
  for (int c = 0; c < dynamics_.set().size(); ++c) {
    const CompiledContact& contact = dynamics_.set().contacts()[c];
    const ContactState<NativePack>& state = dynamics_.contact_states[c];
    const double lever = size_of(state.p);
    double linear = to_eigen(dynamics_.tree().gravity).norm(), angular = 0.0;
    for (const int body : {contact.tool_body, contact.base_body}) {
      if (body < 0) continue;
      const auto& bias = dynamics_.kinematics().bodies[body].a_bias;
      linear += size_of(bias.linear) + size_of(bias.angular) * lever;
      angular += size_of(bias.angular);
    }
    const double speed = size_of(state.nu.linear) + size_of(state.nu.angular) * lever;
    for (const int d : contact.directions) {
      sizes[row] = d < 3 ? linear : angular;
      sizes[row] += contact.spec.kd[d] * (d < 3 ? speed : size_of(state.nu.angular));
      sizes[row] += contact.spec.kp[d] * (d < 3 ? 2.0 * lever + 1.0 : std::numbers::pi);
      ++row;
    }
  }
  return sizes;
}

CheckSizes CheckValues::sizes(const CheckState& state) {
  at(CheckColumns(state), 1, {.forward = true});
  const auto& delassus = dynamics_.delassus();
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(nv(), nv()), J(rows(), nv());
  for (int i = 0; i < nv(); ++i)
    for (int j = i; j >= 0; j = dynamics_.tree().parent_of_v[j])
      M(i, j) = M(j, i) = dynamics_.mass().mass[i * nv() + j].v[0];
  for (int k = 0; k < nv(); ++k)
    for (int r = 0; r < rows(); ++r) J(r, k) = delassus.jacobian_by_v[k * delassus.stride + r].v[0];
  const Eigen::MatrixXd abs_J = J.cwiseAbs();
  const Eigen::VectorXd bias = bias_sizes(), drift = drift_sizes();
  const auto largest = [](const Eigen::VectorXd& x, const Eigen::VectorXd& units) {
    return x.size() > 0 ? x.cwiseQuotient(units).maxCoeff() : 0.0;
  };
  CheckSizes sizes;
  sizes.tau = largest(
      M.cwiseAbs() * state.a.cwiseAbs() + bias + abs_J.transpose() * state.lambda.cwiseAbs(),
      units_.torque);
  sizes.alpha = largest(abs_J * state.a.cwiseAbs() + drift, units_.row);
  if (dynamics_.status(0) >= Status::SingularMass) return sizes;
  const Eigen::MatrixXd inverse =
      solve_positive(M, Eigen::MatrixXd::Identity(nv(), nv())).cwiseAbs();
  Eigen::VectorXd a = inverse * (state.tau.cwiseAbs() + bias);
  if (rows() > 0) {
    Eigen::MatrixXd G = J * solve_positive(M, J.transpose());
    G.diagonal().array() += dynamics_.solver().mu;
    const Eigen::VectorXd lambda =
        solve_positive(G, Eigen::MatrixXd::Identity(rows(), rows())).cwiseAbs() *
        (abs_J * a + drift);
    sizes.lambda = largest(lambda, units_.row_force);
    a += inverse * (abs_J.transpose() * lambda);
  }
  sizes.a = largest(a, units_.motion);
  return sizes;
}

}  // namespace burnish
