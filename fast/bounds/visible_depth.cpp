// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fast/bounds/visible_depth.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fast/bounds/face_over_piece.h"
#include "fast/bounds/uncertain_function.h"
#include "fast/bounds/uncertain_strips.h"

namespace pcm::fast {

namespace {

/// A search for one master face looks at no more pieces.
constexpr int kMostPieces = 256;

/// The sides of its box, positive inside.
std::array<UncertainFunction, 4> sides_of(const BoxST& box) {
  return {UncertainFunction(1, box.low_s, 0, 0, 0, 0), UncertainFunction(-1, box.high_s, 0, 0, 0, 0),
          UncertainFunction(0, 0, 1, box.low_t, 0, 0), UncertainFunction(0, 0, -1, box.high_t, 0, 0)};
}

/// The weights of the master's corners: near a side they are unsure where faces that lean may hide, and the first one
/// where the engine, whose three weights are each computed for itself, does not cut f at s + t = 1 exactly.
std::array<UncertainFunction, 3> sides_of_master(const std::array<double, 3>& leant_weights, const FaceEnclosure& f) {
  return {UncertainFunction(-1, 0, -1, 0, 1, leant_weights[0] + f.third_side_error),
          UncertainFunction(1, 0, 0, 0, 0, leant_weights[1]), UncertainFunction(0, 0, 1, 0, 0, leant_weights[2])};
}

/// A box that has all of a piece.
BoxST box_about(const ConvexPolygon& piece) {
  const BoxST box = box_of(piece.points.data(), piece.count);
  return {box.low_s - kLostByCuts, box.high_s + kLostByCuts, box.low_t - kLostByCuts, box.high_t + kLostByCuts};
}

PrismPoint centre_of(const ConvexPolygon& polygon) {
  PrismPoint sum = PrismPoint::Zero();
  for (int i = 0; i < polygon.count; ++i) sum += polygon[i];
  return sum / polygon.count;
}

class Search {
 public:
  Search(const std::vector<FaceInView>& sights, const std::array<double, 3>& leant_weights, double floor,
         VisibleDepthScratch& scratch)
      : sights_(sights), leant_weights_(leant_weights), floor_(floor), scratch_(scratch) {}

  DepthRange run(double computed);

 private:
  using Carrier = VisibleDepthScratch::Carrier;
  using Other = VisibleDepthScratch::Other;
  using Piece = VisibleDepthScratch::Piece;
  enum class Outcome : std::uint8_t { hidden, visible, never_certain, open };

  void start();
  void find_others(Carrier& carrier);
  static CertainOrder order_of(Other& other, const FaceOverPieces& f);
  /// `for_certain`: whether it is asked if it is seen for certain; else only if it is hidden.
  Outcome examine(const Piece& piece, bool for_certain);
  void weigh(const ConvexPolygon& polygon, const FaceOverPieces& f, Other& other);
  bool is_hidden(const ConvexPolygon& polygon, const FaceOverPieces& f);
  void leave_out_bordering(const ConvexPolygon& polygon, const FaceOverPieces& f);
  std::optional<std::size_t> side_that_borders(const FaceOverPieces& g, const ConvexPolygon& polygon,
                                               const FaceOverPieces& f) const;
  std::optional<bool> is_covered(const PrismPoint& x, const FaceOverPieces& f) const;
  Outcome examine_borders(const ConvexPolygon& polygon, const FaceOverPieces& f, bool for_certain);
  /// False where the function's sign is as unsure on every part of the piece, or is sure.
  bool part_along(const UncertainFunction& function, const ConvexPolygon& polygon) {
    const bool parts = function.parts(polygon);
    if (!cut_ && parts) cut_ = function;
    return parts;
  }
  /// Twice, for the part in which the sign is left open.
  bool may_part(const Piece& piece) const { return cut_ && piece.polygon.cuts + 2 <= kMostPieceCuts; }
  void part(const Piece& piece, std::vector<Piece>& heap);
  void push(const ConvexPolygon& polygon, std::size_t carrier, std::vector<Piece>& heap);
  bool is_close(const Piece& piece, const DepthRange& range) const;
  double sure_depth(const Piece& piece) const;
  Piece within_borders(const Piece& piece) const;
  /// The shortest way to what the search would find; false, and nothing said, where it leads nowhere.
  bool find_within_borders(DepthRange& range);
  void find_visible(DepthRange& range);
  void find_hidden(DepthRange& range);

