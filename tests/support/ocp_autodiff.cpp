#include "support/ocp_autodiff.hpp"

#include <functional>

#include "burnish/model/state.hpp"
#include "derivatives/constrained_derivatives.tpp"
#include "derivatives/frame_kinematics.tpp"
#include "derivatives/momentum.tpp"
#include "dynamics/frame_kinematics.tpp"
#include "dynamics/integration.tpp"
#include "dynamics/springs.tpp"
#include "ocp/residual_force.tpp"
#include "ocp/residual_frame.tpp"
#include "ocp/residual_momentum.tpp"
#include "ocp/residual_state.tpp"
#include "ocp/runge_kutta.tpp"
#include "ocp/stage_dynamics.tpp"
#include "support/autodiff.hpp"

namespace burnish {
extern template class ConstrainedDynamics<test::Dual>;
}

namespace burnish::test {
namespace {

const ocp::CompiledStage& stage_of(const ocp::CompiledProblem& problem, const OcpPoint& at) {
  return problem.stages[static_cast<std::size_t>(at.stage)];
}

void set_step(ocp::StageDynamics<Dual>& dynamics, const ocp::KnotTime<double>& when) {
  dynamics.set_step(Dual(when.per_second), Dual(when.step_ratio), Dual(when.decaying));
}

/// Derivatives of evaluate(x, u) with respect to all of z.
Eigen::MatrixXd by_z(const ocp::CompiledProblem& problem, const OcpPoint& at,
                     const std::function<Duals(const Duals& x, const Duals& u)>& evaluate) {
  const StateLayout& l = problem.layout;
  Seeded x{at.x, Eigen::MatrixXd::Zero(l.nx(), l.nz())},
      u{at.u, Eigen::MatrixXd::Zero(l.nu, l.nz())};
  x.directions.block(0, l.column_q(), l.nq, l.nv) = tangent_map(problem.model, at.x.head(l.nq));
  x.directions.bottomRightCorner(l.ndx() - l.nv, l.ndx() - l.nv).setIdentity();
  u.directions.leftCols(l.nu).setIdentity();
  return differentiate(x, u, evaluate);
}

/// x (+) dx.
Duals moved(const ocp::CompiledProblem& problem, const Duals& x, const Duals& dx) {
  const StateLayout& l = problem.layout;
  Duals result = x;
  integrate_configuration(problem.tree, x.data(), dx.data(), result.data());
  for (int i = 0; i < l.ndx() - l.nv; ++i)
    result[static_cast<std::size_t>(l.nq + i)] =
        x[static_cast<std::size_t>(l.nq + i)] + dx[static_cast<std::size_t>(l.nv + i)];
  return result;
}

/// Torque state after a fraction of the step; all other entries as in x.
Duals filtered(const ocp::CompiledProblem& problem, Duals x, const Duals& u, double decay) {
  const StateLayout& l = problem.layout;
  for (int i = 0; i < l.filtered; ++i) {
    Dual& tau = x[static_cast<std::size_t>(l.nq + l.nv + i)];
    tau = Dual(decay * tau + (1.0 - decay) * u[static_cast<std::size_t>(i)]);
  }
  return x;
}

class Stepper {
 public:
  Stepper(const ocp::CompiledProblem& problem, const OcpPoint& at)
      : problem_(problem),
        stage_(stage_of(problem, at)),
        when_(problem.timing(stage_, at.step > 0.0 ? at.step : stage_.step)),
        targets_(at.targets.begin(), at.targets.end()),
        dynamics_(problem) {
    dynamics_.turn(stage_, targets_.data());
    set_step(dynamics_, when_);
  }

  Duals euler(const Duals& x, const Duals& u) {
    const StateLayout& l = problem_.layout;
    dynamics_.values(stage_, x.data(), u.data());
    Duals dx(static_cast<std::size_t>(l.ndx()), Dual(0.0));
    for (int k = 0; k < l.nv; ++k) {
      const Dual dv = Dual(when_.step * dynamics_.acceleration()[k]);
      dx[static_cast<std::size_t>(l.nv + k)] = dv;
      dx[static_cast<std::size_t>(k)] =
          Dual(when_.step * (x[static_cast<std::size_t>(l.nq + k)] + dv));
    }
    return moved(problem_, filtered(problem_, with_last_forces(x), u, when_.decay), dx);
  }

