// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace burnish {

/// A file that is written beside its place, under another name, and gets its own when all of it is
/// there: nothing half-written ever bears it, and what bore it before is replaced in one step. A
/// device or a pipe is written to as it is.
class WholeFile {
 public:
  /// Throws Error with the reason, such as "cannot write 'run/trace.csv': Permission denied".
  explicit WholeFile(const std::filesystem::path& file);
  /// What was not kept is gone.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// Behind the last byte. Throws Error as the constructor does: "No space left on device".
  void keep();

 private:
  [[noreturn]] void refuse(int reason) const;

  std::filesystem::path name_, target_, part_;  ///< as given, behind links, beside it
  std::ofstream stream_;
};

/// Throws Error as WholeFile does.
void write_whole_file(const std::filesystem::path& file, std::string_view text);

}  // namespace burnish
