// Tests of the cells of CSV files.
#include "base/csv_cell.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace burnish::testing {
namespace {

std::string cell(const auto& content) {
  std::string line = "before,";
  append_cell(line, content);
  return line.substr(7);
}

TEST(CsvCell, Number_ReadsBackExactlyAndNanIsEmpty) {
  for (const double value : {0.1, -1.0 / 3.0, 1e-300, 7.0, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(std::stod(cell(value)), value);
  EXPECT_EQ(cell(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(CsvCell, TextWithCommaOrQuote_IsQuoted) {
  EXPECT_EQ(cell("speed/joint_2"), "speed/joint_2");
  EXPECT_EQ(cell("a, b/x"), "\"a, b/x\"");
  EXPECT_EQ(cell("the \"box\""), "\"the \"\"box\"\"\"");
}

}  // namespace
}  // namespace burnish::testing
