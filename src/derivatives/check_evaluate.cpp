// The blocks of one state, twice: from the library's derivatives and from its values.
#include <limits>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/check_differences.hpp"
#include "derivatives/check_run.hpp"
#include "derivatives/check_values.hpp"

namespace burnish {
namespace {

constexpr double exact_step = 0.5;  // of central differences of quadratic functions

/// What central differences with a step leave of the rounding of sums of this size, some of which
/// the extrapolation multiplies.
double noise_of(double size, double step) {
  return 16.0 * std::numeric_limits<double>::epsilon() * size / step;
}

/// Differences of the values at one state. Columns are entries of what is moved, rows those of
/// CheckValues::at.
class Differences {
 public:
  Differences(const Model& model, CheckValues& values, const CheckState& state, bool forward)
      : model_(model), values_(values), state_(state), forward_(forward) {}

  /// By q, in the tangent space, as exactly as the comparison needs it.
  Eigen::MatrixXd by_q(const CheckSizes& sizes) {
    const auto moved = [&](double h) {
      CheckColumns columns(state_);
      columns.q.resize(model_.nq, model_.nv);
      for (int k = 0; k < model_.nv; ++k)
        columns.q.col(k) = integrate(model_, state_.q, h * Eigen::VectorXd::Unit(model_.nv, k));
      return values_.at(columns, model_.nv, {forward_, true, true});
    };
    const int nv = values_.nv(), m = values_.rows();
    const auto noise = [](double size) { return noise_of(size, smallest_difference); };
    return extrapolated_differences(moved,
                                    {{nv, noise(sizes.a)},
                                     {m, noise(sizes.lambda)},
                                     {nv, noise(sizes.tau)},
                                     {m, noise(sizes.alpha)}},
                                    1e-8);
  }
  /// By another argument, in which the values are at most quadratic.
  Eigen::MatrixXd by(Eigen::MatrixXd CheckColumns::*argument, const Evaluations& wanted) {
    const auto moved = [&](double h) {
      CheckColumns columns(state_);
      const Eigen::VectorXd at = (columns.*argument).col(0);
      (columns.*argument) = at.replicate(1, at.size());
      (columns.*argument).diagonal().array() += h;
      return values_.at(columns, static_cast<int>(at.size()), wanted);
    };
    return central_differences(moved, exact_step);
  }

