#include "burnish/report/svg_plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/to_size.hpp"
#include "base/whole_file.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

// Layout of a plot, chosen by hand [px].
constexpr double font = 11.0;           // size of the font
constexpr double letter = 0.58 * font;  // mean width of a letter
constexpr double left = 64.0, top = 28.0, bottom = 40.0, panel_gap = 12.0;

std::string px(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

/// Lower and upper end of an axis in plotted units, which are logarithms for a logarithmic axis.
struct AxisRange {
  double lower = std::numeric_limits<double>::infinity();
  double upper = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    lower = std::min(lower, value);
    upper = std::max(upper, value);
  }
  double span() const { return upper - lower; }
  void settle() {
    if (!(lower <= upper)) lower = 0.0, upper = 1.0;
    // The span has a minimum, so that rounding errors of a constant do not fill the axis.
    const double min_span = 1e-6 * std::max({std::abs(lower), std::abs(upper), 1e-3});
    if (span() < min_span) {
      const double middle = 0.5 * (lower + upper);
      const double half = std::max(0.05 * std::abs(middle), min_span);
      lower = middle - half;
      upper = middle + half;
    }
  }
  void widen_to(double min_span) {
    const double by = 0.5 * (min_span - span());
    if (!(by > 0.0)) return;
    lower -= by;
    upper += by;
  }
  void widen(double fraction) {
    const double by = fraction * span();
    lower -= by;
    upper += by;
  }
};

/// Returns the minimum span of a vertical axis, by the unit in its label. Smaller spans would show
/// rounding errors. The spans are chosen by hand.
double min_span_of(const std::string& label) {
  static const std::pair<const char*, double> spans[] = {
      {"[N]", 0.01},   {"[Nm]", 0.01},  {"[mm]", 1e-3},    {"[deg]", 1e-3}, {"[m]", 1e-6},
      {"[rad]", 1e-5}, {"[m/s]", 1e-5}, {"[rad/s]", 1e-4}, {"[ms]", 1e-3}};
  for (const auto& [unit, span] : spans)
    if (label.find(unit) != std::string::npos) return span;
  return 0.0;
}

/// Returns 1, 2 or 5 times a power of ten, such that `span` has about `wanted` steps.
double tick_step(double span, double wanted) {
  const double rough = span / wanted, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10.0 * power;
}

std::string tick_text(double value, double step) {
  char text[32];
  if (std::abs(value) < 1e-9 * step) value = 0.0;
  const double size = std::max(std::abs(value), step);
  if (size >= 1e5 || step < 1e-4) {
    std::snprintf(text, sizeof text, "%.3g", value);
  } else {
    const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    std::snprintf(text, sizeof text, "%.*f", digits, value);
  }
  return text;
}

struct Tick {
  double at;
  std::string text;
};

std::vector<Tick> ticks_of(const AxisRange& range, double wanted, bool logarithmic) {
  std::vector<Tick> ticks;
  double step = tick_step(range.span(), wanted);
  if (logarithmic) step = std::max(1.0, std::round(step));
  const long first = std::lround(std::ceil(range.lower / step - 1e-9));
  for (long i = first; static_cast<double>(i) * step <= range.upper + 1e-9 * step; ++i) {
    const double at = static_cast<double>(i) * step;
    ticks.push_back(
        {at, logarithmic ? "1e" + std::to_string(std::lround(at)) : tick_text(at, step)});
  }
  return ticks;
}

/// Writer of one panel.
struct PanelWriter {
  const Panel& panel;
  double x0, y0, width, height;  // upper left corner and size of the axes [px]
  AxisRange x = {}, y = {};
  std::string& out;

  double plotted(double value) const {
    if (!panel.log_y) return value;
    return value > 0.0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
  }
  double to_x(double value) const { return x0 + (value - x.lower) / x.span() * width; }
  double to_y(double value) const { return y0 + height - (value - y.lower) / y.span() * height; }

  void find_ranges() {
    for (const Curve& curve : panel.curves) {
      const Eigen::Index size = std::min(curve.x.size(), curve.y.size());
      for (Eigen::Index i = 0; i < size; ++i) {
        const double value = plotted(curve.y[i]);
        if (!std::isfinite(value) || !std::isfinite(curve.x[i])) continue;
        x.include(curve.x[i]);
        y.include(value);
      }
    }
    x.settle();
    y.settle();
    y.widen(0.06);
    if (!panel.log_y) y.widen_to(min_span_of(panel.y_label));
    if (!panel.equal_aspect) return;
    x.widen(0.06);
    const double per_px = std::max(x.span() / width, y.span() / height);
    x.widen(0.5 * (per_px * width / x.span() - 1.0));
    y.widen(0.5 * (per_px * height / y.span() - 1.0));
  }

  void text(double at_x, double at_y, const std::string& words, const char* anchor,
            const char* more = "") const {
    out += "<text x='" + px(at_x) + "' y='" + px(at_y) + "' text-anchor='" + anchor + "'" + more +
           ">" + escaped(words) + "</text>\n";
  }
  void line(double ax, double ay, double bx, double by, const char* kind) const {
    out += "<line class='" + std::string(kind) + "' x1='" + px(ax) + "' y1='" + px(ay) + "' x2='" +
           px(bx) + "' y2='" + px(by) + "'/>\n";
  }

