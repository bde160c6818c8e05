// Derivative blocks at one state: analytic derivatives and finite differences of values.
#include <limits>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/check_differences.hpp"
#include "derivatives/check_run.hpp"
#include "derivatives/check_values.hpp"

namespace burnish {
namespace {

/// Step of central differences of quadratic functions, in units of the argument; chosen by hand.
/// Such differences have no truncation error.
constexpr double exact_step = 0.5;

/// Returns the rounding error of central differences, for values that are sums of terms of the
/// given size. The factor 16 includes the amplification by the extrapolation.
double noise_of(double size, double step) {
  return 16.0 * std::numeric_limits<double>::epsilon() * size / step;
}

/// Returns the factor, at most 1, that scales the steps in q. It is below 1 if a contact follows a
/// surface whose radius of curvature is smaller than the robot.
double finer_on(const CheckState& state, const ContactSet& set, const ContactDynamics& dynamics,
                double length) {
  double sharpest = 1.0;
  for (int c = 0; c < set.size(); ++c) {
    const std::optional<Quadric>& stated = set.contacts()[c].spec.reference.quadric;
    const std::optional<Quadric>& surface = c == 0 && state.surface ? state.surface : stated;
    if (!surface) continue;
    const ContactForce at = dynamics.force(c);
    const Eigen::Vector3d tool =
        at.base_rotation.transpose() * (at.tool_position - at.base_position);
    const double slope = surface->gradient(tool).norm();
    if (slope > 0.0) sharpest = std::max(sharpest, surface->Q.norm() / slope * length);
  }
  return 1.0 / sharpest;
}

/// Finite differences of the values at one state. Each column belongs to one entry of the argument.
/// The rows are ordered as in CheckValues::at().
class Differences {
 public:
  Differences(const Model& model, CheckValues& values, const CheckState& state, bool forward)
      : model_(model), values_(values), state_(state), forward_(forward) {}

  /// Returns the extrapolated derivatives by q, in the tangent space.
  Eigen::MatrixXd by_q(const CheckSizes& sizes, double finer) {
    const CheckUnits& units = values_.units();
    const int nv = values_.nv(), m = values_.rows();
    Eigen::VectorXd rows(2 * (nv + m));
    rows << units.motion, units.row_force, units.torque, units.row;
    const auto moved = [&](double h) {
      CheckColumns columns(state_);
      columns.q.resize(model_.nq, model_.nv);
      for (int k = 0; k < model_.nv; ++k)
        columns.q.col(k) =
            integrate(model_, state_.q, h * units.motion[k] * Eigen::VectorXd::Unit(model_.nv, k));
      return Eigen::MatrixXd(rows.cwiseInverse().asDiagonal() *
                             values_.at(columns, model_.nv, {forward_, true, true}));
    };
    const auto noise = [&](double size) { return noise_of(size, finer * smallest_difference); };
    const Eigen::MatrixXd in_units = extrapolated_differences(moved,
                                                              {{nv, noise(sizes.a)},
                                                               {m, noise(sizes.lambda)},
                                                               {nv, noise(sizes.tau)},
                                                               {m, noise(sizes.alpha)}},
                                                              1e-8, finer);
    return rows.asDiagonal() * in_units * units.motion.cwiseInverse().asDiagonal();
  }
  /// Returns the derivatives by an argument in which the values are at most quadratic.
  Eigen::MatrixXd by(Eigen::MatrixXd CheckColumns::*argument, const Eigen::VectorXd& steps,
                     const Evaluations& wanted) {
    const auto moved = [&](double h) {
      CheckColumns columns(state_);
      const Eigen::VectorXd at = (columns.*argument).col(0);
      (columns.*argument) = at.replicate(1, at.size());
      (columns.*argument).diagonal() += h * steps;
      return values_.at(columns, static_cast<int>(at.size()), wanted);
    };
    return central_differences(moved, 1.0) * steps.cwiseInverse().asDiagonal();
  }

 private:
  const Model& model_;
  CheckValues& values_;
  const CheckState& state_;
  bool forward_;
};

/// Returns the lower bound of the scale of relative errors: a thousandth of the largest value, in
/// its unit. Smaller entries consist of rounding errors.
double floor_of(const Eigen::VectorXd& values, const Eigen::VectorXd& units) {
  return std::max(
      1e-12, 1e-3 * (values.size() > 0 ? values.cwiseQuotient(units).cwiseAbs().maxCoeff() : 0.0));
}

/// Builder of the derivative blocks at one state.
class Blocks {
 public:
  Blocks(const Model& model, ContactDynamics& dynamics, CheckValues& values,
         const CheckState& state)
      : dynamics_(dynamics),
        state_(state),
        units_(values.units()),
        nv_(dynamics.nv()),
        m_(dynamics.rows()) {
    forward_ = dynamics.forward(state.q, state.v, state.tau) != Status::SingularMass;
    finer_ = finer_on(state, dynamics.contacts(), dynamics, units_.length);
    sizes_ = values.sizes(state);
    Differences differences(model, values, state, forward_);
    by_q_ = differences.by_q(sizes_, finer_);
    by_v_ = differences.by(&CheckColumns::v, exact_step * units_.motion, {forward_, true, true});
    if (forward_)
      by_tau_ = differences.by(&CheckColumns::tau, exact_step * units_.torque, {.forward = true});
    by_a_ = differences.by(&CheckColumns::a, exact_step * units_.motion,
                           {.inverse = true, .acceleration = true});
    by_lambda_ =
        differences.by(&CheckColumns::lambda, exact_step * units_.row_force, {.inverse = true});
    for (int k = 0; k < model.nv; ++k) v_names_.push_back(model.v_name(k));
    row_names_ = dynamics_.row_names();
  }

