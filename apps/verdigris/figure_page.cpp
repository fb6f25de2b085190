#include "figure_page.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "verdigris/io/replace_file.hpp"
#include "verdigris/io/write_png.hpp"

using namespace verdigris;

namespace {

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t word = 0;
    for (std::size_t n = 0; n < 3; ++n)
      word = word << 8 | (k + n < bytes.size() ? static_cast<std::uint8_t>(bytes[k + n]) : 0u);
    for (std::size_t n = 0; n < 4; ++n)
      text += k + n > bytes.size() ? '=' : digits[word >> (18 - 6 * n) & 63u];
  }
  return text;
}

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<title>Figures of Gobron &amp; Chiba 1999, again</title>
<style>
body { font: 16px/1.5 system-ui, sans-serif; color: #26282c; background: #fff; max-width: 1180px; margin: 3em auto; padding: 0 1.5em; }
h1 { font-size: 1.9em; line-height: 1.2; } h2 { margin-top: 2.6em; border-top: 1px solid #d8dadc; padding-top: 1em; }
p { max-width: 46em; }
.panels { display: grid; gap: 14px; margin: 1em 0; } figure { margin: 0; } figcaption { font-size: .9em; color: #5a5e64; }
.picture { position: relative; line-height: 0; } .picture img { width: 100%; } .picture svg { position: absolute; inset: 0; width: 100%; height: 100%; }
table { border-collapse: collapse; margin: 1em 0; } td, th { text-align: left; vertical-align: top; padding: .35em 1.2em .35em 0; border-bottom: 1px solid #e2e4e6; }
</style></head><body>
)";

}  // namespace

void Overlay::line(glm::dvec2 from, glm::dvec2 to, const std::string& colour, double width) {
  svg += fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"/>",
      from.x, from.y, to.x, to.y, colour, width);
}

void Overlay::circle(glm::dvec2 centre, double radius, const std::string& colour, double width) {
  svg += fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>",
      centre.x, centre.y, radius, colour, width);
}

void FigurePage::section(const std::string& title, const std::string& text) {
  body_ += fmt::format("<h2>{}</h2>\n<p>{}</p>\n", title, text);
}

void FigurePage::figure(const std::string& name, const std::vector<Panel>& panels, int columns) {
  body_ += fmt::format("<div class=\"panels\" style=\"grid-template-columns: repeat({}, 1fr)\">\n", columns);
  char letter = 'a';
  for (const Panel& panel : panels) {
    const std::string file = panels.size() > 1 ? fmt::format("{}{}.png", name, letter++) : name + ".png";
    write_png(panel.image, folder_ / file);
    std::ifstream in(folder_ / file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    body_ += fmt::format("<figure><div class=\"picture\"><img alt=\"{}\" src=\"data:image/png;base64,{}\">",
                         name, base64(bytes));
    if (!panel.overlay.svg.empty())
      body_ += fmt::format("<svg viewBox=\"0 0 {} {}\">{}</svg>", panel.image.width, panel.image.height,
                           panel.overlay.svg);
    body_ += fmt::format("</div><figcaption>{}</figcaption></figure>\n", panel.caption);
  }
  body_ += "</div>\n";
}

void FigurePage::table(const std::vector<Compared>& rows) {
  body_ += "<table><tr><th></th><th>paper, 1999</th><th>here</th><th></th></tr>\n";
  for (const Compared& row : rows)
    body_ += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", row.what, row.paper,
                         row.ours, row.remark);
  body_ += "</table>\n";
}

void FigurePage::write() const {
  ReplaceFile file(folder_ / "index.html");
  file.write(head);
  file.write(body_);
  file.write("</body></html>\n");
  file.commit();
}
