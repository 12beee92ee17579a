// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/paraview/vtp_series.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "meshes/generate/boxes.h"
#include "tests/compare/io/base64_decoded.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::simulate {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The numbers of the array of that name, by VTK's rule: length in bytes, then they.
template <class T>
std::vector<T> array_in(const std::string& file, const std::string& name) {
  const std::size_t tag = file.find("Name=\"" + name + "\"");
  const std::size_t begin = file.find('>', tag) + 1;
  const std::string bytes = compare::base64_decoded(file.substr(begin, file.find('<', begin) - begin));
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data(), sizeof length);
  EXPECT_EQ(length + sizeof length, bytes.size()) << name;
  std::vector<T> values(length / sizeof(T));
  std::memcpy(values.data(), bytes.data() + sizeof length, length);
  return values;
}

Recording two_boxes() {
  Recording recording;
  recording.surfaces = {{"E", generate::box({1, 1, 1}), {}}, {"F", generate::box({2, 2, 2}), {}}};
  recording.pairings = {{"E on F", 0, 1}};
  for (int i = 0; i < 2; ++i) {
    Frame frame;
    frame.t = 0.25 * i;
    frame.poses_W.resize(2);
    frame.poses_W[1].r = {0, 0, 1.5 - 0.5 * i};
    if (i == 1) frame.elements = {{0, Side::F, 3, 5e3}, {0, Side::F, 3, 7e3}, {0, Side::E, 2, 100}};
    recording.frames.push_back(frame);
  }
  return recording;
}

TEST(VtpSeries, HoldsEveryFrameWithPointsInPlaceAndPressuresByFace) {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path("vtp");
  write_vtp_series(folder, two_boxes());
  const std::string list = text_of(folder / "frames.pvd");
  EXPECT_NE(list.find("timestep=\"0.25\" part=\"0\" file=\"1.vtp\""), std::string::npos) << list;
  const std::string frame = text_of(folder / "1.vtp");
  EXPECT_NE(frame.find("NumberOfPoints=\"16\" NumberOfPolys=\"24\""), std::string::npos);
  const std::vector<float> points = array_in<float>(frame, "points");
  ASSERT_EQ(points.size(), 48U);
  const Eigen::Vector3d first_of_F = generate::box({2, 2, 2}).vertices[0] + Eigen::Vector3d(0, 0, 1);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(points[static_cast<std::size_t>(24 + k)], static_cast<float>(first_of_F[k]));
  const std::vector<float> pressures = array_in<float>(frame, "pressure");
  ASSERT_EQ(pressures.size(), 24U);
  for (std::size_t f = 0; f < 24; ++f) EXPECT_EQ(pressures[f], f == 15 ? 7e3F : f == 2 ? 100.F : 0.F) << f;
  EXPECT_EQ(array_in<std::int32_t>(frame, "surface")[12], 1);
  EXPECT_EQ(array_in<std::int32_t>(frame, "offsets").back(), 72);
  for (const std::int32_t corner : array_in<std::int32_t>(frame, "connectivity")) EXPECT_LT(corner, 16);
  EXPECT_EQ(array_in<std::int32_t>(frame, "connectivity")[36], 8 + generate::box({2, 2, 2}).faces[0][0]);
  for (const float pressure : array_in<float>(text_of(folder / "0.vtp"), "pressure")) EXPECT_EQ(pressure, 0);
}

TEST(VtpSeries, SaysWhereItCannotWrite) {
  expect_bad_input([] { write_vtp_series("/dev/null/there", two_boxes()); }, "can't be created");
}

}  // namespace
}  // namespace pcm::simulate