  const std::vector<FaceInView>& sights_;
  const std::array<double, 3>& leant_weights_;
  const double floor_;
  VisibleDepthScratch& scratch_;
  // Of the piece at hand:
  bool doubted_ = false;                  ///< another face may hide some of it
  bool hopeless_ = false;                 ///< and that stays unsure on any part of it
  std::optional<UncertainFunction> cut_;  ///< what it may be parted along
  BoxST box_{};
};

bool less_deep(const VisibleDepthScratch::Piece& a, const VisibleDepthScratch::Piece& b) {
  return a.deepest < b.deepest;
}

void push_deepest(std::vector<VisibleDepthScratch::Piece>& heap, const VisibleDepthScratch::Piece& piece) {
  heap.push_back(piece);
  std::push_heap(heap.begin(), heap.end(), less_deep);
}

VisibleDepthScratch::Piece pop_deepest(std::vector<VisibleDepthScratch::Piece>& heap) {
  std::pop_heap(heap.begin(), heap.end(), less_deep);
  const VisibleDepthScratch::Piece piece = heap.back();
  heap.pop_back();
  return piece;
}

void Search::push(const ConvexPolygon& polygon, std::size_t carrier, std::vector<Piece>& heap) {
  if (polygon.count == 0) return;
  const FaceOverPieces& f = *scratch_.carriers[carrier].face;
  const double over_piece = f.depth.greatest_over(polygon), greatest = f.enclosure->greatest;
  const double deepest = over_piece < greatest ? over_piece : greatest;  // No number where that overflows.
  if (!(deepest <= floor_)) push_deepest(heap, {polygon, carrier, deepest});
}

void Search::start() {
  scratch_.carriers.clear();
  scratch_.others.clear();
  scratch_.pieces.clear();
  scratch_.unsettled.clear();
  scratch_.faces.clear();
  for (const FaceInView& sight : sights_) scratch_.faces.emplace_back(sight.enclosure);
  for (std::size_t i = 0; i < sights_.size(); ++i) {
    const FaceEnclosure& f = sights_[i].enclosure;
    if (!sights_[i].may_carry || f.greatest <= floor_) continue;
    scratch_.carriers.push_back({&scratch_.faces[i], false, 0, 0});
    const std::size_t carrier = scratch_.carriers.size() - 1;
    if (f.facing != 0) {
      push(part_covered(scratch_.faces[i]), carrier, scratch_.pieces);
    } else {
      push_deepest(scratch_.pieces, {ConvexPolygon(), carrier, f.greatest});
    }
  }
}

void Search::find_others(Carrier& carrier) {
  carrier.has_others = true;
  carrier.first = scratch_.others.size();
  for (const FaceOverPieces& other : scratch_.faces) {
    const FaceEnclosure& g = *other.enclosure;
    if (&other != carrier.face && !carrier.face->enclosure->box.common(g.box).empty())
      scratch_.others.push_back({&other, g.facing == 0, CertainOrder::unsure});
  }
  carrier.last = scratch_.others.size();
}

CertainOrder Search::order_of(Other& other, const FaceOverPieces& carrier) {
  if (!other.compared) {
    other.compared = true;
    const FaceEnclosure &g = *other.face->enclosure, &f = *carrier.enclosure;
    const bool apart = greatest_overlap(f, g, f.box.common(g.box)) == 0;
    other.order = apart ? CertainOrder::after : certain_order(g, f);
  }
  return other.order;
}

// Whatever may lie before f is either among the hiders or stands against its being seen.
void Search::weigh(const ConvexPolygon& polygon, const FaceOverPieces& f, Other& other) {
  const FaceOverPieces& g = *other.face;
  if (other.order == CertainOrder::after) return;
  if (box_.common(g.enclosure->box).empty()) return;
  if (g.enclosure->facing == 0) {
    bool parts = false;
    for (const UncertainFunction& side : sides_of(g.enclosure->box)) parts = part_along(side, polygon) || parts;
    doubted_ = true;
    hopeless_ = hopeless_ || !parts;
    return;
  }
  if (lies_outside(g, polygon)) return;
  const UncertainFunction beyond = depth_beyond(*f.enclosure, *g.enclosure);
  const Sign below = g.enclosure->only_hangs ? Sign::positive : g.depth.sign_over(polygon);
  Sign before = beyond.sign_over(polygon);
  if (below == Sign::negative || before == Sign::negative) return;
  if (before == Sign::unsure) {
    const CertainOrder order = order_of(other, f);
    if (order == CertainOrder::after) return;
    if (order == CertainOrder::before) before = Sign::positive;
  }
  if (below == Sign::positive && before == Sign::positive) {
    scratch_.hiders.push_back(&g);
    return;
  }
  bool parts = false;
  if (before == Sign::unsure) parts = part_along(beyond, polygon);
  if (below == Sign::unsure) parts = part_along(g.depth, polygon) || parts;
  for (const UncertainFunction& inside : g.inside) parts = part_along(inside, polygon) || parts;
  doubted_ = true;
  hopeless_ = hopeless_ || !parts;
}

// Without those whose common border meets the piece, until it meets none.
void Search::leave_out_bordering(const ConvexPolygon& polygon, const FaceOverPieces& f) {
  std::vector<const FaceOverPieces*>& covering = scratch_.covering;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < covering.size();) {
      const std::optional<std::size_t> side = side_that_borders(*covering[i], polygon, f);
      if (!side) {
        ++i;
        continue;
      }
      const bool parts = part_along(covering[i]->inside[*side], polygon);
      covering.erase(covering.begin() + static_cast<std::ptrdiff_t>(i));
      changed = doubted_ = true;
      hopeless_ = hopeless_ || !parts;
    }
  }
}