  Duals runge_kutta(const Duals& x, const Duals& u) {
    const double fraction[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0, 2.0, 2.0, 1.0};
    const double decay[4] = {1.0, when_.half_decay, when_.half_decay, when_.decay};
    const auto size = static_cast<std::size_t>(problem_.layout.ndx());
    Duals rate(size, Dual(0.0)), sum(size, Dual(0.0)), from = x;
    for (int i = 0; i < 4; ++i) {
      Duals dx(size, Dual(0.0));
      for (std::size_t k = 0; k < size; ++k) dx[k] = Dual(fraction[i] * when_.step * rate[k]);
      rate = rate_at(moved(problem_, filtered(problem_, x, u, decay[i]), dx), u);
      if (i == 0) from = with_last_forces(x);
      for (const TangentBlock& block : problem_.blocks) {
        using namespace ocp::runge_kutta_detail;
        Dual* const entries = rate.data() + block.first;
        const Motion<Dual> theta = load_twist(block.kind, dx.data() + block.first, 1);
        store_twist(block.kind, offset_rate(theta, load_twist(block.kind, entries, 1)), entries, 1);
      }
      for (std::size_t k = 0; k < size; ++k) sum[k] += Dual(when_.step / 6.0 * weight[i] * rate[k]);
    }
    return moved(problem_, filtered(problem_, from, u, when_.decay), sum);
  }

 private:
  /// x with the contact forces of the last evaluation; zero for inactive contacts.
  Duals with_last_forces(Duals x) const {
    const StateLayout& l = problem_.layout;
    const ConstrainedDynamics<Dual>& dynamics = dynamics_.contact_dynamics();
    for (const ocp::ForceState& force : problem_.force_states) {
      const auto contact = static_cast<std::size_t>(force.contact);
      for (int i = 0; i < force.rows; ++i)
        x[static_cast<std::size_t>(l.nq + l.nv + l.filtered + force.first + i)] =
            stage_.active[contact] == 0
                ? Dual(0.0)
                : dynamics
                      .lambda[static_cast<std::size_t>(dynamics.active().first_row[contact] + i)];
    }
    return x;
  }
  /// (v, a, 0)
  Duals rate_at(const Duals& x, const Duals& u) {
    const StateLayout& l = problem_.layout;
    dynamics_.values(stage_, x.data(), u.data());
    Duals rate(static_cast<std::size_t>(l.ndx()), Dual(0.0));
    for (int k = 0; k < l.nv; ++k) {
      rate[static_cast<std::size_t>(k)] = x[static_cast<std::size_t>(l.nq + k)];
      rate[static_cast<std::size_t>(l.nv + k)] = dynamics_.acceleration()[k];
    }
    return rate;
  }

  const ocp::CompiledProblem& problem_;
  const ocp::CompiledStage& stage_;
  ocp::KnotTime<double> when_;
  Duals targets_;
  ocp::StageDynamics<Dual> dynamics_;
};

}  // namespace

std::vector<double> targets_of(const ocp::CompiledProblem& problem, int stage, double time) {
  const ocp::CompiledStage& at = problem.stages[static_cast<std::size_t>(stage)];
  std::vector<double> targets(static_cast<std::size_t>(std::max(at.targets, 1)));
  Eigen::VectorXd scratch(512);
  ocp::load_targets(at, time, {}, scratch, targets.data());
  return targets;
}

Eigen::MatrixXd residual_by_autodiff(const ocp::CompiledProblem& problem, const OcpPoint& at,
                                     int term) {
  const ocp::CompiledStage& stage = stage_of(problem, at);
  const ocp::CompiledTerm& compiled = stage.terms[static_cast<std::size_t>(term)];
  ocp::StageDynamics<Dual> dynamics(problem);
  const Duals targets(at.targets.begin(), at.targets.end());
  return by_z(problem, at, [&](const Duals& x, const Duals& u) {
    dynamics.turn(stage, targets.data());
    set_step(dynamics, problem.timing(stage, at.step > 0.0 ? at.step : stage.step));
    dynamics.values(stage, x.data(), u.data());
    Duals r(static_cast<std::size_t>(compiled.rows), Dual(0.0));
    std::visit(
        [&](const auto& residual) {
          if constexpr (requires { residual.user; }) {
            throw Error("a user's own residual is evaluated in double");
          } else {
            residual.evaluate(dynamics.knot(), targets.data() + compiled.target, r.data(),
                              static_cast<Dual*>(nullptr));
          }
        },
        compiled.residual);
    return r;
  });
}

Eigen::MatrixXd step_by_autodiff(const ocp::CompiledProblem& problem, const OcpPoint& at) {
  const ocp::CompiledStage& stage = stage_of(problem, at);
  const StateLayout& l = problem.layout;
  Stepper stepper(problem, at);
  return by_z(problem, at, [&](const Duals& x, const Duals& u) {
    const Duals next = stage.integrator == Integrator::RungeKutta4 ? stepper.runge_kutta(x, u)
                                                                   : stepper.euler(x, u);
    const Duals from = constant_duals(values_of(next));
    Duals dx(static_cast<std::size_t>(l.ndx()), Dual(0.0));
    difference_configuration(problem.tree, from.data(), next.data(), dx.data());
    for (int i = 0; i < l.ndx() - l.nv; ++i)
      dx[static_cast<std::size_t>(l.nv + i)] = next[static_cast<std::size_t>(l.nq + i)];
    return dx;
  });
}

}  // namespace burnish::test
