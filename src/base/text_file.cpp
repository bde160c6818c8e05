#include "base/text_file.hpp"

#include <array>
#include <fstream>

#include "base/sentence.hpp"
#include "base/to_size.hpp"

namespace burnish {

std::string read_text(const std::filesystem::path& file, const std::string& wanted) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    refuse(file.string(), "this is a folder; wanted a " + wanted);
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    refuse(file.string(), "the file cannot be opened; wanted a readable " + wanted);
  }
  return read_text(stream, file.string());
}

std::string read_text(std::istream& stream, const std::string& source) {
  std::string text;
  std::array<char, 1 << 16> block;
  while (stream.read(block.data(), block.size()), stream.gcount() > 0) {
    text.append(block.data(), to_size(stream.gcount()));
    check_size(text, source);
  }
  return text;
}

void check_size(const std::string& text, const std::string& source, int megabytes) {
  if (text.size() <= to_size(megabytes) << 20) return;
  refuse(source, "the input is larger than " + std::to_string(megabytes) + " MB, the maximum size");
}

}  // namespace burnish
