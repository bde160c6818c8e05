#include "mujoco/mujoco_description.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish::mujoco {
namespace {

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

std::string stops_of(const Model& model, const Joint& joint) {
  const double lower = model.q_lower[joint.q_index], upper = model.q_upper[joint.q_index];
  if (!std::isfinite(lower) || !std::isfinite(upper) || lower >= upper) return "";
  return R"( limited="true" range=")" + numbers(lower, upper) + "\"";
}

/// Returns the joints of a body. A floating joint that is not at the root becomes three slides and
/// a ball joint.
std::string joints_of(const Model& model, int body, bool stops) {
  const Joint& joint = model.joints[to_size(body)];
  const auto moving = [](const char* type, const char* axis, const std::string& more) {
    return "<joint type=\"" + std::string(type) + "\" axis=\"" + axis + "\"" + more + "/>";
  };
  const std::string name = " name=\"" + joint_name(body) + "\"";
  const std::string ends = stops && !joint.follows ? stops_of(model, joint) : "";
  switch (joint.kind) {
    case JointKind::Revolute:
      return moving("hinge", "0 0 1", name + ends);
    case JointKind::Continuous:
      return moving("hinge", "0 0 1", name);
    case JointKind::Prismatic:
      return moving("slide", "0 0 1", name + ends);
    case JointKind::Planar:
      return moving("slide", "1 0 0", "") + moving("slide", "0 1 0", "") +
             moving("hinge", "0 0 1", "");
    case JointKind::FreeFlyer:
      if (joint.parent < 0 && joint.placement.isApprox(Eigen::Isometry3d::Identity(), 0.0))
        return "<freejoint/>";
      return moving("slide", "1 0 0", "") + moving("slide", "0 1 0", "") +
             moving("slide", "0 0 1", "") + "<joint type=\"ball\"/>";
    case JointKind::Ball:
      return "<joint type=\"ball\"" + name + "/>";
  }
  return "";
}

std::string sites_of(const Model& model, int body) {
  std::string text;
  for (std::size_t f = 0; f < model.frames.size(); ++f)
    if (model.frames[f].body == body)
      text += "<site name=\"" + site_name(static_cast<int>(f)) + "\"" +
              pose_attributes(model.frames[f].placement) + "/>\n";
  return text;
}

/// Returns the text of a body with its descendants.
std::string body_text(const Model& model, int body, const Additions& additions) {
  const Joint& joint = model.joints[to_size(body)];
  const PrincipalInertia inertia = principal(joint);
  Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
  at.translation() = joint.com;
  at.linear() = inertia.axes;
  const double moment = std::max(inertia.moments.maxCoeff(), 1e-12);
  std::string text = "<body name=\"" + body_name(body) + "\"" + pose_attributes(joint.placement) +
                     ">" + joints_of(model, body, additions.joint_stops) + "\n<inertial" +
                     pose_attributes(at) + " mass=\"" + numbers(std::max(joint.mass, 1e-12)) +
                     "\" diaginertia=\"" + numbers(moment, moment, moment) + "\"/>\n" +
                     sites_of(model, body);
  if (const auto added = additions.bodies.find(body); added != additions.bodies.end())
    text += added->second;
  for (std::size_t child = 0; child < model.joints.size(); ++child)
    if (model.joints[child].parent == body)
      text += body_text(model, static_cast<int>(child), additions);
  return text + "</body>\n";
}

void store(const Eigen::Vector3d& from, mjtNum* to) { mju_copy3(to, from.data()); }

void store(const Eigen::Matrix3d& from, mjtNum* to) {
  const Eigen::Quaterniond r(from);
  to[0] = r.w(), to[1] = r.x(), to[2] = r.y(), to[3] = r.z();
}

}  // namespace

std::string pose_attributes(const Eigen::Isometry3d& placement) {
  const Eigen::Vector3d p = placement.translation();
  const Eigen::Quaterniond r(Eigen::Matrix3d(placement.linear()));
  return " pos=\"" + numbers(p.x(), p.y(), p.z()) + "\" quat=\"" +
         numbers(r.w(), r.x(), r.y(), r.z()) + "\"";
}

std::string body_name(int body) { return body < 0 ? "world" : "b" + std::to_string(body); }
std::string joint_name(int joint) { return "j" + std::to_string(joint); }
std::string site_name(int frame) { return "f" + std::to_string(frame); }

std::string describe(const Model& model, const Additions& additions) {
  const Eigen::Vector3d g = model.gravity;
  std::string text =
      "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n"
      "<option gravity=\"" +
      numbers(g.x(), g.y(), g.z()) + R"(" jacobian="dense" solver="Newton" )" + additions.options +
      "/>\n<worldbody>\n" + sites_of(model, -1) + additions.world;
  for (std::size_t j = 0; j < model.joints.size(); ++j)
    if (model.joints[j].parent < 0) text += body_text(model, static_cast<int>(j), additions);
  return text + "</worldbody>\n" + additions.sections + "</mujoco>\n";
}

ModelPointer compile(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "model.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char reason[1000] = "";
  mjModel* model = mj_loadXML("model.xml", files.get(), reason, sizeof reason);
  mj_deleteVFS(files.get());
  if (model == nullptr) {
    std::string sentence = "MuJoCo rejects the model: " + std::string(reason);
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    throw Error(sentence);
  }
  return ModelPointer(model);
}

void load_figures(const Model& model, mjModel& theirs, mjData& data) {
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const int body = mj_name2id(&theirs, mjOBJ_BODY, body_name(static_cast<int>(j)).c_str());
    const PrincipalInertia inertia = principal(joint);
    theirs.body_mass[body] = joint.mass;
    store(inertia.moments, theirs.body_inertia + 3 * body);
    store(joint.com, theirs.body_ipos + 3 * body);
    store(inertia.axes, theirs.body_iquat + 4 * body);
  }
  // A leader's armature already contains the armatures of its followers.
  int entry = 0;
  for (const Joint& joint : model.joints) {
    for (int k = 0; k < joint.nv; ++k)
      theirs.dof_armature[entry + k] = model.armature[joint.v_index + k];
    entry += joint_nv(joint.kind);
  }
  mj_setConst(&theirs, &data);
}

}  // namespace burnish::mujoco
