#include "support/mujoco_model.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "burnish/base/error.hpp"

namespace burnish::test {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <class... Values>
std::string numbers(Values... values) {
  std::string text;
  char one[40];
  ((std::snprintf(one, sizeof one, "%.17g ", static_cast<double>(values)), text += one), ...);
  text.pop_back();
  return text;
}

std::string pose(const Eigen::Isometry3d& placement) {
  const Eigen::Vector3d p = placement.translation();
  const Eigen::Quaterniond r(Eigen::Matrix3d(placement.linear()));
  return " pos=\"" + numbers(p.x(), p.y(), p.z()) + "\" quat=\"" +
         numbers(r.w(), r.x(), r.y(), r.z()) + "\"";
}

struct PrincipalInertia {
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;
};

PrincipalInertia principal(const Joint& joint) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(joint.inertia_at_com);
  PrincipalInertia result{solver.eigenvalues(), solver.eigenvectors()};
  if (result.axes.determinant() < 0.0) result.axes.col(0) *= -1.0;
  return result;
}

std::string body_name(int body) { return body < 0 ? "world" : "b" + std::to_string(body); }
std::string site_name(int frame) { return "f" + std::to_string(frame); }

/// The joints of a body: hinges and slides, and a ball where a floating joint is not at the root.
std::string joints_of(const Joint& joint) {
  const auto slide = [](const char* axis) {
    return "<joint type=\"slide\" axis=\"" + std::string(axis) + "\"/>";
  };
  const std::string hinge = "<joint type=\"hinge\" axis=\"0 0 1\"/>";
  switch (joint.kind) {
    case JointKind::Revolute:
    case JointKind::Continuous:
      return hinge;
    case JointKind::Prismatic:
      return slide("0 0 1");
    case JointKind::Planar:
      return slide("1 0 0") + slide("0 1 0") + hinge;
    case JointKind::FreeFlyer:
      if (joint.parent < 0 && joint.placement.isApprox(Eigen::Isometry3d::Identity(), 0.0))
        return "<freejoint/>";
      return slide("1 0 0") + slide("0 1 0") + slide("0 0 1") + "<joint type=\"ball\"/>";
  }
  return "";
}

std::string sites_of(const Model& model, int body) {
  std::string text;
  for (std::size_t f = 0; f < model.frames.size(); ++f)
    if (model.frames[f].body == body)
      text += "<site name=\"" + site_name(static_cast<int>(f)) + "\"" +
              pose(model.frames[f].placement) + "/>\n";
  return text;
}

/// A body with its descendants. MuJoCo refuses moments that published figures round past the
/// triangle inequality, so it reads a ball's and load_figures() puts in the true ones.
std::string body_text(const Model& model, int body) {
  const Joint& joint = model.joints[static_cast<std::size_t>(body)];
  const PrincipalInertia inertia = principal(joint);
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  at.translation() = joint.com;
  at.linear() = inertia.axes;
  const double moment = std::max(inertia.moments.maxCoeff(), 1e-12);
  std::string text = "<body name=\"" + body_name(body) + "\"" + pose(joint.placement) + ">" +
                     joints_of(joint) + "\n<inertial" + pose(at) + " mass=\"" +
                     numbers(std::max(joint.mass, 1e-12)) + "\" diaginertia=\"" +
                     numbers(moment, moment, moment) + "\"/>\n" + sites_of(model, body);
  for (std::size_t child = 0; child < model.joints.size(); ++child)
    if (model.joints[child].parent == body) text += body_text(model, static_cast<int>(child));
  return text + "</body>\n";
}

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

std::string mjcf(const Model& model, const std::vector<Tie>& ties) {
  const Eigen::Vector3d g = model.gravity;
  std::string text =
      "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n"
      "<option gravity=\"" +
      numbers(g.x(), g.y(), g.z()) +
      "\" jacobian=\"dense\" solver=\"Newton\" iterations=\"50\" tolerance=\"0\"/>\n<worldbody>\n";
  text += sites_of(model, -1);
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    if (model.joints[j].parent < 0) text += body_text(model, static_cast<int>(j));
  return text + "</worldbody>\n" + ties_text(model, ties) + "</mujoco>\n";
}

