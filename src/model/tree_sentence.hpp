// Sentences about a robot's description, for error messages and warnings.
#pragma once

#include "base/sentence.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Returns the beginning of a sentence: the name of the file, else the name of the robot.
inline std::string origin_of(const TreeSpec& tree) {
  if (!tree.source.empty()) return tree.source;
  return tree.name.empty() ? "tree" : "robot " + in_quotes(tree.name);
}

/// Returns a label such as "line 12: joint 'a'".
inline std::string label(const std::string& kind, const std::string& name, int line) {
  return (line > 0 ? "line " + std::to_string(line) + ": " : "") + kind + " " + in_quotes(name);
}
inline std::string label_of(const JointSpec& joint) {
  return label("joint", joint.name, joint.line);
}
inline std::string label_of(const LinkSpec& link) { return label("link", link.name, link.line); }

[[noreturn]] inline void refuse(const TreeSpec& tree, const std::string& what) {
  refuse(origin_of(tree), what);
}

}  // namespace burnish
