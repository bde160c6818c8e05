#include "model/tree_check.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <unordered_map>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "model/loops.hpp"
#include "model/tree_sentence.hpp"

namespace burnish {
namespace {

using IndexByName = std::unordered_map<std::string, std::size_t>;

template <class Element>
IndexByName index_names(const std::vector<Element>& elements, const std::string& kind,
                        Findings& findings) {
  IndexByName index;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::string& name = elements[i].name;
    if (name.empty()) {
      findings.problem(kind + " number " + std::to_string(i + 1) +
                       " has no name; wanted a name for every " + kind);
    } else if (!index.emplace(name, i).second) {
      findings.problem(label_of(elements[i]) + " is defined twice; wanted unique names of " + kind +
                       "s");
    }
  }
  return index;
}

/// Returns the joint above each link, as an index into tree.joints, -1 for a root.
std::vector<int> parent_joints(const TreeSpec& tree, const IndexByName& links, Findings& findings) {
  std::vector<std::string> existing;
  for (const LinkSpec& link : tree.links) existing.push_back(link.name);
  const auto exists = [&](const JointSpec& joint, const std::string& name, const char* role) {
    if (links.contains(name)) return true;
    findings.problem(label_of(joint) + ": " + role + " link " + in_quotes(name) +
                     " does not exist" + (findings.are_few() ? did_you_mean(name, existing) : ""));
    return false;
  };
  std::vector<int> above(tree.links.size(), -1);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const JointSpec& joint = tree.joints[j];
    exists(joint, joint.parent_link, "parent");
    if (!exists(joint, joint.child_link, "child")) continue;
    const std::size_t child = links.at(joint.child_link);
    if (above[child] >= 0) {
      const JointSpec& first = tree.joints[to_size(above[child])];
      findings.problem(label_of(tree.links[child]) + " has two parents, " +
                       in_quotes(first.parent_link) + " through joint " + in_quotes(first.name) +
                       " and " + in_quotes(joint.parent_link) + " through joint " +
                       in_quotes(joint.name) + "; wanted one parent");
      continue;
    }
    above[child] = static_cast<int>(j);
  }
  return above;
}

void check_one_root(const TreeSpec& tree, const std::vector<int>& above, Findings& findings) {
  const LinkSpec* root = nullptr;
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (above[i] >= 0) continue;
    if (root == nullptr) {
      root = &tree.links[i];
      continue;
    }
    findings.problem("links " + in_quotes(root->name) + " and " + in_quotes(tree.links[i].name) +
                     " both have no parent joint; wanted one root, so connect them by a joint");
  }
}

/// Reports cycles, and trees that are too deep. Finds the depth of each link by a walk up to a link
/// of known depth. A walk longer than the number of links is a cycle.
void check_depths(const TreeSpec& tree, const IndexByName& links, const std::vector<int>& above,
                  Findings& findings) {
  std::vector<int> depth(tree.links.size(), 0);
  std::vector<std::size_t> path;
  for (std::size_t start = 0; start < tree.links.size(); ++start) {
    path.clear();
    std::size_t link = start;
    while (depth[link] == 0 && above[link] >= 0) {
      path.push_back(link);
      if (path.size() > tree.links.size()) {
        findings.problem("link " + in_quotes(tree.links[link].name) +
                         " is its own ancestor through joint " +
                         in_quotes(tree.joints[to_size(above[link])].name) +
                         "; wanted a tree of links without cycles");
        return;
      }
      link = links.at(tree.joints[to_size(above[link])].parent_link);
    }
    int below = depth[link] == 0 ? 1 : depth[link];
    depth[link] = below;
    for (auto up = path.rbegin(); up != path.rend(); ++up) depth[*up] = ++below;
    if (below > max_depth) {
      findings.problem("link " + in_quotes(tree.links[start].name) + " is " +
                       std::to_string(below) + " links from the root; wanted at most " +
                       std::to_string(max_depth));
      return;
    }
  }
}

/// Checks of the values of one link or joint. Reports problems under its name.
struct ValueCheck {
  std::string element;
  Findings& findings;

  void problem(const std::string& what) const { findings.problem(element + what); }
  void value(const std::string& quantity, double stated, const std::string& wanted) const {
    problem(": " + quantity + " is " + number(stated) + "; wanted " + wanted);
  }

