// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// check() against CGAL's own tests of polygon soups and surfaces, on bodies damaged at random and on real surfaces.
//
// Both sides speak of these, and must agree in them exactly, face by face and edge by edge:
//   a vertex twice in a face, faces on one line, vertices of equal coordinates, unused vertices, edges of more than two
//   faces, vertices of more than one fan, inconsistent orientation, borders and their direction, components and which
//   are closed, components that look the wrong way for their nesting, and the verdicts fit and closed.
// The definitions differ in this, and the test takes account of it in the places named:
//   - An open surface is fit here; CGAL's tests of orientation and nesting want a closed one. They are asked about the
//     closed components alone, without the open ones (closed_part).
//   - An inward component within the bounding box of an open one is only warned of here, as a possible cavity; CGAL has
//     no such notion. The test sorts those out by CGAL's boxes (expected_inside_out).
//   - A surface that crosses or touches itself may be fit here; CGAL's orientation, read off at the topmost vertex, and
//     its nesting are defined only where nothing does. There the sign of the enclosed volume decides here, and CGAL's
//     exact volume is asked instead, where there is a single closed component; with several only the other findings are
//     compared (compare_orientation).
//   - CGAL says of an inside-out surface as a whole that it bounds a volume, the infinite one; here it is refused. So
//     the test wants the topmost component to look outward as well.
//   - Where an edge has more than two faces CGAL cuts the surface along it, and so finds several fans at its ends; here
//     the fans are joined there, for the edge is reported already. Pinched vertices are compared without such edges.
//   - CGAL's soups ignore where vertices are: vertices of equal coordinates don't keep it from calling a soup a mesh.
//     Here they are refused. CGAL counts them on their own.
//   - An empty soup is a mesh to CGAL and is refused here; indices out of range and coordinates that are not finite are
//     outside of CGAL's preconditions. None of the damages leads there.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "meshes/generate/boxes.h"
#include "meshes/generate/degenerate/bodies.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "meshes/generate/degenerate/lattice_tetrahedra.h"
#include "meshes/generate/round.h"
#include "pcm/check.h"
#include "pcm/read_mesh.h"
#include "pcm/write_obj.h"

namespace pcm {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polygon = std::vector<std::size_t>;
using Edge = std::array<Index, 2>;

// ---------------------------------------------------------------------------------------------------------- damage

/// Bodies and their damages, drawn without the library's distributions, which differ from one to another.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  std::size_t below(std::size_t n) { return random_() % n; }
  Index vertex(const TriangleMesh& mesh) { return static_cast<Index>(below(mesh.vertices.size())); }
  Index face(const TriangleMesh& mesh) { return static_cast<Index>(below(mesh.faces.size())); }
  std::uint64_t number() { return random_(); }

 private:
  std::mt19937_64 random_;
};

TriangleMesh moved(TriangleMesh mesh, double scale, const Eigen::Vector3d& shift) {
  for (Eigen::Vector3d& x : mesh.vertices) x = scale * x + shift;
  return mesh;
}

TriangleMesh draw_body(Draw& draw) {
  const TriangleMesh cube = generate::box({2, 2, 2});
  switch (draw.below(12)) {
    case 0:
      return cube;
    case 1:
      return generate::gridded_box(2, 2);
    case 2:
      return generate::icosphere(1, 0);
    case 3:
      return generate::icosphere(1, 1);
    case 4:
      return generate::torus(1, 0.375, 6, 4);
    case 5:
      return degenerate::hollow_cube(0.5);
    case 6:
      return degenerate::joined(cube, moved(generate::icosphere(1, 0), 1, {4, 0, 1}));
    case 7:
      return degenerate::open_box({2, 2, 2});
    case 8:
      return degenerate::lattice_tetrahedra(draw.number() % 1000)[0];
    case 9:
      return degenerate::joined(degenerate::hollow_cube(0.5), moved(cube, 0.0625, {0, 0, 0}));
    case 10:
      return degenerate::joined(degenerate::open_box({4, 4, 4}), cube);
    default:
      return degenerate::torus_chain(2, 1, 0.25, 4, 4);
  }
}

