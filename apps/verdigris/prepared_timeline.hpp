#pragma once
// A timeline before its first operation: the model, surface and masks of a scene that weathers.

#include <vector>

#include "model.hpp"
#include "progress.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/weathering/timeline.hpp"

/// Refuses what can be known before the model is read. Throws InputError.
void check_timeline_scene(const verdigris::Scene& scene);

/// Stays where it is made: its parts refer to each other. The scene must outlive it.
class PreparedTimeline {
 public:
  /// `scene` gets the hash of the model and the size of cells that was used. Throws InputError.
  PreparedTimeline(verdigris::Scene& scene, Progress& progress, bool quiet);
  PreparedTimeline(const PreparedTimeline&) = delete;
  PreparedTimeline& operator=(const PreparedTimeline&) = delete;

  const verdigris::Surface& surface() const { return surface_; }
  /// The metal as it is before anything happens.
  verdigris::CoatedMetal metal() const;
  /// Lets all of it happen to `metal`; any number of times. See run_timeline.
  std::vector<verdigris::TimelineRecord> run(verdigris::CoatedMetal& metal,
                                             const verdigris::TimelineListener& listener);

 private:
  const verdigris::Scene& scene_;
  verdigris::Material material_;
  LoadedModel model_;  // without its mesh, which is the surface's
  verdigris::Surface surface_;
  verdigris::SourceMasks sources_;
  verdigris::MaskBook masks_;
};
