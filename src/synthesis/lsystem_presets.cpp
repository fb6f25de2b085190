#include <fmt/format.h>

#include <algorithm>

#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/lsystem.hpp"

namespace verdigris {

namespace {

// Sources: Lindenmayer 1968 (algae); ABOP 1.3 (curves), figures 1.24 (plants), 1.27 (stochastic plant), 1.25
// (bush) and 2.6 (Honda's trees); the ternary tree of Carleton's lecture on texture synthesis. The `*-vein`,
// `roots` and `cracks` systems are for surfaces.
constexpr LSystemPreset presets[] = {
    {"algae", "Lindenmayer's algae, A -> B, B -> AB: lengths are Fibonacci numbers",
     "iterations = 10\nangle = 0\ndraw = AB\naxiom = A\nA -> B\nB -> AB\n"},
    {"koch-curve", "von Koch's curve, dimension log 4 / log 3",
     "angle = 60\niterations = 5\nstep = 1\nwidth = 0.2\naxiom = F\nF -> F-F++F-F\n"},
    {"koch-snowflake", "three of von Koch's curves round a triangle",
     "angle = 60\niterations = 4\nwidth = 0.2\naxiom = F++F++F\nF -> F-F++F-F\n"},
    {"koch-island", "the quadratic Koch island",
     "angle = 90\niterations = 3\nwidth = 0.3\naxiom = F-F-F-F\nF -> F-F+F+FF-F-F+F\n"},
    {"sierpinski-arrowhead", "a curve that tends to the Sierpinski triangle",
     "angle = 60\niterations = 7\nwidth = 0.3\naxiom = G\nF -> G+F+G\nG -> F-G-F\n"},
    {"dragon", "the dragon of folded paper",
     "angle = 90\niterations = 11\nwidth = 0.3\naxiom = FX\nX -> X+YF+\nY -> -FX-Y\n"},
    {"hilbert", "Hilbert's curve, which fills a square",
     "angle = 90\niterations = 5\nwidth = 0.3\naxiom = L\nL -> +RF-LFL-FR+\nR -> -LF+RFR+FL-\n"},
    {"hilbert-3d", "Hilbert's curve, which fills a cube",
     "angle = 90\niterations = 3\nwidth = 0.3\naxiom = A\n"
     "A -> B-F+CFC+F-D&F^D-F+&&CFC+F+B//\n"
     "B -> A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//\n"
     "C -> |D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//\n"
     "D -> |CFB-F+B|FA&F^A&&FB-F+B|FC//\n"},
    {"gosper", "the flowsnake, which fills a hexagonal tile",
     "angle = 60\niterations = 4\nwidth = 0.3\naxiom = F\n"
     "F -> F+G++G-F--FF-G+\nG -> -F+GG++G+F--F-G\n"},
    {"branching", "the lecture's branching: an apex sprouts two apices while stems elongate",
     "angle = 30\niterations = 6\nwidth = 0.6\naxiom = A\nA -> F[!+A][!-A]FA\nF -> FF\n"},
    {"plant-edge", "a plant rewritten edge by edge (ABOP 1.24 b)",
     "angle = 20\niterations = 5\nwidth = 0.3\naxiom = F\nF -> F[+F]F[-F][F]\n"},
    {"plant", "a plant whose stems elongate (ABOP 1.24 f)",
     "angle = 22.5\niterations = 5\nwidth = 0.4\ntaper = 0.8\naxiom = X\n"
     "X -> F-[![X]+X]+F[!+FX]-X\nF -> FF\n"},
    {"weed", "a plant with opposite twigs (ABOP 1.24 d)",
     "angle = 20\niterations = 7\nwidth = 0.6\ntaper = 0.75\naxiom = X\nX -> F[!+X]F[!-X]+X\nF -> FF\n"},
    {"stochastic-plant", "a plant of three rules drawn at random (ABOP 1.27)",
     "angle = 25\niterations = 5\nwidth = 0.3\naxiom = F\n"
     "F @ 0.33 -> F[+F]F[-F]F\nF @ 0.33 -> F[+F]F\nF @ 0.34 -> F[-F]F\n"},
    {"ternary-tree", "the lecture's tree, three branches on each tip",
     "angle = 30\niterations = 5\nwidth = 0.25\naxiom = F\nlet third = 120\n"
     "F -> F[!&F][!/(third)&F][!\\(third)&F]\n"},
    {"bush", "a bush of leafy branches without leaves (after ABOP 1.25)",
     "angle = 22.5\niterations = 6\nwidth = 0.8\ntaper = 0.75\naxiom = A\n"
     "A -> [&F!A]/////[&F!A]///////[&F!A]\nF -> S/////F\nS -> F\n"},
    {"honda-tree", "a tree of lengths and widths (ABOP 2.6, after Honda)",
     "iterations = 9\nstep = 1\nwidth = 1\n"
     "let r = 0.9\nlet s = 0.7\nlet w = 0.707\nlet a = 45\nlet d = 137.5\n"
     "axiom = A(10, 1)\n"
     "A(l, v) -> !(v)F(l)[&(a)B(l * s, v * w)]/(d)A(l * r, v * w)\n"
     "B(l, v) -> !(v)F(l)[-(a)C(l * s, v * w)]C(l * r, v * w)\n"
     "C(l, v) -> !(v)F(l)[+(a)B(l * s, v * w)]B(l * r, v * w)\n"},
    {"veins", "leaf veins of the second and third order, for surfaces",
     "iterations = 11\nwidth = 0.8\nstep = 1\nlet a = 48\nlet r = 0.62\naxiom = A(7, 1)\n"
     "A(l, w) if l > 0.4 -> !(w)F(1)[+(a)!(w * r)B(l * r, w * r)]F(1)[-(a)!(w * r)B(l * r, w * r)]"
     "A(l * 0.93, w * 0.93)\n"
     "B(l, w) if l > 0.4 -> !(w)F(l * 0.25)[+(40)B(l * 0.55, w * r)]F(l * 0.25)[-(40)B(l * 0.55, w * r)]"
     "F(l * 0.4)B(l * 0.5, w * 0.8)\n"},
    {"roots", "roots that wander, fork and thin out, for surfaces",
     "iterations = 16\nangle = 14\nwidth = 0.7\ntaper = 0.72\naxiom = [A][+(120)A][-(120)A]\n"
     "A @ 4 -> F+A\nA @ 4 -> F-A\nA @ 3 -> F[!+(35)A]-A\nA @ 3 -> F[!-(35)A]+A\nA @ 1 -> F!A\n"},
    {"cracks", "cracks that run nearly straight and branch at wide angles, for surfaces",
     "iterations = 26\nangle = 9\nwidth = 0.25\ntaper = 0.8\naxiom = [A]|A\n"
     "A @ 6 -> F+A\nA @ 6 -> F-A\nA @ 5 -> FA\nA @ 1 -> F[!+(70)A]A\nA @ 1 -> F[!-(70)A]A\n"},
};

}  // namespace

std::span<const LSystemPreset> lsystem_presets() {
  return presets;
}

LSystem named_lsystem(std::string_view name) {
  std::string names;
  for (const LSystemPreset& preset : presets) {
    if (preset.name == name) return parse_lsystem(preset.text, preset.name);
    if (!names.empty()) names += ", ";
    names += preset.name;
  }
  throw InputError("L-system", fmt::format("there is none named '{}'", name), "choose one of: " + names);
}

bool leaves_plane(const Word& word) {
  return word.symbols.find_first_of("&^\\/") != std::string::npos;
}

}  // namespace verdigris