/// The faces that edges join to `first`; with a repeated vertex in it, all such faces.
std::vector<Index> component_of(const TriangleMesh& mesh, Index first) {
  const std::vector<Index> component = check(mesh).component_of_face;
  std::vector<Index> faces;
  for (std::size_t f = 0; f < component.size(); ++f)
    if (component[f] == component[first]) faces.push_back(static_cast<Index>(f));
  return faces;
}

/// A component of its own with the same shape, about its middle scaled down and shifted.
TriangleMesh copy_of_component(const TriangleMesh& mesh, Index first, double scale, const Eigen::Vector3d& shift) {
  const std::vector<Index> faces = component_of(mesh, first);
  std::map<Index, Index> renumbered;
  TriangleMesh copy;
  Eigen::Vector3d middle(0, 0, 0);
  for (const Index f : faces) {
    Triangle face{};
    for (int k = 0; k < 3; ++k) {
      const Index v = mesh.faces[f][k];
      const auto [it, is_new] = renumbered.insert({v, static_cast<Index>(copy.vertices.size())});
      if (is_new) {
        copy.vertices.push_back(mesh.vertices[v]);
        middle += mesh.vertices[v];
      }
      face[k] = it->second;
    }
    copy.faces.push_back(face);
  }
  middle /= static_cast<double>(copy.vertices.size());
  return moved(std::move(copy), scale, (1 - scale) * middle + shift);
}

Eigen::Vector3d draw_shift(Draw& draw) {
  const auto coordinate = [&] { return static_cast<double>(draw.below(33)) / 16 - 1; };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

void add(TriangleMesh& mesh, const TriangleMesh& component) {
  mesh = degenerate::joined(std::move(mesh), component);
}

/// One damage; its name is appended to the mesh's.
void damage(TriangleMesh& mesh, Draw& draw) {
  const Index f = draw.face(mesh);
  const Index v = draw.vertex(mesh);
  const Index w = draw.vertex(mesh);
  Triangle& face = mesh.faces[f];
  const auto note = [&](const char* what) { mesh.name += std::string("; ") + what; };
  switch (draw.below(19)) {
    case 0:
      note("reversed face");
      return std::swap(face[1], face[2]);
    case 1:
      note("dropped face");
      if (mesh.faces.size() > 1) mesh.faces.erase(mesh.faces.begin() + f);
      return;
    case 2:
      note("doubled face");
      return mesh.faces.push_back(Triangle(face));
    case 3:
      note("crack");
      mesh.vertices.push_back(Eigen::Vector3d(mesh.vertices[v]));
      for (Triangle& t : mesh.faces)
        if (draw.below(2) == 0) std::replace(t.begin(), t.end(), v, static_cast<Index>(mesh.vertices.size() - 1));
      return;
    case 4:
      note("merged vertices");
      for (Triangle& t : mesh.faces) std::replace(t.begin(), t.end(), v, w);
      return;
    case 5:
      note("vertex repeated in a face");
      face[draw.below(3)] = face[draw.below(3)];
      return;
    case 6:
      note("vertex put on another");
      mesh.vertices[v] = Eigen::Vector3d(mesh.vertices[w]);
      return;
    case 7:
      note("inverted component");
      for (const Index g : component_of(mesh, f)) std::swap(mesh.faces[g][1], mesh.faces[g][2]);
      return;
    case 8:
      note("all inverted");
      mesh = degenerate::inverted(std::move(mesh));
      return;
    case 9:
    case 10:
      note("smaller copy within, the same way up");
      return add(mesh, copy_of_component(mesh, f, 0.25, {0, 0, 0}));
    case 11:
    case 12:
      note("smaller copy within, inverted");
      return add(mesh, degenerate::inverted(copy_of_component(mesh, f, 0.25, {0, 0, 0})));
    case 13:
      note("stray face between vertices");
      return mesh.faces.push_back({v, w, draw.vertex(mesh)});
    case 14: {
      note("pinched to its mirror image");
      TriangleMesh mirrored = degenerate::inverted(copy_of_component(mesh, f, -1, {0, 0, 0}));
      const Index image = static_cast<Index>(mesh.vertices.size());
      const Eigen::Vector3d shift = mesh.vertices[face[0]] - mirrored.vertices[0];
      const Index shared = face[0];
      add(mesh, moved(std::move(mirrored), 1, shift));
      for (Triangle& t : mesh.faces) std::replace(t.begin(), t.end(), image, shared);
      return;
    }
    case 15:
      note("face on one line");
      mesh.vertices[face[0]] = (mesh.vertices[face[1]] + mesh.vertices[face[2]]) / 2;
      return;
    case 16:
      note("unused vertex");
      return mesh.vertices.push_back({5, 6, 7});
    case 17:
      note("shifted vertex");
      mesh.vertices[v] += draw_shift(draw);
      return;
    default:
      note("shifted copy");
      return add(mesh, copy_of_component(mesh, f, 1, draw_shift(draw)));
  }
}

// ------------------------------------------------------------------------------------------------------- CGAL's view

struct Soup {
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
};

Soup soup_of(const TriangleMesh& mesh) {
  Soup soup;
  for (const Eigen::Vector3d& x : mesh.vertices) soup.points.emplace_back(x[0], x[1], x[2]);
  for (const auto& [a, b, c] : mesh.faces)
    soup.polygons.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c)});
  return soup;
}