  std::vector<DerivativeBlock> all() {
    if (forward_) add_forward();
    add_inverse();
    add_acceleration();
    return blocks_;
  }

 private:
  /// Rows or columns of a block: their names and units.
  struct Side {
    const std::vector<std::string>& names;
    const Eigen::VectorXd& units;
  };
  /// Sizes to which the errors of a block are compared, as in DerivativeBlock.
  struct ErrorSizes {
    double floor, noise;
  };
  void add(const char* name, const Side& rows, const Side& columns, const Eigen::MatrixXd& value,
           const Eigen::MatrixXd& expected, const ErrorSizes& sizes) {
    blocks_.push_back({name, rows.names, columns.names, value, expected, sizes.floor, sizes.noise,
                       rows.units, columns.units});
    if (!good_) blocks_.back().value.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  /// Sets the values of later blocks to NaN unless the status is Ok, so that these blocks fail.
  void require(Status status) { good_ = status == Status::Ok; }
  double q_step() const { return finer_ * smallest_difference; }

  void add_forward() {
    require(dynamics_.forward(state_.q, state_.v, state_.tau));
    const double a_floor = floor_of(dynamics_.a(), units_.motion);
    const double lambda_floor = floor_of(dynamics_.lambda(), units_.row_force);
    require(dynamics_.forward_derivatives());
    const auto add_a = [&](const char* name, const Side& columns, const Eigen::MatrixXd& value,
                           const Eigen::MatrixXd& by, double step) {
      add(name, motion_, columns, value, by.topRows(nv_), {a_floor, noise_of(sizes_.a, step)});
    };
    const auto add_lambda = [&](const char* name, const Side& columns, const Eigen::MatrixXd& value,
                                const Eigen::MatrixXd& by, double step) {
      add(name, row_forces_, columns, value, by.middleRows(nv_, m_),
          {lambda_floor, noise_of(sizes_.lambda, step)});
    };
    add_a("da_dq", motion_, dynamics_.da_dq(), by_q_, q_step());
    add_lambda("dlambda_dq", motion_, dynamics_.dlambda_dq(), by_q_, q_step());
    add_a("da_dv", motion_, dynamics_.da_dv(), by_v_, exact_step);
    add_lambda("dlambda_dv", motion_, dynamics_.dlambda_dv(), by_v_, exact_step);
    add_a("da_dtau", torque_, dynamics_.da_dtau(), by_tau_, exact_step);
    add_lambda("dlambda_dtau", torque_, dynamics_.dlambda_dtau(), by_tau_, exact_step);
  }

  void add_inverse() {
    require(dynamics_.inverse(state_.q, state_.v, state_.a, state_.lambda));
    const double floor = floor_of(dynamics_.tau(), units_.torque);
    const double noise = noise_of(sizes_.tau, exact_step);
    require(dynamics_.inverse_derivatives());
    const auto rows = [&](const Eigen::MatrixXd& by) { return by.middleRows(nv_ + m_, nv_); };
    add("dtau_dq", torque_, motion_, dynamics_.dtau_dq(), rows(by_q_),
        {floor, noise_of(sizes_.tau, q_step())});
    add("dtau_dv", torque_, motion_, dynamics_.dtau_dv(), rows(by_v_), {floor, noise});
    add("dtau_da", torque_, motion_, dynamics_.mass_matrix(), rows(by_a_), {1e-3 * floor, noise});
    add("dtau_dlambda", torque_, row_forces_, -dynamics_.jacobian().transpose(), rows(by_lambda_),
        {1e-3 * floor, noise});
  }

  void add_acceleration() {
    require(dynamics_.acceleration(state_.q, state_.v, state_.a));
    const double floor = floor_of(dynamics_.alpha(), units_.row);
    const double noise = noise_of(sizes_.alpha, exact_step);
    require(dynamics_.acceleration_derivatives());
    const auto rows = [&](const Eigen::MatrixXd& by) { return by.bottomRows(m_); };
    add("dalpha_dq", rows_, motion_, dynamics_.dalpha_dq(), rows(by_q_),
        {floor, noise_of(sizes_.alpha, q_step())});
    add("dalpha_dv", rows_, motion_, dynamics_.dalpha_dv(), rows(by_v_), {floor, noise});
    add("dalpha_da", rows_, motion_, dynamics_.jacobian(), rows(by_a_), {floor, noise});
  }

  ContactDynamics& dynamics_;
  const CheckState& state_;
  const CheckUnits& units_;
  int nv_, m_;
  double finer_ = 1.0;  ///< Scale of the steps in q, at most 1
  bool forward_ = true, good_ = true;
  Eigen::MatrixXd by_q_, by_v_, by_tau_, by_a_, by_lambda_;
  CheckSizes sizes_;
  std::vector<std::string> v_names_, row_names_;
  Side motion_{v_names_, units_.motion}, torque_{v_names_, units_.torque};
  Side rows_{row_names_, units_.row}, row_forces_{row_names_, units_.row_force};
  std::vector<DerivativeBlock> blocks_;
};

}  // namespace

std::vector<DerivativeBlock> derivative_blocks(const Model& model, ContactDynamics& dynamics,
                                               CheckValues& values, const CheckState& state) {
  if (state.surface) {
    if (dynamics.set_surface(0, *state.surface) != Status::Ok)
      throw Error("check: the surface at a state is not finite; wanted finite numbers");
    values.set_surface(*state.surface);
  }
  return Blocks(model, dynamics, values, state).all();
}

}  // namespace burnish
