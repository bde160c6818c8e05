// The blocks of one state, twice: from the library's derivatives and from its values.
#include <limits>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "derivatives/check_differences.hpp"
#include "derivatives/check_run.hpp"

namespace burnish {
namespace {

constexpr double exact_step = 0.5;  // of central differences of quadratic functions

/// Values of the three evaluations; all NaN where the status is not Ok.
class Values {
 public:
  Values(const Model& model, ContactDynamics& dynamics, const CheckState& state)
      : model_(model), dynamics_(dynamics), state_(state) {}

  Eigen::VectorXd forward(const CheckState& x) {
    Eigen::VectorXd result(dynamics_.nv() + dynamics_.rows());
    const Status status = dynamics_.forward(x.q, x.v, x.tau);
    result << dynamics_.a(), dynamics_.lambda();
    return checked(status, result);
  }
  Eigen::VectorXd inverse(const CheckState& x) {
    const Status status = dynamics_.inverse(x.q, x.v, x.a, x.lambda);
    return checked(status, dynamics_.tau());
  }
  Eigen::VectorXd acceleration(const CheckState& x) {
    const Status status = dynamics_.acceleration(x.q, x.v, x.a);
    return checked(status, dynamics_.alpha());
  }

  using Function = Eigen::VectorXd (Values::*)(const CheckState&);

  /// By q, in the tangent space. `split`: where the values change their unit.
  Eigen::MatrixXd by_q(Function function, int split) {
    const auto moved = [&](int k, double h) {
      CheckState x = state_;
      x.q = integrate(model_, x.q, h * Eigen::VectorXd::Unit(model_.nv, k));
      return (this->*function)(x);
    };
    return extrapolated_differences(moved, model_.nv, split);
  }
  /// By another argument, in which the values are at most quadratic.
  Eigen::MatrixXd by(Function function, Eigen::VectorXd CheckState::*argument) {
    const auto moved = [&](int k, double h) {
      CheckState x = state_;
      (x.*argument)[k] += h;
      return (this->*function)(x);
    };
    return central_differences(moved, static_cast<int>((state_.*argument).size()), exact_step);
  }

 private:
  static Eigen::VectorXd checked(Status status, Eigen::VectorXd values) {
    if (status != Status::Ok) values.setConstant(std::numeric_limits<double>::quiet_NaN());
    return values;
  }

  const Model& model_;
  ContactDynamics& dynamics_;
  const CheckState& state_;
};

struct Names {
  std::vector<std::string> v, rows;
};

/// Errors of entries far below the values themselves are rounding.
double floor_of(const Eigen::VectorXd& values) {
  return std::max(1e-12, 1e-3 * values.cwiseAbs().maxCoeff());
}

void add_forward(ContactDynamics& dynamics, const CheckState& state, Values& values,
                 const Names& names, std::vector<DerivativeBlock>& blocks) {
  const int nv = dynamics.nv(), m = dynamics.rows();
  const double a_floor = floor_of(values.forward(state).head(nv));
  const double lambda_floor = floor_of(values.forward(state).tail(m));
  dynamics.forward_derivatives();
  const Eigen::MatrixXd a_by[] = {dynamics.da_dq(), dynamics.da_dv(), dynamics.da_dtau()};
  const Eigen::MatrixXd lambda_by[] = {dynamics.dlambda_dq(), dynamics.dlambda_dv(),
                                       dynamics.dlambda_dtau()};
  const Eigen::MatrixXd expected[] = {values.by_q(&Values::forward, nv),
                                      values.by(&Values::forward, &CheckState::v),
                                      values.by(&Values::forward, &CheckState::tau)};
  const char* const suffix[] = {"_dq", "_dv", "_dtau"};
  for (int i = 0; i < 3; ++i) {
    blocks.push_back({std::string("da") + suffix[i], names.v, names.v, a_by[i],
                      expected[i].topRows(nv), a_floor});
    blocks.push_back({std::string("dlambda") + suffix[i], names.rows, names.v, lambda_by[i],
                      expected[i].bottomRows(m), lambda_floor});
  }
}

void add_inverse(ContactDynamics& dynamics, const CheckState& state, Values& values,
                 const Names& names, std::vector<DerivativeBlock>& blocks) {
  const double floor = floor_of(values.inverse(state));
  dynamics.inverse_derivatives();
  const Eigen::MatrixXd by_q = dynamics.dtau_dq(), by_v = dynamics.dtau_dv();
  const Eigen::MatrixXd by_a = dynamics.mass_matrix();
  const Eigen::MatrixXd by_lambda = -dynamics.jacobian().transpose();
  blocks.push_back(
      {"dtau_dq", names.v, names.v, by_q, values.by_q(&Values::inverse, dynamics.nv()), floor});
  blocks.push_back(
      {"dtau_dv", names.v, names.v, by_v, values.by(&Values::inverse, &CheckState::v), floor});
  blocks.push_back({"dtau_da", names.v, names.v, by_a, values.by(&Values::inverse, &CheckState::a),
                    1e-3 * floor});
  blocks.push_back({"dtau_dlambda", names.v, names.rows, by_lambda,
                    values.by(&Values::inverse, &CheckState::lambda), 1e-3 * floor});
}

void add_acceleration(ContactDynamics& dynamics, const CheckState& state, Values& values,
                      const Names& names, std::vector<DerivativeBlock>& blocks) {
  const double floor = floor_of(values.acceleration(state));
  dynamics.acceleration_derivatives();
  const Eigen::MatrixXd by_q = dynamics.dalpha_dq(), by_v = dynamics.dalpha_dv();
  const Eigen::MatrixXd by_a = dynamics.jacobian();
  blocks.push_back({"dalpha_dq", names.rows, names.v, by_q,
                    values.by_q(&Values::acceleration, dynamics.rows()), floor});
  blocks.push_back({"dalpha_dv", names.rows, names.v, by_v,
                    values.by(&Values::acceleration, &CheckState::v), floor});
  blocks.push_back({"dalpha_da", names.rows, names.v, by_a,
                    values.by(&Values::acceleration, &CheckState::a), floor});
}

}  // namespace

std::vector<DerivativeBlock> derivative_blocks(const Model& model,
                                               const std::vector<ContactSpec>& contacts, double mu,
                                               const CheckState& state) {
  ContactDynamics dynamics(model, contacts, {.mu = mu});
  Values values(model, dynamics, state);
  Names names;
  for (int k = 0; k < model.nv; ++k) names.v.push_back(model.v_name(k));
  names.rows = dynamics.row_names();
  std::vector<DerivativeBlock> blocks;
  add_forward(dynamics, state, values, names, blocks);
  add_inverse(dynamics, state, values, names, blocks);
  add_acceleration(dynamics, state, values, names, blocks);
  return blocks;
}

}  // namespace burnish
