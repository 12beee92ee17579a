// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings/tracked_pairs.h"

#include <limits>

#include "fast/crossings/pair_margin.h"
#include "fast/predicates/orientation.h"
#include "fast/simd/overlap_sets.h"

namespace pcm::fast {

namespace {

/// Whether the same edges bound the segment in which two faces cross, if they do.
bool cross_alike(const PairSigns& a, const PairSigns& b) {
  if ((a.passing == 0) != (b.passing == 0)) return false;
  return a.passing == 0 || pair_crossing(a) == pair_crossing(b);
}

double margin_of(PosedPair& posed, const std::pair<Index, Index>& faces, const PairSigns& signs) {
  return kShorter * pair_margin(posed.face_Me(Side::E, faces.first), posed.face_Me(Side::F, faces.second), signs);
}

PairSigns find_signs_of(PosedPair& posed, const std::pair<Index, Index>& faces, const SureSigns& known) {
  return find_signs(posed[Side::E].face_points(faces.first, posed.work),
                    posed[Side::F].face_points(faces.second, posed.work), known,
                    sure_determinant(posed.placement.extent), posed.work);
}

}  // namespace

void TrackedPairs::list(PosedPair& posed, double margin, NodePairs& open) {
  clear();  // Until the list is whole.
  const PreparedSurface& F = posed.surface(Side::F);
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const auto visit = [&](Index face_E, Index face_F, const SureSigns& known) {
    for (const Index v : F.face(face_F)) {
      low = low.cwiseMin(F.vertex(v));
      high = high.cwiseMax(F.vertex(v));
    }
    const std::pair<Index, Index> faces(face_E, face_F);
    faces_.push_back(faces);
    if (known.of_passing()) {
      signs_.push_back({known.above_of_E(), known.above_of_F(), known.passing()});
      until_.push_back(kShorter * margin);
    } else {
      ++posed.work.unsure_pairs;
      signs_.push_back(find_signs_of(posed, faces, known));
      until_.push_back(margin_of(posed, faces, signs_.back()));
    }
    return true;
  };
  for_each_candidate(posed.surface(Side::E), posed.surface(Side::F), posed.placement, open, posed.work, visit, margin);
  if (!faces_.empty()) ball_of_listed_ = ball_about(low, high);
  listed_until_ = kShorter * margin;
}

// Winding numbers of the vertices of a component differ by what its edges cross, so that with the same crossings they
// all are what they were or all others; and these only where each of them has passed through a face of the other
// surface: one of a pair that is looked at again, as all other ones have kept off, or crossed in the same way all
// along, when no corner of the one can come to lie in the other.
TrackedPairs::Outcome TrackedPairs::update(PosedPair& posed, double travelled, std::size_t fewest_vertices) {
  expired_.resize(faces_.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    expired_[count] = static_cast<Index>(i);
    count += travelled < until_[i] ? 0 : 1;
  }
  expired_.resize(count);
  bool same = 3 * count < fewest_vertices;
  for (const Index pair : expired_) {
    const auto i = static_cast<std::size_t>(pair);
    const PairSigns signs = find_signs_of(posed, faces_[i], SureSigns());
    same = same && cross_alike(signs, signs_[i]);
    signs_[i] = signs;
    until_[i] = travelled + margin_of(posed, faces_[i], signs);
  }
  return same ? Outcome::same : Outcome::unknown;
}

}  // namespace pcm::fast
