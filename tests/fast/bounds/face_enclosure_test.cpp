// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/bounds/uncertain_strips.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "fast/bounds/face_over_piece.h"

/// What is certain of faces whose corners may be shifted, and the areas that their sides may pass over, against faces
/// that are shifted: by much more than roundings do, so that areas and points can be compared in plain doubles.
namespace pcm::fast::face_enclosure_test {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  /// An end of the interval more often than not.
  double end() { return random_() % 3 == 0 ? unit() : (random_() % 2 == 0 ? 1.0 : -1.0); }

 private:
  std::mt19937_64 random_;
};

PrismPoint point(double s, double t, double depth) {
  return {1 - s - t, s, t, depth};
}

LinearDepth plane_of(const std::array<PrismPoint, 3>& corners) {
  const PrismPoint a = corners[1] - corners[0], b = corners[2] - corners[0];
  const double twice_area = a[kS] * b[kT] - a[kT] * b[kS];
  return {corners[0][kDepth], corners[0][kS], corners[0][kT], (a[kDepth] * b[kT] - b[kDepth] * a[kT]) / twice_area,
          (b[kDepth] * a[kS] - a[kDepth] * b[kS]) / twice_area};
}

double at(const LinearDepth& plane, double s, double t) {
  return plane.value + plane.per_s * (s - plane.s_0) + plane.per_t * (t - plane.t_0);
}

/// A face within the master, counterclockwise.
FaceEnclosure draw_face(Draw& draw, double shift, Index first_vertex) {
  FaceEnclosure f;
  do {
    for (PrismPoint& corner : f.corners)
      corner = point(0.24 + 0.24 * draw.unit(), 0.24 + 0.24 * draw.unit(), 1 + draw.unit());
  } while (cross_st(f.corners[0], f.corners[1], f.corners[2]) < 0.02);
  f.of_master = false;
  f.face = first_vertex;
  f.facing = -1;
  f.vertices = {first_vertex, first_vertex + 1, first_vertex + 2};
  f.position_error = f.vertex_error = f.corner_error = {shift, shift, shift};
  f.depth = plane_of(f.corners);
  f.relative_rounding = f.crossing_rounding = 0;
  f.hinge_depth = 0;
  f.only_hangs = false;
  f.knows_sides = true;
  f.depth_error = f.field_error = shift * (1 + std::abs(f.depth.per_s) + std::abs(f.depth.per_t));
  f.greatest = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const PrismPoint side = f.corners[(k + 1) % 3] - f.corners[k];
    f.side_error[k] = shift * (std::abs(side[kS]) + std::abs(side[kT]));
    f.side_cuts[k] = 0;
    f.fixed[k] = false;
  }
  f.box = {1, 0, 1, 0};
  for (const PrismPoint& c : f.corners) {
    f.box = {std::min(f.box.low_s, c[kS]), std::max(f.box.high_s, c[kS]), std::min(f.box.low_t, c[kT]),
             std::max(f.box.high_t, c[kT])};
  }
  f.box = {f.box.low_s - shift, f.box.high_s + shift, f.box.low_t - shift, f.box.high_t + shift};
  return f;
}

/// Has all its vertices shifted, the same ones alike.
std::array<PrismPoint, 3> shifted(const FaceEnclosure& f, double shift, Draw& draw) {
  std::array<PrismPoint, 3> corners = f.corners;
  for (PrismPoint& c : corners) c += point(shift * draw.end(), shift * draw.end(), shift * draw.end()) - point(0, 0, 0);
  return corners;
}

bool covers(const std::array<PrismPoint, 3>& f, const PrismPoint& x) {
  return cross_st(f[0], f[1], x) > 0 && cross_st(f[1], f[2], x) > 0 && cross_st(f[2], f[0], x) > 0;
}

double triangle_area(const std::array<PrismPoint, 3>& f) {
  return 0.5 * cross_st(f[0], f[1], f[2]);
}

double common_area(const std::array<PrismPoint, 3>& f, const std::array<PrismPoint, 3>& g) {
  ConvexPolygon part;
  for (const PrismPoint& corner : f) part.add(corner);
  for (std::size_t k = 0; k < 3 && !part.empty(); ++k) {
    Heights heights{};
    for (int i = 0; i < part.count; ++i) heights[static_cast<std::size_t>(i)] = cross_st(g[k], g[(k + 1) % 3], part[i]);
    keep_where_not_negative(part, heights);
  }
  return part.empty() ? 0 : 0.5 * twice_area(part);
}

