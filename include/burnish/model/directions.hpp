// Some of the six directions of a relative motion: what a contact or a loop holds.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "burnish/base/error.hpp"

namespace burnish {

/// Names of the six directions, translations first.
inline constexpr std::array<std::string_view, 6> direction_names{"x", "y", "z", "rx", "ry", "rz"};

/// A subset of {x, y, z, rx, ry, rz}. Rows of a contact are in this order.
struct Directions {
  std::uint8_t bits = 0;

  static constexpr Directions all() { return {0b111111}; }
  static constexpr Directions linear() { return {0b000111}; }
  static constexpr Directions angular() { return {0b111000}; }
  static constexpr Directions x() { return {0b000001}; }
  static constexpr Directions y() { return {0b000010}; }
  static constexpr Directions z() { return {0b000100}; }
  /// A flat pad on a plane whose normal is z: normal translation and the two tilts.
  static constexpr Directions pad_z() { return {0b011100}; }
  /// The same for a plane whose normal is y or x.
  static constexpr Directions pad_y() { return {0b101010}; }
  static constexpr Directions pad_x() { return {0b110001}; }

  /// Reads "all", "linear", "angular", "pad_x|y|z", or names in any order separated by commas, such
  /// as "z,rx,ry". Throws Error naming the unknown word and the nearest known one.
  static Directions parse(std::string_view text);
  /// Names in order, separated by commas: "z,rx,ry".
  std::string text() const;

  constexpr bool has(int direction) const { return ((bits >> direction) & 1) != 0; }
  constexpr int count() const {
    int n = 0;
    for (int d = 0; d < 6; ++d) n += has(d) ? 1 : 0;
    return n;
  }
  constexpr bool operator==(const Directions&) const = default;
};

constexpr Directions operator|(Directions a, Directions b) {
  return {static_cast<std::uint8_t>(a.bits | b.bits)};
}

}  // namespace burnish
