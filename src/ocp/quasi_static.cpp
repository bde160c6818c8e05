#include "base/decomposition.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish {

Eigen::VectorXd ocp::torque_at_rest(const CompiledProblem& problem, const ConstVectorRef& q) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(problem.model.nv);
  Eigen::VectorXd torque =
      Eigen::Map<const Eigen::VectorXd>(problem.torque_bias.data(), problem.model.nv);
  if (problem.passive)
    add_spring_torque(problem.passive->springs, q.data(), rest.data(), torque.data());
  return torque;
}

Problem::QuasiStatic Problem::quasi_static(int stage, const ConstVectorRef& x,
                                           const Eigen::VectorXd& force) const {
  const ocp::CompiledProblem& compiled = impl_->compiled;
  const StateLayout& l = compiled.layout;
  const ocp::CompiledStage& at = compiled.stages.at(to_size(stage));
  if (x.size() < l.nq)
    throw Error("quasi_static: x has " + std::to_string(x.size()) + " entries; wanted at least " +
                std::to_string(l.nq));
  // Only the bias and the Jacobian are used, so contacts and the mass matrix may be singular.
  ContactDynamics dynamics(compiled.model, impl_->contacts_of(stage), {.mu = 1e-6});
  for (int c = 0; c < compiled.contacts.size(); ++c)
    dynamics.set_active(c, at.active[to_size(c)] != 0);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(l.nv);
  const Status status = dynamics.acceleration(x.head(l.nq), zero, zero);
  if (status != Status::Ok) throw Error("quasi_static: " + std::string(describe(status)));
  // The rows of loops are the last rows. Forces of loops are unknown unless `force` contains them.
  int rows = dynamics.rows();
  int loops = 0;
  for (int c = 0; c < compiled.contacts.size(); ++c) {
    const CompiledContact& contact = compiled.contacts.contacts()[to_size(c)];
    const bool is_active_loop = dynamics.is_active(c) && is_loop(compiled.model, contact.spec);
    loops = is_active_loop ? loops + static_cast<int>(contact.directions.size()) : 0;
  }
  const bool loops_are_free = force.size() != 0 && force.size() == rows - loops;
  if (loops_are_free) rows -= loops;
  if (force.size() != 0 && force.size() != rows)
    throw Error("quasi_static: force has " + std::to_string(force.size()) + " entries; wanted " +
                std::to_string(rows));
  // Balance of torques at rest, with the selection S of the actuated joints and the gravity torque
  // b: S^T u + J^T lambda = b(q, 0) - bias - torque of springs.
  const int free = force.size() == 0 ? rows : loops_are_free ? loops : 0;
  const int unknowns = l.nu + free;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(l.nv, unknowns);
  for (int i = 0; i < l.nu; ++i) A(l.actuated[to_size(i)], i) = 1.0;
  Eigen::VectorXd b = dynamics.bias() - ocp::torque_at_rest(compiled, x.head(l.nq));
  A.rightCols(free) = dynamics.jacobian().bottomRows(free).transpose();
  if (force.size() != 0) b -= dynamics.jacobian().topRows(rows).transpose() * force;
  const Eigen::VectorXd solution = least_squares(A, b);
  QuasiStatic result;
  result.control = solution.head(l.nu);
  result.force = force.size() == 0 ? Eigen::VectorXd(solution.tail(rows)) : force;
  result.residual = (A * solution - b).cwiseAbs().maxCoeff();
  return result;
}

}  // namespace burnish
