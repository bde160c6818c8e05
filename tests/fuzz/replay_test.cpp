// Replays the corpus of the fuzz targets, and every text that a reader once handled wrongly.
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "fuzz/readers.hpp"

namespace burnish::fuzz {
namespace {

namespace fs = std::filesystem;

class ReaderReplay : public ::testing::TestWithParam<const Reader*> {};

TEST_P(ReaderReplay, AnyText_IsReadOrRefusedInOneSentenceWithinASecond) {
  int files = 0;
  for (const char* kind : {"corpus", "regressions"}) {
    const fs::path folder = fs::path(BURNISH_FUZZ_DIR) / kind / GetParam()->name;
    if (!fs::exists(folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << stream.rdbuf();
      EXPECT_NO_THROW(run(*GetParam(), text.str())) << entry.path();
      ++files;
    }
  }
  EXPECT_GT(files, 0);
}

INSTANTIATE_TEST_SUITE_P(Reader, ReaderReplay,
                         ::testing::Values(&urdf, &mjcf, &srdf, &robot, &problem, &task, &request,
                                           &table),
                         [](const ::testing::TestParamInfo<const Reader*>& test) {
                           return std::string(test.param->name);
                         });

// The replay is only meaningful if run() detects errors.
TEST(ReaderRun, OtherExceptionOrHang_IsAnError) {
  const auto throws_another = [](const std::string&) { throw std::out_of_range("vector::at"); };
  EXPECT_THROW(run({"exceptions", throws_another}, ""), std::logic_error);
  const auto hangs = [](const std::string&) {
    for (const std::clock_t begun = std::clock();
         std::clock() - begun < 11 * CLOCKS_PER_SEC / 10;) {
    }
  };
  EXPECT_THROW(run({"hangs", hangs}, ""), std::logic_error);
  EXPECT_NO_THROW(run({"nothing", [](const std::string&) {}}, ""));
}

}  // namespace
}  // namespace burnish::fuzz
