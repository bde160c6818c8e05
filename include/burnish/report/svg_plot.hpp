// Line plots as SVG files, which any browser shows.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "burnish/base/views.hpp"

namespace burnish {

/// A curve in a plot. Points that are not finite leave gaps in the curve.
/// @described report
struct Curve {
  std::string name = {};  ///< Name in the legend (empty: not listed)
  Eigen::VectorXd x;
  Eigen::VectorXd y;
  int color = -1;       ///< Index of the colour in the palette (-1: the next colour)
  bool dashed = false;  ///< Whether the line is dashed, such as for limits and targets
};

/// A pair of axes with its curves.
/// @described report
struct Panel {
  std::string title = {};
  std::string x_label = {};  ///< Label of the x axis, with its unit, such as "time [s]"
  std::string y_label = {};
  std::vector<Curve> curves = {};
  bool equal_aspect = false;  ///< Whether both axes have the same scale
  bool log_y = false;  ///< Whether the y axis is logarithmic @more Values <= 0 are then left out
};

/// A figure with one or more panels of line plots. The result is an SVG file that any browser
/// shows.
/// @described report
struct PlotSpec {
  std::string title = {};
  std::vector<Panel> panels = {};
  int columns = 1;            ///< Number of panels side by side
  double panel_width = 640;   ///< Width of a panel, including its legend, in {px}
  double panel_height = 240;  ///< Height of a panel, in {px}
};

/// Returns the colours of curves. People of any colour vision can distinguish these colours (Okabe
/// and Ito, 2008).
const std::vector<std::string>& plot_palette();

/// Returns a plot as the text of an SVG file.
std::string svg_plot(const PlotSpec& spec);
/// Writes a plot to an SVG file. Throws Error if the file cannot be written.
void write_svg_plot(const PlotSpec& spec, const std::filesystem::path& file);

}  // namespace burnish
