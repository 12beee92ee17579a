// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/loft.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "meshes/generate/deterministic_trigonometry.h"
#include "meshes/generate/generator_support.h"

namespace pcm::generate {
namespace {

using Sections = std::vector<CrossSection>;
using Column = double CrossSection::*;

/// Slope of the column's chord from section i to section i + 1.
double chord_slope(const Sections& sections, Column column, std::size_t i) {
  return (sections[i + 1].*column - sections[i].*column) / (sections[i + 1].position - sections[i].position);
}

/// Slope of the interpolant at section i: the weighted harmonic mean of the chords beside it, 0 at an extremum.
double slope(const Sections& sections, Column column, std::size_t i) {
  if (i == 0) return chord_slope(sections, column, 0);
  if (i + 1 == sections.size()) return chord_slope(sections, column, i - 1);
  const double before = chord_slope(sections, column, i - 1), after = chord_slope(sections, column, i);
  if (!(before * after > 0)) return 0;
  const double length_before = sections[i].position - sections[i - 1].position;
  const double length_after = sections[i + 1].position - sections[i].position;
  const double weight_before = 2 * length_after + length_before, weight_after = length_after + 2 * length_before;
  return (weight_before + weight_after) / (weight_before / before + weight_after / after);
}

/// The column's value at `position`, between sections i and i + 1: a cubic in Hermite's form.
double interpolated(const Sections& sections, Column column, std::size_t i, double position) {
  const double length = sections[i + 1].position - sections[i].position;
  const double t = (position - sections[i].position) / length;
  const double from = sections[i].*column, to = sections[i + 1].*column;
  const double slope_from = slope(sections, column, i) * length, slope_to = slope(sections, column, i + 1) * length;
  const double rest = 1 - t;
  return from + (to - from) * (t * t * (3 - 2 * t)) + slope_from * (t * rest * rest) - slope_to * (t * t * rest);
}

CrossSection section_at(const Sections& sections, double position) {
  std::size_t i = 0;
  while (i + 2 < sections.size() && position >= sections[i + 1].position) ++i;
  const auto value = [&](Column column) { return interpolated(sections, column, i, position); };
  return {position,
          value(&CrossSection::center_u),
          value(&CrossSection::center_v),
          value(&CrossSection::half_u),
          value(&CrossSection::half_v),
          value(&CrossSection::squareness)};
}

/// Distance of the unit cross-section from its centre in the given direction.
double radius_of_unit_section(const CosineSine& direction, double squareness) {
  const double c2 = direction.cosine * direction.cosine, s2 = direction.sine * direction.sine;
  const double c8 = c2 * c2 * (c2 * c2), s8 = s2 * s2 * (s2 * s2);
  return 1 + squareness * (1 / std::sqrt(std::sqrt(std::sqrt(c8 + s8))) - 1);
}

Eigen::Vector3d point(LoftAxis axis, double u, double v, double position) {
  return axis == LoftAxis::x ? Eigen::Vector3d(position, u, v) : Eigen::Vector3d(u, v, position);
}

Eigen::Vector3d pole(LoftAxis axis, const CrossSection& section) {
  return point(axis, section.center_u, section.center_v, section.position);
}

}  // namespace

std::vector<LoftRing> rounded_rings(double start, double end, const RoundedEnd& first, const RoundedEnd& last,
                                    Index count) {
  std::vector<LoftRing> rings;
  for (Index i = 1; i <= first.rings; ++i) {
    const auto [cosine, sine] = cosine_sine_of_turn(i, std::int64_t{4} * (first.rings + 1));
    rings.push_back({start + first.length * (1 - cosine), sine});
  }
  const Index between = count - first.rings - last.rings;
  const double from = start + first.length, to = end - last.length;
  for (Index i = 0; i < between; ++i) {
    rings.push_back({from + (to - from) * (static_cast<double>(i) / static_cast<double>(between - 1)), 1});
  }
  for (Index i = last.rings; i >= 1; --i) {
    const auto [cosine, sine] = cosine_sine_of_turn(i, std::int64_t{4} * (last.rings + 1));
    rings.push_back({end - last.length * (1 - cosine), sine});
  }
  return rings;
}

TriangleMesh loft(std::string_view name, LoftAxis axis, const std::vector<CrossSection>& sections,
                  const std::vector<LoftRing>& rings, Index segments) {
  std::vector<Eigen::Vector3d> vertices{pole(axis, sections.front())};
  vertices.reserve(rings.size() * static_cast<std::size_t>(segments) + 2);
  for (const LoftRing& ring : rings) {
    const CrossSection section = section_at(sections, ring.position);
    for (Index k = 0; k < segments; ++k) {
      const CosineSine direction = cosine_sine_of_turn(k, segments);
      const double scale = ring.scale * radius_of_unit_section(direction, section.squareness);
      vertices.push_back(point(axis, section.center_u + section.half_u * (scale * direction.cosine),
                               section.center_v + section.half_v * (scale * direction.sine), ring.position));
    }
  }
  vertices.push_back(pole(axis, sections.back()));
  return finished(name, std::move(vertices), pole_to_pole_faces(static_cast<Index>(rings.size()), segments));
}

}  // namespace pcm::generate
