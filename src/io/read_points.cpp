#include "verdigris/io/read_points.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "faults.hpp"
#include "file_bytes.hpp"
#include "text_cursor.hpp"
#include "text_numbers.hpp"

namespace verdigris {

namespace {

// Visits each line that holds something: the numbers on it, and where it begins.
template <typename Visit>
void visit_lines(const std::filesystem::path& file, std::size_t least, std::size_t most, const char* form,
                 Visit&& visit) {
  io::FileBytes bytes = io::read_file(file);
  io::prepare_text(bytes, file);
  std::replace(bytes.data(), bytes.data() + bytes.size(), ',', ' ');
  io::Faults faults(file, bytes.view(), true);
  io::TextCursor cursor(bytes.view());
  std::vector<double> numbers;
  bool any = false;
  while (!cursor.at_end()) {
    numbers.clear();
    std::size_t begin = cursor.offset();
    for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
      if (numbers.empty()) begin = cursor.word_offset();
      numbers.push_back(io::number_at(word, cursor.word_offset(), faults, "number"));
    }
    if (!numbers.empty()) {
      if (numbers.size() < least || numbers.size() > most)
        faults.add(begin, fmt::format("{} numbers on the line", numbers.size()), form);
      else
        visit(numbers, begin, faults);
      any = true;
    }
    cursor.next_line();
  }
  faults.check();
  if (!any) throw InputError(io::shown(file), "there is nothing in it but blanks and comments", form);
}

}  // namespace

std::vector<WeightedPoint> read_points(const std::filesystem::path& file) {
  std::vector<WeightedPoint> points;
  visit_lines(file, 3, 4, "write `x y z` or `x y z weight` on each line, in model units",
              [&](const std::vector<double>& n, std::size_t at, io::Faults& faults) {
                const double weight = n.size() == 4 ? n[3] : 1.0;
                if (!(weight > 0.0))
                  faults.add(at, fmt::format("weight {} is not positive", weight),
                             "give weights greater than 0");
                points.push_back({{n[0], n[1], n[2]}, weight});
              });
  return points;
}

std::vector<double> read_numbers(const std::filesystem::path& file) {
  std::vector<double> numbers;
  visit_lines(file, 1, 1, "write one number on each line",
              [&](const std::vector<double>& n, std::size_t, io::Faults&) { numbers.push_back(n[0]); });
  return numbers;
}

}  // namespace verdigris
