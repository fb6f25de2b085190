#pragma once
// The figures of Gobron & Chiba 1999, each group in a file of its own.

#include "figure_page.hpp"

/// Fig. 2: the cup as triangles, cells, regions and patina.
void figure_of_the_cup(FigurePage& page);
/// Fig. 8: how much worse two grids can be oriented.
void figure_of_orientation(FigurePage& page);
/// Fig. 10: a disc across an edge.
void figure_of_discs(FigurePage& page);
/// Figs 16 and 17 and the list of numbers beside them: regions on a simple object.
void figures_of_regions(FigurePage& page);
/// Fig. 21: light through two layers.
void figure_of_layers(FigurePage& page);
/// Figs 22 and 23 and the list of numbers beside them: patina on the cup.
void figures_of_patina(FigurePage& page);
