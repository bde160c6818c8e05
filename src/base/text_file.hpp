// Reads whole files as text.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace burnish {

/// Maximum size of an input file [MB]. A larger input is probably a mistake, such as /dev/zero.
inline constexpr int max_megabytes = 64;

/// Reads a whole file. Throws Error if the file is a folder, cannot be opened or is too large.
/// `wanted` names the expected kind of file in these messages, such as "URDF file".
std::string read_text(const std::filesystem::path& file, const std::string& wanted);

/// Reads the rest of a stream. Throws Error if the text is larger than max_megabytes. The message
/// calls the stream `source`.
std::string read_text(std::istream& stream, const std::string& source);

/// Throws Error if `text`, called `source` in the message, is larger than `megabytes`.
void check_size(const std::string& text, const std::string& source, int megabytes = max_megabytes);

}  // namespace burnish
