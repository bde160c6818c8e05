#include "support/mujoco_model.hpp"

#include <algorithm>

#include "base/decomposition.hpp"
#include "burnish/base/error.hpp"

namespace burnish::test {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using mujoco::body_name;
using mujoco::site_name;

int body_of(const Model& model, const std::string& frame) {
  if (frame == "world" && !model.has_frame(frame)) return -1;
  return model.frames[static_cast<std::size_t>(model.frame_index(frame))].body;
}

std::string ties_text(const Model& model, const std::vector<Tie>& ties) {
  std::string text = "<equality>\n";
  for (const Tie& tie : ties) {
    const bool weld = tie.kind == Tie::Kind::Weld;
    text += std::string(weld ? "<weld" : "<connect anchor=\"0 0 0\"") + " body1=\"" +
            body_name(body_of(model, tie.tool)) + "\"";
    if (body_of(model, tie.base) >= 0)
      text += " body2=\"" + body_name(body_of(model, tie.base)) + "\"";
    text += "/>\n";
  }
  return text + "</equality>\n";
}

mujoco::ModelPointer compiled(const Model& model, const std::vector<Tie>& ties) {
  mujoco::Additions additions;
  additions.options = "iterations=\"50\" tolerance=\"0\"";
  additions.sections = ties_text(model, ties);
  return mujoco::compile(mujoco::describe(model, additions));
}

void store(const Eigen::Vector3d& from, mjtNum* to) { mju_copy3(to, from.data()); }

void store(const Eigen::Matrix3d& from, mjtNum* to) {
  const Eigen::Quaterniond r(from);
  to[0] = r.w(), to[1] = r.x(), to[2] = r.y(), to[3] = r.z();
}

Eigen::Isometry3d body_pose(const mjData& data, int body) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Map<const RowMajor>(data.xmat + 9 * body, 3, 3);
  result.translation() = Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * body);
  return result;
}

}  // namespace

MujocoModel::MujocoModel(const Model& model, const std::vector<Tie>& ties)
    : model_(model),
      ties_(ties),
      m_(compiled(model, ties)),
      d_(mj_makeData(m_.get())),
      coordinates_(model, *m_) {
  mujoco::load_figures(model_, *m_, *d_);
}

void MujocoModel::set_state(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  coordinates_.store(q, v, *d_);
  mju_zero(d_->qfrc_applied, m_->nv);
  mj_kinematics(m_.get(), d_.get());
  place_ties();
  mj_fwdPosition(m_.get(), d_.get());
  mj_fwdVelocity(m_.get(), d_.get());
}

/// Moves the anchors of all ties to the current positions of their frames.
void MujocoModel::place_ties() {
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    const Tie& tie = ties_[i];
    const int tool = m_->eq_obj1id[i], base = m_->eq_obj2id[i];
    const Eigen::Isometry3d tool_pose = body_pose(*d_, tool), base_pose = body_pose(*d_, base);
    const Eigen::Vector3d p = placement(tie.tool).translation();
    const Eigen::Vector3d in_tool = tool_pose.inverse() * p, in_base = base_pose.inverse() * p;
    double* data = m_->eq_data + mjNEQDATA * static_cast<int>(i);
    if (tie.kind == Tie::Kind::Connect) {
      store(in_tool, data);
      store(in_base, data + 3);
      continue;
    }
    // Anchor in the base; pose of the base in the tool without the anchor; torque scale.
    store(in_base, data);
    store(in_tool, data + 3);
    store(Eigen::Matrix3d(tool_pose.linear().transpose() * base_pose.linear()), data + 6);
    data[10] = 1.0;
  }
}

Eigen::MatrixXd MujocoModel::mass_matrix() { return mujoco::mass_matrix(*m_, *d_, coordinates_); }

Eigen::VectorXd MujocoModel::bias() { return mujoco::bias(*m_, *d_, coordinates_); }

Eigen::VectorXd MujocoModel::acceleration_from(const double* qacc) const {
  return coordinates_.T() * Eigen::Map<const Eigen::VectorXd>(qacc, m_->nv) +
         coordinates_.correction();
}

void MujocoModel::load_torque(const Eigen::VectorXd& tau) {
  Eigen::Map<Eigen::VectorXd>(d_->qfrc_applied, m_->nv) = coordinates_.T().transpose() * tau;
}

Eigen::VectorXd MujocoModel::forward(const Eigen::VectorXd& tau) {
  const auto follows = [](const Joint& joint) { return joint.follows.has_value(); };
  if (std::any_of(model_.joints.begin(), model_.joints.end(), follows))
    return solve_positive(mass_matrix(), tau - bias());
  load_torque(tau);
  mj_fwdActuation(m_.get(), d_.get());
  mj_fwdAcceleration(m_.get(), d_.get());
  return acceleration_from(d_->qacc_smooth);
}

Eigen::VectorXd MujocoModel::inverse(const Eigen::VectorXd& a) {
  const int flags = m_->opt.disableflags;
  m_->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_PASSIVE;
  Eigen::Map<Eigen::VectorXd>(d_->qacc, m_->nv) =
      coordinates_.T().transpose() * (a - coordinates_.correction());
  mj_inverse(m_.get(), d_.get());
  m_->opt.disableflags = flags;
  return coordinates_.T() * Eigen::Map<const Eigen::VectorXd>(d_->qfrc_inverse, m_->nv);
}

