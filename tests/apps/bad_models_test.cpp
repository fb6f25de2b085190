// Models that cannot be used. What the readers make of each kind of damage is tested in tests/io.
#include <gtest/gtest.h>

#include "program.hpp"

namespace {

struct BadModel {
  const char *name, *content, *place;
};

const BadModel bad_models[] = {
    {"empty.obj", "", "empty.obj"},
    {"truncated.obj", "v 0 0 0\nv 1 0 0\nv 0 1", "truncated.obj:3"},
    {"truncated.stl", "solid cut\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0", "truncated.stl"},
    {"huge.off", "OFF\n2000000000 2000000000 0\n0 0 0\n", "huge.off:2"},
    {"huge.ply",
     "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
     "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\nabc",
     "huge.ply"},
    {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "nan.obj:1"},
    {"inf.off", "OFF\n3 1 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n", "inf.off:4"},
    {"range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "range.obj:4"},
    {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "points.obj"},
    {"flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "flat.obj"},
    {"text.glb", "not a model", "text.glb"},
    {"model.xyz", "0 0 0\n", "model.xyz"},
};

TEST(BadModels, AreRefused) {
  const Workplace place;
  const auto out = place.path("out");
  for (const BadModel& bad : bad_models) {
    SCOPED_TRACE(bad.name);
    const std::string model = place.file(bad.name, bad.content);
    expect_refused(verdigris({"voronoi", model, "--out", out}), bad.place, out);
    expect_refused(verdigris({"info", model}), bad.place, out);
  }
}

TEST(BadModels, ThatAreNoFiles) {
  const Workplace place;
  const auto out = place.path("out");
  std::filesystem::create_directory(place.path("folder.stl"));
  for (const char* model : {"missing.obj", "folder.stl"}) {
    SCOPED_TRACE(model);
    expect_refused(verdigris({"voronoi", place.path(model), "--out", out}), model, out);
    expect_refused(verdigris({"info", place.path(model)}), model, out);
  }
}

}  // namespace