constexpr double kShift = 1e-3;

TEST(FaceEnclosure, SidesPassOverNoMoreThanTheirStrips) {
  Draw draw(1);
  double greatest = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const FaceEnclosure f = draw_face(draw, kShift, 0);
    const std::array<PrismPoint, 3> moved = shifted(f, kShift, draw);
    const double passed = triangle_area(f.corners) + triangle_area(moved) - 2 * common_area(f.corners, moved);
    const double bound = strips_along_sides(f, kShift, kShift, f, f.box).area;
    ASSERT_LE(passed, bound);
    greatest = std::max(greatest, passed / bound);
  }
  std::printf("  greatest area over its bound %.3f\n", greatest);
  EXPECT_GE(greatest, 0.5);
}

TEST(FaceEnclosure, SidesOfFacesNotMuchLargerThanTheirShiftPassOverNoMoreThanTheirStrips) {
  Draw draw(10);
  double greatest = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    FaceEnclosure f = draw_face(draw, kShift, 0);
    // Short both ways, or narrow.
    const PrismPoint centre = (f.corners[0] + f.corners[1] + f.corners[2]) / 3;
    const double s = std::exp2(-4 + 4 * draw.unit()), t = trial % 2 == 0 ? s : 1;
    for (PrismPoint& c : f.corners) {
      c = point(centre[kS] + s * (c[kS] - centre[kS]), centre[kT] + t * (c[kT] - centre[kT]), c[kDepth]);
    }
    f.depth = plane_of(f.corners);
    f.box = {0, 1, 0, 1};
    for (std::size_t k = 0; k < 3; ++k) {
      const PrismPoint side = f.corners[(k + 1) % 3] - f.corners[k];
      f.side_error[k] = kShift * (std::abs(side[kS]) + std::abs(side[kT]));
    }
    std::array<PrismPoint, 3> moved = shifted(f, kShift, draw);
    if (triangle_area(moved) < 0) std::swap(moved[1], moved[2]);
    const double passed = triangle_area(f.corners) + triangle_area(moved) - 2 * common_area(f.corners, moved);
    const double bound = strips_along_sides(f, kShift, kShift, f, f.box).area;
    ASSERT_LE(passed, bound) << trial;
    greatest = std::max(greatest, passed / bound);
  }
  std::printf("  greatest area over its bound %.3f\n", greatest);
  EXPECT_GE(greatest, 0.5);
}

TEST(FaceEnclosure, ZeroStripHoldsWhatAnErrorOfTheFunctionDecides) {
  Draw draw(2);
  double greatest = 0;
  const BoxST box{0, 1, 0, 1};
  const std::array<PrismPoint, 3> lower{point(0, 0, 0), point(1, 0, 0), point(1, 1, 0)};
  const std::array<PrismPoint, 3> upper{point(0, 0, 0), point(1, 1, 0), point(0, 1, 0)};
  const auto positive = [](const std::array<PrismPoint, 3>& triangle, const LinearDepth& function) {
    ConvexPolygon part;
    for (const PrismPoint& corner : triangle) part.add(corner);
    Heights heights{};
    for (int i = 0; i < 3; ++i) heights[static_cast<std::size_t>(i)] = at(function, part[i][kS], part[i][kT]);
    keep_where_not_negative(part, heights);
    return part.empty() ? 0 : 0.5 * twice_area(part);
  };
  for (int trial = 0; trial < 20000; ++trial) {
    LinearDepth function{0.5 * draw.unit(), 0.5, 0.5, draw.unit(), draw.unit()};
    const double error = std::exp2(-10 + 8 * draw.unit());
    LinearDepth moved = function;
    // The same error everywhere: the zeros stay parallel, and the area between them is a difference.
    moved.value += error;
    const double between =
        positive(lower, moved) + positive(upper, moved) - positive(lower, function) - positive(upper, function);
    const ZeroStrip strip = zero_strip(function, {error, error}, box);
    ASSERT_LE(between, strip.area + 1e-12);
    if (strip.area > 1e-6) greatest = std::max(greatest, between / strip.area);
    const double least = std::abs(function.middle(box)) - function.half_range(box);
    EXPECT_EQ(strip.area > 0, least <= error);
    EXPECT_EQ(strip.everywhere, std::abs(function.middle(box)) + function.half_range(box) <= error);
  }
  EXPECT_GE(greatest, 0.9);
}

