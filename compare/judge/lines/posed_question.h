// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

/// Questions that leave the program, for engines of any make: a folder with poses.jsonl and the surfaces beside it
/// (docs/judge.md).
namespace pcm::compare {

struct PosedSurface {
  std::string name;    ///< one of a kind in its folder
  std::string file;    ///< below the folder
  std::string sha256;  ///< of that file's bytes
  TriangleMesh mesh;
};

struct PosedQuestion {
  std::string id;       ///< the pose's name as `pcm verify` has it
  std::string pair;     ///< which surfaces, in words
  std::string stratum;  ///< which kind of pose
  std::size_t E = 0;    ///< number of the surface
  std::size_t F = 0;
  Pose pose;
  Velocity velocity;
  ContactLaw law;
  Mode mode = Mode::both;
  Scheme scheme = Scheme::barycentric;
  std::string comment;                 ///< for readers
  std::optional<double> known_volume;  ///< of the intersection, worked out by hand, m^3
};

/// What such a folder holds.
struct PosedQuestions {
  std::vector<PosedSurface> surfaces;
  std::vector<PosedQuestion> questions;
};

}  // namespace pcm::compare
