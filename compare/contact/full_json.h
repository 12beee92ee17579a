// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "compare/contact/contact_record.h"
#include "compare/contact/placed_surfaces.h"
#include "compare/io/json/exact_json.h"
#include "compare/poses/poses_file.h"
#include "compare/poses/surface_features.h"

namespace pcm::compare {

/// What `pcm contact --full` adds to an answer of contact_json.h, whoever answered. Vertices and faces are numbered
/// from 0 in the order of their files.
class FullJson {
 public:
  /// The meshes must outlive this.
  FullJson(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Json provenance);

  /// Adds to `json`, the answer that `record` tells of as well, at this state. Keys that it has stay as they are, but
  /// that its polygons and areas get further ones. Of polygons that were not wanted nothing is added.
  void add_to(Json& json, const ContactRecord& record, const State& state) const;

 private:
  SurfaceFeatures E_, F_;
  Json provenance_;
};

}  // namespace pcm::compare
