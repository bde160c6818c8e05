// A robot's tree of joints as lines of text.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::app {

/// One line per joint, in the model's order. A joint that is the only child of the one above stands
/// below it; where the tree branches, each branch starts with a corner:
///
///     rail_joint
///     slew_joint
///     +- left_luff_joint
///     |  left_wrist_joint
///     +- right_luff_joint
///
/// drawn with box characters (UTF-8).
std::vector<std::string> draw_tree(const Model& model);

/// Characters of UTF-8 text.
std::size_t width_of(const std::string& text);

/// `text` filled with blanks to `width` characters; right: blanks first.
std::string padded(const std::string& text, std::size_t width, bool right = false);

}  // namespace burnish::app