mjModel* load(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char reason[1000] = "";
  mjModel* model = mj_loadXML("model.xml", files.get(), reason, sizeof reason);
  mj_deleteVFS(files.get());
  if (model == nullptr) throw Error("MuJoCo refuses the model: " + std::string(reason));
  return model;
}

void store(const Eigen::Vector3d& from, mjtNum* to) { mju_copy3(to, from.data()); }

void store(const Eigen::Matrix3d& from, mjtNum* to) {
  const Eigen::Quaterniond r(from);
  to[0] = r.w(), to[1] = r.x(), to[2] = r.y(), to[3] = r.z();
}

/// Writes a joint's coordinates and returns how many MuJoCo has; `turn` is the rotation from the
/// joint's moving axes to its fixed ones.
int store_joint(const Joint& joint, const double* x, double* qpos, Eigen::Matrix3d& turn) {
  switch (joint.kind) {
    case JointKind::Revolute:
    case JointKind::Prismatic:
      qpos[0] = x[0];
      return 1;
    case JointKind::Continuous:
      qpos[0] = std::atan2(x[1], x[0]);
      return 1;
    case JointKind::Planar:
      qpos[0] = x[0], qpos[1] = x[1], qpos[2] = std::atan2(x[3], x[2]);
      turn = Eigen::AngleAxisd(qpos[2], Eigen::Vector3d::UnitZ()).toRotationMatrix();
      return 3;
    case JointKind::FreeFlyer:
      std::copy(x, x + 3, qpos);
      turn = Eigen::Quaterniond(x[6], x[3], x[4], x[5]).toRotationMatrix();
      qpos[3] = x[6], qpos[4] = x[3], qpos[5] = x[4], qpos[6] = x[5];
      return 7;
  }
  return 0;
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
      m_(load(mjcf(model, ties))),
      d_(mj_makeData(m_.get())),
      T_(Eigen::MatrixXd::Identity(model.nv, model.nv)),
      correction_(Eigen::VectorXd::Zero(model.nv)) {
  if (m_->nv != model.nv) throw Error("MuJoCo counts other degrees of freedom");
  load_figures();
}

void MujocoModel::load_figures() {
  for (std::size_t j = 0; j < model_.joints.size(); ++j) {
    const Joint& joint = model_.joints[j];
    const int body = mj_name2id(m_.get(), mjOBJ_BODY, body_name(static_cast<int>(j)).c_str());
    const PrincipalInertia inertia = principal(joint);
    m_->body_mass[body] = joint.mass;
    store(inertia.moments, m_->body_inertia + 3 * body);
    store(joint.com, m_->body_ipos + 3 * body);
    store(inertia.axes, m_->body_iquat + 4 * body);
  }
  for (int k = 0; k < model_.nv; ++k) m_->dof_armature[k] = model_.armature[k];
  mj_setConst(m_.get(), d_.get());
}

void MujocoModel::set_state(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  int at = 0;
  for (const Joint& joint : model_.joints) {
    Eigen::Matrix3d turn;
    at += store_joint(joint, q.data() + joint.q_index, d_->qpos + at, turn);
    if (joint.nv == 1) continue;
    // Translations are along fixed axes there and along body axes here.
    const bool planar = joint.kind == JointKind::Planar;
    const int first = joint.v_index, linear = planar ? 2 : 3;
    for (int i = 0; i < linear; ++i)
      for (int j = 0; j < linear; ++j) T_(first + i, first + j) = turn(j, i);
    const Eigen::Vector3d u(v[first], v[first + 1], planar ? 0.0 : v[first + 2]);
    const Eigen::Vector3d w(planar ? 0.0 : v[first + 3], planar ? 0.0 : v[first + 4],
                            v[first + joint.nv - 1]);
    const Eigen::Vector3d rate = u.cross(w);
    for (int i = 0; i < linear; ++i) correction_[first + i] = rate[i];
  }
  Eigen::Map<Eigen::VectorXd>(d_->qvel, m_->nv) = T_.transpose() * v;
  mju_zero(d_->qfrc_applied, m_->nv);
  mj_kinematics(m_.get(), d_.get());
  place_ties();
  mj_fwdPosition(m_.get(), d_.get());
  mj_fwdVelocity(m_.get(), d_.get());
}

/// Moves the anchors of all ties to where the frames are.
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
    // Anchor in the base, pose of the base in the tool with the anchor taken off, torque scale.
    store(in_base, data);
    store(in_tool, data + 3);
    store(Eigen::Matrix3d(tool_pose.linear().transpose() * base_pose.linear()), data + 6);
    data[10] = 1.0;
  }
}

