#pragma once
// A material: a metal and the layers that lie or grow on it (the n layers that Gobron & Chiba 1999 ask for as
// future work).

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "verdigris/material/growth_law.hpp"

namespace verdigris {

/// What light meets.
struct Finish {
  glm::vec3 colour{0.5f};   ///< sRGB, 0..1
  float roughness = 0.5f;   ///< 0 mirror .. 1 matt, as in glTF
  float metallic = 0.0f;    ///< 0..1, as in glTF
  float specular = 0.1f;    ///< Ks of the paper's light model, 0..1
  float shininess = 10.0f;  ///< n of the same
};

/// A layer. Light in it falls off as exp(-x / (1 - opacity)), x its thickness in units of `unit`.
struct Layer {
  std::string name;
  Finish finish;
  double opacity = 0.5;  ///< 0..1, below 1
  double unit = 1.0;     ///< micrometres that count as 1 in the light formula
  double density = 1.0;  ///< g/cm3
  double initial = 0.0;  ///< micrometres on a sound cell: paint, primer
  bool shrinks = false;  ///< the law takes from `initial` instead of adding to it
  GrowthLaw growth;
};

/// A metal with its layers.
struct Material {
  std::string name, summary;
  Finish metal;
  double density = 8.0;       ///< of the metal, g/cm3
  double thickness = 1000.0;  ///< of the metal, micrometres
  GrowthLaw loss;             ///< of the metal
  std::vector<Layer> layers;  ///< from the metal outwards
};

/// Thickness of a layer, micrometres, `years` after the cell corroded; of a sound cell for years < 0.
double layer_thickness(const Layer& layer, ExposureClass exposure, double years, double factor = 1.0);

/// Metal lost, micrometres, at most the metal's thickness; 0 for years < 0.
double metal_loss(const Material& material, ExposureClass exposure, double years, double factor = 1.0);

/// Years after which no metal is left; infinite when some always is.
double metal_lifetime(const Material& material, ExposureClass exposure, double factor = 1.0);

/// Mass of metal lost, g/m2: micrometres times g/cm3.
inline double mass_of(double micrometres, double density) {
  return micrometres * density;
}

/// What a stack has become: the whole of the closed forms at once.
struct Stack {
  double metal_lost = 0.0;     ///< micrometres
  std::vector<double> layers;  ///< micrometres, as Material::layers
};
Stack stack_at(const Material& material, ExposureClass exposure, double years, double factor = 1.0);

}  // namespace verdigris