Mesh mesh_of(const Soup& soup) {
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return mesh;
}

/// What CGAL meets when it orients a soup.
struct Findings {
  std::map<Edge, std::size_t> non_manifold_edges;  ///< with how many faces
  std::set<Index> non_manifold_vertices;
  std::set<Index> reversed_faces;
};

struct Visitor : PMP::Default_orientation_visitor {
  Findings* findings = nullptr;
  std::vector<Index> const* face_numbers = nullptr;

  void non_manifold_edge(std::size_t a, std::size_t b, std::size_t faces) const {
    findings->non_manifold_edges[{static_cast<Index>(std::min(a, b)), static_cast<Index>(std::max(a, b))}] = faces;
  }
  void non_manifold_vertex(std::size_t v, std::size_t) const {
    findings->non_manifold_vertices.insert(static_cast<Index>(v));
  }
  void polygon_orientation_reversed(std::size_t f) const { findings->reversed_faces.insert((*face_numbers)[f]); }
};

/// Without the faces of a repeated vertex, which CGAL takes for no polygons.
Findings orient(const Soup& soup, const std::vector<Index>& repeated_vertex_faces) {
  Soup usable{soup.points, {}};
  std::vector<Index> face_numbers;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    if (std::binary_search(repeated_vertex_faces.begin(), repeated_vertex_faces.end(), static_cast<Index>(f))) continue;
    usable.polygons.push_back(soup.polygons[f]);
    face_numbers.push_back(static_cast<Index>(f));
  }
  Findings findings;
  Visitor visitor;
  visitor.findings = &findings;
  visitor.face_numbers = &face_numbers;
  PMP::orient_polygon_soup(usable.points, usable.polygons, CGAL::parameters::visitor(visitor));
  return findings;
}

/// The closed components of a mesh as a mesh, and the number of each in the whole.
struct ClosedPart {
  Mesh mesh;
  std::vector<Index> components;
};

ClosedPart closed_part(const Soup& soup, const std::vector<Index>& component_of_face, const std::vector<bool>& closed) {
  Soup part{soup.points, {}};
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    if (closed[component_of_face[f]]) part.polygons.push_back(soup.polygons[f]);
  PMP::remove_isolated_points_in_polygon_soup(part.points, part.polygons);
  ClosedPart result{mesh_of(part), {}};
  for (std::size_t c = 0; c < closed.size(); ++c)
    if (closed[c]) result.components.push_back(static_cast<Index>(c));
  return result;
}

/// A component that looks the wrong way: its number, how many enclose it, the sign of its volume.
using WrongWay = std::tuple<Index, Index, int>;

/// CGAL's wrong components of a part that neither crosses nor touches itself. Nesting and orientation are asked for one
/// by one: where both are wrong, CGAL 5.5 fails an assertion of its own over the numbers of volumes.
std::vector<WrongWay> find_wrong_ways(ClosedPart& part, const Soup& soup, const std::vector<Index>& component_of_face,
                                      std::size_t component_count) {
  std::vector<std::size_t> levels;
  auto volume = part.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:volume").first;
  PMP::volume_connected_components(part.mesh, volume,
                                   CGAL::parameters::do_orientation_tests(false).nesting_levels(std::ref(levels)));
  EXPECT_EQ(levels.size(), part.components.size());
  std::vector<WrongWay> wrong;
  for (std::size_t c = 0; c < levels.size(); ++c) {
    std::vector<bool> alone(component_count, false);
    alone[part.components[c]] = true;
    const bool outward = PMP::is_outward_oriented(closed_part(soup, component_of_face, alone).mesh);
    if (outward != (levels[c] % 2 == 0))
      wrong.emplace_back(part.components[c], static_cast<Index>(levels[c]), outward ? 1 : -1);
  }
  return wrong;
}

