// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <string>

#include "pcm/bad_input.h"
#include "tests/meshes/mesh_measures.h"

namespace pcm::test {

/// That the mesh is sound, closed, consistently oriented outward, with that many faces and that topology.
inline void expect_closed(const TriangleMesh& mesh, Index faces, int expected_euler_characteristic = 2) {
  SCOPED_TRACE(mesh.name);
  EXPECT_EQ(flaw(mesh), "");
  EXPECT_EQ(std::ssize(mesh.faces), faces);
  EXPECT_EQ(border_edges(mesh), 0);
  EXPECT_EQ(euler_characteristic(mesh), expected_euler_characteristic);
  EXPECT_GT(signed_volume(mesh), 0);
}

/// That the mesh is sound, consistently oriented, with that many faces and border edges.
inline void expect_open(const TriangleMesh& mesh, Index faces, int expected_border_edges) {
  SCOPED_TRACE(mesh.name);
  EXPECT_EQ(flaw(mesh), "");
  EXPECT_EQ(std::ssize(mesh.faces), faces);
  EXPECT_EQ(border_edges(mesh), expected_border_edges);
}

/// That the call is refused with a message that contains the text, such as the parameter's name.
inline void expect_refused(const std::function<void()>& call, const std::string& text) {
  try {
    call();
    ADD_FAILURE() << "not refused: " << text;
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

}  // namespace pcm::test
