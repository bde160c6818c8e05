#include "model/tree_check.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <unordered_map>

#include "model/sentence.hpp"

namespace burnish {
namespace {

using IndexByName = std::unordered_map<std::string, std::size_t>;

std::string joint_label(const JointSpec& joint) { return "joint " + in_quotes(joint.name); }
std::string link_label(const LinkSpec& link) { return "link " + in_quotes(link.name); }

template <class Element>
IndexByName index_names(const TreeSpec& tree, const std::vector<Element>& elements,
                        const std::string& kind) {
  IndexByName index;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::string& name = elements[i].name;
    if (name.empty()) {
      refuse(tree, kind + " number " + std::to_string(i + 1) + " has no name; every " + kind +
                       " needs one");
    }
    if (!index.emplace(name, i).second) {
      refuse(tree, kind + " " + in_quotes(name) + " is defined twice; names of " + kind +
                       "s must be unique");
    }
  }
  return index;
}

std::size_t find_link(const TreeSpec& tree, const IndexByName& links, const JointSpec& joint,
                      const std::string& name, const std::string& role) {
  const auto found = links.find(name);
  if (found != links.end()) return found->second;
  std::vector<std::string> known;
  for (const LinkSpec& link : tree.links) known.push_back(link.name);
  refuse(tree, joint_label(joint) + ": " + role + " link " + in_quotes(name) + " does not exist" +
                   did_you_mean(name, known));
}

/// The joint above each link as an index into tree.joints, -1 for a root.
std::vector<int> parent_joints(const TreeSpec& tree, const IndexByName& links) {
  std::vector<int> above(tree.links.size(), -1);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const JointSpec& joint = tree.joints[j];
    find_link(tree, links, joint, joint.parent_link, "parent");
    const std::size_t child = find_link(tree, links, joint, joint.child_link, "child");
    if (above[child] >= 0) {
      const JointSpec& first = tree.joints[static_cast<std::size_t>(above[child])];
      refuse(tree, "link " + in_quotes(joint.child_link) + " has two parents, " +
                       in_quotes(first.parent_link) + " through joint " + in_quotes(first.name) +
                       " and " + in_quotes(joint.parent_link) + " through joint " +
                       in_quotes(joint.name) + "; a link of a tree has one");
    }
    above[child] = static_cast<int>(j);
  }
  return above;
}

void check_one_root(const TreeSpec& tree, const std::vector<int>& above) {
  const LinkSpec* root = nullptr;
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (above[i] >= 0) continue;
    if (root != nullptr) {
      refuse(tree, "links " + in_quotes(root->name) + " and " + in_quotes(tree.links[i].name) +
                       " both have no parent joint; a tree has one root, so join them by a joint");
    }
    root = &tree.links[i];
  }
}

/// Depth of every link by walking up until a link of known depth. A walk longer than the number
/// of links has met a cycle.
void check_depths(const TreeSpec& tree, const IndexByName& links, const std::vector<int>& above) {
  std::vector<int> depth(tree.links.size(), 0);
  std::vector<std::size_t> path;
  for (std::size_t start = 0; start < tree.links.size(); ++start) {
    path.clear();
    std::size_t link = start;
    while (depth[link] == 0 && above[link] >= 0) {
      path.push_back(link);
      if (path.size() > tree.links.size()) {
        refuse(tree, "link " + in_quotes(tree.links[link].name) +
                         " is its own ancestor through joint " +
                         in_quotes(tree.joints[static_cast<std::size_t>(above[link])].name) +
                         "; the links must form a tree without cycles");
      }
      link = links.at(tree.joints[static_cast<std::size_t>(above[link])].parent_link);
    }
    int below = depth[link] == 0 ? 1 : depth[link];
    depth[link] = below;
    for (auto up = path.rbegin(); up != path.rend(); ++up) depth[*up] = ++below;
    if (below > max_depth) {
      refuse(tree, "link " + in_quotes(tree.links[start].name) + " is " + std::to_string(below) +
                       " links from the root; at most " + std::to_string(max_depth) +
                       " are supported");
    }
  }
}

[[noreturn]] void refuse_value(const TreeSpec& tree, const std::string& element,
                               const std::string& quantity, double value,
                               const std::string& wanted) {
  refuse(tree, element + ": " + quantity + " is " + number(value) + "; " + wanted);
}

template <class Derived>
void check_finite(const TreeSpec& tree, const std::string& element, const std::string& quantity,
                  const Eigen::MatrixBase<Derived>& values) {
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (!std::isfinite(values(i, j))) {
        refuse_value(tree, element, quantity, values(i, j), "it must be finite");
      }
    }
  }
}

void check_placement(const TreeSpec& tree, const std::string& element, const std::string& quantity,
                     const Eigen::Isometry3d& placement) {
  check_finite(tree, element, quantity, placement.matrix().topRows<3>());
  const Eigen::Matrix3d rotation = placement.linear();
  const bool is_rotation =
      (rotation * rotation.transpose()).isIdentity(1e-6) && rotation.determinant() > 0.0;
  if (!is_rotation) {
    refuse(tree, element + ": the rotation of its " + quantity +
                     " is not orthonormal and right-handed; a rotation matrix was wanted");
  }
}