/// The sign of the volume of a closed mesh, in rational numbers.
int exact_volume_sign(const Mesh& mesh) {
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto exact = [&](Mesh::Vertex_index v) {
    const Kernel::Point_3& p = mesh.point(v);
    return Exact::Point_3(p.x(), p.y(), p.z());
  };
  CGAL::Exact_rational volume = 0;
  for (const Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    volume += CGAL::volume(Exact::Point_3(0, 0, 0), exact(mesh.source(h)), exact(mesh.target(h)),
                           exact(mesh.target(mesh.next(h))));
  }
  return CGAL::sign(volume);
}

// -------------------------------------------------------------------------------------------------------- comparison

/// How often what was met.
using Tally = std::map<std::string, int>;

void compare_vertices_and_faces(const Soup& soup, const MeshReport& report) {
  std::vector<Index> repeated;
  std::vector<Index> collinear;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon& p = soup.polygons[f];
    if (!PMP::is_polygon_soup_a_polygon_mesh(std::vector<Polygon>{p})) {
      repeated.push_back(static_cast<Index>(f));
    } else if (CGAL::collinear(soup.points[p[0]], soup.points[p[1]], soup.points[p[2]])) {
      collinear.push_back(static_cast<Index>(f));
    }
  }
  EXPECT_EQ(report.repeated_vertex_faces, repeated);
  EXPECT_EQ(report.zero_area_faces, collinear);
  Soup without_unused = soup;
  EXPECT_EQ(report.unused_vertices.size(),
            PMP::remove_isolated_points_in_polygon_soup(without_unused.points, without_unused.polygons));
  Soup merged = soup;
  EXPECT_EQ(report.duplicate_vertices.size(),
            PMP::merge_duplicate_points_in_polygon_soup(merged.points, merged.polygons));
  for (const auto& [first, later] : report.duplicate_vertices) EXPECT_EQ(soup.points[first], soup.points[later]);
}

void compare_edges_and_fans(const Soup& soup, const MeshReport& report) {
  const Findings findings = orient(soup, report.repeated_vertex_faces);
  std::map<Edge, std::size_t> non_manifold_edges;
  for (const EdgeFaces& edge : report.non_manifold_edges) non_manifold_edges[edge.edge] = edge.faces.size();
  EXPECT_EQ(non_manifold_edges, findings.non_manifold_edges);
  if (non_manifold_edges.empty()) {
    const std::set<Index> pinched(report.pinched_vertices.begin(), report.pinched_vertices.end());
    EXPECT_EQ(pinched, findings.non_manifold_vertices);
  }
  EXPECT_EQ(report.flipped_edges.empty(), findings.reversed_faces.empty());
  for (const EdgeFaces& edge : report.flipped_edges)
    EXPECT_NE(findings.reversed_faces.contains(edge.faces[0]), findings.reversed_faces.contains(edge.faces[1]));
  const bool torn = !findings.reversed_faces.empty() || !findings.non_manifold_edges.empty();
  EXPECT_FALSE(torn && report.closed());
  EXPECT_EQ(PMP::is_polygon_soup_a_polygon_mesh(soup.polygons),
            report.repeated_vertex_faces.empty() && report.non_manifold_edges.empty() &&
                report.pinched_vertices.empty() && report.flipped_edges.empty());
}

