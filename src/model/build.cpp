// Compilation of a tree into a model. One walk over the links merges links that are fixed to each
// other into bodies, and places all frames. The joints then determine the tables over q and v.
#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/to_size.hpp"
#include "burnish/model/model.hpp"
#include "model/followers.hpp"
#include "model/lock.hpp"
#include "model/loops.hpp"
#include "model/mass_check.hpp"
#include "model/plausibility.hpp"
#include "model/posture.hpp"
#include "model/tendons.hpp"
#include "model/tree_check.hpp"
#include "model/tree_sentence.hpp"

namespace burnish {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Link that the walk has yet to place.
struct Pending {
  const JointSpec* joint;            ///< Joint above the link, nullptr for the root link
  int body;                          ///< Body of the parent link
  Eigen::Isometry3d parent_in_body;  ///< Placement of the parent link in `body`
};

/// State of the walk over a description.
struct Walk {
  const TreeSpec& tree;
  const ModelOptions& options;
  std::unordered_map<std::string, const LinkSpec*> link_by_name;
  std::unordered_map<std::string, std::vector<const JointSpec*>> joints_below;  ///< By parent link
  /// Joint of the description for each joint of the model, nullptr for a free-flying base
  std::vector<const JointSpec*> spec_of_joint;
  const std::map<std::string, FileJoint>& held;
};

Walk prepare(const LockedTree& locked, const ModelOptions& options) {
  const TreeSpec& tree = locked.tree;
  Walk walk{tree, options, {}, {}, {}, locked.held};
  for (const LinkSpec& link : tree.links) walk.link_by_name.emplace(link.name, &link);
  for (const JointSpec& joint : tree.joints) walk.joints_below[joint.parent_link].push_back(&joint);
  if (tree.sibling_order == SiblingOrder::AsListed) return walk;
  for (auto& [parent, joints] : walk.joints_below) {
    std::sort(joints.begin(), joints.end(),
              [](const JointSpec* a, const JointSpec* b) { return a->name < b->name; });
  }
  return walk;
}

const LinkSpec& root_of(const Walk& walk) {
  std::unordered_map<std::string_view, bool> is_child;
  for (const JointSpec& joint : walk.tree.joints) is_child[joint.child_link] = true;
  const auto root =
      std::find_if(walk.tree.links.begin(), walk.tree.links.end(),
                   [&](const LinkSpec& link) { return !is_child.contains(link.name); });
  return *root;  // check_topology guarantees exactly one root
}

int add_joint(Walk& walk, Model& model, const JointSpec* spec, Joint joint) {
  const bool follows = spec != nullptr && spec->mimic;
  joint.nq = follows ? 0 : joint_nq(joint.kind);
  joint.nv = follows ? 0 : joint_nv(joint.kind);
  joint.q_index = model.nq;
  joint.v_index = model.nv;
  model.nq += joint.nq;
  model.nv += joint.nv;
  model.file_joints.push_back({joint.name, joint.kind, static_cast<int>(model.joints.size()), {}});
  model.joints.push_back(std::move(joint));
  walk.spec_of_joint.push_back(spec);
  return static_cast<int>(model.joints.size()) - 1;
}

/// Returns the inertia about `to` of a solid with the given mass, centre of mass and inertia about
/// the centre of mass.
Eigen::Matrix3d inertia_about(const Eigen::Vector3d& to, double mass, const Eigen::Vector3d& com,
                              const Eigen::Matrix3d& inertia_at_com) {
  const Eigen::Vector3d arm = com - to;
  return inertia_at_com +
         mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

/// Adds a link's inertia to the body that it is fixed to.
void lump(Joint& body, const InertiaSpec& link, const Eigen::Isometry3d& link_in_body) {
  const Eigen::Vector3d com = link_in_body * link.com;
  const Eigen::Matrix3d inertia =
      link_in_body.linear() * link.inertia_at_com * link_in_body.linear().transpose();
  const double mass = body.mass + link.mass;
  const Eigen::Vector3d shared_com =
      mass > 0.0 ? Eigen::Vector3d((body.mass * body.com + link.mass * com) / mass)
                 : Eigen::Vector3d::Zero();
  const Eigen::Matrix3d sum = inertia_about(shared_com, body.mass, body.com, body.inertia_at_com) +
                              inertia_about(shared_com, link.mass, com, inertia);
  body.inertia_at_com = 0.5 * (sum + sum.transpose());
  body.com = shared_com;
  body.mass = mass;
}

/// Adds the link's inertia, frame and solids to the body. Pushes the joints below the link onto the
/// stack, with the first on top.
void place_link(Walk& walk, Model& model, const LinkSpec& link, int body,
                const Eigen::Isometry3d& link_in_body, std::vector<Pending>& stack) {
  model.frames.push_back({link.name, FrameKind::Link, body, link_in_body});
  if (body >= 0) {
    lump(model.joints[to_size(body)], link.inertia, link_in_body);
  }
  for (const VisualSpec& visual : link.visuals) {
    model.visuals.push_back(
        {link.name, body, link_in_body * visual.placement, visual.shape, visual.rgba});
  }
  const auto below = walk.joints_below.find(link.name);
  if (below == walk.joints_below.end()) return;
  for (auto joint = below->second.rbegin(); joint != below->second.rend(); ++joint) {
    stack.push_back({*joint, body, link_in_body});
  }
}

void place_root(Walk& walk, Model& model, std::vector<Pending>& stack) {
  int body = -1;
  Eigen::Isometry3d link_in_body = walk.options.base_placement;
  if (walk.options.base == Base::FreeFlyer) {
    Joint joint;
    joint.name = root_joint_name;
    joint.kind = JointKind::FreeFlyer;
    body = add_joint(walk, model, nullptr, std::move(joint));
    link_in_body.setIdentity();
    model.frames.push_back({std::string(root_joint_name), FrameKind::Joint, body, link_in_body});
  }
  place_link(walk, model, root_of(walk), body, link_in_body, stack);
}

void place_child(Walk& walk, Model& model, const Pending& pending, std::vector<Pending>& stack) {
  const JointSpec& spec = *pending.joint;
  int body = pending.body;
  Eigen::Isometry3d link_in_body = pending.parent_in_body * spec.placement;
  if (spec.type != JointType::Fixed) {
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();  // pose of the body in the child link
    if (spec.type != JointType::Floating && spec.type != JointType::Ball)
      turn.linear() = rotation_from_z(spec.axis.normalized());
    Joint joint;
    joint.name = spec.name;
    joint.kind = kind_of(spec.type);
    joint.parent = pending.body;
    joint.placement = link_in_body * turn;
    body = add_joint(walk, model, &spec, std::move(joint));
    link_in_body = turn.inverse();
  } else if (const auto held = walk.held.find(spec.name); held != walk.held.end()) {
    model.file_joints.push_back(held->second);
  }
  model.frames.push_back({spec.name, FrameKind::Joint, body, link_in_body});
  place_link(walk, model, *walk.link_by_name.at(spec.child_link), body, link_in_body, stack);
}

void fill_limits(const Walk& walk, Model& model) {
  model.q_lower = Eigen::VectorXd::Constant(model.nq, -infinity);
  model.q_upper = Eigen::VectorXd::Constant(model.nq, infinity);
  model.velocity_limit = model.effort_limit = Eigen::VectorXd::Constant(model.nv, infinity);
  model.damping = model.friction = model.armature = Eigen::VectorXd::Zero(model.nv);
  model.stiffness = model.spring_rest = model.damping;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    const JointSpec* spec = walk.spec_of_joint[i];
    if (spec == nullptr || joint.follows) continue;
    if (joint.kind == JointKind::Revolute || joint.kind == JointKind::Prismatic) {
      model.q_lower[joint.q_index] = spec->lower;
      model.q_upper[joint.q_index] = spec->upper;
    }
    model.velocity_limit.segment(joint.v_index, joint.nv).setConstant(spec->velocity_limit);
    model.effort_limit.segment(joint.v_index, joint.nv).setConstant(spec->effort_limit);
    model.damping.segment(joint.v_index, joint.nv).setConstant(spec->damping);
    model.friction.segment(joint.v_index, joint.nv).setConstant(spec->friction);
    model.armature.segment(joint.v_index, joint.nv).setConstant(spec->armature);
    if (!has_spring(*spec)) continue;
    model.stiffness.segment(joint.v_index, joint.nv).setConstant(spec->stiffness);
    if (joint.nv == 1) model.spring_rest[joint.v_index] = spec->rest;
  }
}

void fill_neutral(const Walk& walk, Model& model) {
  model.q_neutral = Eigen::VectorXd::Zero(model.nq);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.follows) continue;
    auto q = model.q_neutral.segment(joint.q_index, joint.nq);
    if (joint.kind == JointKind::Continuous) q[0] = 1.0;
    if (joint.kind == JointKind::Planar) q[2] = 1.0;
    if (joint.kind == JointKind::Ball) q[3] = 1.0;
    if (joint.kind != JointKind::FreeFlyer) continue;
    q[6] = 1.0;
    if (walk.spec_of_joint[i] != nullptr) continue;
    q.head<3>() = walk.options.base_placement.translation();
    q.tail<4>() = Eigen::Quaterniond(walk.options.base_placement.linear()).normalized().coeffs();
  }
}

