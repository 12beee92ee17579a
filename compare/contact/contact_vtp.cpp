// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/contact/contact_vtp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <utility>

#include "compare/io/create_folder.h"
#include "meshes/files/text_file.h"

namespace pcm::compare {
namespace {

constexpr const char* kContacts = "contacts.pvd";

void append(std::vector<double>& numbers, const Eigen::Vector3d& x) {
  numbers.insert(numbers.end(), x.data(), x.data() + 3);
}

/// One number, or one vector, an element.
template <class Value>
VtpArray array_of(const std::vector<fast::Element>& elements, const std::string& name, Value value) {
  std::vector<double> numbers;
  for (const fast::Element& e : elements) numbers.push_back(value(e));
  return {name, 1, std::move(numbers)};
}
VtpArray array_of(const std::vector<fast::Element>& elements, const std::string& name,
                  Eigen::Vector3d fast::Element::*vector) {
  std::vector<double> numbers;
  for (const fast::Element& e : elements) append(numbers, e.*vector);
  return {name, 3, std::move(numbers)};
}
template <class Number>
VtpArray numbers_of(const std::vector<fast::Element>& elements, const std::string& name, Number number) {
  std::vector<std::int32_t> numbers;
  for (const fast::Element& e : elements) numbers.push_back(number(e));
  return {name, 1, std::move(numbers)};
}

const std::filesystem::path& created(const std::filesystem::path& folder) {
  create_folder(folder);
  return folder;
}

std::int32_t number_of(Side side) {
  return side == Side::E ? 0 : 1;
}

}  // namespace

VtpPolyData surface_vtp(const ContactRecord& record, const PlacedSurfaces& placed, Side side) {
  const std::vector<Triangle>& faces = placed.mesh(side).faces;
  std::vector<double> points;
  for (const Eigen::Vector3d& x : placed.vertices_Me(side)) append(points, x);
  VtpPolyData data;
  data.points.values = std::move(points);
  for (const Triangle& face : faces) {
    data.polygons.corners.insert(data.polygons.corners.end(), face.begin(), face.end());
    data.polygons.end_cell();
  }
  std::vector<std::int32_t> active(faces.size(), 0);
  const AreaRecord& area = side == Side::E ? record.E : record.F;
  for (const Index f : area.intersected) active[static_cast<std::size_t>(f)] = 1;
  for (const Index f : area.inner) active[static_cast<std::size_t>(f)] = 2;
  std::vector<double> pressures(faces.size(), 0), penetrations(faces.size(), 0);
  std::vector<bool> carries(faces.size(), false);
  for (const fast::Element& e : record.elements) {
    if (e.master != side) continue;
    const auto f = static_cast<std::size_t>(e.master_face);
    pressures[f] = carries[f] ? std::max(pressures[f], pressure(e)) : pressure(e);
    penetrations[f] = std::max(penetrations[f], e.penetration);
    carries[f] = true;
  }
  data.cell_data = {{"pressure", 1, std::move(pressures)},
                    {"penetration", 1, std::move(penetrations)},
                    {"active", 1, std::move(active)}};
  data.scalars = "pressure";
  return data;
}

VtpPolyData polygons_vtp(const ContactRecord& record) {
  VtpPolyData data;
  std::vector<double> points;
  std::vector<std::int32_t> edge_of, edges, faces, closed, patches;
  std::int32_t next = 0;
  for (const PolygonRecord& polygon : record.polygons) {
    const std::int32_t first = next;
    for (const fast::Crossing& x : polygon.points) {
      append(points, x.position_Me);
      edge_of.push_back(number_of(x.edge_side));
      edges.insert(edges.end(), x.edge.begin(), x.edge.end());
      faces.push_back(x.face);
      data.lines.corners.push_back(next++);
    }
    if (polygon.closed) data.lines.corners.push_back(first);
    data.lines.end_cell();
    closed.push_back(polygon.closed ? 1 : 0);
    patches.push_back(polygon.patch);
  }
  data.points.values = std::move(points);
  data.point_data = {{"edge_of", 1, std::move(edge_of)}, {"edge", 2, std::move(edges)}, {"face", 1, std::move(faces)}};
  data.cell_data = {{"closed", 1, std::move(closed)}, {"patch", 1, std::move(patches)}};
  return data;
}

VtpPolyData elements_vtp(const ContactRecord& record) {
  using fast::Element;
  const std::vector<Element>& elements = record.elements;
  VtpPolyData data;
  data.points.values = array_of(elements, "points", &Element::position_Me).values;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(elements.size()); ++i) {
    data.vertices.corners.push_back(i);
    data.vertices.end_cell();
  }
  const auto plain = [&](const std::string& name, double Element::*number) {
    return array_of(elements, name, [number](const Element& e) { return e.*number; });
  };
  data.point_data = {array_of(elements, "pressure", pressure),
                     plain("penetration", &Element::penetration),
                     plain("area", &Element::area),
                     plain("normal_velocity", &Element::normal_velocity),
                     plain("tangential_velocity", &Element::tangential_velocity),
                     plain("normal_force", &Element::normal_force),
                     plain("tangential_force", &Element::tangential_force),
                     array_of(elements, "normal", &Element::normal_Me),
                     array_of(elements, "force", &Element::force_Me),
                     numbers_of(elements, "master", [](const Element& e) { return number_of(e.master); }),
                     numbers_of(elements, "master_face", [](const Element& e) { return e.master_face; }),
                     numbers_of(elements, "slave_face", [](const Element& e) { return e.slave_face; })};
  data.scalars = "pressure";
  return data;
}

bool is_name_in_vtp_folder(const std::string& file) {
  static const std::regex part("(E|F|polygons|elements)_[0-9]+\\.vtp");
  return file == kContacts || std::regex_match(file, part);
}

ContactVtpFolder::ContactVtpFolder(std::filesystem::path folder)
    : folder_(std::move(folder)), contacts_(created(folder_) / kContacts) {}

void ContactVtpFolder::write(const ContactRecord& record, const PlacedSurfaces& placed, bool with_polygons) {
  ++contact_;
  std::vector<PvdEntry> parts{write_part(0, "E", surface_vtp(record, placed, Side::E)),
                              write_part(1, "F", surface_vtp(record, placed, Side::F))};
  if (with_polygons) parts.push_back(write_part(2, "polygons", polygons_vtp(record)));
  parts.push_back(write_part(3, "elements", elements_vtp(record)));
  contacts_.add(parts);
}

PvdEntry ContactVtpFolder::write_part(int part, const std::string& name, const VtpPolyData& data) const {
  const std::string file = fmt::format("{}_{}.vtp", name, contact_);
  write_text_file(folder_ / file, vtp(data));
  return {static_cast<double>(contact_), part, file};
}

}  // namespace pcm::compare
