#pragma once
// A metal and what lies on it, cell by cell: what operators of weathering work on.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/material/material.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Where a coat came from, which says what it does.
enum class CoatKind : std::uint8_t {
  product,  ///< grown on the metal by corrosion
  applied,  ///< paint, glaze: keeps the weather off the metal, can crack and peel
  loose,    ///< dust, stains: lies on top and lets everything through
};

/// One coat over the whole surface.
struct Coat {
  Layer layer;
  CoatKind kind = CoatKind::applied;
  Field<float> thickness;  ///< [slot] micrometres, >= 0
  Field<float> adhesion;   ///< [slot] 0..1 of a sound bond; empty: 1 everywhere
};

/// The state of a surface that weathers. Values of ghosts are those of their owners whenever an operator
/// begins; the values of other slots mean nothing.
struct CoatedMetal {
  Material metal;           ///< with its laws; its layers that grow are the first coats
  Field<float> loss;        ///< [slot] metal lost, micrometres
  Field<float> corroded;    ///< [slot] years that it has corroded; below 0: sound
  Field<float> damage;      ///< [slot] 0..1: cracks and scratches
  std::vector<Coat> coats;  ///< from the metal outwards

  bool gone(std::uint32_t slot) const { return loss[slot] >= static_cast<float>(metal.thickness); }
};

/// Bright metal with the coats its material starts with, such as paint. Throws InputError for projected
/// links.
CoatedMetal make_coated_metal(const Surface& surface, const Material& material);

/// Index of the uppermost coat of that name; of the uppermost applied one when `name` is empty. Throws
/// InputError, naming `owner`, when there is none.
std::size_t find_coat(const CoatedMetal& metal, std::string_view name, std::string_view owner);

/// Micrometres of applied coats over a cell.
float cover(const CoatedMetal& metal, std::uint32_t slot);

/// A cell counts as bare where its applied coats are thinner than this, micrometres.
inline constexpr float bare_below = 0.5f;

/// Takes up to `depth` micrometres off the coats of a cell, from the uppermost down to coat `lowest`; returns
/// how much they gave. Coats never go below 0.
float take_off(CoatedMetal& metal, std::uint32_t slot, float depth, std::size_t lowest = 0);

/// Gives ghosts the values of their owners in every field.
void show_ghosts(const Surface& surface, CoatedMetal& metal);

/// The whole in numbers; means over all owned cells.
struct CoatedNumbers {
  double bare = 0.0;                 ///< share of cells without applied coats
  double corroded = 0.0;             ///< share of cells
  double gone = 0.0;                 ///< share of cells
  double loss = 0.0, deepest = 0.0;  ///< micrometres of metal: mean, greatest
  double mass_loss = 0.0;            ///< g/m2
  double damaged = 0.0;              ///< share of cells with cracks or scratches
  std::vector<double> coats;         ///< [coat] mean micrometres
};
CoatedNumbers measure(const Surface& surface, const CoatedMetal& metal);

}  // namespace verdigris