  template <class Derived>
  bool finite(const std::string& quantity, const Eigen::MatrixBase<Derived>& values) const {
    for (Eigen::Index j = 0; j < values.cols(); ++j) {
      for (Eigen::Index i = 0; i < values.rows(); ++i) {
        if (std::isfinite(values(i, j))) continue;
        value(quantity, values(i, j), "a finite number");
        return false;
      }
    }
    return true;
  }

  void placement(const std::string& quantity, const Eigen::Isometry3d& stated) const {
    if (!finite(quantity, stated.matrix().topRows<3>())) return;
    const Eigen::Matrix3d rotation = stated.linear();
    if ((rotation * rotation.transpose()).isIdentity(1e-6) && rotation.determinant() > 0.0) return;
    problem(": the rotation of its " + quantity +
            " is not orthonormal and right-handed; wanted a rotation matrix");
  }

  void not_negative(const std::string& quantity, double stated, bool may_be_infinite) const {
    if (std::isnan(stated) || stated < 0.0 || (!may_be_infinite && std::isinf(stated))) {
      value(quantity, stated,
            may_be_infinite ? "zero or a positive number" : "zero or a finite positive number");
    }
  }
};

/// Returns the inertia that counts as zero for this body [kg m^2]: the inertia of a speck of dust,
/// plus small fractions of the body's inertia and of the inertia of its mass at a small distance.
/// Constants, chosen by hand: `fraction` of the inertia, `smallest_size` of a body [m], and inertia
/// of `dust` [kg m^2].
double negligible_inertia(const InertiaSpec& inertia) {
  constexpr double fraction = 1e-6, smallest_size = 0.01, dust = 1e-20;
  return dust + fraction * (inertia.inertia_at_com.cwiseAbs().maxCoeff() +
                            1e-3 * std::abs(inertia.mass) * smallest_size * smallest_size);
}

void check_inertia(const LinkSpec& link, Findings& findings) {
  const ValueCheck check{label_of(link), findings};
  const Eigen::Matrix3d& inertia = link.inertia.inertia_at_com;
  const double mass = link.inertia.mass;
  if (!std::isfinite(mass)) return check.value("mass", mass, "a finite number");
  if (mass < 0.0) {
    check.problem(": mass " + number(mass) + " kg is negative; wanted zero or a positive mass");
  }
  check.finite("centre of mass", link.inertia.com);
  if (!check.finite("inertia", inertia)) return;
  const double size = inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > 1e-9 * size) {
    return check.problem(
        ": its inertia matrix is not symmetric; wanted a symmetric matrix, about the centre of "
        "mass");
  }
  const double smallest_moment = inertia.diagonal().minCoeff();
  const double negligible = negligible_inertia(link.inertia);
  if (smallest_moment < -inertia_tolerance * size - negligible) {
    return check.problem(": moment of inertia " + number(smallest_moment) +
                         " kg m^2 is negative; wanted zero or a positive moment");
  }
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (principal[0] < -negligible) {
    findings.warn(check.element + ": its inertia has the principal moment " + number(principal[0]) +
                  " kg m^2, which is negative; no solid has a negative moment");
  } else if (principal[0] + principal[1] < (1.0 - inertia_tolerance) * principal[2] - negligible) {
    findings.warn(check.element + ": its principal moments of inertia " + number(principal[0]) +
                  ", " + number(principal[1]) + ", " + number(principal[2]) +
                  " kg m^2 belong to no solid; the largest can be at most the sum of the other two "
                  "(5 % are allowed for rounding)");
  }
}

double smallest_size(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->size.minCoeff();
  if (const auto* tube = std::get_if<CylinderShape>(&shape)) {
    return std::min(tube->radius, tube->length);
  }
  if (const auto* ball = std::get_if<SphereShape>(&shape)) return ball->radius;
  return 0.0;
}

void check_visuals(const LinkSpec& link, Findings& findings) {
  const ValueCheck check{label_of(link), findings};
  for (const VisualSpec& visual : link.visuals) {
    check.placement("visual placement", visual.placement);
    check.finite("visual colour", visual.rgba);
    if (const auto* box = std::get_if<BoxShape>(&visual.shape)) {
      if (!check.finite("visual box size", box->size)) continue;
    } else if (const auto* mesh = std::get_if<MeshShape>(&visual.shape)) {
      check.finite("visual mesh scale", mesh->scale);
    }
    const double size = smallest_size(visual.shape);
    if (!(size >= 0.0) || !std::isfinite(size)) {
      check.value("a size of its visual", size, "zero or a finite positive number");
    }
  }
}

