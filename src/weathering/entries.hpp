#pragma once
// Operators of the library, each added by the file that holds it.

#include "verdigris/weathering/operators.hpp"

namespace verdigris::weathering {

void add_coat(OperatorCatalogue& catalogue);
void add_wear(OperatorCatalogue& catalogue);
void add_scratch(OperatorCatalogue& catalogue);
void add_crack(OperatorCatalogue& catalogue);
void add_peel(OperatorCatalogue& catalogue);
void add_dust(OperatorCatalogue& catalogue);
void add_stain(OperatorCatalogue& catalogue);
void add_age(OperatorCatalogue& catalogue);

}  // namespace verdigris::weathering
