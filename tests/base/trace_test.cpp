// Tests of the trace of a run: columns, capacity and CSV text.
#include "burnish/base/trace.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "support/refusal.hpp"

namespace burnish {
namespace {

using testing::expect_words;
using testing::refusal;

Trace three_rows() {
  Trace trace({{"time", "s"}, {"tool_force_z_world", "N"}}, 3);
  for (int i = 0; i < 3; ++i) {
    double* row = trace.add_row();
    row[0] = 0.1 * i;
    row[1] = 30.0 + i;
  }
  return trace;
}

TEST(Trace, Columns_AreFoundByName) {
  const Trace trace = three_rows();
  EXPECT_EQ(trace.rows(), 3);
  EXPECT_EQ(trace.index("tool_force_z_world"), 1);
  EXPECT_EQ(trace.column("tool_force_z_world"), Eigen::Vector3d(30.0, 31.0, 32.0));
  EXPECT_EQ(trace.at(2, 0), 0.2);
  EXPECT_TRUE(trace.has("time"));
  EXPECT_FALSE(trace.has("Time"));
}

TEST(Trace, RowsBeyondCapacity_AreCountedAsDropped) {
  Trace trace = three_rows();
  EXPECT_EQ(trace.add_row(), nullptr);
  EXPECT_EQ(trace.add_row(), nullptr);
  EXPECT_EQ(trace.dropped(), 2);
  EXPECT_EQ(trace.rows(), 3);
  trace.clear();
  EXPECT_EQ(trace.rows(), 0);
  EXPECT_EQ(trace.dropped(), 0);
  double* row = trace.add_row();
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row[1], 0.0) << "a new row starts at zero";
}

TEST(Trace, CsvText_HasUnitsInTheHeaderAndEveryDigit) {
  Trace trace = three_rows();
  std::ostringstream out;
  trace.write_csv(out);
  EXPECT_EQ(out.str(), "time [s],tool_force_z_world [N]\n0,30\n0.1,31\n0.2,32\n");
  trace.clear();
  trace.add_row()[0] = 0.1 + 0.2;
  std::ostringstream digits;
  trace.write_csv(digits);
  EXPECT_NE(digits.str().find("0.30000000000000004,0"), std::string::npos) << digits.str();
}

TEST(Trace, BadColumnsCapacityOrFile_AreRefused) {
  expect_words(refusal([] { Trace({{"a", "m"}, {"a", "m"}}, 1); }), {"two columns", "'a'"});
  expect_words(refusal([] { Trace({{"a,b", "m"}}, 1); }), {"a,b", "without commas"});
  expect_words(refusal([] { Trace({{"", "m"}}, 1); }), {"column 0"});
  expect_words(refusal([] { Trace({}, -1); }), {"capacity", "-1"});
  expect_words(refusal([] { (void)three_rows().column("tool_force_z_word"); }),
               {"no column", "did you mean 'tool_force_z_world'"});
  expect_words(refusal([] { three_rows().write_csv(std::filesystem::path("/no/such/folder/x")); }),
               {"cannot write", "/no/such/folder/x"});
}

TEST(Trace, NanInCsvText_IsAnEmptyCell) {
  Trace trace({{"a", "N"}, {"b", "N"}, {"c", "N"}}, 1);
  double* row = trace.add_row();
  row[0] = 1.5, row[1] = std::nan(""), row[2] = -std::nan("");
  std::ostringstream text;
  trace.write_csv(text);
  EXPECT_EQ(text.str(), "a [N],b [N],c [N]\n1.5,,\n");
}

}  // namespace
}  // namespace burnish
