// Scene files that cannot be used.
#include <gtest/gtest.h>

#include "program.hpp"

namespace {

const char* const good =
    "[mesh]\nfile = \"cube.obj\"\n\n[surface]\ncells = 600\n\n[seeds]\ncount = 3\n\n[picture]\ndraw = "
    "false\n";

struct Change {
  const char *what, *by, *place;
};

const Change changes[] = {
    {"[mesh]", "[mush]", "scene.toml:1"},
    {"[mesh]", "[mesh", "scene.toml:1"},
    {"cube.obj", "sphere.obj", "sphere.obj"},
    {"file = \"cube.obj\"", "", "scene.toml"},
    {"file = \"cube.obj\"", "file = \"cube.obj\"\nhash = \"0123\"", "cube.obj"},
    {"cells = 600", "cells = \"600\"", "scene.toml:5"},
    {"cells = 600", "cells = nan", "scene.toml:5"},
    {"cells = 600", "cell_size = 0", "scene.toml:5"},
    {"cells = 600", "cells = 600\ncell_size = 0.1", "scene.toml"},
    {"cells = 600", "cell_number = 600", "scene.toml:5"},
    {"cells = 600", "cells = 600\nlinks = \"chains\"", "links"},
    {"count = 3", "count = 0", "scene.toml:8"},
    {"count = 3", "count = 3.5", "scene.toml:8"},
    {"count = 3", "count = 3\nvertices = [1]", "scene.toml"},
    {"count = 3", "points = [[0.0, 1.0]]", "scene.toml:8"},
    {"count = 3", "points = [[0.0, 1.0, nan]]", "scene.toml:8"},
    {"count = 3", "file = \"none.txt\"", "none.txt"},
    {"count = 3", "vertices = [99]", "vertex 99"},
    {"count = 3", "count = 3\nweights = [1.0]", "weights"},
    {"[seeds]\ncount = 3", "", "seeds"},
    {"draw = false", "draw = 0", "scene.toml:11"},
    {"draw = false", "width = 0", "scene.toml:11"},
    {"draw = false", "view = \"sideways\"", "view"},
    {"draw = false", "up = \"x\"", "up"},
    {"[picture]", "[behaviour]\nname = \"moss\"\n\n[picture]", "moss"},
    {"[picture]", "[behaviour]\nname = \"voronoi\"\nspeed = 2\n\n[picture]", "speed"},
    {"[picture]", "[behaviour]\nname = \"voronoi\"\ncorner = 2\n\n[picture]", "corner"},
    {"[picture]", "[behaviour]\nname = \"voronoi\"\ncorner = \"often\"\n\n[picture]", "scene.toml"},
    {"[picture]", "[run]\nsteps = -1\n\n[picture]", "scene.toml"},
    {"[picture]", "[barrier]\nangle = 200\n\n[picture]", "scene.toml"},
};

TEST(BadScenes, AreRefused) {
  const Workplace place;
  place.cube();
  const std::string out = place.path("out");
  ASSERT_EQ(verdigris({"run", place.file("scene.toml", good), "--out", place.path("good")}).status, 0);
  for (const Change& change : changes) {
    SCOPED_TRACE(change.by);
    std::string scene = good;
    scene.replace(scene.find(change.what), std::string(change.what).size(), change.by);
    expect_refused(verdigris({"run", place.file("scene.toml", scene), "--out", out}), change.place, out);
  }
}

TEST(BadScenes, ThatAreNoScenes) {
  const Workplace place;
  const std::string out = place.path("out");
  expect_refused(verdigris({"run", place.path("none.toml"), "--out", out}), "none.toml", out);
  expect_refused(verdigris({"run", place.file("empty.toml", ""), "--out", out}), "empty.toml", out);
  expect_refused(verdigris({"run", place.cube(), "--out", out}), "cube.obj:1", out);
}

}  // namespace
