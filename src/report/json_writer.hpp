// JSON as text, written from left to right.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/views.hpp"

namespace burnish {

/// Bytes in base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

/// Commas and quotes are its business, brackets are the caller's: what is begun has to be ended.
/// "<" becomes \u003c, so that no text can end the script element that holds the JSON.
class JsonWriter {
 public:
  void begin_object() { begin('{'); }
  void end_object() { end('}'); }
  void begin_array() { begin('['); }
  void end_array() { end(']'); }
  void key(std::string_view name);

  /// Infinity and NaN become null: JSON knows neither. Numbers read back as they were.
  void value(double number);
  void value(std::int64_t number);
  void value(int number) { value(static_cast<std::int64_t>(number)); }
  void value(bool truth);
  /// Bytes that are no UTF-8 become U+FFFD.
  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(const std::string& text) { value(std::string_view(text)); }
  void null();
  /// JSON that was written elsewhere.
  void raw(std::string_view json);

  /// A list of numbers.
  void value(const Eigen::Ref<const Eigen::VectorXd>& numbers);
  /// [px, py, pz, qx, qy, qz, qw], w not negative.
  void value(const Eigen::Isometry3d& placement);
  /// {"n": count, "f32": base64 of little-endian float32}; NaN stays NaN.
  void floats(std::span<const float> numbers);
  void floats(const Eigen::Ref<const Eigen::VectorXd>& numbers);
  /// {"n": count, "u32": base64 of little-endian uint32}.
  void integers(std::span<const std::uint32_t> numbers);

  template <class T>
  void field(std::string_view name, const T& what) {
    key(name);
    value(what);
  }

  /// The text so far; the writer is empty afterwards.
  std::string take();

 private:
  void begin(char bracket);
  void end(char bracket);
  void separate();
  void quoted(std::string_view text);
  void packed(std::string_view kind, std::size_t count, const std::string& bytes);

  std::string text_;
  bool first_ = true;  ///< nothing stands before in the present bracket, or a key does
};

}  // namespace burnish