/// The area of the box where one function is positive and the other one is not.
double area_between(const LinearDepth& a, const LinearDepth& b, const BoxST& box) {
  const std::array<PrismPoint, 4> corners{point(box.low_s, box.low_t, 0), point(box.high_s, box.low_t, 0),
                                          point(box.high_s, box.high_t, 0), point(box.low_s, box.high_t, 0)};
  const auto keep = [](ConvexPolygon& part, const LinearDepth& function, double sign) {
    Heights heights{};
    for (int i = 0; i < part.count; ++i)
      heights[static_cast<std::size_t>(i)] = sign * function.at(part[i][kS], part[i][kT]);
    if (!part.empty()) keep_where_not_negative(part, heights);
  };
  double area = 0;
  for (const double sign : {1.0, -1.0}) {
    ConvexPolygon part;
    for (const PrismPoint& corner : corners) part.add(corner);
    keep(part, a, sign);
    keep(part, b, -sign);
    area += part.empty() ? 0 : 0.5 * twice_area(part);
  }
  return area;
}

/// A linear function nowhere in the box greater than `most`, either way: more often than not that great in a corner.
LinearDepth draw_change(Draw& draw, double most, const BoxST& box) {
  const auto pick = [&draw] { return draw.unit() > 0 ? draw.end() : 0.0; };
  LinearDepth change{pick(), 0.5 * (box.low_s + box.high_s), 0.5 * (box.low_t + box.high_t), pick() / box.width_s(),
                     pick() / box.width_t()};
  const double greatest = std::abs(change.middle(box)) + change.half_range(box),
               scale = greatest > 0 ? most / greatest : 0;
  return {scale * change.value, change.s_0, change.t_0, scale * change.per_s, scale * change.per_t};
}

/// Of functions that are measured from one point.
LinearDepth sum_of(const LinearDepth& a, double share, const LinearDepth& b) {
  return {a.value + share * b.value, a.s_0, a.t_0, a.per_s + share * b.per_s, a.per_t + share * b.per_t};
}

/// A function, how far it is off, and two that are both within that of it, and nearer to each other.
struct TwoFunctions {
  LinearDepth given, one, other;
  LineError error;

  TwoFunctions(Draw& draw, const BoxST& box) {
    given = {draw.unit(), 0.5 * (box.low_s + box.high_s), 0.5 * (box.low_t + box.high_t), draw.unit() / box.width_s(),
             draw.unit() / box.width_t()};
    error.off = std::exp2(-6 + 5 * draw.unit());
    error.apart = error.off * std::exp2(-5 + 5 * draw.unit());
    one = sum_of(given, 1, draw_change(draw, error.off - error.apart, box));
    other = sum_of(one, 1, draw_change(draw, error.apart, box));
  }
};

TEST(FaceEnclosure, ZeroStripHoldsWhatLiesBetweenTheZerosOfTwoFunctionsNearTheGivenOne) {
  Draw draw(6);
  double greatest = 0;
  int strips = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    const double s = 0.4 + 0.4 * draw.unit(), t = 0.4 + 0.4 * draw.unit();
    const BoxST box{s, s + std::exp2(-6 + 6 * draw.unit()), t, t + std::exp2(-6 + 6 * draw.unit())};
    const TwoFunctions functions(draw, box);
    const ZeroStrip strip = zero_strip(functions.given, functions.error, box);
    const double between = area_between(functions.one, functions.other, box);
    ASSERT_LE(between, strip.area * (1 + 1e-9) + 1e-12 * box.area()) << trial;
    if (strip.area == 0 || strip.everywhere || !(strip.area < box.area())) continue;
    ++strips;
    greatest = std::max(greatest, between / strip.area);
  }
  std::printf("  greatest area over its bound %.3f of %d\n", greatest, strips);
  EXPECT_GE(greatest, 0.7);
  EXPECT_GE(strips, 5000);
}

