// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "compare/io/provenance/sha256.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::compare {
namespace {

TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

/// Bytes of which no two neighbouring blocks are alike.
std::string many_bytes(std::size_t count) {
  std::string bytes;
  for (std::size_t k = 0; k < count; ++k) bytes.push_back(static_cast<char>(k * k / 251 + k));
  return bytes;
}

TEST(Sha256, OfAFileIsThatOfItsBytesWhateverTheirNumber) {
  const TemporaryFolder scratch;
  constexpr std::size_t kBlock = 1 << 16;
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, kBlock - 1, kBlock, kBlock + 1, 3 * kBlock + 7}) {
    const std::string bytes = many_bytes(count);
    EXPECT_EQ(sha256_of_file(scratch.write("bytes", bytes)), sha256(bytes)) << count;
  }
  EXPECT_EQ(sha256_of_file(scratch.path("nowhere")), std::nullopt);
  EXPECT_EQ(sha256_of_file(scratch.path()), std::nullopt) << "a folder";
}

/// The most memory that this process has held so far, in bytes.
std::int64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * std::int64_t{1024};
}

TEST(Sha256, OfAFileTakesNoMemoryForTheWhole) {
  const TemporaryFolder scratch;
  const std::string file = scratch.write("zeros", "");
  constexpr std::int64_t kSize = std::int64_t{1} << 28;
  std::filesystem::resize_file(file, kSize);
  const std::int64_t before = peak_memory();
  EXPECT_EQ(sha256_of_file(file), "a6d72ac7690f53be6ae46ba88506bd97302a093f7108472bd9efc3cefda06484");
  EXPECT_LT(peak_memory() - before, kSize / 4);
}

}  // namespace
}  // namespace pcm::compare
