// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "pcm/bad_input.h"
#include "pcm/check.h"

namespace pcm {
namespace {

/// The number a vertex or face has in an OBJ file.
std::string number(Index i) {
  return std::to_string(std::int64_t{i} + 1);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// The first few elements, each as `describe` has it, and how many more there are.
template <typename Element, typename Describe>
std::string first_few(const std::vector<Element>& elements, const Describe& describe) {
  constexpr std::size_t kShown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(elements.size(), kShown); ++i) {
    if (i > 0) text += ", ";
    text += describe(elements[i]);
  }
  if (elements.size() > kShown) text += " and " + std::to_string(elements.size() - kShown) + " more";
  return text;
}

std::string describe_edge(const std::array<Index, 2>& edge) {
  return number(edge[0]) + "-" + number(edge[1]);
}

std::string describe_edge_with_faces(const EdgeFaces& edge) {
  return describe_edge(edge.edge) + " (faces " + first_few(edge.faces, number) + ")";
}

std::string describe_duplicate(const std::array<Index, 2>& pair) {
  return number(pair[1]) + " (as " + number(pair[0]) + ")";
}

std::string describe_inside_out(const InsideOutComponent& component) {
  std::string text = "the one of face " + number(component.first_face) + " (";
  text += counted(static_cast<std::size_t>(component.face_count), "face", "faces");
  if (component.volume_sign == 0) text += ", encloses no volume";
  if (component.enclosing > 0) {
    text += ", enclosed by ";
    text += counted(static_cast<std::size_t>(component.enclosing), "other", "others");
  }
  return text + ")";
}

/// Collects issues of which there are any.
class IssueList {
 public:
  void add(MeshIssueKind kind, Severity severity, std::size_t count, std::string text) {
    if (count > 0) issues_.push_back({kind, severity, count, std::move(text)});
  }

  template <typename Element, typename Describe>
  void add(MeshIssueKind kind, Severity severity, const std::vector<Element>& elements, const std::string& one,
           const std::string& many, const Describe& describe, const std::string& remedy) {
    if (elements.empty()) return;
    std::string text = counted(elements.size(), one, many);
    text += ": ";
    text += first_few(elements, describe);
    text += remedy;
    add(kind, severity, elements.size(), std::move(text));
  }

  std::vector<MeshIssue> take() { return std::move(issues_); }

 private:
  std::vector<MeshIssue> issues_;
};

}  // namespace

bool MeshReport::fit() const {
  return face_count > 0 && non_finite_vertices.empty() && out_of_range_faces.empty() && repeated_vertex_faces.empty() &&
         zero_area_faces.empty() && duplicate_vertices.empty() && non_manifold_edges.empty() &&
         pinched_vertices.empty() && flipped_edges.empty() && inside_out.empty();
}

bool MeshReport::closed() const {
  return component_count > 0 && closed_component_count == component_count && out_of_range_faces.empty() &&
         repeated_vertex_faces.empty();
}

std::vector<MeshIssue> MeshReport::issues() const {
  IssueList list;
  list.add(MeshIssueKind::no_faces, Severity::error, face_count == 0 ? 1 : 0,
           "the surface has no face; export it with its faces");
  list.add(MeshIssueKind::non_finite_vertices, Severity::error, non_finite_vertices,
           "vertex with a coordinate that is not finite", "vertices with a coordinate that is not finite", number,
           "; correct the coordinates");
  list.add(MeshIssueKind::indices_out_of_range, Severity::error, out_of_range_faces,
           "face that refers to a vertex that doesn't exist", "faces that refer to a vertex that doesn't exist", number,
           "; correct the indices or remove the faces");
  list.add(MeshIssueKind::repeated_vertices, Severity::error, repeated_vertex_faces,
           "face that has the same vertex twice", "faces that have the same vertex twice", number,
           "; remove such faces");
  list.add(MeshIssueKind::zero_area_faces, Severity::error, zero_area_faces, "face of zero area", "faces of zero area",
           number, "; move one of the three vertices off their common line, or collapse the face's shortest edge");
  list.add(MeshIssueKind::duplicate_vertices, Severity::error, duplicate_vertices, "duplicate vertex",
           "duplicate vertices", describe_duplicate,
           "; merge vertices of equal coordinates: where borders meet in them this closes a crack");
  list.add(MeshIssueKind::non_manifold_edges, Severity::error, non_manifold_edges, "edge of more than two faces",
           "edges of more than two faces", describe_edge_with_faces,
           "; remove the surplus faces, or move apart the bodies that touch there and give each its own vertices");
  list.add(MeshIssueKind::pinched_vertices, Severity::error, pinched_vertices,
           "vertex in which parts of the surface touch", "vertices in which parts of the surface touch", number,
           "; give each fan of faces a vertex of its own, at another place");
  list.add(MeshIssueKind::inconsistent_orientation, Severity::error, flipped_edges,
           "edge between faces of opposite orientation", "edges between faces of opposite orientation",
           describe_edge_with_faces, "; reverse the order of the vertices of the faces that look inward");
  list.add(
      MeshIssueKind::inside_out_components, Severity::error, inside_out, "closed component that is inside out",
      "closed components that are inside out", describe_inside_out,
      "; reverse the order of the vertices of all its faces (outer shells look outward, cavities inward), or remove "
      "it where it encloses no volume");
  list.add(MeshIssueKind::possible_cavities, Severity::warning, possible_cavities, "closed component that looks inward",
           "closed components that look inward", describe_inside_out,
           "; reverse the order of the vertices of all its faces unless it is a cavity of the open part around it");
  list.add(MeshIssueKind::unused_vertices, Severity::warning, unused_vertices, "vertex that no face uses",
           "vertices that no face uses", number, "; they may be removed");
  list.add(MeshIssueKind::border_edges, Severity::note, border_edges, "border edge", "border edges", describe_edge,
           "; the surface is open there");
  return list.take();
}

std::string MeshReport::summary() const {
  std::string text = name.empty() ? "surface" : name;
  text += fit() ? (closed() ? ": fit for contact, closed" : ": fit for contact, open") : ": not fit for contact";
  text += "\n  " + counted(static_cast<std::size_t>(vertex_count), "vertex", "vertices");
  text += ", " + counted(static_cast<std::size_t>(face_count), "face", "faces");
  text += ", " + counted(static_cast<std::size_t>(component_count), "component", "components");
  text += " (" + std::to_string(closed_component_count) + " closed)";
  for (const MeshIssue& issue : issues()) {
    const char* label = issue.severity == Severity::error     ? "error: "
                        : issue.severity == Severity::warning ? "warning: "
                                                              : "note: ";
    text.append("\n  ").append(label).append(issue.text);
  }
  return text;
}

void require_fit(const MeshReport& report) {
  if (report.fit()) return;
  std::string message = report.name.empty() ? "the surface" : report.name;
  message += ": not fit for contact: ";
  bool first = true;
  for (const MeshIssue& issue : report.issues()) {
    if (issue.severity != Severity::error) continue;
    if (!first) message += ". Also: ";
    message += issue.text;
    first = false;
  }
  throw BadInput(message);
}

void require_fit(const TriangleMesh& mesh) {
  require_fit(check(mesh));
}

}  // namespace pcm