std::optional<std::size_t> Search::side_that_borders(const FaceOverPieces& g, const ConvexPolygon& polygon,
                                                     const FaceOverPieces& f) const {
  const std::vector<const FaceOverPieces*>& covering = scratch_.covering;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!side_may_meet(g, k, polygon) || leaves_master_alone(*g.enclosure, k) ||
        surely_beside(*g.enclosure, k, *f.enclosure))
      continue;
    const auto is_beyond = [&](const FaceOverPieces* h) { return goes_on(*g.enclosure, k, *h->enclosure); };
    if (std::none_of(covering.begin(), covering.end(), is_beyond)) return k;
  }
  return std::nullopt;
}

/// Whether a point of f is covered, where nothing is unsure there.
std::optional<bool> Search::is_covered(const PrismPoint& x, const FaceOverPieces& f) const {
  // Above the master's plane position errors may be greater.
  if (f.depth.sign_at(x) == Sign::negative || sign_within(f, x) != Sign::positive) return std::nullopt;
  bool certain = true;
  for (const FaceOverPieces* const g : scratch_.covering) {
    const Sign sign = sign_within(*g, x);
    if (sign == Sign::positive) return true;
    certain = certain && sign == Sign::negative;
  }
  return certain ? std::optional(false) : std::nullopt;
}

