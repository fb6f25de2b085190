#pragma once
// Curves as pictures: axes with round numbers, labels and a legend; needs no font and no OpenGL.

#include <glm/vec2.hpp>
#include <limits>
#include <string>
#include <vector>

#include "verdigris/picture/colour.hpp"
#include "verdigris/picture/image.hpp"

namespace verdigris {

/// One curve, in the units of the axes. Points that are not finite break it.
struct PlotCurve {
  std::string name;  ///< in the legend; empty: not there
  std::vector<glm::dvec2> points;
  Rgba8 colour{0, 0, 0, 0};  ///< alpha 0: the next of the plot's own
  enum class Style { line, dashed, dots } style = Style::line;
};

/// A point of the x axis that is worth a word.
struct PlotMark {
  double x;
  std::string name;
};

/// A plot. Ranges that are not given (not a number) follow from the points.
struct Plot {
  std::string title, x_label, y_label;  ///< UTF-8: letters, digits, signs, and µ ² ³ ° ×
  std::vector<PlotCurve> curves;
  std::vector<PlotMark> marks;
  bool log_x = false, log_y = false;  ///< what is not positive is left out
  double x_low = std::numeric_limits<double>::quiet_NaN(), x_high = x_low, y_low = x_low, y_high = x_low;
};

/// Draws it. Text and lines scale with the height of the picture. The same plot gives the same bits. Throws
/// InputError for a picture smaller than 160 x 120 or larger than 16384.
Image draw_plot(const Plot& plot, int width = 1280, int height = 800);

/// Round numbers from `low` to `high`, about `count` of them: steps of 1, 2 or 5 times a power of ten.
std::vector<double> round_ticks(double low, double high, int count);

/// A tick's number as it is written: 0.25, 1500, 2.5e6.
std::string tick_text(double value);

}  // namespace verdigris
