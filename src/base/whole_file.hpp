// Writes files atomically: a file is either complete or absent.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace burnish {

/// Output file that appears under its name only when complete. The content is written to a
/// temporary file in the same folder. keep() renames this file and so replaces an older file in one
/// step. Devices and pipes are written directly.
class WholeFile {
 public:
  /// Throws Error with the reason, such as "cannot write 'run/trace.csv': Permission denied".
  explicit WholeFile(const std::filesystem::path& file);
  /// Deletes the temporary file unless keep() was called.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// Completes the file; call it after the last write. Throws Error with the reason, such as
  /// "cannot write 'run/trace.csv': No space left on device".
  void keep();

 private:
  [[noreturn]] void refuse(int reason) const;

  std::filesystem::path name_;       ///< Path as given
  std::filesystem::path target_;     ///< Path with symbolic links resolved
  std::filesystem::path temporary_;  ///< Temporary file beside target_; empty: written directly
  std::ofstream stream_;
};

/// Writes `text` to `file` through a WholeFile. Throws Error with the reason.
void write_whole_file(const std::filesystem::path& file, std::string_view text);

}  // namespace burnish