void check_joint(const JointSpec& joint, Findings& findings) {
  const ValueCheck check{label_of(joint), findings};
  check.placement("placement", joint.placement);
  const bool is_ball = joint.type == JointType::Ball;
  const bool has_axis =
      joint.type != JointType::Fixed && joint.type != JointType::Floating && !is_ball;
  if (check.finite("axis", joint.axis) && has_axis && joint.axis.norm() < 1e-9) {
    check.problem(": its axis is zero; wanted a direction");
  }
  if (std::isnan(joint.lower)) check.value("lower limit", joint.lower, "a number");
  if (std::isnan(joint.upper)) check.value("upper limit", joint.upper, "a number");
  if (joint.lower > joint.upper) {
    check.problem(": its lower limit " + number(joint.lower) + " is above its upper limit " +
                  number(joint.upper) + "; wanted lower <= upper");
  }
  if (is_ball && joint.rest != 0.0 && joint.stiffness > 0.0) {
    findings.warn(check.element + ": 'rest' of " + number(joint.rest) +
                  " is ignored, because the spring of a ball joint rests at zero rotation");
  }
  if (is_ball && (std::isfinite(joint.lower) || std::isfinite(joint.upper))) {
    findings.warn(check.element +
                  ": its position limits are ignored, because a ball joint has no position limits");
  }
  check.not_negative("velocity limit", joint.velocity_limit, true);
  check.not_negative("effort limit", joint.effort_limit, true);
  check.not_negative("damping", joint.damping, false);
  check.not_negative("friction", joint.friction, false);
  check.not_negative("armature", joint.armature, false);
  check.not_negative("stiffness", joint.stiffness, false);
  check.finite("rest of its spring", Eigen::Matrix<double, 1, 1>(joint.rest));
  if (joint.stiffness > 0.0 &&
      (joint.type == JointType::Planar || joint.type == JointType::Floating)) {
    findings.warn(check.element +
                  ": its spring is ignored; only joints with one coordinate and ball joints can "
                  "have springs");
  }
  if (!joint.mimic) return;
  check.finite("mimic multiplier", Eigen::Matrix<double, 1, 1>(joint.mimic->multiplier));
  check.finite("mimic offset", Eigen::Matrix<double, 1, 1>(joint.mimic->offset));
}

void check_tendon(const TendonSpec& tendon, Findings& findings) {
  const ValueCheck check{label("tendon", tendon.name, tendon.line), findings};
  if (tendon.parts.empty()) check.problem(" couples no joint; wanted at least one");
  for (const TendonSpec::Part& part : tendon.parts) {
    check.finite("coefficient of joint " + in_quotes(part.joint),
                 Eigen::Matrix<double, 1, 1>(part.coefficient));
  }
  check.finite("rest", Eigen::Matrix<double, 1, 1>(tendon.rest));
  check.not_negative("stiffness", tendon.stiffness, false);
  check.not_negative("damping", tendon.damping, false);
}

}  // namespace

void check_topology(const TreeSpec& tree, Findings& findings) {
  if (tree.links.empty()) return findings.problem("it has no links; wanted at least one");
  if (tree.links.size() > max_links) {
    return findings.problem("it has " + std::to_string(tree.links.size()) +
                            " links; wanted at most " + std::to_string(max_links));
  }
  Findings of_names(findings.origin());
  const IndexByName links = index_names(tree.links, "link", of_names);
  index_names(tree.joints, "joint", of_names);
  const std::vector<int> above = parent_joints(tree, links, of_names);
  // Wrong names would cause misleading findings about roots and depths.
  if (!of_names.has_problems()) {
    check_depths(tree, links, above, of_names);
    if (!of_names.has_problems()) check_one_root(tree, above, of_names);
  }
  check_loops(tree, of_names);
  findings.add(of_names);
}

void check_values(const TreeSpec& tree, Findings& findings) {
  for (const LinkSpec& link : tree.links) {
    check_inertia(link, findings);
    check_visuals(link, findings);
  }
  for (const JointSpec& joint : tree.joints) check_joint(joint, findings);
  for (const TendonSpec& tendon : tree.tendons) check_tendon(tendon, findings);
}

}  // namespace burnish