TEST(FaceEnclosure, StripAlongLineHoldsWhatOfItLiesInBothFaces) {
  Draw draw(7);
  double greatest = 0;
  int strips = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const FaceEnclosure f = draw_face(draw, kShift, 0), g = draw_face(draw, kShift, 3);
    const BoxST box = f.box.common(g.box);
    if (box.empty()) continue;
    const TwoFunctions functions(draw, box);
    const LineStrip strip = strip_along_line(functions.given, functions.error, f, g, box);
    const std::array<PrismPoint, 3> moved_f = shifted(f, kShift, draw), moved_g = shifted(g, kShift, draw);
    double area = 0, volume = 0;
    for (const double sign : {1.0, -1.0}) {
      ConvexPolygon part;
      for (const PrismPoint& corner : moved_f) part.add(corner);
      const auto keep = [&part](auto&& height) {
        if (part.empty()) return;
        Heights heights{};
        for (int i = 0; i < part.count; ++i) heights[static_cast<std::size_t>(i)] = height(part[i]);
        keep_where_not_negative(part, heights);
      };
      for (std::size_t k = 0; k < 3; ++k)
        keep([&](const PrismPoint& x) { return cross_st(moved_g[k], moved_g[(k + 1) % 3], x); });
      keep([&](const PrismPoint& x) { return sign * functions.one.at(x[kS], x[kT]); });
      keep([&](const PrismPoint& x) { return -sign * functions.other.at(x[kS], x[kT]); });
      keep([](const PrismPoint& x) { return x[kDepth]; });
      if (part.empty()) continue;
      Moments moments;
      moments.add(part);
      area += moments.area;
      volume += moments.depth;
    }
    ASSERT_LE(area, strip.area * (1 + 1e-9) + 1e-12) << trial;
    ASSERT_LE(volume, strip.volume * (1 + 1e-9) + 1e-12) << trial;
    if (strip.area == 0 || strip.everywhere) continue;
    ++strips;
    greatest = std::max(greatest, area / strip.area);
  }
  std::printf("  greatest area over its bound %.3f of %d\n", greatest, strips);
  EXPECT_GE(greatest, 0.5);
  EXPECT_GE(strips, 3000);
}

TEST(FaceEnclosure, GreatestAreaHoldsWhatAFaceMayCoverOfTheMaster) {
  Draw draw(8);
  double greatest = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    FaceEnclosure f = draw_face(draw, kShift, 0);
    // Slivers, and faces that reach beyond the master or above it.
    const double squeeze = trial % 2 == 0 ? kShift : 1, size = trial % 3 == 0 ? 4 : 1;
    for (PrismPoint& c : f.corners) {
      c = point(size * squeeze * c[kS], size * c[kT] + (trial % 4 - 1.5) * 0.1, c[kDepth] - 0.2 * (trial % 5));
    }
    f.cut_error = {0, 0, 0};
    f.box = {0, 1, 0, 1};
    const std::array<PrismPoint, 3> moved = shifted(f, kShift, draw);
    ConvexPolygon part;
    for (const PrismPoint& corner : moved) part.add(corner);
    if (cross_st(moved[0], moved[1], moved[2]) < 0) continue;
    for (int coordinate = 0; coordinate <= kDepth && !part.empty(); ++coordinate) {
      Heights heights{};
      for (int i = 0; i < part.count; ++i) heights[static_cast<std::size_t>(i)] = part[i][coordinate];
      keep_where_not_negative(part, heights);
    }
    const double covered = part.empty() ? 0 : 0.5 * twice_area(part);
    const double bound = greatest_area(f);
    ASSERT_LE(covered, bound) << trial;
    if (bound > 0) greatest = std::max(greatest, covered / bound);
  }
  std::printf("  greatest area over its bound %.3f\n", greatest);
  EXPECT_GE(greatest, 0.9);
}

mpq_class exact_at(const LinearDepth& plane, const mpq_class& s, const mpq_class& t) {
  return plane.value + mpq_class(plane.per_s) * (s - plane.s_0) + mpq_class(plane.per_t) * (t - plane.t_0);
}

