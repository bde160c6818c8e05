// Whole files as text.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace burnish {

/// What is larger is a slip, such as a device that never ends.
inline constexpr int max_megabytes = 64;

/// The whole file. Throws Error where it is a folder, cannot be opened or is too large; `wanted`
/// says in these sentences what it should have been, e.g. "URDF file".
std::string read_text(const std::filesystem::path& file, const std::string& wanted);

/// What is left of a stream, which is called `source` where it is too large.
std::string read_text(std::istream& stream, const std::string& source);

/// Throws Error where a text is larger than its reader takes.
void check_size(const std::string& text, const std::string& source, int megabytes = max_megabytes);

}  // namespace burnish
