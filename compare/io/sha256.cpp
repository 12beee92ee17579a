// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace pcm::compare {
namespace {

void append_little_endian(std::string& bytes, std::uint64_t value, int count) {
  for (int k = 0; k < count; ++k) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

}  // namespace

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL knows no SHA-256");
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

std::optional<std::string> sha256_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string bytes;
  std::vector<char> piece(1 << 16);
  do {
    stream.read(piece.data(), std::ssize(piece));
    bytes.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  if (stream.bad()) return std::nullopt;  // a folder, say
  return sha256(bytes);
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