TEST(FaceEnclosure, HowMuchFartherOneFaceIsHoldsItsRoundingsWhereTheyAreNearlyAsFar) {
  Draw draw(12);
  double greatest = 0;  // Of what it is off, in roundings of the depth.
  for (int trial = 0; trial < 20000; ++trial) {
    FaceEnclosure f = draw_face(draw, 0, 0), g = draw_face(draw, 0, 3);
    const double slope = std::exp2(-12 + 12 * draw.unit());
    g.depth = {draw.unit(), draw.unit(), draw.unit(), slope * draw.unit(), slope * draw.unit()};
    f.depth = g.depth;
    f.depth.s_0 = draw.unit();
    f.depth.t_0 = draw.unit();
    f.depth.value = g.depth.at(f.depth.s_0, f.depth.t_0);
    f.depth_error = g.depth_error = 0;
    const double s = std::abs(draw.unit()), t = std::abs(draw.unit());
    ConvexPolygon there;
    there.add(point(s, t, 0));
    const mpq_class farther = exact_at(f.depth, s, t) - exact_at(g.depth, s, t);
    ASSERT_GE(mpq_class(depth_beyond(f, g).greatest_over(there)), farther) << trial;
    ASSERT_GE(mpq_class(depth_beyond(g, f).greatest_over(there)), -farther) << trial;
    greatest = std::max(greatest, std::abs(farther.get_d()) / (kUnitRoundoff * std::abs(g.depth.value)));
  }
  std::printf("  off by up to %.2f roundings of the depth\n", greatest);
  EXPECT_GE(greatest, 0.5);
}

TEST(FaceEnclosure, FacesThatAreCertainlyApartStayApart) {
  Draw draw(3);
  int apart = 0, near = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    const FaceEnclosure f = draw_face(draw, kShift, 0);
    FaceEnclosure g = draw_face(draw, kShift, 3);
    // Just beside one side of f, a vertex at a time; or anywhere.
    if (trial % 2 == 0) {
      const PrismPoint& a = f.corners[0];
      const PrismPoint& b = f.corners[1];
      const double offset = 4 * kShift * (1 + draw.unit());
      const PrismPoint outward = point(b[kT] - a[kT], a[kS] - b[kS], 0) - point(0, 0, 0);
      g.corners[0] = a + (0.3 + 0.3 * draw.unit()) * (b - a) + offset / std::hypot(outward[kS], outward[kT]) * outward;
      g.corners[2] = g.corners[0] + 0.3 * (b - a) + 0.2 * outward;
      g.corners[1] = g.corners[0] - 0.2 * (b - a) + 0.3 * outward;
      if (cross_st(g.corners[0], g.corners[1], g.corners[2]) < 0) std::swap(g.corners[1], g.corners[2]);
    }
    const BoxST box{0, 1, 0, 1};
    const double overlap = greatest_overlap(f, g, box);
    apart += overlap == 0 ? 1 : 0;
    near += overlap > 0 && overlap < box.area() ? 1 : 0;
    const double common = common_area(shifted(f, kShift, draw), shifted(g, kShift, draw));
    ASSERT_LE(common, overlap) << trial;
  }
  EXPECT_GE(apart, 1000);
  EXPECT_GE(near, 100);
}

TEST(FaceEnclosure, FacesAtOneSideStayApartHoweverItMoves) {
  Draw draw(4);
  for (int trial = 0; trial < 10000; ++trial) {
    const FaceEnclosure f = draw_face(draw, kShift, 0);
    FaceEnclosure g = f;
    // Vertices 0 and 1 of f, the third beyond their side.
    const PrismPoint& a = f.corners[0];
    const PrismPoint& b = f.corners[1];
    const PrismPoint outward = point(b[kT] - a[kT], a[kS] - b[kS], 0) - point(0, 0, 0);
    g.vertices = {1, 0, 7};
    g.corners = {b, a, a + 0.5 * (1 + draw.unit()) * (b - a) + (0.3 + 0.2 * draw.unit()) * outward};
    EXPECT_EQ(greatest_overlap(f, g, {0, 1, 0, 1}), 0);
  }
}

