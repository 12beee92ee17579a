// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/poses/surface_features.h"
#include "pcm/inputs.h"

namespace pcm::compare {

/// A question put to both sides.
struct Question {
  const SurfaceFeatures& E;
  const SurfaceFeatures& F;
  const ContactLaw& law;
  Mode mode = Mode::E;
  Scheme scheme = Scheme::barycentric;
  Pose pose;
  Velocity velocity;
};

}  // namespace pcm::compare
