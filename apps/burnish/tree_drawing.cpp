#include "tree_drawing.hpp"

#include "base/to_size.hpp"

namespace burnish::app {
namespace {

constexpr int root = -1;

class Drawing {
 public:
  explicit Drawing(const Model& model) : model_(model), children_(model.joints.size() + 1) {
    for (std::size_t i = 0; i < model.joints.size(); ++i)
      children_[to_size(model.joints[i].parent + 1)].push_back(static_cast<int>(i));
    lines.resize(model.joints.size());
    draw_children(root, "");
  }
  std::vector<std::string> lines;

 private:
  const std::vector<int>& children(int joint) const { return children_[to_size(joint + 1)]; }

  /// Draws all descendants of a joint. Chains are drawn in a loop; only forks need recursion.
  void draw_children(int joint, const std::string& before) {
    while (children(joint).size() == 1) {
      joint = children(joint).front();
      line(joint) = before + name(joint);
    }
    for (const int child : children(joint)) {
      const bool last = child == children(joint).back();
      line(child) = before + (last ? "└─ " : "├─ ") + name(child);
      draw_children(child, before + (last ? "   " : "│  "));
    }
  }
  std::string& line(int joint) { return lines[to_size(joint)]; }
  const std::string& name(int joint) const { return model_.joints[to_size(joint)].name; }

  const Model& model_;
  /// Children of joint i at index i + 1, children of the world at index 0.
  std::vector<std::vector<int>> children_;
};

}  // namespace

std::vector<std::string> draw_tree(const Model& model) { return Drawing(model).lines; }

std::size_t width_of(const std::string& text) {
  std::size_t width = 0;
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) ++width;
  return width;
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::size_t used = width_of(text);
  const std::string blanks(used < width ? width - used : 0, ' ');
  return right ? blanks + text : text + blanks;
}

}  // namespace burnish::app
