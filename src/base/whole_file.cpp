#include "base/whole_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "burnish/base/error.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

/// Returns the target of a symbolic link, since a write must replace the target and not the link.
/// Returns any other path unchanged.
fs::path behind_links(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_symlink(file, ignored)) return file;
  const fs::path target = fs::canonical(file, ignored);
  return ignored ? file : target;
}

/// Returns the name of the temporary file. Returns an empty path if `target` cannot be replaced,
/// such as /dev/stdout.
fs::path temporary_for(const fs::path& target) {
  std::error_code ignored;
  if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored)) return {};
  return target.parent_path() /
         ("." + target.filename().string() + "." + std::to_string(getpid()) + ".part");
}

}  // namespace

WholeFile::WholeFile(const fs::path& file)
    : name_(file), target_(behind_links(file)), temporary_(temporary_for(target_)) {
  errno = 0;
  stream_.open(temporary_.empty() ? target_ : temporary_, std::ios::binary);
  if (!stream_) refuse(errno);
}

WholeFile::~WholeFile() {
  if (temporary_.empty()) return;
  stream_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void WholeFile::keep() {
  stream_.close();
  if (!stream_) refuse(errno);
  if (temporary_.empty()) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) refuse(error.value());
  temporary_.clear();
}

void WholeFile::refuse(int reason) const {
  throw Error("cannot write '" + name_.string() + "'" +
              (reason != 0 ? std::string(": ") + std::strerror(reason) : std::string()));
}

void write_whole_file(const fs::path& file, std::string_view text) {
  WholeFile whole(file);
  whole.stream() << text;
  whole.keep();
}

}  // namespace burnish
