// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/brute_force/clipped_strips.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace pcm::brute_force {
namespace {

const std::array<Linear, 3> kTriangle = {Linear{0, 1, 0}, Linear{0, 0, 1}, Linear{1, -1, -1}};

/// The part of a boundary in the triangle, from abscissa to abscissa.
struct Segment {
  Line line;
  Rational from;
  Rational to;
};

/// The abscissae at which anything may happen, and the segments that lie between them.
struct Arrangement {
  std::set<Rational> abscissae;
  std::vector<Segment> segments;
};

void add(Arrangement& arrangement, const Boundary& boundary) {
  const Linear& zero = boundary.zero;
  if (zero.along_t == 0) {
    if (zero.along_s == 0) return;
    const Rational s = -zero.at_origin / zero.along_s;
    if (s > 0 && s < 1) arrangement.abscissae.insert(s);
    return;
  }
  Segment segment{{-zero.along_s / zero.along_t, -zero.at_origin / zero.along_t}, 0, 1};
  const auto restrict_to = [&](const Linear& limit) {
    const Rational constant = limit.at(0, segment.line.offset);
    const Rational slope = limit.along_s + limit.along_t * segment.line.slope;
    if (slope > 0) segment.from = std::max(segment.from, Rational(-constant / slope));
    if (slope < 0) segment.to = std::min(segment.to, Rational(-constant / slope));
    if (slope == 0 && constant < 0) segment.to = segment.from;
  };
  for (const Linear& limit : kTriangle) restrict_to(limit);
  for (const Linear& limit : boundary.limits) restrict_to(limit);
  if (segment.from >= segment.to) return;
  arrangement.abscissae.insert(segment.from);
  arrangement.abscissae.insert(segment.to);
  arrangement.segments.push_back(std::move(segment));
}

void add_intersections(Arrangement& arrangement) {
  const auto& segments = arrangement.segments;
  for (auto a = segments.begin(); a != segments.end(); ++a)
    for (auto b = std::next(a); b != segments.end(); ++b) {
      if (a->line.slope == b->line.slope || a->from >= b->to || b->from >= a->to) continue;
      const Rational s = (b->line.offset - a->line.offset) / (a->line.slope - b->line.slope);
      if (s > std::max(a->from, b->from) && s < std::min(a->to, b->to)) arrangement.abscissae.insert(s);
    }
}

/// A number strictly between two others, with as few digits as it takes: what is computed from it is cheap.
Rational short_number_between(const Rational& low, const Rational& high) {
  const Rational width = high - low;
  const auto numerator_bits = mpz_sizeinbase(width.get_num_mpz_t(), 2);
  const auto denominator_bits = mpz_sizeinbase(width.get_den_mpz_t(), 2);
  // 2^-places is less than the width, so the next multiple of it above `low` is below `high`.
  const auto places = denominator_bits + 1 > numerator_bits ? denominator_bits + 1 - numerator_bits : 0;
  Rational scaled;
  mpq_mul_2exp(scaled.get_mpq_t(), low.get_mpq_t(), places);
  mpz_class below;
  mpz_fdiv_q(below.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational result(mpz_class(below + 1));
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), places);
  return result;
}

/// The lines that pass between two neighbouring abscissae, from the lowest up, each with its height at s.
std::vector<std::pair<Rational, Line>> lines_between(const Arrangement& arrangement, const Rational& from,
                                                     const Rational& to, const Rational& s) {
  std::vector<std::pair<Rational, Line>> lines;
  for (const Segment& segment : arrangement.segments)
    if (segment.from <= from && segment.to >= to) lines.emplace_back(segment.line.at(s), segment.line);
  std::ranges::sort(lines, {}, &std::pair<Rational, Line>::first);
  // Lines do not intersect here, so what is equally high is the same line.
  const auto same_height = [](const auto& a, const auto& b) { return a.first == b.first; };
  lines.erase(std::unique(lines.begin(), lines.end(), same_height), lines.end());
  return lines;
}

/// The strips between two neighbouring abscissae.
std::vector<Strip> strips_between(const Arrangement& arrangement, const Rational& from, const Rational& to,
                                  const Question& question) {
  const Rational s = short_number_between(from, to);
  const auto lines = lines_between(arrangement, from, to, s);
  std::vector<Strip> strips;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto& [low, lower] = lines[i - 1];
    const auto& [high, upper] = lines[i];
    const std::optional<Index> answer = question(s, short_number_between(low, high));
    if (!answer) continue;
    if (!strips.empty() && strips.back().answer == *answer && strips.back().upper == lower)
      strips.back().upper = upper;
    else
      strips.push_back({lower, upper, *answer, from, to});
  }
  return strips;
}

}  // namespace

Linear operator-(const Linear& a, const Linear& b) {
  return {a.at_origin - b.at_origin, a.along_s - b.along_s, a.along_t - b.along_t};
}

std::vector<Strip> strips_of(const std::vector<Boundary>& boundaries, const Question& question) {
  Arrangement arrangement;
  for (const Linear& side : kTriangle) add(arrangement, {side, {}});
  for (const Boundary& boundary : boundaries) add(arrangement, boundary);
  add_intersections(arrangement);

  std::vector<Strip> finished;
  std::vector<Strip> open;
  for (auto from = arrangement.abscissae.begin(); std::next(from) != arrangement.abscissae.end(); ++from) {
    std::vector<Strip> next = strips_between(arrangement, *from, *std::next(from), question);
    for (Strip& strip : open) {
      const auto goes_on = std::ranges::find_if(next, [&](const Strip& other) {
        return other.answer == strip.answer && other.lower == strip.lower && other.upper == strip.upper;
      });
      if (goes_on != next.end())
        goes_on->from = strip.from;
      else
        finished.push_back(std::move(strip));
    }
    open = std::move(next);
  }
  finished.insert(finished.end(), open.begin(), open.end());
  return finished;
}

}  // namespace pcm::brute_force
