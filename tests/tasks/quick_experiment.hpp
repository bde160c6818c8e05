// Quick versions of experiments, and checks that apply to every report.
#pragma once

#include <gtest/gtest.h>

#include "polishing/experiments/experiment.hpp"

namespace burnish::testing {

using namespace burnish::polishing;

inline ExperimentSpec quick() {
  ExperimentSpec spec;
  spec.quick = true;
  spec.threads = 2;
  return spec;
}

inline const ResultTable& table_named(const ExperimentReport& report, const std::string& name) {
  for (const ResultTable& table : report.tables)
    if (table.name == name) return table;
  throw Error("no table " + name);
}

inline double number_at(const ResultTable& table, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].name == column) return std::get<double>(table.rows.at(row)[i]);
  throw Error("no column " + column);
}

inline void expect_complete(const ExperimentReport& report) {
  EXPECT_FALSE(report.interrupted);
  for (const std::string& failure : report.failures) ADD_FAILURE() << failure;
  ASSERT_FALSE(report.tables.empty());
  for (const ResultTable& table : report.tables) EXPECT_FALSE(table.rows.empty()) << table.name;
  ASSERT_FALSE(report.figures.empty());
  for (const Figure& figure : report.figures) {
    const std::string svg = svg_plot(figure.plot);
    EXPECT_NE(svg.find("<path class="), std::string::npos) << figure.name;
    EXPECT_LT(svg.size(), 200e3) << figure.name;
  }
}

}  // namespace burnish::testing
