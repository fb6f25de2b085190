#pragma once
// One page of pictures, plots and words that needs no other file.

#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "verdigris/picture/image.hpp"

/// Lines over a picture, in its pixels.
struct Overlay {
  std::string svg;

  void line(glm::dvec2 from, glm::dvec2 to, const std::string& colour, double width);
  void circle(glm::dvec2 centre, double radius, const std::string& colour, double width);
};

/// A picture of a figure, with the letter and words below it.
struct Panel {
  std::string caption;
  verdigris::Image image;
  Overlay overlay = {};
};

/// The paper's number beside ours.
struct Compared {
  std::string what, paper, ours, remark;
};

/// The page. Texts are HTML. Each picture is also written as a PNG beside it.
class FigurePage {
 public:
  explicit FigurePage(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void section(const std::string& title, const std::string& text);
  void figure(const std::string& name, const std::vector<Panel>& panels, int columns);
  void table(const std::vector<Compared>& rows);
  /// Writes index.html. Throws InputError.
  void write() const;

 private:
  std::filesystem::path folder_;
  std::string body_;
};
