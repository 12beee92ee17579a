// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/provenance/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <vector>

namespace pcm::compare {
namespace {

void append_little_endian(std::string& bytes, std::uint64_t value, int count) {
  for (int k = 0; k < count; ++k) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

/// Of bytes that come block by block.
class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    require(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }
  void add(std::string_view bytes) { require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1); }
  /// Once, at the end.
  std::string in_hexadecimal() {
    std::array<unsigned char, 32> digest{};
    require(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr) == 1);
    return fmt::format("{:02x}", fmt::join(digest, ""));
  }

 private:
  static void require(bool done) {
    if (!done) throw std::runtime_error("OpenSSL knows no SHA-256");
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.in_hexadecimal();
}

std::optional<std::string> sha256_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  Digest digest;
  std::vector<char> block(1 << 16);
  do {
    stream.read(block.data(), std::ssize(block));
    digest.add({block.data(), static_cast<std::size_t>(stream.gcount())});
  } while (stream);
  if (stream.bad()) return std::nullopt;  // a folder, say
  return digest.in_hexadecimal();
}

std::string sha256(const TriangleMesh& mesh) {
  std::string bytes;
  append_little_endian(bytes, mesh.vertices.size(), 8);
  for (const Eigen::Vector3d& x : mesh.vertices)
    for (int j = 0; j < 3; ++j) append_little_endian(bytes, std::bit_cast<std::uint64_t>(x[j]), 8);
  for (const Triangle& face : mesh.faces)
    for (const Index v : face) append_little_endian(bytes, static_cast<std::uint32_t>(v), 4);
  return sha256(bytes);
}

}  // namespace pcm::compare
