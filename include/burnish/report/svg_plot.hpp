// Line plots as SVG files that any browser shows.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "burnish/base/views.hpp"

namespace burnish {

/// One line. Points that are not finite interrupt it.
/// @described report
struct Curve {
  std::string name = {};  ///< in the legend; empty: not listed
  Eigen::VectorXd x;
  Eigen::VectorXd y;
  int color = -1;       ///< of the palette; -1: the next one
  bool dashed = false;  ///< limits and targets
};

/// Axes with curves in them.
/// @described report
struct Panel {
  std::string title = {};
  std::string x_label = {};  ///< with units, such as "time [s]"
  std::string y_label = {};
  std::vector<Curve> curves = {};
  bool equal_aspect = false;  ///< a metre is as long upwards as to the right
  bool log_y = false;         ///< values that are not positive are left out
};

/// Line plots as an SVG file that any browser shows.
/// @described report
struct PlotSpec {
  std::string title = {};
  std::vector<Panel> panels = {};
  int columns = 1;            ///< panels beside each other
  double panel_width = 640;   ///< {px}, the legend included
  double panel_height = 240;  ///< {px}
};

/// The colours of curves, told apart by people of any colour vision (Okabe and Ito, 2008).
const std::vector<std::string>& plot_palette();

/// The text of an SVG file.
std::string svg_plot(const PlotSpec& spec);
/// Throws Error if the file cannot be written.
void write_svg_plot(const PlotSpec& spec, const std::filesystem::path& file);

}  // namespace burnish