/// Inserts `k` into the ascending list unless it is there.
void add_entry(int k, std::vector<int>& support) {
  const auto at = std::lower_bound(support.begin(), support.end(), k);
  if (at == support.end() || *at != k) support.insert(at, k);
}

void fill_support(Model& model) {
  bool has_followers = false;
  model.support_begin.push_back(0);
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    const auto of_parent = model.support(joint.parent);
    std::vector<int> support(of_parent.begin(), of_parent.end());
    int previous = support.empty() ? -1 : support.back();
    for (int k = joint.v_index; k < joint.v_index + joint.nv; ++k) {
      model.joint_of_v.push_back(static_cast<int>(i));
      model.parent_of_v.push_back(previous);
      add_entry(k, support);
      previous = k;
    }
    if (joint.follows) add_entry(joint.v_index, support);
    has_followers = has_followers || joint.follows;
    model.support_entries.insert(model.support_entries.end(), support.begin(), support.end());
    model.support_begin.push_back(static_cast<int>(model.support_entries.size()));
  }
  if (has_followers) chain_coupled_entries(model);
}

void check_isometry(const std::string& origin, const std::string& what,
                    const Eigen::Isometry3d& placement) {
  const Eigen::Matrix3d rotation = placement.linear();
  const bool valid = placement.matrix().allFinite() &&
                     (rotation * rotation.transpose()).isIdentity(1e-6) &&
                     rotation.determinant() > 0.0;
  if (valid) return;
  refuse(origin,
         what + " is not a rigid transformation; wanted a finite position and a rotation matrix");
}

