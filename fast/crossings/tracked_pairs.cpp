// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/crossings/tracked_pairs.h"

#include <algorithm>
#include <limits>

#include "fast/crossings/pair_margin.h"
#include "fast/predicates/orientation.h"
#include "fast/simd/face_lanes.h"
#include "fast/simd/overlap_sets.h"

namespace pcm::fast {

namespace {

/// Whether the same edges bound the segment in which two faces cross, if they do.
bool cross_alike(const PairSigns& a, const PairSigns& b) {
  if ((a.passing == 0) != (b.passing == 0)) return false;
  return a.passing == 0 || pair_crossing(a) == pair_crossing(b);
}

/// Of coordinates: of lesser ones nothing in the lanes overflows.
constexpr double kGreatestInLanes = 0x1p80;

/// Signs of a pair and how far points of F may travel until they may be others, m.
struct SignsForNow {
  PairSigns signs;
  double margin;
};

SignsForNow look_at(PosedPair& posed, const std::pair<Index, Index>& faces) {
  SignsForNow found;
  found.signs = find_signs(posed[Side::E].face_points(faces.first, posed.work),
                           posed[Side::F].face_points(faces.second, posed.work), SureSigns(),
                           sure_determinant(posed.placement.extent), posed.work);
  found.margin = pair_margin(posed.face_Me(Side::E, faces.first), posed.face_Me(Side::F, faces.second), found.signs);
  return found;
}

}  // namespace

void TrackedPairs::list(PosedPair& posed, double margin, NodePairs& open) {
  clear();  // Until the list is whole.
  expired_.clear();
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
      expired_.push_back(static_cast<Index>(signs_.size()));
      signs_.emplace_back();
      until_.push_back(0);
    }
    return true;
  };
  for_each_candidate(posed.surface(Side::E), posed.surface(Side::F), posed.placement, open, posed.work, visit, margin);
  look_again(posed, 0);
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
  const bool few = 3 * count < fewest_vertices;
  const bool alike = look_again(posed, travelled);
  return few && alike ? Outcome::same : Outcome::unknown;
}

bool TrackedPairs::look_again(PosedPair& posed, double travelled) {
  const bool in_lanes = posed.placement.max_coordinate < kGreatestInLanes;
  bool alike = true;
  for (std::size_t first = 0; first < expired_.size(); first += kElementLanes) {
    const std::size_t count = std::min(kElementLanes, expired_.size() - first);
    const auto pair = [&](std::size_t lane) { return static_cast<std::size_t>(expired_[first + lane]); };
    PairsLookedAt looked_at;
    if (in_lanes) {
      PairLanes lanes;
      for (std::size_t lane = 0; lane < kElementLanes; ++lane) {
        const auto [face_E, face_F] = faces_[pair(lane < count ? lane : 0)];
        enter_corners(posed, Side::E, face_E, lanes.e, lane);
        enter_corners(posed, Side::F, face_F, lanes.f, lane);
      }
      looked_at = fastest_wide_tests().pairs(lanes);
      posed.work.predicates += 10 * static_cast<std::int64_t>(count);
    }
    for (std::size_t lane = 0; lane < count; ++lane) {
      const std::size_t i = pair(lane);
      const SureSigns known(looked_at.signs[lane]);
      const SignsForNow now =
          has_lane(looked_at.sure, lane)
              ? SignsForNow{{known.above_of_E(), known.above_of_F(), known.passing()}, looked_at.margin.value[lane]}
              : look_at(posed, faces_[i]);
      alike = alike && cross_alike(now.signs, signs_[i]);
      signs_[i] = now.signs;
      until_[i] = travelled + kShorter * now.margin;
    }
  }
  return alike;
}

}  // namespace pcm::fast
