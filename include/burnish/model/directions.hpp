// Subsets of the six directions of a relative motion. A contact or a loop constrains such a subset.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "burnish/base/error.hpp"

namespace burnish {

/// Names of the six directions of a relative motion: three translations, then three rotations.
inline constexpr std::array<std::string_view, 6> direction_names{"x", "y", "z", "rx", "ry", "rz"};

/// A subset of the six directions of a relative motion. The rows of a contact are in the order x,
/// y, z, rx, ry, rz.
struct Directions {
  std::uint8_t bits = 0;

  static constexpr Directions all() { return {0b111111}; }
  static constexpr Directions linear() { return {0b000111}; }
  static constexpr Directions angular() { return {0b111000}; }
  static constexpr Directions x() { return {0b000001}; }
  static constexpr Directions y() { return {0b000010}; }
  static constexpr Directions z() { return {0b000100}; }
  /// Directions constrained by a flat pad on a plane with normal z: z, rx, ry.
  static constexpr Directions pad_z() { return {0b011100}; }
  /// Directions constrained by a flat pad on a plane with normal y: y, rx, rz.
  static constexpr Directions pad_y() { return {0b101010}; }
  /// Directions constrained by a flat pad on a plane with normal x: x, ry, rz.
  static constexpr Directions pad_x() { return {0b110001}; }

  /// Parses direction names separated by commas, in any order, such as "z,rx,ry". The names "all",
  /// "linear", "angular", "pad_x", "pad_y" and "pad_z" stand for several directions. Throws Error
  /// if the text has no name, or with the nearest known name if a name is unknown.
  static Directions parse(std::string_view text);
  /// Returns the direction names separated by commas, in the order x, y, z, rx, ry, rz. Example:
  /// "z,rx,ry".
  std::string text() const;

  constexpr bool has(int direction) const { return ((bits >> direction) & 1) != 0; }
  constexpr int count() const {
    int n = 0;
    for (int d = 0; d < 6; ++d) n += has(d) ? 1 : 0;
    return n;
  }
  /// Returns true if a rotation is among the directions.
  constexpr bool has_angular() const { return (bits & angular().bits) != 0; }
  constexpr bool operator==(const Directions&) const = default;
};

constexpr Directions operator|(Directions a, Directions b) {
  return {static_cast<std::uint8_t>(a.bits | b.bits)};
}

}  // namespace burnish
