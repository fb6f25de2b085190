#include "stroke_font.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

namespace verdigris {

namespace {

// M x y: pen to; L x y: line to; A cx cy rx ry from to: arc of an ellipse, degrees, counter-clockwise if they
// rise, joined to the line before it if there is one (after M or A with no M between).
struct Drawn {
  std::uint32_t character;
  double advance;
  const char* pen;
};

constexpr Drawn drawn[] = {
    {' ', 260, ""},
    {'0', 530, "A 265 350 195 350 90 450"},
    {'1', 530, "M 110 570 L 290 700 L 290 0"},
    {'2', 530, "A 265 500 190 200 165 -38 L 75 0 L 465 0"},
    {'3', 530, "A 255 525 180 175 150 -90 A 255 175 205 175 90 -150"},
    {'4', 530, "M 360 0 L 360 700 L 60 210 L 475 210"},
    {'5', 530, "M 425 700 L 130 700 L 105 390 A 250 228 210 228 134 -150"},
    {'6', 530, "A 405 215 340 480 93 180 A 265 215 200 215 180 540"},
    {'7', 530, "M 70 700 L 465 700 L 200 0"},
    {'8', 530, "A 265 530 170 170 90 450 M 265 360 A 265 180 205 180 90 450"},
    {'9', 530, "A 265 485 200 215 0 360 A 125 485 340 480 0 -87"},
    {'a', 550, "A 265 250 195 250 0 360 M 460 500 L 460 0"},
    {'b', 550, "M 85 700 L 85 0 M 85 250 A 280 250 195 250 180 540"},
    {'c', 480, "A 270 250 200 250 48 312"},
    {'d', 550, "A 265 250 195 250 0 360 M 460 700 L 460 0"},
    {'e', 520, "M 68 262 L 462 262 A 265 250 198 250 3 312"},
    {'f', 310, "A 290 560 135 140 70 180 L 155 0 M 40 480 L 275 480"},
    {'g', 550, "A 265 250 195 250 0 360 M 460 500 L 460 -20 A 270 -20 190 180 0 -150"},
    {'h', 510, "M 85 700 L 85 0 M 85 290 A 258 290 173 210 180 0 L 431 0"},
    {'i', 180, "M 90 500 L 90 0 M 90 670 L 90 676"},
    {'j', 190, "M 105 500 L 105 -60 A 5 -60 100 140 0 -80 M 105 670 L 105 676"},
    {'k', 460, "M 85 700 L 85 0 M 400 500 L 85 190 M 195 298 L 425 0"},
    {'l', 180, "M 90 700 L 90 0"},
    {'m', 770,
     "M 85 500 L 85 0 M 85 320 A 236 320 151 180 180 0 L 387 0 M 387 320 A 538 320 151 180 180 0 L 689 0"},
    {'n', 510, "M 85 500 L 85 0 M 85 290 A 258 290 173 210 180 0 L 431 0"},
    {'o', 540, "A 270 250 203 250 0 360"},
    {'p', 550, "M 85 500 L 85 -200 M 85 250 A 280 250 195 250 180 540"},
    {'q', 550, "A 265 250 195 250 0 360 M 460 500 L 460 -200"},
    {'r', 340, "M 85 500 L 85 0 M 85 270 A 265 270 180 228 180 72"},
    {'s', 440, "A 222 377 145 123 42 270 A 222 127 165 127 90 -142"},
    {'t', 340, "M 150 660 L 150 130 A 262 130 112 130 180 292 M 40 480 L 295 480"},
    {'u', 510, "M 79 500 L 79 210 A 252 210 173 210 180 360 L 425 500 M 425 500 L 425 0"},
    {'v', 460, "M 45 500 L 230 0 L 415 500"},
    {'w', 690, "M 45 500 L 195 0 L 345 490 L 495 0 L 645 500"},
    {'x', 450, "M 55 500 L 395 0 M 395 500 L 55 0"},
    {'y', 460, "M 45 500 L 230 0 M 415 500 L 230 0 L 165 -150 A 80 -95 100 105 -33 -95"},
    {'z', 440, "M 65 500 L 380 500 L 60 0 L 390 0"},
    {'A', 600, "M 40 0 L 300 700 L 560 0 M 122 225 L 478 225"},
    {'B', 560,
     "M 90 0 L 90 700 L 280 700 A 280 530 172 170 90 -90 L 90 360 M 280 360 A 290 180 200 180 90 -90 L 90 0"},
    {'C', 620, "A 360 350 290 350 48 312"},
    {'D', 630, "M 90 0 L 90 700 L 250 700 A 250 350 310 350 90 -90 L 90 0"},
    {'E', 510, "M 450 700 L 90 700 L 90 0 L 455 0 M 90 365 L 405 365"},
    {'F', 480, "M 440 700 L 90 700 L 90 0 M 90 355 L 395 355"},
    {'G', 690, "A 360 350 290 350 48 350 L 650 330 L 400 330"},
    {'H', 620, "M 90 0 L 90 700 M 530 0 L 530 700 M 90 360 L 530 360"},
    {'I', 200, "M 100 0 L 100 700"},
    {'J', 430, "M 340 700 L 340 180 A 195 180 145 180 0 -160"},
    {'K', 570, "M 90 0 L 90 700 M 505 700 L 90 265 M 225 405 L 530 0"},
    {'L', 470, "M 90 700 L 90 0 L 430 0"},
    {'M', 720, "M 90 0 L 90 700 L 360 160 L 630 700 L 630 0"},
    {'N', 620, "M 90 0 L 90 700 L 530 0 L 530 700"},
    {'O', 740, "A 370 350 300 350 0 360"},
    {'P', 530, "M 90 0 L 90 700 L 285 700 A 285 510 190 190 90 -90 L 90 320"},
    {'Q', 740, "A 370 350 300 350 0 360 M 450 170 L 655 -45"},
    {'R', 560, "M 90 0 L 90 700 L 285 700 A 285 510 190 190 90 -90 L 90 320 M 300 320 L 505 0"},
    {'S', 550, "A 275 530 185 170 42 270 A 275 180 210 180 90 -148"},
    {'T', 540, "M 35 700 L 505 700 M 270 700 L 270 0"},
    {'U', 610, "M 85 700 L 85 230 A 305 230 220 230 180 360 L 525 700"},
    {'V', 580, "M 40 700 L 290 0 L 540 700"},
    {'W', 840, "M 40 700 L 230 0 L 420 690 L 610 0 L 800 700"},
    {'X', 560, "M 60 700 L 500 0 M 500 700 L 60 0"},
    {'Y', 560, "M 40 700 L 280 330 L 520 700 M 280 330 L 280 0"},
    {'Z', 540, "M 65 700 L 475 700 L 55 0 L 485 0"},
    {'.', 200, "M 100 5 L 100 12"},
    {',', 200, "M 105 15 L 70 -110"},
    {':', 200, "M 100 5 L 100 12 M 100 420 L 100 427"},
    {';', 200, "M 105 15 L 70 -110 M 105 420 L 105 427"},
    {'-', 340, "M 60 270 L 280 270"},
    {'+', 540, "M 75 310 L 465 310 M 270 505 L 270 115"},
    {'=', 540, "M 75 390 L 465 390 M 75 230 L 465 230"},
    {'<', 540, "M 455 520 L 85 310 L 455 100"},
    {'>', 540, "M 85 520 L 455 310 L 85 100"},
    {'(', 290, "A 430 290 330 560 130 230"},
    {')', 290, "A -140 290 330 560 50 -50"},
    {'[', 280, "M 240 780 L 100 780 L 100 -120 L 240 -120"},
    {']', 280, "M 40 780 L 180 780 L 180 -120 L 40 -120"},
    {'/', 400, "M 40 -80 L 360 780"},
    {'%', 780, "A 205 530 130 165 0 360 M 575 170 A 575 170 130 165 90 450 M 600 700 L 180 0"},
    {'*', 380, "M 190 700 L 190 400 M 60 625 L 320 475 M 320 625 L 60 475"},
    {'\'', 170, "M 85 700 L 85 540"},
    {'"', 290, "M 90 700 L 90 540 M 200 700 L 200 540"},
    {'!', 200, "M 100 700 L 100 210 M 100 5 L 100 12"},
    {'?', 440, "A 215 535 150 165 165 -60 L 215 300 L 215 200 M 215 5 L 215 12"},
    {'_', 500, "M 30 -100 L 470 -100"},
    {'&', 660, "M 610 0 L 170 500 A 265 560 115 140 210 -30 L 150 320 A 250 180 190 180 130 340 L 590 380"},
    {'~', 540, "A 180 280 95 70 180 20 A 355 330 95 70 200 360"},
    {0xB0, 330, "A 165 580 95 110 0 360"},                            // degree
    {0xB2, 340, "A 165 610 105 90 165 -35 L 60 400 L 280 400"},       // squared
    {0xB3, 340, "A 155 625 95 75 150 -90 A 155 475 108 75 90 -150"},  // cubed
    {0xB5, 510,
     "M 79 500 L 79 -200 M 79 210 A 252 210 173 210 180 360 L 425 500 M 425 500 L 425 0"},  // micro
    {0xB7, 240, "M 120 300 L 120 306"},                                                     // middle dot
    {0xD7, 500, "M 90 470 L 410 150 M 410 470 L 90 150"},                                   // times
    {0xE9, 520, "M 68 262 L 462 262 A 265 250 198 250 3 312 M 230 610 L 340 740"},          // e acute
    {0x2013, 540, "M 50 270 L 490 270"},                                                    // dash
    {0x2212, 540, "M 75 310 L 465 310"},                                                    // minus
};

Glyph made(double advance, const char* pen) {
  Glyph glyph{advance, {}};
  const char* const end = pen + std::string_view(pen).size();
  const auto number = [&] {
    while (*pen == ' ') ++pen;
    double value = 0.0;
    pen = std::from_chars(pen, end, value).ptr;
    return value;
  };
  bool down = false;
  while (pen != end) {
    const char command = *pen++;
    if (command == ' ') continue;
    if (command != 'A') {
      const double x = number(), y = number();
      if (command == 'M' || !down) glyph.lines.emplace_back();
      glyph.lines.back().emplace_back(x, y);
      down = true;
      continue;
    }
    const double cx = number(), cy = number(), rx = number(), ry = number(), from = number(), to = number();
    if (!down) glyph.lines.emplace_back();
    down = true;
    const int steps = static_cast<int>(std::ceil(std::abs(to - from) / 9.0));
    for (int k = 0; k <= steps; ++k) {
      const double angle = (from + (to - from) * k / steps) * std::numbers::pi / 180.0;
      glyph.lines.back().emplace_back(cx + rx * std::cos(angle), cy + ry * std::sin(angle));
    }
  }
  return glyph;
}

}  // namespace

const Glyph& glyph_of(std::uint32_t character) {
  static const std::map<std::uint32_t, Glyph> glyphs = [] {
    std::map<std::uint32_t, Glyph> all;
    for (const Drawn& d : drawn) all.emplace(d.character, made(d.advance, d.pen));
    return all;
  }();
  static const Glyph box = made(530, "M 90 0 L 440 0 L 440 700 L 90 700 L 90 0");
  const auto found = glyphs.find(character);
  return found == glyphs.end() ? box : found->second;
}

std::uint32_t next_character(std::string_view& utf8) {
  const auto byte = [&](std::size_t k) { return static_cast<std::uint8_t>(utf8[k]); };
  const std::uint32_t first = byte(0);
  const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  std::uint32_t character = more == 0 ? first : first & (0x3Fu >> more);
  bool good = more < utf8.size();
  for (std::size_t k = 1; good && k <= more; ++k) {
    good = (byte(k) & 0xC0u) == 0x80u;
    character = character << 6 | (byte(k) & 0x3Fu);
  }
  utf8.remove_prefix(good ? more + 1 : 1);
  return good ? character : first;
}

}  // namespace verdigris
