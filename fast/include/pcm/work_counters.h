// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace pcm::fast {

/// How much work an evaluation did, and how much it was spared. With several threads in an evaluation, box_tests,
/// vertices_transformed, predicates, exact ones and ties too, and searches depend on which thread took what.
struct WorkCounters {
  std::int64_t box_tests = 0;
  std::int64_t node_pairs = 0;            ///< of the trees, whose children or faces were tested
  std::int64_t face_rows = 0;             ///< faces of F that were tested against up to eight of E at once
  std::int64_t live_lanes = 0;            ///< face pairs in these whose boxes touch
  std::int64_t candidate_pairs = 0;       ///< face pairs that boxes and planes do not separate
  std::int64_t unsure_pairs = 0;          ///< of these, where single precision was not asked or could not tell
  std::int64_t crossing_pairs = 0;        ///< face pairs that cross; 0 where a step changed none, and none is listed
  std::int64_t vertices_transformed = 0;  ///< of F, each at most once a thread
  std::int64_t predicates = 0;            ///< signs asked for, but those that single precision decides in lanes
  std::int64_t exact_predicates = 0;      ///< signs the floating-point filter could not decide
  std::int64_t tie_breaks = 0;            ///< exact zeros decided by the tie rule
  std::int64_t elements = 0;              ///< formed
  std::int64_t velocities = 0;            ///< elements whose velocities were computed
  std::int64_t law_only = 0;              ///< evaluations that found nothing anew, at a known pose: 1, or 0
  // In the barycentric scheme:
  std::int64_t lines = 0;          ///< penetration lines, one for each active face of a master
  std::int64_t lines_settled = 0;  ///< of these, known to find what they found at the last pose
  // Lines searched for along the trees, by why no walk decided them:
  std::int64_t searches_unseen = 0;   ///< no face was found through which they surely leave the slave
  std::int64_t searches_oblique = 0;  ///< they leave it too far off the face's normal
  std::int64_t searches_slave = 0;    ///< they may meet another face of the slave before, or on the face
  std::int64_t searches_master = 0;   ///< they may meet another face of the master before

  std::int64_t searches() const { return searches_unseen + searches_oblique + searches_slave + searches_master; }

  WorkCounters& operator+=(const WorkCounters& work) {
    box_tests += work.box_tests;
    node_pairs += work.node_pairs;
    face_rows += work.face_rows;
    live_lanes += work.live_lanes;
    candidate_pairs += work.candidate_pairs;
    unsure_pairs += work.unsure_pairs;
    crossing_pairs += work.crossing_pairs;
    vertices_transformed += work.vertices_transformed;
    predicates += work.predicates;
    exact_predicates += work.exact_predicates;
    tie_breaks += work.tie_breaks;
    elements += work.elements;
    velocities += work.velocities;
    law_only += work.law_only;
    lines += work.lines;
    lines_settled += work.lines_settled;
    searches_unseen += work.searches_unseen;
    searches_oblique += work.searches_oblique;
    searches_slave += work.searches_slave;
    searches_master += work.searches_master;
    return *this;
  }
};
static_assert(sizeof(WorkCounters) == 20 * sizeof(std::int64_t), "all of them have to be added");

}  // namespace pcm::fast
