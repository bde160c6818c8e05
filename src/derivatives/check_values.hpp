// Values of the three evaluations at many states, several at a time.
#pragma once

#include "contact/constrained_dynamics.hpp"
#include "derivatives/check_states.hpp"
#include "math/pack.hpp"

namespace burnish {

/// Which evaluations are wanted.
struct Evaluations {
  bool forward = false, inverse = false, acceleration = false;
};

/// States, one per column; what has one column is the same for all.
struct CheckColumns {
  explicit CheckColumns(const CheckState& state)
      : q(state.q), v(state.v), tau(state.tau), a(state.a), lambda(state.lambda) {}
  Eigen::MatrixXd q, v, tau, a, lambda;
};

/// How large the numbers are that the values of a state are sums of, in units of the check: what is
/// left of them where they cancel is rounding.
struct CheckSizes {
  double a = 0.0, lambda = 0.0, tau = 0.0, alpha = 0.0;
};

class CheckValues {
 public:
  CheckValues(const Model& model, const ContactSet& set, const ContactSolver& solver);

  /// Of n states: rows a (nv), lambda (rows), tau (nv), alpha (rows), a column per state. What is
  /// not wanted is zero, what has no status Ok is NaN.
  Eigen::MatrixXd at(const CheckColumns& states, int n, const Evaluations& wanted);

  /// Another one that the first contact follows.
  void set_surface(const Quadric& surface);

  /// At one state; a and lambda zero where M is singular.
  CheckSizes sizes(const CheckState& state);
  const CheckUnits& units() const { return units_; }

  int nv() const { return dynamics_.nv(); }
  int rows() const { return dynamics_.rows(); }

 private:
  void store(const std::vector<NativePack>& from, int count, int row, int first,
             Eigen::MatrixXd& to) const;
  Eigen::VectorXd bias_sizes() const;
  Eigen::VectorXd drift_sizes() const;

  CheckUnits units_;
  ConstrainedDynamics<NativePack> dynamics_;
  std::vector<NativePack> q_, v_, tau_, a_, lambda_;
};

}  // namespace burnish