/// Borders, components and which are closed; returns those.
std::vector<bool> compare_components(Mesh& mesh, const MeshReport& report) {
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t count = PMP::connected_components(mesh, component);
  std::vector<bool> closed(count, true);
  std::set<Edge> borders;
  for (const Mesh::Halfedge_index h : mesh.halfedges()) {
    if (!mesh.is_border(h)) continue;
    const auto of_face = mesh.opposite(h);
    closed[component[mesh.face(of_face)]] = false;
    borders.insert({static_cast<Index>(mesh.source(of_face).idx()), static_cast<Index>(mesh.target(of_face).idx())});
  }
  EXPECT_EQ(std::set<Edge>(report.border_edges.begin(), report.border_edges.end()), borders);
  EXPECT_EQ(report.border_edges.size(), borders.size());
  EXPECT_EQ(report.closed(), CGAL::is_closed(mesh));
  EXPECT_EQ(report.component_count, static_cast<Index>(count));
  EXPECT_EQ(report.closed_component_count, std::count(closed.begin(), closed.end(), true));
  for (const Mesh::Face_index f : mesh.faces())
    EXPECT_EQ(report.component_of_face[f], static_cast<Index>(component[f])) << "face " << f.idx();
  return closed;
}

std::vector<WrongWay> as_wrong_ways(const std::vector<InsideOutComponent>& components) {
  std::vector<WrongWay> result;
  for (const InsideOutComponent& c : components) result.emplace_back(c.component, c.enclosing, c.volume_sign);
  return result;
}

/// Of the wrong ones those that do not look inward, or that no open component's box has room for.
std::vector<WrongWay> expected_inside_out(const std::vector<WrongWay>& wrong, const Soup& soup,
                                          const MeshReport& report, const std::vector<bool>& closed) {
  std::vector<CGAL::Bbox_3> boxes(closed.size());
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (const std::size_t v : soup.polygons[f]) boxes[report.component_of_face[f]] += soup.points[v].bbox();
  std::vector<WrongWay> certain;
  for (const WrongWay& candidate : wrong) {
    const CGAL::Bbox_3& box = boxes[std::get<0>(candidate)];
    bool in_open_one = false;
    for (std::size_t c = 0; c < closed.size(); ++c)
      in_open_one = in_open_one || (!closed[c] && boxes[c] + box == boxes[c]);
    if (!in_open_one || std::get<2>(candidate) >= 0) certain.push_back(candidate);
  }
  return certain;
}

/// Orientation and nesting of the closed components.
void compare_orientation(const Soup& soup, const MeshReport& report, const std::vector<bool>& closed, Tally& tally) {
  ClosedPart part = closed_part(soup, report.component_of_face, closed);
  if (part.components.empty()) return;
  const bool crosses_itself = PMP::does_self_intersect(part.mesh);
  std::vector<WrongWay> wrong;
  if (!crosses_itself) {
    ++tally["orientation compared"];
    wrong = find_wrong_ways(part, soup, report.component_of_face, closed.size());
    EXPECT_EQ(wrong.empty(), PMP::does_bound_a_volume(part.mesh) && PMP::is_outward_oriented(part.mesh));
    for (const auto& [component, level, sign] : wrong) ++tally["wrong way at level " + std::to_string(level)];
    if (wrong.empty() && part.components.size() > 1) ++tally["several closed components, all the right way"];
  } else if (part.components.size() == 1) {
    ++tally["orientation of a surface that crosses itself compared by volume"];
    const int sign = exact_volume_sign(part.mesh);
    if (sign <= 0) wrong.emplace_back(part.components[0], 0, sign);
  } else {
    ++tally["orientation not compared"];
    return;
  }
  EXPECT_EQ(as_wrong_ways(report.inside_out), expected_inside_out(wrong, soup, report, closed));
  EXPECT_EQ(report.inside_out.size() + report.possible_cavities.size(), wrong.size());
}

void count_outcomes(const MeshReport& report, Tally& tally) {
  static const std::map<MeshIssueKind, std::string> names = {
      {MeshIssueKind::repeated_vertices, "vertex twice in a face"},
      {MeshIssueKind::zero_area_faces, "face of zero area"},
      {MeshIssueKind::duplicate_vertices, "duplicate vertex"},
      {MeshIssueKind::non_manifold_edges, "edge of more than two faces"},
      {MeshIssueKind::pinched_vertices, "pinched vertex"},
      {MeshIssueKind::inconsistent_orientation, "inconsistent orientation"},
      {MeshIssueKind::inside_out_components, "inside out"},
      {MeshIssueKind::possible_cavities, "possible cavity"},
      {MeshIssueKind::unused_vertices, "unused vertex"},
      {MeshIssueKind::border_edges, "border"},
  };
  ++tally[!report.fit() ? "unfit" : report.closed() ? "fit and closed" : "fit and open"];
  std::vector<MeshIssueKind> errors;
  for (const MeshIssue& issue : report.issues()) {
    if (issue.severity == Severity::error) {
      errors.push_back(issue.kind);
    } else {
      ++tally[names.at(issue.kind)];
    }
  }
  EXPECT_EQ(report.fit(), errors.empty());
  for (const MeshIssueKind kind : errors) ++tally[(errors.size() == 1 ? "only " : "among others ") + names.at(kind)];
}

