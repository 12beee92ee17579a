// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pcm::fast {

/// How much work an evaluation did, and how much it was spared. With several threads in an evaluation, box_tests,
/// vertices_transformed and predicates, exact ones and ties too, hang on which thread took what.
struct WorkCounters {
  std::int64_t box_tests = 0;
  std::int64_t candidate_pairs = 0;       ///< face pairs that boxes and planes do not separate
  std::int64_t crossing_pairs = 0;        ///< face pairs that cross
  std::int64_t vertices_transformed = 0;  ///< of F, each at most once a thread
  std::int64_t predicates = 0;            ///< signs asked for, but those that single precision decides in lanes
  std::int64_t exact_predicates = 0;      ///< signs the floating-point filter could not decide
  std::int64_t tie_breaks = 0;            ///< exact zeros decided by the tie rule
  std::int64_t elements = 0;              ///< formed
  std::int64_t velocities = 0;            ///< elements whose velocities were computed
  std::int64_t law_only = 0;              ///< evaluations that found nothing anew, at a known pose: 1, or 0

  WorkCounters& operator+=(const WorkCounters& work) {
    box_tests += work.box_tests;
    candidate_pairs += work.candidate_pairs;
    crossing_pairs += work.crossing_pairs;
    vertices_transformed += work.vertices_transformed;
    predicates += work.predicates;
    exact_predicates += work.exact_predicates;
    tie_breaks += work.tie_breaks;
    elements += work.elements;
    velocities += work.velocities;
    law_only += work.law_only;
    return *this;
  }
};

}  // namespace pcm::fast
