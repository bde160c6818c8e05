#include "burnish/estimate/foot_forces.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/kinematics.hpp"

namespace burnish {
namespace {

int rows_of(const std::vector<FootSpec>& feet) {
  int rows = 0;
  for (const FootSpec& foot : feet) rows += foot.kind == FootKind::Sole ? 6 : 3;
  return rows;
}

}  // namespace

struct FootForces::Impl {
  Impl(const Model& model, const std::vector<FootSpec>& specs, double rate)
      : bandwidth(rate),
        tree(model),
        kinematics(tree),
        dynamics(model),
        up(-model.gravity.normalized()),
        v_before(Eigen::VectorXd::Zero(model.nv)),
        a(v_before),
        rest(v_before),
        J(RowMatrix::Zero(rows_of(specs), model.nv)),
        normal(Eigen::MatrixXd::Zero(J.rows(), J.rows())),
        wrenches(Eigen::VectorXd::Zero(J.rows())),
        forces(Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(specs.size()))),
        normal_forces(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(specs.size()))) {
    for (const FootSpec& spec : specs) {
      feet.push_back(compile_frame(model, spec.frame));
      if (feet.back().body < 0)
        throw Error("the foot " + in_quotes(spec.frame) +
                    " is fixed to the world; wanted a frame of the robot");
      rows.push_back(spec.kind == FootKind::Sole ? 6 : 3);
    }
    if (!(rate > 0.0) || !std::isfinite(rate))
      throw Error("foot forces: the bandwidth is " + number(rate) +
                  " rad/s; wanted a positive number");
  }

  /// Computes the Jacobian of the feet's origins in world axes; for soles, also of their rotations.
  void fill_jacobian() noexcept {
    J.setZero();
    int row = 0;
    for (std::size_t i = 0; i < feet.size(); ++i) {
      const CompiledFrame& foot = feet[i];
      const BodyState<double>& body = kinematics.bodies[to_size(foot.body)];
      const Vec3<double> p = body.p + body.R * foot.p;
      for (const MovingAxis& moving : foot.support) {
        const Motion<double> at = at_point(kinematics.axes[to_size(moving.axis)].axis, p);
        J.block<3, 1>(row, moving.v) = to_eigen(at.linear);
        if (rows[i] == 6) J.block<3, 1>(row + 3, moving.v) = to_eigen(at.angular);
      }
      row += rows[i];
    }
  }
  bool fit() noexcept {
    normal.noalias() = J * J.transpose();
    normal.diagonal().array() += 1e-9;  // regularization [m^2]
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(normal);
    if (factor.info() != Eigen::Success) return false;
    wrenches.noalias() = J * rest;
    factor.matrixL().solveInPlace(wrenches);
    factor.matrixU().solveInPlace(wrenches);
    return wrenches.allFinite();
  }

  double bandwidth;
  Tree tree;
  Kinematics<double> kinematics;
  ContactDynamics dynamics;
  Eigen::Vector3d up;
  std::vector<CompiledFrame> feet;
  std::vector<int> rows;
  bool started = false;
  Eigen::VectorXd v_before, a, rest;
  RowMatrix J;
  Eigen::MatrixXd normal;
  Eigen::VectorXd wrenches, none;
  Eigen::Matrix3Xd forces;
  Eigen::VectorXd normal_forces;
};

FootForces::FootForces(const Model& model, const std::vector<FootSpec>& feet, double bandwidth)
    : impl_(std::make_unique<Impl>(model, feet, bandwidth)) {}
FootForces::~FootForces() = default;
FootForces::FootForces(FootForces&&) noexcept = default;
FootForces& FootForces::operator=(FootForces&&) noexcept = default;

void FootForces::reset() noexcept {
  impl_->started = false;
  impl_->rest.setZero();
  impl_->forces.setZero();
  impl_->normal_forces.setZero();
}

Status FootForces::set_payload(std::string_view frame, const InertiaSpec& payload) {
  return impl_->dynamics.set_payload(frame, payload);
}

Status FootForces::update(const ConstVectorRef& q, const ConstVectorRef& v,
                          const ConstVectorRef& tau, double dt) noexcept {
  Impl& d = *impl_;
  if (v.size() != d.a.size() || tau.size() != d.a.size()) return Status::WrongSize;
  if (!tau.allFinite() || !(dt > 0.0) || !std::isfinite(dt)) return Status::NotFinite;
  if (d.started)
    d.a = (v - d.v_before) / dt;
  else
    d.a.setZero();
  const Status status = d.dynamics.inverse(q, v, d.a, d.none);
  if (!is_usable(status)) return status;
  update_kinematics(d.tree, q.data(), v.data(), d.kinematics);
  d.fill_jacobian();
  const double weight = d.started ? -std::expm1(-d.bandwidth * dt) : 1.0;
  d.a = d.rest;  // saves `rest`, which is restored if fit() fails
  d.rest += weight * (d.dynamics.tau() - tau - d.rest);
  if (!d.fit()) {
    d.rest = d.a;
    return Status::SingularContacts;
  }
  d.started = true;
  d.v_before = v;
  int row = 0;
  for (std::size_t i = 0; i < d.feet.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    d.forces.col(k) = d.wrenches.segment<3>(row);
    d.normal_forces[k] = d.up.dot(d.forces.col(k));
    row += d.rows[i];
  }
  return Status::Ok;
}

const Eigen::Matrix3Xd& FootForces::forces_world() const { return impl_->forces; }
const Eigen::VectorXd& FootForces::normal_forces() const { return impl_->normal_forces; }

}  // namespace burnish