  void axes() const {
    for (const Tick& tick : ticks_of(x, width / 80.0, false)) {
      line(to_x(tick.at), y0, to_x(tick.at), y0 + height, "grid");
      text(to_x(tick.at), y0 + height + font + 4.0, tick.text, "middle");
    }
    for (const Tick& tick : ticks_of(y, height / 36.0, panel.log_y)) {
      line(x0, to_y(tick.at), x0 + width, to_y(tick.at), "grid");
      text(x0 - 5.0, to_y(tick.at) + 0.35 * font, tick.text, "end");
    }
    line(x0, y0 + height, x0 + width, y0 + height, "axis");
    line(x0, y0, x0, y0 + height, "axis");
    text(x0, y0 - 8.0, panel.title, "start", " class='title'");
    text(x0 + 0.5 * width, y0 + height + 2.0 * font + 8.0, panel.x_label, "middle");
    const double turned_x = x0 - left + font + 2.0, turned_y = y0 + 0.5 * height;
    const std::string turn = " transform='rotate(-90 " + px(turned_x) + " " + px(turned_y) + ")'";
    text(turned_x, turned_y, panel.y_label, "middle", turn.c_str());
  }

  void curve(const Curve& given, const std::string& color) const {
    const Eigen::Index size = std::min(given.x.size(), given.y.size());
    std::string path;
    bool pen_down = false;
    for (Eigen::Index i = 0; i < size; ++i) {
      const double value = plotted(given.y[i]);
      if (!std::isfinite(value) || !std::isfinite(given.x[i])) {
        pen_down = false;
        continue;
      }
      path += (pen_down ? "L" : "M") + px(to_x(given.x[i])) + " " + px(to_y(value));
      pen_down = true;
    }
    if (path.empty()) return;
    out += "<path class='curve' stroke='" + color + "'" +
           (given.dashed ? " stroke-dasharray='5 3'" : "") + " d='" + path + "'/>\n";
  }

  void write() const {
    axes();
    int next = 0;
    double legend_y = y0 + 0.5 * font;
    const double legend_x = x0 + width + panel_gap;
    const auto& palette = plot_palette();
    for (const Curve& given : panel.curves) {
      const int number = given.color >= 0 ? given.color : next++;
      const std::string& color = palette[to_size(number) % palette.size()];
      // When the palette repeats, curves are dashed.
      Curve drawn = given;
      drawn.dashed = given.dashed || number >= static_cast<int>(palette.size());
      curve(drawn, color);
      if (given.name.empty()) continue;
      out += "<line class='curve' stroke='" + color + "'" +
             (drawn.dashed ? " stroke-dasharray='5 3'" : "") + " x1='" + px(legend_x) + "' y1='" +
             px(legend_y) + "' x2='" + px(legend_x + 20.0) + "' y2='" + px(legend_y) + "'/>\n";
      text(legend_x + 26.0, legend_y + 0.35 * font, given.name, "start");
      legend_y += 1.35 * font;
    }
  }
};

/// Width of the legend and number of its lines.
std::pair<double, int> legend_size(const Panel& panel) {
  std::size_t longest = 0;
  int lines = 0;
  for (const Curve& curve : panel.curves) {
    if (curve.name.empty()) continue;
    longest = std::max(longest, curve.name.size());
    ++lines;
  }
  return {lines == 0 ? 0.0 : 26.0 + letter * static_cast<double>(longest) + 2.0 * panel_gap, lines};
}

}  // namespace

const std::vector<std::string>& plot_palette() {
  static const std::vector<std::string> colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                               "#E69F00", "#56B4E9", "#000000"};
  return colors;
}

std::string svg_plot(const PlotSpec& spec) {
  const int columns = std::max(1, spec.columns), count = static_cast<int>(spec.panels.size());
  const double head = spec.title.empty() ? 0.0 : 30.0;
  double axes_height = spec.panel_height - top - bottom;
  for (const Panel& panel : spec.panels)
    axes_height = std::max(axes_height, 1.35 * font * legend_size(panel).second);
  const double row = axes_height + top + bottom;
  const double width = spec.panel_width * columns;
  const int lines = (count + columns - 1) / columns;
  const double height = head + row * lines;
  std::string out = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " + px(width) + " " +
                    px(height) + "' width='" + px(width) + "' height='" + px(height) +
                    "' font-family='sans-serif' font-size='" + px(font) + "'>\n" +
                    "<style>.grid{stroke:#e4e4e4}.axis{stroke:#444}.curve{fill:none;"
                    "stroke-width:1.6}.title{font-weight:bold}text{fill:#222}</style>\n"
                    "<rect width='100%' height='100%' fill='white'/>\n";
  if (!spec.title.empty())
    out += "<text x='" + px(left) + "' y='20' font-size='15'>" + escaped(spec.title) + "</text>\n";
  for (int i = 0; i < count; ++i) {
    const Panel& panel = spec.panels[to_size(i)];
    const double legend = legend_size(panel).first;
    const int column = i % columns, line = i / columns;
    PanelWriter writer{panel,
                       spec.panel_width * column + left,
                       head + row * line + top,
                       std::max(80.0, spec.panel_width - left - panel_gap - legend),
                       axes_height,
                       {},
                       {},
                       out};
    writer.find_ranges();
    writer.write();
  }
  return out + "</svg>\n";
}

void write_svg_plot(const PlotSpec& spec, const std::filesystem::path& file) {
  write_whole_file(file, svg_plot(spec));
}

}  // namespace burnish
