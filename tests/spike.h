// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pcm/triangle_mesh.h"

namespace pcm {

/// A closed spike whose tip is a fan of three faces, 3e-8 of its length wide.
inline TriangleMesh spike() {
  TriangleMesh mesh;
  mesh.name = "spike";
  mesh.vertices = {{0x1p-3, 0x1p-4, -0x1p-2},
                   {0x1p-4, -0x1p-2, 0x1p-4},
                   {-0x1p-3, 0x1.8p-3, 0x1p-3},
                   {0x1.346d09a38p+0, 0x1.a85462eap-2, 0x1.42bc34cep-1},
                   {0x1.346d09968p+0, 0x1.a85461e6p-2, 0x1.42bc354fp-1},
                   {0x1.346d096f8p+0, 0x1.a854635p-2, 0x1.42bc3569p-1},
                   {0x1.346d09948p+0, 0x1.a85462c8p-2, 0x1.42bc3529p-1}};
  mesh.faces = {{0, 1, 2}, {3, 6, 4}, {4, 6, 5}, {5, 6, 3}, {0, 3, 1},
                {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {2, 5, 0}, {0, 5, 3}};
  return mesh;
}

}  // namespace pcm
