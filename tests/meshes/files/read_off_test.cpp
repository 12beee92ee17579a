// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/files/read_off.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pcm/read_mesh.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm::read_off_test {
namespace {

const std::string kVertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

void expect_error(const std::string& text, const std::string& part) {
  expect_bad_input([&] { parse_off(text, "a.off"); }, part);
}

TEST(ReadOff, HeaderVariantsCommentsAndPolygonsAreRead) {
  const std::vector<Triangle> expected{{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(parse_off("OFF\n4 1 0\n" + kVertices + "4 0 1 2 3\n", "").faces, expected);
  EXPECT_EQ(parse_off("OFF 4 1 0\n" + kVertices + "4 0 1 2 3", "").faces, expected);
  EXPECT_EQ(parse_off("OFF 4 1\n" + kVertices + "4  0 1 2 3 0.5 0.5 0.5\n", "").faces, expected);
  EXPECT_EQ(
      parse_off("# a square\r\nOFF\r\n\r\n4 2 0 # counts\r\n\r\n" + kVertices + "3 0 1 2\n\n3 0 2 3\n\n", "").faces,
      expected);
}

TEST(ReadOff, ColoursOfVerticesAreIgnored) {
  const TriangleMesh mesh =
      parse_off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n1 2 3 0 0 0 0\n3 0 1 2\n", "c");
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(mesh.name, "c");
}

TEST(ReadOff, ErrorsNameFileLineAndRemedy) {
  expect_error("", "a.off: the file is empty");
  expect_error("NOFF\n", "a.off:1: the file begins with 'NOFF'");
  expect_error("solid x\n", "a.off:1: the file begins with 'solid'");
  expect_error("OFF BINARY\n", "a.off:1: a binary OFF file");
  expect_error("OFF\n", "a.off:1: the file ends before its counts");
  expect_error("OFF\n4\n", "a.off:2: expected the numbers of vertices, faces and edges");
  expect_error("OFF\n4 1 0 0\n", "a.off:2: expected the numbers");
  expect_error("OFF\n4 -1 0\n", "a.off:2: '-1' is not a number of faces");
  expect_error("OFF\n99999999999 1 0\n", "a.off:2: more than 2147483647");
  expect_error("OFF\n0 0 0\n", "a.off: no vertex");
  expect_error("OFF\n4 0 0\n" + kVertices, "a.off: no face");
  expect_error("OFF\n5 1 0\n" + kVertices, "a.off:6: the file ends after 4 of 5 vertices");
  expect_error("OFF\n2000000000 1 0\n0 0 0\n", "the file ends after 1 of 2000000000 vertices");
  expect_error("OFF\n4 2 0\n" + kVertices + "3 0 1 2\n", "a.off:7: the file ends after 1 of 2 faces");
  expect_error("OFF\n4 1 0\n" + kVertices + "3 0 1 2\n3 0 2 3\n", "a.off:8: more lines than the header counts");
  expect_error("OFF\n4 1 0\n" + kVertices + "3 0 1\n", "a.off:7: the face announces 3 corners, but 2 follow");
  expect_error("OFF\n4 1 0\n" + kVertices + "2 0 1\n", "a.off:7: the face has 2 corners");
  expect_error("OFF\n4 1 0\n" + kVertices + "3 0 1 4\n",
               "a.off:7: the face refers to vertex 4, but the file's vertices are numbered 0 to 3");
  expect_error("OFF\n4 1 0\n" + kVertices + "3 0 1 -1\n", "a.off:7: '-1' is not the index of a vertex");
  expect_error("OFF\n1 1 0\n0 0\n", "a.off:3: a vertex needs three coordinates");
  expect_error("OFF\n4 1 zz\n", "a.off:2: 'zz' is not a number of edges");
  expect_error("OFF\n1 1 0\n0 0 0 foo\n", "a.off:3: 'foo' is not a finite number");
  expect_error("OFF\n4 1 0\n" + kVertices + "3 0 1 2 bar\n", "a.off:7: 'bar' is not a finite number");
  expect_error("OFF\n1 1 0\n0 0 1e400\n", "a.off:3: '1e400' is not a finite number");
}

TEST(ReadMesh, FormatFollowsTheExtension) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("a.OFF", "OFF\n4 1 0\n" + kVertices + "4 0 1 2 3\n")).faces.size(), 2u);
  EXPECT_EQ(read_mesh(folder.write("a.Obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).faces.size(), 1u);
  expect_bad_input([&] { read_mesh(folder.write("a.stl", "solid\n")); }, "a.stl: the extension '.stl' is not");
  expect_bad_input([&] { read_mesh(folder.write("plain", "x")); }, "plain: the extension '' is not");
  expect_bad_input([&] { read_mesh(folder.path()); }, ": this is a folder");
  expect_bad_input([&] { read_mesh(folder.path() / "none.stl"); }, "none.stl: no such file");
  expect_bad_input([&] { read_mesh(folder.path() / "none.obj"); }, "none.obj: no such file");
}

}  // namespace
}  // namespace pcm::read_off_test
