#include "verdigris/picture/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "canvas.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

constexpr Rgba8 paper{255, 255, 255, 255}, ink{38, 40, 44, 255}, pale{226, 228, 230, 255},
    grey{110, 114, 120, 255};
// Copper, verdigris, and what can be told from them in grey and with colour-blind eyes.
constexpr std::array<Rgba8, 6> curve_colours{{{178, 84, 38, 255},
                                              {22, 128, 112, 255},
                                              {52, 88, 160, 255},
                                              {214, 160, 40, 255},
                                              {120, 60, 120, 255},
                                              {90, 94, 100, 255}}};

// One axis: values to 0..1.
struct Axis {
  double low, high;
  bool logarithmic;
  std::vector<double> ticks;

  bool shows(double v) const { return std::isfinite(v) && (!logarithmic || v > 0.0); }
  double operator()(double v) const {
    return logarithmic ? (std::log(v) - std::log(low)) / (std::log(high) - std::log(low))
                       : (v - low) / (high - low);
  }
};

Axis make_axis(const Plot& plot, int k, double low, double high, bool logarithmic, int count) {
  const bool given_low = std::isfinite(low), given_high = std::isfinite(high);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const PlotCurve& curve : plot.curves)
    for (const glm::dvec2& p : curve.points) {
      if (!std::isfinite(p[k]) || (logarithmic && !(p[k] > 0.0))) continue;
      least = std::min(least, p[k]);
      most = std::max(most, p[k]);
    }
  if (!(least <= most)) least = logarithmic ? 1.0 : 0.0, most = logarithmic ? 10.0 : 1.0;
  if (given_low) least = low;
  if (given_high) most = high;
  Axis axis{least, most, logarithmic, {}};
  if (logarithmic) {
    if (!given_low) axis.low = std::pow(10.0, std::floor(std::log10(least) + 1e-9));
    if (!given_high) axis.high = std::pow(10.0, std::ceil(std::log10(most) - 1e-9));
    if (!(axis.low < axis.high)) axis.high = axis.low * 10.0;
    for (double t = std::pow(10.0, std::ceil(std::log10(axis.low) - 1e-9)); t <= axis.high * 1.0001;
         t *= 10.0)
      axis.ticks.push_back(t);
    return axis;
  }
  // Whatever is near zero begins there.
  if (!given_low && axis.low > 0.0 && axis.low < 0.35 * axis.high) axis.low = 0.0;
  if (!(axis.low < axis.high)) axis.high = axis.low + std::max(1.0, std::abs(axis.low));
  axis.ticks = round_ticks(axis.low, axis.high, count);
  if (axis.ticks.size() < 2) return axis;
  const double step = axis.ticks[1] - axis.ticks[0];
  if (!given_low) axis.low = std::floor(axis.low / step + 1e-9) * step;
  if (!given_high && k == 1) axis.high = std::ceil(axis.high / step - 1e-9) * step;
  axis.ticks = round_ticks(axis.low, axis.high, count);
  return axis;
}

class PlotPainter {
 public:
  PlotPainter(const Plot& plot, int width, int height)
      : plot_(plot),
        canvas_(width, height, paper),
        unit_(height / 800.0),
        x_(make_axis(plot, 0, plot.x_low, plot.x_high, plot.log_x,
                     std::max(3, width * 7 / std::max(height, 1) / 2 + 3))),
        y_(make_axis(plot, 1, plot.y_low, plot.y_high, plot.log_y, 6)) {
    double widest = 0.0;
    for (const double tick : y_.ticks) widest = std::max(widest, text_width(tick_text(tick), tick_size()));
    left_ = 34 * unit_ + widest + (plot.y_label.empty() ? 0.0 : 46 * unit_);
    const double last = x_.ticks.empty() ? 0.0 : text_width(tick_text(x_.ticks.back()), tick_size());
    right_ = width - std::max(34 * unit_, 0.5 * last + 12 * unit_);
    top_ = (plot.title.empty() ? 42 : 100) * unit_;
    bottom_ = height - (plot.x_label.empty() ? 58 : 98) * unit_;
  }

