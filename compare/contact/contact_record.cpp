// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/contact_record.h"

#include "fast/force/statistics_sum.h"

namespace pcm::compare {
namespace {

template <class ActiveArea>
AreaRecord area_record(const ActiveArea& active, const Knowledge& known) {
  AreaRecord record{active.intersected, active.inner, {}, {}};
  if (known.areas) {
    record.area = active.area;
    record.vector_area_Me = active.vector_area_Me;
  }
  return record;
}

/// What both result types name alike.
template <class Result>
ContactRecord common_record(const Result& result, const Knowledge& known) {
  ContactRecord record;
  record.known = known;
  record.touching = result.touching;
  record.nested = result.nested;
  record.ambiguous = result.ambiguous;
  record.patches = result.patches;
  record.E = area_record(result.E, known);
  record.F = area_record(result.F, known);
  record.too_deep = result.too_deep;
  record.max_penetration = result.max_penetration;
  record.penetration_exceeded = result.penetration_exceeded;
  record.force_Me = result.force_Me;
  record.torque_Me = result.torque_Me;
  return record;
}

fast::Element element_record(const reference::Element& e) {
  fast::Element element;
  element.master = e.master;
  element.master_face = e.master_face;
  element.slave_face = e.slave_face;
  element.area = e.area;
  element.penetration = e.penetration;
  element.normal_velocity = e.normal_velocity;
  element.tangential_velocity = e.tangential_velocity;
  element.normal_force = e.normal_force;
  element.tangential_force = e.tangential_force;
  element.normal_Me = e.normal_Me;
  element.position_Me = e.position_Me;
  element.force_Me = e.force_Me;
  return element;
}

}  // namespace

ContactRecord contact_record(const fast::Contact& contact, const Knowledge& known) {
  ContactRecord record = common_record(contact, known);
  for (const fast::Polygon& polygon : contact.polygons) {
    const auto first = contact.crossings.begin() + polygon.first;
    record.polygons.push_back({polygon.closed, polygon.patch, {first, first + polygon.count}});
  }
  if (contact.has_volume) record.volume = contact.volume;
  record.undefined_areas = contact.undefined_areas;
  record.elements = contact.elements;
  record.statistics = contact.statistics;
  return record;
}

ContactRecord contact_record(const reference::Answer& answer) {
  ContactRecord record = common_record(answer, {});
  for (const reference::Polygon& polygon : answer.polygons) {
    PolygonRecord& copy = record.polygons.emplace_back();
    copy.closed = polygon.closed;
    copy.patch = polygon.patch;
    for (const reference::Crossing& x : polygon.points)
      copy.points.push_back({x.edge_side, x.edge, x.face, x.position_Me});
  }
  record.volume = answer.volume;
  record.undefined_areas = answer.undefined_areas;
  fast::StatisticsSum statistics;
  for (const reference::Element& e : answer.elements) statistics.add(record.elements.emplace_back(element_record(e)));
  record.statistics = statistics.result();
  return record;
}

double pressure(const fast::Element& element) {
  return element.area > 0 ? element.normal_force / element.area : 0;
}

}  // namespace pcm::compare
