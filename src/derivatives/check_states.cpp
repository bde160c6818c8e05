#include "derivatives/check_states.hpp"

#include <Eigen/Cholesky>
#include <numbers>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"

namespace burnish {
namespace {

constexpr double largest_angle = std::numbers::pi - 0.1;  // rad, to the target
constexpr double largest_condition = 1e5;                 // of J M^-1 J^T, unit diagonal
constexpr int tries_per_state = 20;

}  // namespace

Eigen::VectorXd CheckStates::uniform(Eigen::Index size, double reach) {
  Eigen::VectorXd result(size);
  for (double& x : result) {
    // The same numbers with every standard library.
    x = reach * (2.0 * static_cast<double>(generator_() >> 11) * 0x1.0p-53 - 1.0);
  }
  return result;
}

bool CheckStates::far_from_jumps(const ContactSet& set, const Eigen::VectorXd& q) const {
  for (const CompiledContact& contact : set.contacts()) {
    if (!contact.proportional) continue;
    if (!contact.holds_rotation && contact.spec.error == PoseError::Split) continue;
    const Eigen::Isometry3d target =
        frame_placement(model_, q, contact.spec.base) * contact.spec.target;
    const Eigen::Isometry3d tool = frame_placement(model_, q, contact.spec.tool);
    const Eigen::AngleAxisd apart(Eigen::Matrix3d(target.linear().transpose() * tool.linear()));
    if (std::abs(apart.angle()) > largest_angle) return false;
  }
  return true;
}

std::optional<std::vector<CheckState>> CheckStates::draw(const ContactSet& set, int count,
                                                         bool rigid) {
  const double weight = model_.total_mass() * model_.gravity.norm();
  const double push = weight > 0.0 ? 0.1 * weight : 1.0;
  ContactDynamics free(model_);
  std::vector<CheckState> states;
  for (int left = tries_per_state * count; static_cast<int>(states.size()) < count; --left) {
    if (left == 0) return std::nullopt;
    CheckState state;
    state.q = random_configuration(model_, generator_);
    if (!far_from_jumps(set, state.q)) continue;
    if (rigid && !(diagnose(model_, set, state.q).condition < largest_condition)) continue;
    state.v = uniform(model_.nv, 1.0);
    state.a = uniform(model_.nv, 5.0);
    state.lambda = uniform(set.rows(), push);
    const Eigen::VectorXd asked = uniform(model_.nv, 5.0);
    const Status status = free.inverse(state.q, state.v, asked, Eigen::VectorXd());
    if (status != Status::Ok) {
      throw Error("check: the model has no inverse dynamics: " + std::string(describe(status)));
    }
    state.tau = free.tau();
    states.push_back(state);
  }
  return states;
}

double CheckStates::compliance(const std::vector<ContactSpec>& contacts) {
  ContactDynamics dynamics(model_, contacts);
  const Eigen::VectorXd q = random_configuration(model_, generator_);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model_.nv);
  dynamics.acceleration(q, rest, rest);
  const Eigen::MatrixXd J = dynamics.jacobian();
  const Eigen::LLT<Eigen::MatrixXd> mass(dynamics.mass_matrix());
  const double mean = (J * mass.solve(J.transpose())).trace() / static_cast<double>(J.rows());
  // Rows that nothing moves need no softness of their own, but some.
  return mean > 0.0 ? 1e-2 * mean : 1e-2;
}

}  // namespace burnish
