// Tests of line plots: curves, axes, gaps and files.
#include "burnish/report/svg_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include "burnish/base/error.hpp"

namespace burnish::testing {
namespace {

/// Returns the points of all paths [px].
std::vector<Eigen::Vector2d> points(const std::string& svg) {
  std::vector<Eigen::Vector2d> result;
  const std::regex point("[ML]([0-9.-]+) ([0-9.-]+)");
  for (std::sregex_iterator it(svg.begin(), svg.end(), point), end; it != end; ++it)
    result.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  return result;
}

PlotSpec one(Panel panel) { return {.panels = {std::move(panel)}}; }

TEST(SvgPlot, Line_IsStraightAndPointsUpwards) {
  const Eigen::Vector3d x(0, 1, 3), y(1, 2, 4);
  const auto p = points(svg_plot(one({.curves = {{.name = "line", .x = x, .y = y}}})));
  ASSERT_EQ(p.size(), 3U);
  EXPECT_GT(p[0].y(), p[1].y());
  EXPECT_NEAR((p[1].y() - p[0].y()) / (p[2].y() - p[0].y()), 1.0 / 3.0, 1e-3);
  EXPECT_NEAR((p[1].x() - p[0].x()) / (p[2].x() - p[0].x()), 1.0 / 3.0, 1e-3);
}

TEST(SvgPlot, EqualAspect_DrawsRoundCircles) {
  const Eigen::VectorXd angle = Eigen::VectorXd::LinSpaced(100, 0.0, 6.3);
  const auto p =
      points(svg_plot(one({.curves = {{.x = angle.array().cos(), .y = 5.0 + angle.array().sin()}},
                           .equal_aspect = true})));
  double left = 1e9, right = -1e9, upper = 1e9, lower = -1e9;
  for (const Eigen::Vector2d& at : p) {
    left = std::min(left, at.x()), right = std::max(right, at.x());
    upper = std::min(upper, at.y()), lower = std::max(lower, at.y());
  }
  EXPECT_NEAR(right - left, lower - upper, 0.2);
}

TEST(SvgPlot, NonFinitePoints_InterruptTheLine) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::VectorXd x(5), y(5);
  x << 0, 1, 2, 3, 4;
  y << 0, 1, nan, std::numeric_limits<double>::infinity(), 4;
  const std::string svg = svg_plot(one({.curves = {{.x = x, .y = y}}}));
  EXPECT_EQ(points(svg).size(), 3U);
  EXPECT_EQ(std::count(svg.begin(), svg.end(), 'M'), 2);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(SvgPlot, EmptyAndConstantCurves_HaveAxes) {
  for (const Eigen::VectorXd& y : {Eigen::VectorXd(), Eigen::VectorXd(Eigen::VectorXd::Zero(3)),
                                   Eigen::VectorXd(Eigen::VectorXd::Constant(3, 1e9))}) {
    for (const bool log : {false, true}) {
      const std::string svg =
          svg_plot(one({.curves = {{.x = Eigen::VectorXd::Zero(y.size()), .y = y}}, .log_y = log}));
      EXPECT_EQ(svg.find("nan"), std::string::npos);
      EXPECT_EQ(svg.find("inf"), std::string::npos);
      EXPECT_NE(svg.find("class='axis'"), std::string::npos);
    }
  }
}

TEST(SvgPlot, RoundingOfAUnit_DoesNotFillThePanel) {
  const Eigen::Vector3d x(0, 1, 2), y(0.0, 1e-9, -1e-9);
  const auto span = [&](const std::string& label) {
    const auto p = points(svg_plot(one({.y_label = label, .curves = {{.x = x, .y = y}}})));
    return std::abs(p[1].y() - p[2].y());
  };
  EXPECT_LT(span("normal error [deg]"), 0.01);
  EXPECT_GT(span("something"), 10.0) << "without a unit, the range is that of the data";
}

TEST(SvgPlot, Text_IsEscaped) {
  const std::string svg = svg_plot(one({.title = "a < b & c"}));
  EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
}

TEST(SvgPlot, UnwritableFile_IsAnError) {
  EXPECT_THROW(write_svg_plot({}, "/nowhere/plot.svg"), Error);
}

}  // namespace
}  // namespace burnish::testing