TEST(FaceEnclosure, CertainOrderIsKeptWherePlanesMove) {
  Draw draw(5);
  int before = 0, after = 0, unsure = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const FaceEnclosure f = draw_face(draw, kShift, 0);
    FaceEnclosure g = draw_face(draw, kShift, 3);
    const double gap = 0.3 * draw.unit();
    for (PrismPoint& c : g.corners) c[kDepth] = at(f.depth, c[kS], c[kT]) - gap + 0.01 * draw.unit();
    g.depth = plane_of(g.corners);
    const CertainOrder order = certain_order(g, f);
    before += order == CertainOrder::before ? 1 : 0;
    after += order == CertainOrder::after ? 1 : 0;
    unsure += order == CertainOrder::unsure ? 1 : 0;
    for (int move = 0; move < 20; ++move) {
      const std::array<PrismPoint, 3> moved_f = shifted(f, kShift, draw), moved_g = shifted(g, kShift, draw);
      const LinearDepth plane_f = plane_of(moved_f), plane_g = plane_of(moved_g);
      const PrismPoint x = point(0.24 + 0.24 * draw.unit(), 0.24 + 0.24 * draw.unit(), 0);
      if (!covers(moved_f, x) || !covers(moved_g, x)) continue;
      const double beyond = at(plane_f, x[kS], x[kT]) - at(plane_g, x[kS], x[kT]);
      if (order == CertainOrder::before) {
        ASSERT_GE(beyond, 0);
      } else if (order == CertainOrder::after) {
        ASSERT_LE(beyond, 0);
      }
    }
  }
  EXPECT_GE(before, 1000);
  EXPECT_GE(after, 1000);
  EXPECT_GE(unsure, 1000);
}

TEST(FaceEnclosure, CertainOrderIsKeptWhereOneFaceIsMuchSmallerOrKnownMuchBetter) {
  // The plane of a small face turns far when its corners move; what is certain lies just beyond that.
  Draw draw(9);
  int sure = 0, unsure = 0;
  double least = HUGE_VAL;
  for (int trial = 0; trial < 20000; ++trial) {
    const double shift_f = trial % 4 < 2 ? kShift : kShift / 16, shift_g = trial % 4 < 2 ? kShift / 16 : kShift;
    FaceEnclosure f = draw_face(draw, shift_f, 0), g = draw_face(draw, shift_g, 3);
    FaceEnclosure& small = trial % 2 == 0 ? f : g;
    const PrismPoint centre = (small.corners[0] + small.corners[1] + small.corners[2]) / 3;
    for (PrismPoint& c : small.corners) c = centre + 0.3 * (c - centre);
    const double gap = 0.05 * draw.unit();
    f.depth = plane_of(f.corners);
    for (PrismPoint& c : g.corners) c[kDepth] = at(f.depth, c[kS], c[kT]) - gap + 0.002 * draw.unit();
    g.depth = plane_of(g.corners);
    const CertainOrder order = certain_order(g, f);
    (order == CertainOrder::unsure ? unsure : sure) += 1;
    for (int move = 0; move < 20; ++move) {
      const std::array<PrismPoint, 3> moved_f = shifted(f, shift_f, draw), moved_g = shifted(g, shift_g, draw);
      const LinearDepth plane_f = plane_of(moved_f), plane_g = plane_of(moved_g);
      // The vertices of the other face's part beneath the small one: a depth's extremes.
      ConvexPolygon part;
      for (const PrismPoint& corner : moved_f) part.add(corner);
      for (std::size_t k = 0; k < 3 && !part.empty(); ++k) {
        Heights heights{};
        for (int i = 0; i < part.count; ++i)
          heights[static_cast<std::size_t>(i)] = cross_st(moved_g[k], moved_g[(k + 1) % 3], part[i]);
        keep_where_not_negative(part, heights);
      }
      if (part.empty()) continue;
      for (int i = 0; i < part.count; ++i) {
        const double beyond = at(plane_f, part[i][kS], part[i][kT]) - at(plane_g, part[i][kS], part[i][kT]);
        if (order == CertainOrder::before) {
          ASSERT_GE(beyond, -1e-12) << trial;
        } else if (order == CertainOrder::after) {
          ASSERT_LE(beyond, 1e-12) << trial;
        }
        if (order != CertainOrder::unsure) least = std::min(least, std::abs(beyond));
      }
    }
  }
  std::printf("  %d sure, %d not; the nearest that was sure %.2g\n", sure, unsure, least);
  EXPECT_GE(sure, 2000);
  EXPECT_GE(unsure, 2000);
}

}  // namespace
}  // namespace pcm::fast::face_enclosure_test