  Image paint() {
    frame();
    marks();
    curves();
    legend();
    return canvas_.image();
  }

 private:
  double tick_size() const { return 15.5 * unit_; }
  double label_size() const { return 17.5 * unit_; }
  glm::dvec2 at(glm::dvec2 p) const {
    return {left_ + x_(p.x) * (right_ - left_), bottom_ - y_(p.y) * (bottom_ - top_)};
  }
  void line(glm::dvec2 a, glm::dvec2 b, double width, Rgba8 colour) {
    const std::array<glm::dvec2, 2> both{a, b};
    canvas_.stroke(both, width, colour);
  }

  void frame() {
    for (const double tick : y_.ticks) {
      const double y = bottom_ - y_(tick) * (bottom_ - top_);
      line({left_, y}, {right_, y}, 1.2 * unit_, pale);
      canvas_.text({left_ - 12 * unit_, y + 0.5 * tick_size()}, tick_text(tick), tick_size(), ink, 1.0);
    }
    for (const double tick : x_.ticks) {
      const double x = left_ + x_(tick) * (right_ - left_);
      line({x, bottom_}, {x, bottom_ + 7 * unit_}, 1.6 * unit_, ink);
      if (x_.logarithmic) line({x, top_}, {x, bottom_}, 1.2 * unit_, pale);
      canvas_.text({x, bottom_ + 16 * unit_ + tick_size()}, tick_text(tick), tick_size(), ink, 0.5);
    }
    line({left_, bottom_}, {right_, bottom_}, 1.8 * unit_, ink);
    canvas_.text({left_, 50 * unit_}, plot_.title, 21 * unit_, ink, 0.0, false, 0.135);
    canvas_.text({0.5 * (left_ + right_), bottom_ + 78 * unit_}, plot_.x_label, label_size(), ink, 0.5);
    canvas_.text({36 * unit_, 0.5 * (top_ + bottom_)}, plot_.y_label, label_size(), ink, 0.5, true);
  }

  void marks() {
    for (const PlotMark& mark : plot_.marks) {
      if (!x_.shows(mark.x) || mark.x < x_.low || mark.x > x_.high) continue;
      const double x = left_ + x_(mark.x) * (right_ - left_);
      const std::array<glm::dvec2, 2> both{glm::dvec2(x, top_), glm::dvec2(x, bottom_)};
      canvas_.dashed(both, 1.4 * unit_, 5 * unit_, grey);
      // Above the frame, to the side where there is room.
      const bool leftwards = x + text_width(mark.name, tick_size()) + 10 * unit_ > right_;
      canvas_.text({x + (leftwards ? 4 : -4) * unit_, top_ - 8 * unit_}, mark.name, tick_size(), grey,
                   leftwards ? 1.0 : 0.0);
    }
  }

  Rgba8 colour_of(std::size_t k) const {
    const Rgba8 own = plot_.curves[k].colour;
    return own.a != 0 ? own : curve_colours[k % curve_colours.size()];
  }

  void draw_run(const std::vector<glm::dvec2>& run, PlotCurve::Style style, Rgba8 colour) {
    if (style == PlotCurve::Style::dots)
      for (const glm::dvec2& p : run) canvas_.dot(p, 4.2 * unit_, colour);
    else if (style == PlotCurve::Style::dashed)
      canvas_.dashed(run, 3.0 * unit_, 9 * unit_, colour);
    else
      canvas_.stroke(run, 3.2 * unit_, colour);
  }

  void curves() {
    for (std::size_t k = 0; k < plot_.curves.size(); ++k) {
      const PlotCurve& curve = plot_.curves[k];
      std::vector<glm::dvec2> run;
      const auto flush = [&] {
        draw_run(run, curve.style, colour_of(k));
        run.clear();
      };
      for (const glm::dvec2& p : curve.points) {
        const bool inside = x_.shows(p.x) && y_.shows(p.y) && p.x >= x_.low && p.x <= x_.high &&
                            p.y >= y_.low && p.y <= y_.high;
        if (!inside) {
          flush();
          continue;
        }
        const glm::dvec2 q = at(p);
        drawn_.push_back(q);
        // Many points a pixel: what cannot be seen is left out.
        if (curve.style != PlotCurve::Style::dots && !run.empty() && std::abs(q.x - run.back().x) < 0.25 &&
            std::abs(q.y - run.back().y) < 0.25)
          continue;
        run.push_back(q);
      }
      flush();
    }
  }