// How many of the hiders lie over a point is the same all over the piece, as far as f covers it: no outer side of
// theirs passes there, but for those that are f's own or lie beside f. So one point of f decides. Where the piece lies
// along f's border, that point is looked for beside the piece.
bool Search::is_hidden(const ConvexPolygon& polygon, const FaceOverPieces& f) {
  scratch_.covering = scratch_.hiders;
  leave_out_bordering(polygon, f);
  if (scratch_.covering.empty()) return false;
  const PrismPoint centre = centre_of(polygon);
  for (int i = -1; i < polygon.count; ++i) {
    const PrismPoint x = i < 0 ? centre : PrismPoint(0.5 * (centre + polygon[i]));
    if (const std::optional<bool> covered = is_covered(x, f)) return *covered;
  }
  const PrismPoint inwards = centre_of(part_covered(f)) - centre;
  for (double share = 0x1p-42; share < 1; share *= 8) {
    const PrismPoint x = centre + share * inwards;
    ConvexPolygon piece_and_point = polygon;  // No polygon, but only its points count.
    piece_and_point.add(x);
    const auto is_parted = [&](const FaceOverPieces* g) {
      return !lies_deep(*g, piece_and_point) || side_that_borders(*g, piece_and_point, f);
    };
    if (std::any_of(scratch_.covering.begin(), scratch_.covering.end(), is_parted)) break;
    if (const std::optional<bool> covered = is_covered(x, f)) return *covered;
  }
  doubted_ = true;
  return false;
}

// What lies within the uncertainty of a border is not seen for certain, however it is parted.
Search::Outcome Search::examine_borders(const ConvexPolygon& polygon, const FaceOverPieces& f, bool for_certain) {
  Outcome outcome = Outcome::visible;
  const auto look_at = [&](const UncertainFunction& side) {
    if (side.sign_over(polygon) == Sign::positive) return;
    if (!part_along(side, polygon)) {
      outcome = Outcome::never_certain;
    } else if (outcome == Outcome::visible) {
      outcome = Outcome::open;
    }
  };
  for (const UncertainFunction& inside : f.inside) look_at(inside);
  if (!for_certain) return outcome;
  for (const UncertainFunction& side : sides_of_master(leant_weights_, *f.enclosure)) look_at(side);
  return outcome;
}

Search::Outcome Search::examine(const Piece& piece, bool for_certain) {
  doubted_ = hopeless_ = false;
  cut_.reset();
  Carrier& carrier = scratch_.carriers[piece.carrier];
  const FaceOverPieces& f = *carrier.face;
  if (f.enclosure->facing == 0) return Outcome::never_certain;
  if (lies_outside(f, piece.polygon)) return Outcome::hidden;
  const Outcome at_borders = examine_borders(piece.polygon, f, for_certain);  // To be parted along these first.
  if (!carrier.has_others) find_others(carrier);
  scratch_.hiders.clear();
  box_ = box_about(piece.polygon);
  for (std::size_t i = carrier.first; i < carrier.last; ++i) weigh(piece.polygon, f, scratch_.others[i]);
  if (!scratch_.hiders.empty() && is_hidden(piece.polygon, f)) return Outcome::hidden;
  if (hopeless_) return Outcome::never_certain;
  return doubted_ && at_borders == Outcome::visible ? Outcome::open : at_borders;
}

void Search::part(const Piece& piece, std::vector<Piece>& heap) {
  if (piece.polygon.count > ConvexPolygon::kMost) {
    const int half = piece.polygon.count / 2;
    Piece first = piece, second = piece;
    first.polygon.count = half + 1;
    second.polygon.count = 0;
    for (int i = half; i < piece.polygon.count; ++i) second.polygon.add(piece.polygon[i]);
    second.polygon.add(piece.polygon[0]);
    part(first, heap);
    part(second, heap);
    return;
  }
  const double at = cut_->parted_at(), open_until = cut_->open_until();
  ConvexPolygon positive = piece.polygon, negative = piece.polygon, between = piece.polygon;
  keep_above(positive, *cut_, 1, at);
  keep_above(negative, *cut_, -1, at);
  keep_above(between, *cut_, 1, -open_until);
  keep_above(between, *cut_, -1, -open_until);
  for (const ConvexPolygon* const polygon : {&positive, &negative, &between}) push(*polygon, piece.carrier, heap);
}

/// Whether the piece can't tell more than errors of its depth do.
bool Search::is_close(const Piece& piece, const DepthRange& range) const {
  const UncertainFunction& depth = scratch_.carriers[piece.carrier].face->depth;
  return piece.deepest - std::max(range.at_least, floor_) <= 8 * depth.parted_at();
}

