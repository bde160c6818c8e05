// Drawing of a robot's tree of joints as lines of text.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::app {

/// Returns one line per joint, in the model's order. A joint that is the only child of its parent
/// is written directly below the parent. At a fork, each branch starts with a corner:
///
///     rail_joint
///     slew_joint
///     +- left_luff_joint
///     |  left_wrist_joint
///     +- right_luff_joint
///
/// with box-drawing characters (UTF-8) in place of +, - and |.
std::vector<std::string> draw_tree(const Model& model);

/// Returns the number of characters of UTF-8 text.
std::size_t width_of(const std::string& text);

/// Returns `text` padded with blanks to `width` characters. `right`: true to put the blanks before
/// the text.
std::string padded(const std::string& text, std::size_t width, bool right = false);

}  // namespace burnish::app