void check_inertia(const TreeSpec& tree, const LinkSpec& link) {
  const std::string label = link_label(link);
  const Eigen::Matrix3d& inertia = link.inertia.inertia_at_com;
  const double mass = link.inertia.mass;
  if (!std::isfinite(mass)) refuse_value(tree, label, "mass", mass, "it must be finite");
  if (mass < 0.0) {
    refuse(tree,
           label + ": mass " + number(mass) + " kg is negative; a mass must be zero or positive");
  }
  check_finite(tree, label, "centre of mass", link.inertia.com);
  check_finite(tree, label, "inertia", inertia);
  const double size = inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() > 1e-9 * size) {
    refuse(tree, label +
                     ": its inertia matrix is not symmetric; an inertia about the centre of "
                     "mass is");
  }
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia, Eigen::EigenvaluesOnly).eigenvalues();
  if (principal[0] < -1e-6 * size) {
    refuse(tree, label + ": its inertia has the principal moment " + number(principal[0]) +
                     " kg m^2, which is negative; principal moments must be zero or positive");
  }
  if (principal[0] + principal[1] < (1.0 - inertia_tolerance) * principal[2]) {
    refuse(tree, label + ": its principal moments of inertia " + number(principal[0]) + ", " +
                     number(principal[1]) + ", " + number(principal[2]) +
                     " kg m^2 belong to no solid; the largest can be at most the sum of the "
                     "other two (5 % are allowed for rounding)");
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

void check_visuals(const TreeSpec& tree, const LinkSpec& link) {
  for (const VisualSpec& visual : link.visuals) {
    check_placement(tree, link_label(link), "visual placement", visual.placement);
    check_finite(tree, link_label(link), "visual colour", visual.rgba);
    if (const auto* box = std::get_if<BoxShape>(&visual.shape)) {
      check_finite(tree, link_label(link), "visual box size", box->size);
    } else if (const auto* mesh = std::get_if<MeshShape>(&visual.shape)) {
      check_finite(tree, link_label(link), "visual mesh scale", mesh->scale);
    }
    const double size = smallest_size(visual.shape);
    if (!(size >= 0.0) || !std::isfinite(size)) {
      refuse_value(tree, link_label(link), "a size of its visual", size,
                   "it must be finite and not negative");
    }
  }
}

void check_not_negative(const TreeSpec& tree, const JointSpec& joint, const std::string& quantity,
                        double value, bool may_be_infinite) {
  if (std::isnan(value) || value < 0.0 || (!may_be_infinite && std::isinf(value))) {
    refuse_value(tree, joint_label(joint), quantity, value, "it must be zero or positive");
  }
}

void check_joint(const TreeSpec& tree, const JointSpec& joint) {
  const std::string label = joint_label(joint);
  check_placement(tree, label, "placement", joint.placement);
  check_finite(tree, label, "axis", joint.axis);
  const bool has_axis = joint.type != JointType::Fixed && joint.type != JointType::Floating;
  if (has_axis && joint.axis.norm() < 1e-9) {
    refuse(tree, label + ": its axis is zero; a direction was wanted");
  }
  if (std::isnan(joint.lower))
    refuse_value(tree, label, "lower limit", joint.lower, "a number was wanted");
  if (std::isnan(joint.upper))
    refuse_value(tree, label, "upper limit", joint.upper, "a number was wanted");
  if (joint.lower > joint.upper) {
    refuse(tree, label + ": its lower limit " + number(joint.lower) + " is above its upper limit " +
                     number(joint.upper) + "; lower must be at most upper");
  }
  check_not_negative(tree, joint, "velocity limit", joint.velocity_limit, true);
  check_not_negative(tree, joint, "effort limit", joint.effort_limit, true);
  check_not_negative(tree, joint, "damping", joint.damping, false);
  check_not_negative(tree, joint, "friction", joint.friction, false);
  check_not_negative(tree, joint, "armature", joint.armature, false);
  if (joint.mimic) {
    check_finite(tree, label, "mimic multiplier",
                 Eigen::Matrix<double, 1, 1>(joint.mimic->multiplier));
    check_finite(tree, label, "mimic offset", Eigen::Matrix<double, 1, 1>(joint.mimic->offset));
  }
}

}  // namespace

void check_topology(const TreeSpec& tree) {
  if (tree.links.empty()) refuse(tree, "it has no links; a robot needs at least one");
  if (tree.links.size() > max_links) {
    refuse(tree, "it has " + std::to_string(tree.links.size()) + " links; at most " +
                     std::to_string(max_links) + " are supported");
  }
  const IndexByName links = index_names(tree, tree.links, "link");
  index_names(tree, tree.joints, "joint");
  const std::vector<int> above = parent_joints(tree, links);
  check_depths(tree, links, above);
  check_one_root(tree, above);
}

void check_values(const TreeSpec& tree) {
  for (const LinkSpec& link : tree.links) {
    check_inertia(tree, link);
    check_visuals(tree, link);
  }
  for (const JointSpec& joint : tree.joints) check_joint(tree, joint);
}

}  // namespace burnish
