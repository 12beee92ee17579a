// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/problems.h"

namespace pcm::compare {

const std::vector<KnownAnswerFamily>& known_answer_families() {
  static const std::vector<KnownAnswerFamily> families{
#ifdef PCM_WITH_DYNAMICS
      motions,
#endif
      blocks,  spheres_on_planes, cylinders, sockets, volumes, wedges};
  return families;
}

}  // namespace pcm::compare
