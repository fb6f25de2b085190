// Checkpoints come back as they were written, or not at all.

#include "verdigris/io/checkpoint_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <xxhash.h>

#include <fstream>
#include <iterator>
#include <random>

#include "verdigris/base/error.hpp"

using namespace verdigris;
namespace fs = std::filesystem;

namespace {

class CheckpointFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "verdigris-checkpoint-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    directory_ = name;
    file_ = directory_ / "checkpoint.vgc";
  }
  void TearDown() override { fs::remove_all(directory_); }

  std::string content() const {
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& bytes) const { std::ofstream(file_, std::ios::binary) << bytes; }
  // With the checksum that belongs to it, as someone would who means harm.
  void put_with_checksum(std::string bytes) const {
    bytes.resize(bytes.size() - 16);
    XXH128_canonical_t digest;
    XXH128_canonicalFromHash(&digest, XXH3_128bits(bytes.data(), bytes.size()));
    put(bytes + std::string(reinterpret_cast<const char*>(digest.digest), 16));
  }
  void expect_refused(const std::string& why) const {
    try {
      read_checkpoint(file_);
      ADD_FAILURE() << "read, though " << why;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), file_.string());
      EXPECT_NE(error.problem().find(why), std::string::npos) << error.what();
      EXPECT_FALSE(error.remedy().empty());
    }
  }

  fs::path directory_, file_;
  const std::vector<std::uint32_t> cells_{0, 1, 0x80000000u, 0xFFFFFFFFu, 0x12345678u};
  const std::vector<std::uint8_t> flags_{1, 0, 255};
  const Checkpoint sample_{
      {{"mesh hash", "0123456789abcdef"}, {"cell size", "0.05"}, {"empty", ""}},
      {77,
       {save_numbers<std::uint32_t>("cells", cells_), save_numbers<std::uint8_t>("flags", flags_),
        save_numbers<std::uint64_t>("none", {})}}};
};

TEST_F(CheckpointFile, ComesBack) {
  write_checkpoint(file_, sample_);
  const Checkpoint back = read_checkpoint(file_);
  EXPECT_EQ(back.identity, sample_.identity);
  EXPECT_EQ(back.state.step, 77u);
  ASSERT_EQ(back.state.arrays.size(), 3u);
  EXPECT_EQ(restore_numbers<std::uint32_t>(back.state, "cells"), cells_);
  EXPECT_EQ(restore_numbers<std::uint8_t>(back.state, "flags"), flags_);
  EXPECT_TRUE(restore_numbers<std::uint64_t>(back.state, "none").empty());
  EXPECT_THROW(restore_numbers<std::uint64_t>(back.state, "cells"), InputError);
  EXPECT_THROW(restore_numbers<std::uint64_t>(back.state, "more"), InputError);
  // The same run at the same step is the same file, and nothing else is left.
  const std::string first = content();
  write_checkpoint(file_, back);
  EXPECT_EQ(content(), first);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), 1);
}

TEST_F(CheckpointFile, LittleEndianAsDocumented) {
  write_checkpoint(file_,
                   {{}, {0x0102, {save_numbers<std::uint16_t>("a", std::vector<std::uint16_t>{0x0A0B})}}});
  const std::string expected(
      "\x89VGC\r\n\x1a\n\1\0\0\0\x47\0\0\0\0\0\0\0\2\1\0\0\0\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0a\2\0\0\0"
      "\1\0\0\0\0\0\0\0\x0B\x0A",
      55);
  EXPECT_EQ(content().substr(0, expected.size()), expected);
}

TEST_F(CheckpointFile, NoBitMayDiffer) {
  write_checkpoint(file_, sample_);
  const std::string good = content();
  for (std::size_t byte = 0; byte < good.size(); ++byte)
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[byte] = static_cast<char>(bad[byte] ^ 1 << bit);
      put(bad);
      ASSERT_THROW(read_checkpoint(file_), InputError) << "bit " << bit << " of byte " << byte;
    }
}

TEST_F(CheckpointFile, NoByteMayBeMissingOrOver) {
  write_checkpoint(file_, sample_);
  const std::string good = content();
  for (std::size_t size = 0; size < good.size(); ++size) {
    put(good.substr(0, size));
    ASSERT_THROW(read_checkpoint(file_), InputError) << size << " bytes";
  }
  put(good + '\0');
  expect_refused("damaged");
  put(good.substr(0, good.size() - 1));
  expect_refused("bytes, of");
}

TEST_F(CheckpointFile, OtherFilesAreNone) {
  expect_refused("there is no checkpoint");
  for (const std::string& other : {std::string(), std::string("v 0 0 0\nf 1 2 3\n"), std::string(1000, '\0'),
                                   std::string("\x89PNG\r\n\x1a\n and so on")}) {
    put(other);
    expect_refused("no verdigris checkpoint");
  }
  fs::remove(file_);
  fs::create_directory(file_);
  expect_refused("no regular file");
  fs::remove(file_);
  fs::create_symlink("/dev/zero", file_);
  expect_refused("no regular file");
}

TEST_F(CheckpointFile, LaterVersionsAreNamed) {
  write_checkpoint(file_, sample_);
  std::string later = content();
  later[8] = 2;
  put_with_checksum(later);
  expect_refused("format version 2");
}

// Lengths that promise more than there is, under a checksum that holds: no crash, no great allocation.
TEST_F(CheckpointFile, LengthsAreNotBelieved) {
  write_checkpoint(file_, sample_);
  const std::string good = content();
  std::mt19937 random(5);
  for (std::size_t at = 20; at + 20 < good.size(); ++at)
    for (const int bytes : {1, 4, 8}) {
      std::string bad = good;
      for (int k = 0; k < bytes; ++k)
        bad[at + static_cast<std::size_t>(k)] = static_cast<char>(random() | 0x80u);
      put_with_checksum(bad);
      try {
        read_checkpoint(file_);  // fine where only a value changed
      } catch (const InputError&) {
      }
    }
}

TEST_F(CheckpointFile, AFailedWriteLeavesTheOneBefore) {
  write_checkpoint(file_, sample_);
  const std::string before = content();
  fs::permissions(directory_, fs::perms::owner_read | fs::perms::owner_exec);
  if (::geteuid() != 0) {  // root may write anywhere
    EXPECT_THROW(write_checkpoint(file_, {{}, {78, {}}}), InputError);
  }
  fs::permissions(directory_, fs::perms::owner_all);
  EXPECT_EQ(content(), before);
  EXPECT_THROW(write_checkpoint(directory_ / "none" / "checkpoint.vgc", sample_), InputError);
}

}  // namespace
