#include "burnish/ocp/loop_inverse.hpp"

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"

namespace burnish {
namespace {

using Decomposition = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;

/// Entries of v with and without a motor, and the contact rows of the loops.
struct LoopParts {
  std::vector<int> driven, passive, rows;
  std::vector<std::string> motors;  ///< Names of driven joints
};

LoopParts parts_of(const Model& model, const ContactDynamics& dynamics,
                   const ActuationSpec& actuation) {
  LoopParts parts;
  std::vector<bool> is_driven(to_size(model.nv), false);
  for (const Joint* joint : driven_joints(model, actuation)) {
    parts.motors.push_back(joint->name);
    for (int k = 0; k < joint->nv; ++k) is_driven[to_size(joint->v_index + k)] = true;
  }
  for (int k = 0; k < model.nv; ++k)
    (is_driven[to_size(k)] ? parts.driven : parts.passive).push_back(k);
  int row = 0;
  for (const ContactSpec& contact : dynamics.contacts().specs())
    for (int i = 0; i < contact.directions.count(); ++i, ++row)
      if (is_loop(model, contact)) parts.rows.push_back(row);
  return parts;
}

/// Changes the accelerations `a` so that J a = wanted. Changes the driven entries only if changes
/// of the passive entries are not sufficient.
void follow(const Eigen::MatrixXd& J, const std::vector<int>& passive,
            const Eigen::VectorXd& wanted, Eigen::VectorXd& a) {
  const Eigen::MatrixXd J_passive = J(Eigen::all, passive);
  a(passive) += Decomposition(J_passive).solve(wanted - J * a);
  a += Decomposition(J).solve(wanted - J * a);
}

/// Returns loop forces that leave no torque at passive joints and minimal torques at the motors.
Eigen::VectorXd loop_forces(const Eigen::MatrixXd& J, const LoopParts& parts,
                            const Eigen::VectorXd& tau) {
  const Eigen::MatrixXd passive = J(Eigen::all, parts.passive).transpose();
  const Eigen::MatrixXd driven = J(Eigen::all, parts.driven).transpose();
  const Decomposition balance(passive);
  Eigen::VectorXd forces = balance.solve(Eigen::VectorXd(tau(parts.passive)));
  // Forces in the kernel of `passive` act only on the motors.
  const Eigen::FullPivLU<Eigen::MatrixXd> kernel(passive);
  if (kernel.dimensionOfKernel() == 0) return forces;
  const Eigen::MatrixXd free = kernel.kernel();
  const Eigen::VectorXd motor_torque = tau(parts.driven) - driven * forces;
  forces += free * Decomposition(Eigen::MatrixXd(driven * free)).solve(motor_torque);
  return forces;
}

}  // namespace

LoopInverse loop_inverse(const Model& model, ContactDynamics& dynamics, const LoopMotion& motion,
                         const ActuationSpec& actuation) {
  const LoopParts parts = parts_of(model, dynamics, actuation);
  LoopInverse result;
  result.v =
      project_velocity_onto_loops(model, motion.q, motion.v, LoopMetric::Plain, parts.motors);
  result.a = motion.a;
  result.lambda = motion.lambda;
  result.status = dynamics.acceleration(motion.q, result.v, result.a);
  if (!is_usable(result.status)) return result;
  const Eigen::MatrixXd J = Eigen::MatrixXd(dynamics.jacobian())(parts.rows, Eigen::all);
  const Eigen::VectorXd alpha = Eigen::VectorXd(dynamics.alpha())(parts.rows);
  follow(J, parts.passive, J * result.a - alpha, result.a);
  result.lambda(parts.rows).setZero();
  result.status = dynamics.inverse(motion.q, result.v, result.a, result.lambda);
  if (!is_usable(result.status)) return result;
  const Eigen::VectorXd tau = dynamics.tau();
  result.lambda(parts.rows) = loop_forces(J, parts, tau);
  result.tau = tau - J.transpose() * Eigen::VectorXd(result.lambda(parts.rows));
  if (!parts.passive.empty())
    result.unbalanced = Eigen::VectorXd(result.tau(parts.passive)).cwiseAbs().maxCoeff();
  return result;
}

}  // namespace burnish
