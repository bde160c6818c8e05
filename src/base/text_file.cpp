#include "base/text_file.hpp"

#include <array>
#include <fstream>

#include "base/sentence.hpp"

namespace burnish {

std::string read_text(const std::filesystem::path& file, const std::string& wanted) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    refuse(file.string(), "this is a folder; a " + wanted + " was wanted");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    refuse(file.string(), "the file cannot be opened; a readable " + wanted + " was wanted");
  }
  return read_text(stream, file.string());
}

std::string read_text(std::istream& stream, const std::string& source) {
  std::string text;
  std::array<char, 1 << 16> block;
  while (stream.read(block.data(), block.size()), stream.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    check_size(text, source);
  }
  return text;
}

void check_size(const std::string& text, const std::string& source, int megabytes) {
  if (text.size() <= static_cast<std::size_t>(megabytes) << 20) return;
  refuse(source,
         "it is larger than " + std::to_string(megabytes) + " MB; at most that much is read");
}

}  // namespace burnish