 private:
  const Model& model_;
  CheckValues& values_;
  const CheckState& state_;
  bool forward_;
};

/// Errors of entries far below the values themselves are rounding.
double floor_of(const Eigen::VectorXd& values) {
  return std::max(1e-12, 1e-3 * (values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0));
}

/// The blocks of one state, put together.
class Blocks {
 public:
  Blocks(const Model& model, ContactDynamics& dynamics, CheckValues& values,
         const CheckState& state)
      : dynamics_(dynamics), state_(state), nv_(dynamics.nv()), m_(dynamics.rows()) {
    forward_ = dynamics.forward(state.q, state.v, state.tau) != Status::SingularMass;
    sizes_ = values.sizes(state);
    Differences differences(model, values, state, forward_);
    by_q_ = differences.by_q(sizes_);
    by_v_ = differences.by(&CheckColumns::v, {forward_, true, true});
    if (forward_) by_tau_ = differences.by(&CheckColumns::tau, {.forward = true});
    by_a_ = differences.by(&CheckColumns::a, {.inverse = true, .acceleration = true});
    by_lambda_ = differences.by(&CheckColumns::lambda, {.inverse = true});
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
  void add(const char* name, const std::vector<std::string>& rows,
           const std::vector<std::string>& columns, const Eigen::MatrixXd& value,
           const Eigen::MatrixXd& expected, double floor, double noise) {
    blocks_.push_back({name, rows, columns, value, expected, floor, noise});
    if (!good_) blocks_.back().value.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  /// What has no result has no derivatives either: its blocks fail.
  void require(Status status) { good_ = status == Status::Ok; }

  void add_forward() {
    require(dynamics_.forward(state_.q, state_.v, state_.tau));
    const double a_floor = floor_of(dynamics_.a()), lambda_floor = floor_of(dynamics_.lambda());
    require(dynamics_.forward_derivatives());
    const auto pair = [&](const char* a, const char* lambda, const Eigen::MatrixXd& by,
                          const Eigen::MatrixXd& da, const Eigen::MatrixXd& dlambda, double step) {
      add(a, v_names_, v_names_, da, by.topRows(nv_), a_floor, noise_of(sizes_.a, step));
      add(lambda, row_names_, v_names_, dlambda, by.middleRows(nv_, m_), lambda_floor,
          noise_of(sizes_.lambda, step));
    };
    pair("da_dq", "dlambda_dq", by_q_, dynamics_.da_dq(), dynamics_.dlambda_dq(),
         smallest_difference);
    pair("da_dv", "dlambda_dv", by_v_, dynamics_.da_dv(), dynamics_.dlambda_dv(), exact_step);
    pair("da_dtau", "dlambda_dtau", by_tau_, dynamics_.da_dtau(), dynamics_.dlambda_dtau(),
         exact_step);
  }

  void add_inverse() {
    require(dynamics_.inverse(state_.q, state_.v, state_.a, state_.lambda));
    const double floor = floor_of(dynamics_.tau());
    const double noise = noise_of(sizes_.tau, exact_step);
    require(dynamics_.inverse_derivatives());
    const auto rows = [&](const Eigen::MatrixXd& by) { return by.middleRows(nv_ + m_, nv_); };
    add("dtau_dq", v_names_, v_names_, dynamics_.dtau_dq(), rows(by_q_), floor,
        noise_of(sizes_.tau, smallest_difference));
    add("dtau_dv", v_names_, v_names_, dynamics_.dtau_dv(), rows(by_v_), floor, noise);
    add("dtau_da", v_names_, v_names_, dynamics_.mass_matrix(), rows(by_a_), 1e-3 * floor, noise);
    add("dtau_dlambda", v_names_, row_names_, -dynamics_.jacobian().transpose(), rows(by_lambda_),
        1e-3 * floor, noise);
  }

  void add_acceleration() {
    require(dynamics_.acceleration(state_.q, state_.v, state_.a));
    const double floor = floor_of(dynamics_.alpha());
    const double noise = noise_of(sizes_.alpha, exact_step);
    require(dynamics_.acceleration_derivatives());
    const auto rows = [&](const Eigen::MatrixXd& by) { return by.bottomRows(m_); };
    add("dalpha_dq", row_names_, v_names_, dynamics_.dalpha_dq(), rows(by_q_), floor,
        noise_of(sizes_.alpha, smallest_difference));
    add("dalpha_dv", row_names_, v_names_, dynamics_.dalpha_dv(), rows(by_v_), floor, noise);
    add("dalpha_da", row_names_, v_names_, dynamics_.jacobian(), rows(by_a_), floor, noise);
  }

  ContactDynamics& dynamics_;
  const CheckState& state_;
  int nv_, m_;
  bool forward_ = true, good_ = true;
  Eigen::MatrixXd by_q_, by_v_, by_tau_, by_a_, by_lambda_;
  CheckSizes sizes_;
  std::vector<std::string> v_names_, row_names_;
  std::vector<DerivativeBlock> blocks_;
};

}  // namespace

std::vector<DerivativeBlock> derivative_blocks(const Model& model, ContactDynamics& dynamics,
                                               CheckValues& values, const CheckState& state) {
  if (state.surface) {
    if (dynamics.set_surface(0, *state.surface) != Status::Ok)
      throw Error("check: the surface at a state holds a NaN or an infinity");
    values.set_surface(*state.surface);
  }
  return Blocks(model, dynamics, values, state).all();
}

}  // namespace burnish
