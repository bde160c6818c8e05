// Tests of files that are replaced completely or not at all.
#include "base/whole_file.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;
using testing::contents;
using testing::expect_words;
using testing::refusal;

class AtomicFile : public ::testing::Test {
 protected:
  int count() const { return static_cast<int>(std::distance(fs::directory_iterator(folder_), {})); }
  testing::Scratch scratch_;
  const fs::path& folder_ = scratch_.folder;
};

TEST_F(AtomicFile, UnfinishedWrite_KeepsThePreviousFile) {
  const fs::path file = folder_ / "a.txt";
  write_whole_file(file, "before");
  {
    WholeFile whole(file);
    whole.stream() << "half";
    whole.stream().flush();
    EXPECT_EQ(contents(file), "before");
  }
  EXPECT_EQ(contents(file), "before");
  EXPECT_EQ(count(), 1) << "the temporary file is deleted";
  write_whole_file(file, "after");
  EXPECT_EQ(contents(file), "after");
  EXPECT_EQ(count(), 1);
}

TEST_F(AtomicFile, WriteThroughALink_ReplacesTheTargetAndKeepsTheLink) {
  fs::create_directory(folder_ / "real");
  write_whole_file(folder_ / "real" / "a.txt", "before");
  fs::create_symlink("real/a.txt", folder_ / "link");
  write_whole_file(folder_ / "link", "after");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(contents(folder_ / "real" / "a.txt"), "after");
}

TEST_F(AtomicFile, FailedWrite_IsRefusedWithTheReason) {
  expect_words(refusal([&] { write_whole_file(folder_ / "none" / "a.txt", "x"); }),
               {"cannot write '", "none/a.txt': No such file or directory"});
  expect_words(refusal([] { write_whole_file("/dev/full", "x"); }),
               {"cannot write '/dev/full': No space left on device"});
  write_whole_file("/dev/null", "x");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace burnish