int MujocoModel::site(const std::string& frame) const {
  return mj_name2id(m_.get(), mjOBJ_SITE, site_name(model_.frame_index(frame)).c_str());
}

Eigen::Isometry3d MujocoModel::placement(const std::string& frame) const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Map<const RowMajor>(d_->site_xmat + 9 * site(frame), 3, 3);
  result.translation() = Eigen::Map<const Eigen::Vector3d>(d_->site_xpos + 3 * site(frame));
  return result;
}

Eigen::MatrixXd MujocoModel::jacobian(const std::string& frame) const {
  RowMajor linear(3, m_->nv), angular(3, m_->nv);
  mj_jacSite(m_.get(), d_.get(), linear.data(), angular.data(), site(frame));
  Eigen::MatrixXd both(6, m_->nv);
  both << linear, angular;
  return both * coordinates_.T().transpose();
}

/// Acceleration of the frame's origin and of its axes at qacc = 0, in world axes.
Vector6 MujocoModel::drift(const std::string& frame) {
  mju_zero(d_->qacc, m_->nv);
  mj_rnePostConstraint(m_.get(), d_.get());
  double spatial[6];
  mj_objectAcceleration(m_.get(), d_.get(), mjOBJ_SITE, site(frame), spatial, 0);
  Vector6 result;
  result << spatial[3], spatial[4], spatial[5], spatial[0], spatial[1], spatial[2];
  result.head<3>() += model_.gravity;
  return result;
}

/// Velocity of the tool relative to the base's material point at the tool: 6 x nv.
Eigen::MatrixXd MujocoModel::relative_jacobian(const Tie& tie) const {
  Eigen::MatrixXd J = jacobian(tie.tool);
  const int base = body_of(model_, tie.base);
  if (base < 0) return J;
  const Eigen::Vector3d p = placement(tie.tool).translation();
  const int body = mj_name2id(m_.get(), mjOBJ_BODY, body_name(base).c_str());
  RowMajor linear(3, m_->nv), angular(3, m_->nv);
  mj_jac(m_.get(), d_.get(), linear.data(), angular.data(), p.data(), body);
  Eigen::MatrixXd both(6, m_->nv);
  both << linear, angular;
  return J - both * coordinates_.T().transpose();
}

/// Acceleration of the tool relative to the base's material point at the tool, at qacc = 0.
Vector6 MujocoModel::relative_drift(std::size_t tie) {
  const Tie& tied = ties_[tie];
  const Vector6 tool = drift(tied.tool);
  if (body_of(model_, tied.base) < 0) return tool;
  Vector6 base = drift(tied.base);
  double twist[6];
  mj_objectVelocity(m_.get(), d_.get(), mjOBJ_XBODY, m_->eq_obj2id[tie], twist, 0);
  const Eigen::Vector3d w(twist[0], twist[1], twist[2]), dw = base.tail<3>();
  const Eigen::Vector3d arm =
      placement(tied.tool).translation() - placement(tied.base).translation();
  base.head<3>() += dw.cross(arm) + w.cross(w.cross(arm));
  return tool - base;
}

TiedMotion MujocoModel::forward_tied(const Eigen::VectorXd& tau, double mu) {
  // MuJoCo's rows are S times our rows, for any axes and scale of a weld's rotation.
  const RowMajor mujoco_rows =
      Eigen::Map<const RowMajor>(d_->efc_J, d_->nefc, m_->nv) * coordinates_.T().transpose();
  Eigen::VectorXd aref(d_->nefc);
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(d_->nefc, d_->nefc);
  int row = 0;
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    const int n = ties_[i].kind == Tie::Kind::Weld ? 6 : 3;
    const Eigen::MatrixXd J = relative_jacobian(ties_[i]).topRows(n);
    const Eigen::MatrixXd fit =
        J.transpose().colPivHouseholderQr().solve(mujoco_rows.middleRows(row, n).transpose());
    S.block(row, row, n, n) = fit.transpose();
    if ((fit.transpose() * J - mujoco_rows.middleRows(row, n)).norm() > 1e-9)
      throw Error("MuJoCo constrains other directions of " + ties_[i].tool);
    aref.segment(row, n) = -S.block(row, row, n, n) * relative_drift(i).head(n);
    row += n;
  }
  load_torque(tau);
  mj_fwdActuation(m_.get(), d_.get());
  mj_fwdAcceleration(m_.get(), d_.get());
  for (int r = 0; r < d_->nefc; ++r) {
    d_->efc_R[r] = mu * S.row(r).squaredNorm();
    d_->efc_D[r] = 1.0 / d_->efc_R[r];
    d_->efc_aref[r] = aref[r];
  }
  mj_fwdConstraint(m_.get(), d_.get());
  const Eigen::VectorXd force = Eigen::Map<const Eigen::VectorXd>(d_->efc_force, d_->nefc);
  return {acceleration_from(d_->qacc), S.transpose() * force};
}

}  // namespace burnish::test
