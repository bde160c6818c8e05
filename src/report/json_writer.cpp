#include "report/json_writer.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

namespace burnish {
namespace {

void put_little_endian(std::string& to, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8)
    to += static_cast<char>(static_cast<unsigned char>(word >> shift));
}

/// Length of the UTF-8 character that a text starts with; 0 if it starts with none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  // Longer than needed, a surrogate, or beyond the last character.
  if ((first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
      (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F))
    return 0;
  return length;
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8U) | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      result += k <= count ? letters[(group >> (18 - 6 * k)) & 63U] : '=';
  }
  return result;
}

void JsonWriter::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

void JsonWriter::begin(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
}

void JsonWriter::end(char bracket) {
  text_ += bracket;
  first_ = false;
}

void JsonWriter::quoted(std::string_view text) {
  text_ += '"';
  while (!text.empty()) {
    const char letter = text.front();
    const std::size_t length = utf8_length(text);
    if (length == 0) {
      text_ += "\xEF\xBF\xBD";
    } else if (letter == '"' || letter == '\\') {
      text_ += '\\';
      text_ += letter;
    } else if (letter == '\n') {
      text_ += "\\n";
    } else if (letter == '<' || static_cast<unsigned char>(letter) < 0x20) {
      constexpr std::string_view digits = "0123456789abcdef";
      const auto code = static_cast<unsigned char>(letter);
      text_ += "\\u00";
      text_ += digits[code >> 4U];
      text_ += digits[code & 15U];
    } else {
      text_ += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  text_ += '"';
}

void JsonWriter::key(std::string_view name) {
  separate();
  quoted(name);
  text_ += ':';
  first_ = true;
}

void JsonWriter::value(double number) {
  separate();
  if (!std::isfinite(number)) {
    text_ += "null";
    return;
  }
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text_.append(digits.data(), end);
}
void JsonWriter::value(std::int64_t number) {
  separate();
  text_ += std::to_string(number);
}
void JsonWriter::value(bool truth) {
  separate();
  text_ += truth ? "true" : "false";
}
void JsonWriter::value(std::string_view text) {
  separate();
  quoted(text);
}
void JsonWriter::null() {
  separate();
  text_ += "null";
}
void JsonWriter::raw(std::string_view json) {
  separate();
  text_ += json;
}

void JsonWriter::value(const Eigen::Ref<const Eigen::VectorXd>& numbers) {
  begin_array();
  for (const double number : numbers) value(number);
  end_array();
}

void JsonWriter::value(const Eigen::Isometry3d& placement) {
  Eigen::Quaterniond rotation(placement.linear());
  if (rotation.w() < 0.0) rotation.coeffs() *= -1.0;
  Eigen::Matrix<double, 7, 1> numbers;
  numbers << placement.translation(), rotation.normalized().coeffs();
  value(numbers);
}

void JsonWriter::packed(std::string_view kind, std::size_t count, const std::string& bytes) {
  begin_object();
  field("n", static_cast<std::int64_t>(count));
  key(kind);
  separate();
  text_ += '"';
  text_ += base64(bytes);
  text_ += '"';
  end_object();
}

void JsonWriter::floats(std::span<const float> numbers) {
  std::string bytes;
  bytes.reserve(4 * numbers.size());
  for (const float number : numbers) put_little_endian(bytes, std::bit_cast<std::uint32_t>(number));
  packed("f32", numbers.size(), bytes);
}
void JsonWriter::floats(const Eigen::Ref<const Eigen::VectorXd>& numbers) {
  const Eigen::VectorXf rounded = numbers.cast<float>();
  floats(std::span<const float>(rounded.data(), static_cast<std::size_t>(rounded.size())));
}
void JsonWriter::integers(std::span<const std::uint32_t> numbers) {
  std::string bytes;
  bytes.reserve(4 * numbers.size());
  for (const std::uint32_t number : numbers) put_little_endian(bytes, number);
  packed("u32", numbers.size(), bytes);
}

std::string JsonWriter::take() {
  first_ = true;
  return std::exchange(text_, {});
}

}  // namespace burnish
