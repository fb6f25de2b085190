// Options that cannot be used.
#include <gtest/gtest.h>

#include "program.hpp"

namespace {

// Runs `verdigris voronoi cube.obj --out out` with more arguments.
class BadOptions : public testing::Test {
 protected:
  void expect_refused_with(Arguments more, const std::string& place) {
    Arguments arguments{"voronoi", place_.cube(), "--out", out_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::string shown;
    for (const std::string& argument : more) shown += argument + " ";
    SCOPED_TRACE(shown);
    expect_refused(verdigris(arguments), place, out_);
  }

  Workplace place_;
  std::string out_ = place_.path("out");
};

TEST_F(BadOptions, CellSizes) {
  for (const char* size : {"0", "-1", "nan", "inf", "abc", "1 m"})
    expect_refused_with({"--cell-size", size}, "--cell-size");
  for (const char* count : {"0", "-5", "1x", "nan", "many"})
    expect_refused_with({"--cells", count}, "--cells");
  // Too small for memory: the message says which size would do.
  expect_refused_with({"--cell-size", "1e-9"}, "or larger");
  expect_refused_with({"--cell-size", "1e-300"}, "cell size");
  expect_refused_with({"--cells", "1e15"}, "or larger");
  expect_refused_with({"--cell-size", "100"}, "cube.obj");
  expect_refused_with({"--cells", "10k", "--cell-size", "0.1"}, "--cell-size");
}

TEST_F(BadOptions, Seeds) {
  for (const char* count : {"0", "-3", "1.5"}) expect_refused_with({"--seeds", count}, "--seeds");
  expect_refused_with({"--cells", "600", "--seeds", "100k"}, "seeds for");
  expect_refused_with({"--seeds", place_.path("none.txt")}, "none.txt");
  expect_refused_with({"--seeds", place_.file("empty.txt", "")}, "empty.txt");
  expect_refused_with({"--seeds", place_.file("comment.txt", "# nothing yet\n")}, "comment.txt");
  expect_refused_with({"--seeds", place_.file("words.txt", "0 0 0\nhere there\n")}, "words.txt:2");
  expect_refused_with({"--seeds", place_.file("short.txt", "0 0 0\n0 1\n")}, "short.txt:2");
  expect_refused_with({"--seeds", place_.file("nan.txt", "0 0 nan\n")}, "nan.txt:1");
  expect_refused_with({"--seeds", place_.file("weight.txt", "0 0 0 -1\n")}, "weight.txt:1");
  expect_refused_with({"--cells", "600", "--seeds", place_.file("near.txt", "0.5 0.5 1\n0.5 0.5 1.0001\n")},
                      "seeds 0 and 1");
  expect_refused_with({"--seed-vertices", "1,1"}, "seeds 0 and 1");
  expect_refused_with({"--seed-vertices", "99"}, "vertex 99");
  expect_refused_with({"--seed-vertices", "one"}, "--seed-vertices");
  expect_refused_with({"--seed-vertices", "1", "--seeds", "2"}, "--seed");
  expect_refused_with({"--seeds", "3", "--seed-weights", "1,2"}, "2 weights for 3 seeds");
  for (const char* weights : {"1,0", "1,-1", "1,nan"})
    expect_refused_with({"--seeds", "2", "--seed-weights", weights}, "seed 1");
}

TEST_F(BadOptions, Barriers) {
  for (const char* angle : {"190", "-1", "steep"})
    expect_refused_with({"--barrier-angle", angle}, "--barrier-angle");
  expect_refused_with({"--barrier-mask", place_.path("none.txt")}, "none.txt");
  expect_refused_with({"--barrier-threshold", "0.3"}, "--barrier-mask");
  expect_refused_with({"--torus-patch", "32"}, "--torus");
  expect_refused_with({"--barrier-mask", place_.file("words.txt", "0\nno\n")}, "words.txt:2");
  expect_refused_with({"--barrier-mask", place_.file("short.txt", "0\n1\n")}, "short.txt");
  expect_refused_with({"--barrier-mask", place_.file("all.txt", "1\n1\n1\n1\n1\n1\n")}, "seeds");
}

TEST_F(BadOptions, Values) {
  expect_refused_with({"--links", "chains"}, "links");
  for (const char* size : {"10", "0x10", "10x", "99999x10", "axb"})
    expect_refused_with({"--size", size}, "--size");
  for (const char* view : {"sideways", "0,0,0", "1,2"}) expect_refused_with({"--view", view}, "view");
  expect_refused_with({"--up", "w"}, "up");
  for (const char* chance : {"-0.1", "1.1", "nan", "often"})
    expect_refused_with({"--corner", chance}, "corner");
  // The last one is what a scene file could not hold.
  for (const char* steps : {"0", "-1", "1.5", "18446744073709551615"})
    expect_refused_with({"--steps", steps}, "--steps");
  for (const char* seed : {"-1", "x", "18446744073709551615"})
    expect_refused_with({"--seed", seed}, "--seed");
  for (const char* threads : {"0", "-2", "x"}) expect_refused_with({"--threads", threads}, "--threads");
}

TEST_F(BadOptions, ThatDoNotExistOrLackTheirValue) {
  expect_refused_with({"--colour"}, "--colour");
  expect_refused_with({"surplus"}, "surplus");
  for (const char* option : {"--seeds", "--cells", "--steps", "--view"})
    expect_refused_with({option}, option);
  for (const Arguments& arguments : {Arguments{}, {"grow"}, {"info"}, {"voronoi"}, {"run"}}) {
    SCOPED_TRACE(arguments.empty() ? "no arguments" : arguments[0]);
    expect_refused(verdigris(arguments), "", out_);
  }
}

TEST_F(BadOptions, OutputsThatCannotBeWritten) {
  const std::string model = place_.cube();
  for (const std::string& out : {model, model + "/in", std::string("/proc/verdigris")}) {
    SCOPED_TRACE(out);
    expect_refused(verdigris({"voronoi", model, "--cells", "600", "--no-picture", "--out", out}), out, out_);
  }
  // Directories where results go: refused before the run, and nothing of them is lost.
  for (const std::string name : {"cells.vtp", "run.toml", "checkpoint.vgc"}) {
    SCOPED_TRACE(name);
    const std::string out = place_.path("for-" + name), taken = out + "/" + name;
    std::filesystem::create_directories(taken);
    const Outcome run = verdigris({"voronoi", model, "--cells", "600", "--no-picture", "--out", out});
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find(taken), std::string::npos) << run.err;
    EXPECT_TRUE(std::filesystem::is_directory(taken));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), std::filesystem::directory_iterator()),
              1);
  }
}

}  // namespace
