// Values of forward dynamics, inverse dynamics and contact acceleration at many states, with one
// state per lane.
#pragma once

#include "contact/constrained_dynamics.hpp"
#include "derivatives/check_states.hpp"
#include "math/pack.hpp"

namespace burnish {

/// Selection of the evaluations to run.
struct Evaluations {
  bool forward = false, inverse = false, acceleration = false;
};

/// States, one per column. A matrix with only one column applies to all states.
struct CheckColumns {
  explicit CheckColumns(const CheckState& state)
      : q(state.q), v(state.v), tau(state.tau), a(state.a), lambda(state.lambda) {}
  Eigen::MatrixXd q, v, tau, a, lambda;
};

/// Sizes of the terms that add up to the values of a state, in units of the check. The sizes
/// determine the rounding errors where terms cancel.
struct CheckSizes {
  double a = 0.0, lambda = 0.0, tau = 0.0, alpha = 0.0;
};

/// Evaluator of one set of contacts.
class CheckValues {
 public:
  CheckValues(const Model& model, const ContactSet& set, const ContactSolver& solver);

  /// Returns the values at n states, one state per column. Rows: a (nv), lambda (rows), tau (nv),
  /// alpha (rows). Values of unwanted evaluations are zero; values without status Ok are NaN.
  Eigen::MatrixXd at(const CheckColumns& states, int n, const Evaluations& wanted);

  /// Replaces the surface that the first contact follows.
  void set_surface(const Quadric& surface);

  /// Returns the sizes of terms at one state. The sizes of a and lambda are zero if M is singular.
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
