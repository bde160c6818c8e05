#include "mjcf/comparison.hpp"

#include <tinyxml2.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "base/sentence.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/model/joint_order.hpp"
#include "burnish/model/state.hpp"
#include "mjcf/joint_map.hpp"
#include "support/contact_states.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLElement;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::MatrixXd mass_matrix_of(const mjModel& model, const mjData& data) {
  RowMajor full(model.nv, model.nv);
  mj_fullM(&model, full.data(), data.qM);
  return full;
}

double placement_error(const mjModel& theirs, const mjData& data, const RigidBody& body,
                       const std::set<std::string>& frames) {
  double worst = 0.0;
  for (int b = 1; b < theirs.nbody; ++b) {
    const std::string name = name_in(theirs, mjOBJ_BODY, b);
    if (!frames.contains(name)) continue;
    const Eigen::Isometry3d ours = body.placement(body.frame(name));
    const Eigen::Vector3d p = Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * b);
    const Eigen::MatrixXd r = Eigen::Map<const RowMajor>(data.xmat + 9 * b, 3, 3);
    worst = std::max({worst, (ours.translation() - p).cwiseAbs().maxCoeff() / (1.0 + p.norm()),
                      (ours.linear() - r).cwiseAbs().maxCoeff()});
  }
  return worst;
}

/// Returns the error of qpos and qvel against the state, mapped by the model's joint order.
double coordinate_error(const JointOrder& order, const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                        const mjModel& theirs, const mjData& data) {
  if (order.nq() != theirs.nq || order.nv() != theirs.nv)
    throw Error("MuJoCo has " + std::to_string(theirs.nq) + " positions, the model's order " +
                std::to_string(order.nq()));
  const auto largest = [](const Eigen::VectorXd& x) {
    return x.size() == 0 ? 0.0 : x.cwiseAbs().maxCoeff();
  };
  const Eigen::VectorXd qpos = Eigen::Map<const Eigen::VectorXd>(data.qpos, theirs.nq);
  const Eigen::VectorXd qvel = Eigen::Map<const Eigen::VectorXd>(data.qvel, theirs.nv);
  return std::max({largest(order.q_to(q) - qpos), largest(order.v_to(v, q) - qvel),
                   largest(order.q_from(qpos) - q), largest(order.v_from(qvel, q) - v)});
}

}  // namespace

Agreement compare(const TreeSpec& tree, mjModel& theirs, int states) {
  ModelOptions options;
  options.gravity = tree.gravity.value_or(options.gravity);
  const Model model = build_model(tree, options);
  const mujoco::DataPointer data(mj_makeData(&theirs));
  const JointMap map(tree, model, theirs);
  const JointOrder order = JointOrder::mujoco(model);
  std::set<std::string> links;
  for (const LinkSpec& link : tree.links) links.insert(link.name);
  ContactDynamics ours(model);
  // MuJoCo treats Coulomb friction as a constraint, not as a passive torque.
  Model without_friction = model;
  without_friction.friction.setZero();
  RigidBody body(without_friction);
  Agreement worst;
  std::mt19937_64 generator(3);
  Eigen::MatrixXd B;
  Eigen::VectorXd drift;
  for (int i = 0; i < states; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    const Eigen::VectorXd v = test::uniform(model.nv, 1.5, generator);
    if (model.nv > 0) ours.forward(q, v, Eigen::VectorXd::Zero(model.nv));
    body.update(q, v);
    map.store(q, v, *data, B, drift);
    worst.coordinates = std::max(worst.coordinates, coordinate_error(order, q, v, theirs, *data));
    mj_fwdPosition(&theirs, data.get());
    mj_fwdVelocity(&theirs, data.get());
    worst.placement = std::max(worst.placement, placement_error(theirs, *data, body, links));
    if (model.nv == 0) continue;
    const Eigen::MatrixXd M = mass_matrix_of(theirs, *data);
    // burnish multiplies the armature of a floating joint by the rate of v, along rotating axes.
    const Eigen::VectorXd armature =
        Eigen::Map<const Eigen::VectorXd>(theirs.dof_armature, theirs.nv);
    const Eigen::VectorXd b = Eigen::Map<Eigen::VectorXd>(data->qfrc_bias, theirs.nv) + M * drift -
                              armature.cwiseProduct(drift);
    const auto error = [](const auto& got, const Eigen::MatrixXd& want) {
      return (Eigen::MatrixXd(got) - want).cwiseAbs().maxCoeff() /
             std::max(want.cwiseAbs().maxCoeff(), 1e-12);
    };
    worst.mass_matrix =
        std::max(worst.mass_matrix, error(ours.mass_matrix(), B.transpose() * M * B));
    // Gravity and velocity terms may cancel, so that the error is relative to the weight, too.
    const Eigen::VectorXd want = B.transpose() * b;
    const double scale =
        std::max({want.cwiseAbs().maxCoeff(), (B.transpose() * M * B).norm(), 1e-12});
    const Eigen::VectorXd passive =
        B.transpose() * Eigen::Map<Eigen::VectorXd>(data->qfrc_passive, theirs.nv);
    worst.passive =
        std::max(worst.passive, (body.passive_torque() - passive).cwiseAbs().maxCoeff() /
                                    std::max(passive.cwiseAbs().maxCoeff(), 1e-12));
    worst.bias = std::max(worst.bias, (ours.bias() - want).cwiseAbs().maxCoeff() / scale);
  }
  return worst;
}

