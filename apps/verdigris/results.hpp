#pragma once
// The second half of a run: what came of it, written into a directory.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "picture.hpp"
#include "start.hpp"
#include "verdigris/automaton/simulation.hpp"

/// What was written beside what was found out on the way.
struct Results {
  std::vector<std::string> files;
  std::uint64_t unreached = 0;  ///< cells without a label, for behaviours that give some
};

/// cells.vtp (unless not wanted; masks as `mask_NAME`), regions.csv for a field of labels, curve.csv for one
/// of arrivals.
Results write_results(const std::filesystem::path& out, const verdigris::Surface& surface,
                      const verdigris::AnySimulation& simulation, const PlacedSeeds& placed,
                      std::span<const verdigris::Mask> masks, bool cells);

/// The simulation's first field, which is what pictures show.
CellValues first_field(const verdigris::AnySimulation& simulation);

/// Regions that end at a barrier touch all the same: for pictures no edge bars the view to the other side.
class OpenView {
 public:
  /// `surface` must outlive it.
  OpenView(const verdigris::Surface& surface, verdigris::LinkKind links);
  const verdigris::Surface& surface() const { return open_ ? *open_ : surface_; }
  /// The values with the ghosts that its surface wants.
  CellValues operator()(CellValues values) const;

 private:
  const verdigris::Surface& surface_;
  std::optional<verdigris::Surface> open_;
};

/// picture.png of the simulation's first field.
void draw_results(const std::filesystem::path& out, const verdigris::Surface& surface,
                  const verdigris::AnySimulation& simulation, const verdigris::Scene& scene);

/// mask_NAME.png; returns that name.
std::string draw_mask(const std::filesystem::path& out, const verdigris::Surface& surface,
                      const verdigris::Mask& mask, const verdigris::Scene& scene);