/// Of a piece that is visible: some of it is seen for certain as deep.
double Search::sure_depth(const Piece& piece) const {
  const UncertainFunction& depth = scratch_.carriers[piece.carrier].face->depth;
  return std::max(depth.over(piece.polygon).high - depth.parted_at(), 0.0);
}

/// What is left of a carrier's piece without all that is uncertain about its borders; fewer than three vertices: none.
VisibleDepthScratch::Piece Search::within_borders(const Piece& piece) const {
  Piece inner = piece;
  const auto keep_inside = [&inner](const UncertainFunction& side) {
    if (inner.polygon.count < ConvexPolygon::kCapacity) keep_above(inner.polygon, side, 1, side.parted_at());
  };
  const FaceOverPieces& f = *scratch_.carriers[piece.carrier].face;
  for (const UncertainFunction& inside : f.inside) keep_inside(inside);
  for (const UncertainFunction& side : sides_of_master(leant_weights_, *f.enclosure)) keep_inside(side);
  return inner;
}

// Most faces see what is deepest for certain, but along its borders, and there it is deeper by no more than errors.
bool Search::find_within_borders(DepthRange& range) {
  if (scratch_.pieces.empty()) return false;
  DepthRange found = range;
  for (const Piece& piece : scratch_.pieces) {
    if (piece.deepest <= found.at_least || scratch_.carriers[piece.carrier].face->enclosure->facing == 0) continue;
    const Piece inner = within_borders(piece);
    if (inner.polygon.empty() || examine(inner, true) != Outcome::visible) continue;
    found.at_least = std::max(found.at_least, sure_depth(inner));
  }
  const Piece& deepest = scratch_.pieces.front();
  if (!is_close(deepest, found)) return false;
  range = {found.at_least, deepest.deepest};
  return true;
}

// What is never certain waits.
void Search::find_visible(DepthRange& range) {
  for (int looked_at = 0; !scratch_.pieces.empty() && looked_at < kMostPieces; ++looked_at) {
    const Piece piece = pop_deepest(scratch_.pieces);
    switch (examine(piece, true)) {
      case Outcome::hidden:
        break;
      case Outcome::open:
        if (may_part(piece)) {
          part(piece, scratch_.pieces);
        } else {
          push_deepest(scratch_.unsettled, piece);
        }
        break;
      case Outcome::never_certain:
        push_deepest(scratch_.unsettled, piece);
        break;
      case Outcome::visible:
        range = {sure_depth(piece), piece.deepest};
        return;
    }
  }
  for (const Piece& piece : scratch_.pieces) push_deepest(scratch_.unsettled, piece);
}

// Until what is left can't tell more than errors of the depth do.
void Search::find_hidden(DepthRange& range) {
  for (int looked_at = 0; !scratch_.unsettled.empty(); ++looked_at) {
    const Piece piece = pop_deepest(scratch_.unsettled);
    if (piece.deepest <= range.at_most) return;
    if (looked_at < kMostPieces && !is_close(piece, range)) {
      if (examine(piece, false) == Outcome::hidden) continue;
      if (doubted_ && may_part(piece)) {
        part(piece, scratch_.unsettled);
        continue;
      }
    }
    range.at_most = piece.deepest;
    return;
  }
}

DepthRange Search::run(double computed) {
  start();
  DepthRange range{0, floor_};
  if (computed > floor_) {
    if (find_within_borders(range)) return range;
    find_visible(range);
  } else {
    std::swap(scratch_.pieces, scratch_.unsettled);
  }
  find_hidden(range);
  return range;
}

}  // namespace

DepthRange find_visible_depth(const std::vector<FaceInView>& sights, const std::array<double, 3>& leant_weights,
                              double computed, double floor, VisibleDepthScratch& scratch) {
  return Search(sights, leant_weights, floor, scratch).run(computed);
}

}  // namespace pcm::fast
