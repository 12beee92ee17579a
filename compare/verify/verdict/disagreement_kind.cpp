// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/verdict/disagreement_kind.h"

#include <array>
#include <cstddef>

namespace pcm::compare {

std::string_view name(Kind kind) {
  constexpr std::array<std::string_view, kKinds> kNames = {
      "failure",
      "touching",
      "nested",
      "ambiguous",
      "polygon count",
      "polygon cycle",
      "patches",
      "intersected faces",
      "inner faces",
      "undefined areas",
      "elements",
      "too deep",
      "crossing position",
      "area",
      "vector area",
      "volume",
      "element area",
      "element penetration",
      "element position",
      "element normal",
      "element velocity",
      "element force",
      "penetration",
      "exceeded",
      "has volume",
      "force",
      "torque",
      "tangent",
      "sums",
      "statistics",
      "bound",
      "penetration bound",
      "paths",
      "work",
      "history",
  };
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace pcm::compare