  // In the corner that the curves leave freest.
  void legend() {
    double widest = 0.0;
    std::size_t named = 0;
    for (const PlotCurve& curve : plot_.curves)
      if (!curve.name.empty()) {
        widest = std::max(widest, text_width(curve.name, tick_size()));
        ++named;
      }
    if (named == 0) return;
    const double line_height = 30 * unit_, width = widest + 70 * unit_,
                 height = static_cast<double>(named) * line_height + 14 * unit_;
    const double gap = 14 * unit_, upper = top_ + gap;
    const std::array<glm::dvec2, 4> corners{
        glm::dvec2(right_ - gap - width, bottom_ - gap - height), glm::dvec2(left_ + gap, upper),
        glm::dvec2(right_ - gap - width, upper), glm::dvec2(left_ + gap, bottom_ - gap - height)};
    const auto crowd = [&](glm::dvec2 c) {
      return std::count_if(drawn_.begin(), drawn_.end(), [&](glm::dvec2 p) {
        return p.x > c.x - gap && p.x < c.x + width + gap && p.y > c.y - gap && p.y < c.y + height + gap;
      });
    };
    glm::dvec2 corner = corners[0];
    for (const glm::dvec2& c : corners)
      if (crowd(c) < crowd(corner)) corner = c;
    canvas_.fill(corner, corner + glm::dvec2(width, height), {255, 255, 255, 225});
    double y = corner.y + 7 * unit_ + 0.5 * line_height;
    for (std::size_t k = 0; k < plot_.curves.size(); ++k) {
      const PlotCurve& curve = plot_.curves[k];
      if (curve.name.empty()) continue;
      const glm::dvec2 from(corner.x + 10 * unit_, y), to(corner.x + 46 * unit_, y);
      if (curve.style == PlotCurve::Style::dots)
        draw_run({0.5 * (from + to)}, curve.style, colour_of(k));
      else
        draw_run({from, to}, curve.style, colour_of(k));
      canvas_.text({corner.x + 58 * unit_, y + 0.5 * tick_size()}, curve.name, tick_size(), ink);
      y += line_height;
    }
  }

  const Plot& plot_;
  Canvas canvas_;
  double unit_;
  Axis x_, y_;
  double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0;
  std::vector<glm::dvec2> drawn_;
};

}  // namespace

std::vector<double> round_ticks(double low, double high, int count) {
  std::vector<double> ticks;
  if (!(low < high) || !std::isfinite(high - low) || count < 1) return ticks;
  const double raw = (high - low) / count, power = std::pow(10.0, std::floor(std::log10(raw)));
  const double ratio = raw / power;
  const double step = power * (ratio < 1.5 ? 1.0 : ratio < 3.5 ? 2.0 : ratio < 7.5 ? 5.0 : 10.0);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0)
    ticks.push_back(k == 0.0 ? 0.0 : k * step);
  return ticks;
}

std::string tick_text(double value) {
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size >= 1e6 || size < 1e-3) {
    const int power = static_cast<int>(std::floor(std::log10(size) + 1e-9));
    return fmt::format("{:.3g}e{}", value / std::pow(10.0, power), power);
  }
  return fmt::format("{:.6g}", value);
}

Image draw_plot(const Plot& plot, int width, int height) {
  if (width < 160 || height < 120 || width > 16384 || height > 16384)
    throw InputError("plot size", fmt::format("{} x {} pixels cannot hold a plot", width, height),
                     "give between 160 x 120 and 16384 x 16384");
  return PlotPainter(plot, width, height).paint();
}

}  // namespace verdigris