Eigen::MatrixXd MujocoModel::mass_matrix() {
  RowMajor M(m_->nv, m_->nv);
  mj_fullM(m_.get(), M.data(), d_->qM);
  return T_ * M * T_.transpose();  // T is orthogonal
}

Eigen::VectorXd MujocoModel::bias() {
  const Eigen::VectorXd theirs = Eigen::Map<const Eigen::VectorXd>(d_->qfrc_bias, m_->nv);
  return T_ * theirs - mass_matrix() * correction_;
}

Eigen::VectorXd MujocoModel::acceleration_from(const double* qacc) const {
  return T_ * Eigen::Map<const Eigen::VectorXd>(qacc, m_->nv) + correction_;
}

void MujocoModel::load_torque(const Eigen::VectorXd& tau) {
  Eigen::Map<Eigen::VectorXd>(d_->qfrc_applied, m_->nv) = T_.transpose() * tau;
}

Eigen::VectorXd MujocoModel::forward(const Eigen::VectorXd& tau) {
  load_torque(tau);
  mj_fwdActuation(m_.get(), d_.get());
  mj_fwdAcceleration(m_.get(), d_.get());
  return acceleration_from(d_->qacc_smooth);
}

Eigen::VectorXd MujocoModel::inverse(const Eigen::VectorXd& a) {
  const int flags = m_->opt.disableflags;
  m_->opt.disableflags |= mjDSBL_CONSTRAINT | mjDSBL_PASSIVE;
  Eigen::Map<Eigen::VectorXd>(d_->qacc, m_->nv) = T_.transpose() * (a - correction_);
  mj_inverse(m_.get(), d_.get());
  m_->opt.disableflags = flags;
  return T_ * Eigen::Map<const Eigen::VectorXd>(d_->qfrc_inverse, m_->nv);
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
  return both * T_.transpose();
}

/// Acceleration of the frame's origin and of its axes at qacc = 0, world axes.
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

/// Velocity of the tool against the base's material point under it: 6 x nv.
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
  return J - both * T_.transpose();
}

/// Acceleration of the tool against the base's material point under it, at qacc = 0.
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
  // MuJoCo's rows are S times ours, whatever axes and scale it writes a weld's rotation in.
  const RowMajor theirs = Eigen::Map<const RowMajor>(d_->efc_J, d_->nefc, m_->nv) * T_.transpose();
  Eigen::VectorXd aref(d_->nefc);
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(d_->nefc, d_->nefc);
  int row = 0;
  for (std::size_t i = 0; i < ties_.size(); ++i) {
    const int n = ties_[i].kind == Tie::Kind::Weld ? 6 : 3;
    const Eigen::MatrixXd J = relative_jacobian(ties_[i]).topRows(n);
    const Eigen::MatrixXd fit =
        J.transpose().colPivHouseholderQr().solve(theirs.middleRows(row, n).transpose());
    S.block(row, row, n, n) = fit.transpose();
    if ((fit.transpose() * J - theirs.middleRows(row, n)).norm() > 1e-9)
      throw Error("MuJoCo ties other directions of " + ties_[i].tool);
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
