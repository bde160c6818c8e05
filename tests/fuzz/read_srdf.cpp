#include "fuzz/readers.hpp"
#include "urdf/srdf.hpp"

namespace burnish::fuzz {
namespace {

/// Tree with one joint of every type.
TreeSpec every_joint() {
  TreeSpec tree;
  for (const auto& [name, type] : {std::pair{"hinge", JointType::Revolute},
                                   {"wheel", JointType::Continuous},
                                   {"slide", JointType::Prismatic},
                                   {"glued", JointType::Fixed},
                                   {"plane", JointType::Planar},
                                   {"adrift", JointType::Floating}}) {
    JointSpec joint;
    joint.name = name;
    joint.type = type;
    tree.joints.push_back(joint);
  }
  return tree;
}

void read(const std::string& text) {
  static const TreeSpec tree = every_joint();
  Findings findings("input.srdf");
  parse_srdf(text, tree, findings);
}

}  // namespace

const Reader srdf{"srdf", read};

}  // namespace burnish::fuzz