void compare(const TriangleMesh& damaged, Tally& tally) {
  const MeshReport report = check(damaged);
  const Soup soup = soup_of(damaged);
  count_outcomes(report, tally);
  compare_vertices_and_faces(soup, report);
  compare_edges_and_fans(soup, report);
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    EXPECT_FALSE(report.fit());
    return;
  }
  Mesh mesh = mesh_of(soup);
  const std::vector<bool> closed = compare_components(mesh, report);
  // CGAL's tests of intersection and orientation want faces with an area.
  if (!report.zero_area_faces.empty()) return;
  compare_orientation(soup, report, closed, tally);
  EXPECT_EQ(report.fit(), report.duplicate_vertices.empty() && report.inside_out.empty());
  if (report.fit() && PMP::does_self_intersect(mesh)) ++tally["fit though it crosses itself"];
}

TEST(MeshFitness, OfDamagedBodiesIsThatOfCgal) {
  constexpr std::uint64_t kSeed = 20031;
  constexpr int kMeshes = 20000;
  std::cout << kMeshes << " meshes of seed " << kSeed << '\n';
  Draw draw(kSeed);
  Tally tally;
  for (int i = 0; i < kMeshes && !testing::Test::HasFailure(); ++i) {
    TriangleMesh mesh = draw_body(draw);
    mesh.name = "mesh " + std::to_string(i) + ", " + mesh.name;
    for (std::size_t damages = 1 + draw.below(3); damages > 0; --damages) damage(mesh, draw);
    SCOPED_TRACE(mesh.name);
    compare(mesh, tally);
    if (testing::Test::HasFailure()) std::cout << check(mesh).summary() << '\n' << format_obj(mesh);
  }
  for (const auto& [outcome, count] : tally) std::cout << count << ' ' << outcome << '\n';

  for (const char* outcome :
       {"fit and closed", "fit and open", "only vertex twice in a face", "only face of zero area",
        "only duplicate vertex", "only edge of more than two faces", "only pinched vertex",
        "only inconsistent orientation", "only inside out", "possible cavity", "unused vertex", "border",
        "wrong way at level 0", "wrong way at level 1", "several closed components, all the right way",
        "orientation of a surface that crosses itself compared by volume", "fit though it crosses itself"})
    EXPECT_GE(tally[outcome], 100) << outcome;
  EXPECT_GE(tally["orientation compared"], kMeshes / 5);
}

/// The surfaces of libcgal-demo: also those that are open, cracked, shuffled or inside out.
TEST(MeshFitness, OfRealSurfacesIsThatOfCgal) {
  const std::filesystem::path folder = PCM_REAL_SURFACES_DIR;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no real surfaces in " << folder << ": ./run fetches them";
  constexpr std::size_t kMostFaces = 35000;  // more take CGAL longer than they show
  Tally tally;
  int compared = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".off") continue;
    // This one has more lines than its header counts.
    if (file.path().filename() == "prim.off") continue;
    SCOPED_TRACE(file.path().filename().string());
    const TriangleMesh mesh = read_mesh(file.path());
    if (mesh.faces.size() > kMostFaces) continue;
    compare(mesh, tally);
    ++compared;
  }
  std::cout << compared << " surfaces\n";
  for (const auto& [outcome, count] : tally) std::cout << count << ' ' << outcome << '\n';

  EXPECT_GE(compared, 100);
  for (const char* outcome :
       {"fit and closed", "fit and open", "only face of zero area", "only duplicate vertex", "only pinched vertex",
        "only inconsistent orientation", "only inside out", "possible cavity", "unused vertex", "border",
        "wrong way at level 0", "several closed components, all the right way",
        "orientation of a surface that crosses itself compared by volume", "fit though it crosses itself"})
    EXPECT_GE(tally[outcome], 1) << outcome;
}

}  // namespace
}  // namespace pcm