mujoco::ModelPointer load(const fs::path& file) {
  char reason[1000] = "";
  mjModel* model = mj_loadXML(file.string().c_str(), nullptr, reason, sizeof reason);
  if (model == nullptr) throw Error("MuJoCo refuses the file: " + std::string(reason));
  return mujoco::ModelPointer(model);
}

namespace {

/// Writes the copy element by element.
class Copy {
 public:
  Copy(const fs::path& file, const TreeSpec& tree) : folder_(file.parent_path()) {
    for (const LinkSpec& link : tree.links) masses_[link.name] = link.inertia;
    root_ = open(file);
    take_names(*root_);
  }

  std::string text() {
    std::string sections;
    each(*root_, [&](const XMLElement& section) {
      const std::string_view name = section.Name();
      if (name == "compiler")
        tag(section, "compiler", {"angle", "eulerseq"}, sections, "inertiafromgeom=\"false\"");
      if (name == "option") copy_option(section, sections);
      if (name == "default") copy_default(section, sections);
      if (name == "worldbody") {
        sections += "<worldbody>\n";
        copy_inside(section, sections, true);
        sections += "</worldbody>\n";
      }
      if (name == "tendon") copy_tendons(section, sections);
      if (name == "equality") copy_equalities(section, sections);
    });
    return "<mujoco>\n<compiler inertiafromgeom=\"false\"/>\n" + sections + "</mujoco>\n";
  }

 private:
  using Attributes = std::vector<const char*>;
  static inline const Attributes pose = {"name",   "pos",   "quat", "axisangle",
                                         "xyaxes", "zaxis", "euler"};
  static inline const Attributes of_joint = {"name",      "class",    "type",     "axis",
                                             "pos",       "ref",      "armature", "damping",
                                             "stiffness", "springref"};

  const XMLElement* open(const fs::path& file) {
    documents_.push_back(std::make_unique<tinyxml2::XMLDocument>());
    if (documents_.back()->LoadFile(file.string().c_str()) != tinyxml2::XML_SUCCESS)
      throw Error("cannot copy " + file.string());
    return documents_.back()->RootElement();
  }

  template <class Visit>
  void each(const XMLElement& element, Visit&& visit) {
    for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (std::string_view(child->Name()) != "include") {
        visit(*child);
        continue;
      }
      each(*open(folder_ / child->Attribute("file")), visit);
    }
  }

  static void tag(const XMLElement& from, const std::string& name, const Attributes& kept,
                  std::string& text, const std::string& more = "", bool open = false) {
    text += "<" + name + " " + more;
    for (const char* attribute : kept)
      if (const char* value = from.Attribute(attribute))
        text += std::string(" ") + attribute + "=\"" + value + "\"";
    text += open ? ">\n" : "/>\n";
  }

  void take_names(const XMLElement& element) {
    each(element, [&](const XMLElement& child) {
      const char* name = child.Attribute("name");
      if (std::string_view(child.Name()) == "body" && name != nullptr) taken_.insert(name);
      take_names(child);
    });
  }

  void copy_option(const XMLElement& option, std::string& text) {
    tag(option, "option", {"gravity"}, text, "", true);
    each(option, [&](const XMLElement& child) {
      if (std::string_view(child.Name()) == "flag") tag(child, "flag", {"gravity"}, text);
    });
    text += "</option>\n";
  }

  void copy_default(const XMLElement& element, std::string& text) {
    tag(element, "default", {"class"}, text, "", true);
    each(element, [&](const XMLElement& child) {
      const std::string_view name = child.Name();
      if (name == "default") copy_default(child, text);
      if (name == "joint")
        tag(child, "joint",
            {"type", "axis", "pos", "ref", "armature", "damping", "stiffness", "springref"}, text);
      if (name == "tendon") tag(child, "tendon", {"stiffness", "damping", "springlength"}, text);
    });
    text += "</default>\n";
  }