void add_frames(const TreeSpec& tree, const std::vector<FrameSpec>& frames, Model& model) {
  for (const FrameSpec& added : frames) {
    if (added.name.empty())
      refuse(tree, "an added frame has no name; wanted a name for every frame");
    if (model.has_frame(added.name)) {
      refuse(tree, "the added frame " + in_quotes(added.name) +
                       " has the name of another frame; wanted a new name");
    }
    if (!model.has_frame(added.parent)) {
      std::vector<std::string> existing;
      for (const Frame& frame : model.frames) existing.push_back(frame.name);
      refuse(tree, "the added frame " + in_quotes(added.name) + " has the parent frame " +
                       in_quotes(added.parent) + ", which does not exist" +
                       did_you_mean(added.parent, existing));
    }
    check_isometry(origin_of(tree), "the placement of the added frame " + in_quotes(added.name),
                   added.placement);
    const Frame& parent = model.frames[to_size(model.frame_index(added.parent))];
    Frame frame{added.name, FrameKind::User, parent.body, parent.placement * added.placement};
    model.frames.push_back(std::move(frame));
  }
}

void check_options(const TreeSpec& tree, const ModelOptions& options) {
  check_isometry(origin_of(tree), "the base's placement", options.base_placement);
  if (!options.gravity.allFinite())
    refuse(tree, "gravity is not finite; wanted three finite numbers");
  if (options.base != Base::FreeFlyer) return;
  for (const JointSpec& joint : tree.joints) {
    if (joint.name == root_joint_name) {
      refuse(tree,
             "joint 'root_joint' of the description has a name that is reserved for the joint of "
             "a free-flying base; wanted another name, or a fixed base");
    }
  }
}

}  // namespace

Model build_model(const TreeSpec& tree, const ModelOptions& options) {
  Findings findings(origin_of(tree));
  check_topology(tree, findings);
  check_values(tree, findings);
  findings.refuse_problems();
  check_options(tree, options);
  LockedTree locked = lock_joints(tree, options);
  Walk walk = prepare(locked, options);
  Model model;
  model.name = tree.name;
  model.gravity = options.gravity;
  model.locked_joints = std::move(locked.locked);
  std::vector<Pending> stack;
  place_root(walk, model, stack);
  while (!stack.empty()) {
    const Pending next = stack.back();
    stack.pop_back();
    place_child(walk, model, next, stack);
  }
  couple_followers(walk.spec_of_joint, model);
  fill_limits(walk, model);
  take_over_limits(walk.spec_of_joint, origin_of(tree), model);
  take_over_springs(walk.spec_of_joint, origin_of(tree), model);
  model.tendons = compile_tendons(locked.tree, model);
  fill_neutral(walk, model);
  fill_support(model);
  check_inertia_along_joints(model, findings);
  check_plausibility(tree, options, findings);
  findings.refuse_problems();
  model.notes = tree.notes;
  model.warnings = tree.warnings;
  model.warnings.insert(model.warnings.end(), findings.warnings().begin(),
                        findings.warnings().end());
  if (options.strict) refuse_warnings(origin_of(tree), model.warnings);
  add_loops(tree, model);
  add_frames(tree, tree.frames, model);
  add_frames(tree, options.frames, model);
  return model;
}

}  // namespace burnish
