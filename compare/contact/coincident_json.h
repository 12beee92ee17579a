// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/explain/explain.h"
#include "compare/io/json/exact_json.h"
#include "reference/oracle.h"

namespace pcm::compare {

/// Says of answers of contact_json.h whether features coincide, and between which bounds the areas lie then.
class CoincidentJson {
 public:
  /// Throws BadInput where a mesh is unfit for contact.
  CoincidentJson(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F, Mode mode, Scheme scheme,
                 reference::Problem problem);

  /// Adds `coincident`, and in E and F `area_open` and `area_closed`: faces in one plane left out and counted in
  /// (reference::AreaInterval). Where nothing coincides both are the answer's own area; else the oracle works them out,
  /// whoever answered. null where the area is.
  void add_to(Json& json, const Pose& pose) const;

 private:
  Explainer explainer_;
  reference::Oracle oracle_;
  reference::Problem problem_;
};

}  // namespace pcm::compare