  void copy_tendons(const XMLElement& section, std::string& text) {
    text += "<tendon>\n";
    each(section, [&](const XMLElement& child) {
      const char* name = child.Attribute("name");
      if (std::string_view(child.Name()) != "fixed" || name == nullptr) return;
      tendons_.insert(name);
      tag(child, "fixed", {"name", "class", "stiffness", "damping", "springlength"}, text, "",
          true);
      each(child, [&](const XMLElement& part) { tag(part, "joint", {"joint", "coef"}, text); });
      text += "</fixed>\n";
    });
    text += "</tendon>\n";
  }

  void copy_equalities(const XMLElement& section, std::string& text) {
    text += "<equality>\n";
    each(section, [&](const XMLElement& child) {
      const std::string name = child.Name();
      const char* tendon = child.Attribute("tendon1");
      if (name == "joint" || (name == "tendon" && tendon != nullptr && tendons_.contains(tendon)) ||
          name == "connect" || name == "weld")
        tag(child, name,
            {"active", "body1", "body2", "anchor", "relpose", "joint1", "joint2", "tendon1",
             "tendon2", "polycoef"},
            text);
    });
    text += "</equality>\n";
  }

  void copy_inertia(const std::string& body, std::string& text) {
    const InertiaSpec& inertia = masses_.at(body);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia.inertia_at_com);
    Eigen::Matrix3d axes = principal.eigenvectors();
    if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.linear() = axes;
    at.translation() = inertia.com;
    // load_masses() sets the true values; MuJoCo refuses moving bodies without a mass.
    text += "<inertial " + mujoco::pose_attributes(at) + " mass=\"1\" diaginertia=\"1 1 1\"/>\n";
  }

  void copy_inside(const XMLElement& element, std::string& text, bool in_world) {
    each(element, [&](const XMLElement& child) {
      const std::string_view kind = child.Name();
      if (kind == "body") {
        copy_body(child, text);
      } else if (kind == "frame") {
        if (!in_world || child.FirstChildElement("joint") != nullptr) check_frame(child);
        tag(child, "body", {"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "childclass"},
            text, "", true);
        text += "<inertial pos=\"0 0 0\" mass=\"0\" diaginertia=\"0 0 0\"/>\n";
        copy_inside(child, text, in_world);
        text += "</body>\n";
      } else if (kind == "joint") {
        tag(child, "joint", of_joint, text);
      } else if (kind == "freejoint") {
        tag(child, "freejoint", {"name"}, text);
      }
    });
  }

  void check_frame(const XMLElement& frame) {
    each(frame, [&](const XMLElement& child) {
      const std::string_view kind = child.Name();
      if (kind == "joint" || kind == "freejoint") throw Error("a frame holds joints");
      if (kind == "frame") check_frame(child);
    });
  }

  void copy_body(const XMLElement& body, std::string& text) {
    const char* stated = body.Attribute("name");
    std::string name = stated == nullptr ? "body" : stated;
    for (int i = 1; stated == nullptr && !taken_.insert(name).second; ++i)
      name = "body_" + std::to_string(i);
    Attributes kept(pose.begin() + 1, pose.end());
    kept.push_back("childclass");
    tag(body, "body", kept, text, "name=\"" + name + "\"", true);
    copy_inertia(name, text);
    copy_inside(body, text, false);
    text += "</body>\n";
  }

  fs::path folder_;
  std::vector<std::unique_ptr<tinyxml2::XMLDocument>> documents_;
  const XMLElement* root_;
  std::map<std::string, InertiaSpec> masses_;
  std::set<std::string> taken_, tendons_;  // names of bodies; names of copied fixed tendons
};

}  // namespace

std::string plain_copy(const fs::path& file, const TreeSpec& tree) {
  return Copy(file, tree).text();
}

void load_masses(const TreeSpec& tree, mjModel& theirs) {
  for (const LinkSpec& link : tree.links) {
    const int body = mj_name2id(&theirs, mjOBJ_BODY, link.name.c_str());
    if (body <= 0) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(link.inertia.inertia_at_com);
    Eigen::Matrix3d axes = principal.eigenvectors();
    if (axes.determinant() < 0.0) axes.col(0) *= -1.0;
    const Eigen::Quaterniond r(axes);
    const double wxyz[4] = {r.w(), r.x(), r.y(), r.z()};
    theirs.body_mass[body] = link.inertia.mass;
    mju_copy3(theirs.body_inertia + 3 * body, principal.eigenvalues().data());
    mju_copy3(theirs.body_ipos + 3 * body, link.inertia.com.data());
    mju_copy4(theirs.body_iquat + 4 * body, wxyz);
  }
  // MuJoCo computes constants of the inertias once, at the start.
  const mujoco::DataPointer data(mj_makeData(&theirs));
  mj_setConst(&theirs, data.get());
}

}  // namespace burnish::testing
