// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes/files/read_obj.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"

namespace pcm {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<Triangle> faces_of(const std::string& text) {
  return parse_obj(text, "a.obj").faces;
}

void expect_error(const std::string& text, const std::string& part) {
  expect_bad_input([&] { parse_obj(text, "a.obj"); }, part);
}

TEST(ReadObj, AllFormsOfCornersNameTheirVertices) {
  const std::vector<Triangle> expected{{0, 1, 2}};
  EXPECT_EQ(faces_of(kSquare + "f 1 2 3"), expected);
  EXPECT_EQ(faces_of(kSquare + "f 1/7 2/8 3/9\n"), expected);
  EXPECT_EQ(faces_of(kSquare + "f 1//4 2//4 3//4\n"), expected);
  EXPECT_EQ(faces_of(kSquare + "f 1/7/4 2/8/4 3/9/4\n"), expected);
  EXPECT_EQ(faces_of(kSquare + "f 1/ 2/ 3//\n"), expected);
  EXPECT_EQ(faces_of(kSquare + "fo 1 2 3\n"), expected);
}

TEST(ReadObj, NegativeIndicesCountBackFromTheLastVertexSoFar) {
  EXPECT_EQ(faces_of(kSquare + "f -4 -3/-1 -2//-1\nv 5 5 5\nf -1 -4 1\n"),
            (std::vector<Triangle>{{0, 1, 2}, {4, 1, 0}}));
}

TEST(ReadObj, PositiveIndicesMayReferToLaterVertices) {
  EXPECT_EQ(faces_of("f 1 2 3\n" + kSquare), (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ReadObj, PolygonsAreFannedFromTheFirstListedCornerWhereConvex) {
  EXPECT_EQ(faces_of(kSquare + "f 2 3 4 1\n"), (std::vector<Triangle>{{1, 2, 3}, {1, 3, 0}}));
  EXPECT_EQ(faces_of(kSquare + "v -1 0.5 0\nf 1 2 3 4 5\n"), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(ReadObj, ConcaveQuadIsCutAtItsReflexCorner) {
  // The reflex corner is the second listed: the fan from the first would lie outside.
  EXPECT_EQ(faces_of("v 0 0 0\nv 1 1 0\nv 2 0 0\nv 1 3 0\nf 1 2 3 4\n"), (std::vector<Triangle>{{3, 0, 1}, {3, 1, 2}}));
}

TEST(ReadObj, LineEndingsCommentsContinuationsAndByteOrderMarkAreUnderstood) {
  const std::vector<Triangle> expected{{0, 1, 2}};
  EXPECT_EQ(faces_of("\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\r\n\r\nv 1 1 0\r\nf 1 2 3\r\n"), expected);
  EXPECT_EQ(faces_of("v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r"), expected);
  EXPECT_EQ(faces_of("# C:\\folder\\\nv\t0 0 0 # origin\n  v 1 0 0\nv 1 \\\n 1 \\\r\n 0\nf 1 2\\\n 3 # end\\\n"),
            expected);
}

TEST(ReadObj, OtherStatementsAreIgnored) {
  EXPECT_EQ(faces_of("mtllib a b.mtl\no thing\n" + kSquare +
                     "vt 0 0\nvn 0 0 1\nvp 1\ng\ns off\nusemtl x\nl 1 2\np 1\ncurv 0 1 2\nf 1 2 3\n"),
            (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(ReadObj, WeightOneAndColoursAreAllowed) {
  const TriangleMesh mesh = parse_obj("v 1 2 3 1.0\nv 4 5 6 .1 .2 .3\nv +7 8e0 -9 1 .1 .2 .3\nf 1 2 3\n", "weights");
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(mesh.vertices[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(7, 8, -9));
  EXPECT_EQ(mesh.name, "weights");
}

TEST(ReadObj, UnderflowIsRoundedNotRefused) {
  const TriangleMesh mesh = parse_obj("v 1e-400 -1e-400 4e-324\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "");
  EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d(0, 0, 5e-324));
  EXPECT_TRUE(std::signbit(mesh.vertices[0].y()));
}

TEST(ReadObj, RepeatedVertexIsLeftToTheCheck) {
  EXPECT_EQ(faces_of(kSquare + "f 1 2 2\n"), (std::vector<Triangle>{{0, 1, 1}}));
  EXPECT_EQ(faces_of(kSquare + "f 1 1 1 1\n").size(), 2u);
}

TEST(ReadObj, ErrorsNameFileLineAndRemedy) {
  expect_error("v 0 0\n", "a.obj:1: a vertex needs three coordinates, here are 2");
  expect_error("v\n", "a.obj:1: a vertex needs three coordinates, here are 0");
  expect_error("\n# x\nv 0 0 1.2.3\n", "a.obj:3: '1.2.3' is not a finite number");
  expect_error("v 0 0 nan\n", "a.obj:1: 'nan' is not a finite number");
  expect_error("v 0 0 0 2 7\n", "a.obj:1: a vertex of 5 numbers; write v x y z");
  expect_error("v 0 0 0 2 1 1 1 1\n", "a.obj:1: a vertex of 8 numbers; write v x y z");
  expect_error("v 0 -inf 0\n", "a.obj:1: '-inf' is not a finite number");
  expect_error("v 0 1e999 0\n", "a.obj:1: '1e999' is not a finite number");
  expect_error("v 0 0 0 x\n", "a.obj:1: 'x' is not a finite number");
  expect_error("v 0 0 0 2\n", "a.obj:1: the vertex has the weight '2'; only 1 is understood");
  expect_error("v 0 0 0 0.5 1 1 1\n", "the weight '0.5'");
  expect_error(kSquare + "f 1 2\n", "a.obj:5: the face has 2 corners, it needs at least 3");
  expect_error(kSquare + "f\n", "a.obj:5: the face has 0 corners");
  expect_error(kSquare + "f 1 2 5\n",
               "a.obj:5: the face refers to vertex 5, but the file's vertices are numbered 1 to 4");
  expect_error(kSquare + "f 1 2 99999999999\n", "refers to vertex 99999999999");
  expect_error(kSquare + "f 1 2 0\n", "a.obj:5: the face refers to vertex 0, but vertices are numbered from 1");
  expect_error(kSquare + "f 1 2 -5\n", "a.obj:5: the face refers to vertex -5, counted back from here");
  expect_error(kSquare + "f 1 \\\n2 \\\n7\n", "a.obj:5: the face refers to vertex 7");
  expect_error(kSquare + "g\nf 1 2 7\n", "a.obj:6: the face refers to vertex 7");
  for (const char* corner : {"x", "1.5", "1/x", "1/2/3/4", "/1", "1//x", "1e0", "99999999999999999999", "+1"})
    expect_error(kSquare + "f 1 2 " + corner + "\n",
                 "a.obj:5: '" + std::string(corner) + "' is not a corner of a face");
  expect_error(kSquare, "a.obj: no face in the file");
  expect_error("", "a.obj: no vertex in the file");
  expect_error("<html>\n<body>\n", "a.obj:1: '<html>' is no statement of Wavefront OBJ");
  for (const char* word : {"ff", "F", "V", "face", "1", "\""})
    expect_error(kSquare + word + " 1 2 3\nf 1 2 3\n", "a.obj:5: '" + std::string(word) + "' is no statement");
  expect_error("f 1 2 3\n", "a.obj: no vertex in the file");
  expect_error("v 0 0 " + std::string(100, 'z') + "\n", "'" + std::string(40, 'z') + "...' is not a finite number");
}

TEST(ReadObj, FilesThatAreNoneAreRefusedByName) {
  const TemporaryFolder folder;
  expect_bad_input([&] { read_obj(folder.path() / "missing.obj"); }, "missing.obj: no such file");
  expect_bad_input([&] { read_obj(folder.path()); }, folder.path().string() + ": this is a folder");
  const auto binary = folder.write("b.obj", std::string("v 0 0 0\n\0\1\2", 11));
  expect_bad_input([&] { read_obj(binary); }, "b.obj: this is a binary file");
  const auto empty = folder.write("e.obj", "");
  expect_bad_input([&] { read_obj(empty); }, "e.obj: no vertex in the file");
  const auto below = folder.write("plain", "x") / "a.obj";
  expect_bad_input([&] { read_obj(below); }, "a.obj: ");
  expect_bad_input([&] { read_obj(""); }, ": no such file");
}

TEST(ReadObj, FileGivesTheMeshItsPathAsName) {
  const TemporaryFolder folder;
  const auto path = folder.write("square.obj", kSquare + "f 1 2 3 4\n");
  const TriangleMesh mesh = read_obj(path);
  EXPECT_EQ(mesh.name, path.string());
  EXPECT_EQ(mesh.faces.size(), 2u);
}

TEST(ReadObj, NoTextOfRandomWordsDoesAnythingButReadOrRefuse) {
  constexpr unsigned kSeed = 17;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  const std::vector<std::string> words{
      "v",  "f",    "1", "2",     "3",  "-1", "-9",           "0",         "1/2",       "//",         "\n", "\n",
      "\r", "\\\n", "#", "1e999", "vt", "\\", "\xEF\xBB\xBF", "v 0 0 1\n", "v 1 0 0\n", "f 1 2 3 4\n"};
  int read = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = i % 2 == 0 ? kSquare : "";
    for (int k = 0; k < 1 + i % 12; ++k) text += words[random() % words.size()] + " ";
    try {
      for (const Triangle& face : parse_obj(text, "fuzz").faces)
        for (const Index vertex : face) ASSERT_GE(vertex, 0);
      ++read;
    } catch (const BadInput&) {
    }
  }
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace pcm
