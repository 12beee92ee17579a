// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/validity/enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "meshes/exact/exact_signs.h"

namespace pcm {
namespace {

/// The faces of all components, sorted into square columns along z so that only those above or below a point are looked
/// at. A face is in every column its bounding box meets.
class Columns {
 public:
  Columns(const TriangleMesh& mesh, const std::vector<Index>& component_of_face) : mesh_(mesh) {
    std::size_t face_count = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (component_of_face[f] < 0) continue;
      ++face_count;
      for (const Index v : mesh.faces[f]) {
        low_ = low_.cwiseMin(mesh.vertices[v].head<2>());
        high_ = high_.cwiseMax(mesh.vertices[v].head<2>());
      }
    }
    // As many columns as faces; fewer where long faces would be entered too often.
    side_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(face_count))) + 1;
    while (side_ > 1 && count_entries(component_of_face, 8 * face_count + 64) > 8 * face_count + 64) side_ /= 2;
    fill(component_of_face);
  }

  std::span<const Index> at(const Eigen::Vector3d& p) const {
    const std::size_t column = cell(p.x(), 0) * side_ + cell(p.y(), 1);
    return std::span(faces_).subspan(starts_[column], starts_[column + 1] - starts_[column]);
  }

  /// Calls `action(face)` for all faces in a column of this one, for some of them several times.
  template <class Action>
  void for_each_near(Index face, const Action& action) const {
    const Range cells = range(static_cast<std::size_t>(face));
    for (std::size_t x = cells.x0; x <= cells.x1; ++x)
      for (std::size_t y = cells.y0; y <= cells.y1; ++y)
        for (std::size_t i = starts_[x * side_ + y]; i < starts_[x * side_ + y + 1]; ++i) action(faces_[i]);
  }

 private:
  struct Range {
    std::size_t x0, x1, y0, y1;
    std::size_t count() const { return (x1 - x0 + 1) * (y1 - y0 + 1); }
  };

  /// Monotonic in the coordinate, so that no point of a face lies outside of its range of cells. Halved, so that the
  /// width of the surface can't overflow.
  std::size_t cell(double coordinate, int axis) const {
    const double width = high_[axis] / 2 - low_[axis] / 2;
    const double position = (coordinate / 2 - low_[axis] / 2) / width * static_cast<double>(side_);
    if (!(position > 0)) return 0;
    return position < static_cast<double>(side_) ? static_cast<std::size_t>(position) : side_ - 1;
  }

  Range range(std::size_t f) const {
    const Triangle& face = mesh_.faces[f];
    const auto& [a, b, c] = face;
    const Eigen::Vector3d low = mesh_.vertices[a].cwiseMin(mesh_.vertices[b]).cwiseMin(mesh_.vertices[c]);
    const Eigen::Vector3d high = mesh_.vertices[a].cwiseMax(mesh_.vertices[b]).cwiseMax(mesh_.vertices[c]);
    return {cell(low.x(), 0), cell(high.x(), 0), cell(low.y(), 1), cell(high.y(), 1)};
  }

  std::size_t count_entries(const std::vector<Index>& component_of_face, std::size_t enough) const {
    std::size_t entries = 0;
    for (std::size_t f = 0; f < mesh_.faces.size() && entries <= enough; ++f)
      if (component_of_face[f] >= 0) entries += range(f).count();
    return entries;
  }

  void fill(const std::vector<Index>& component_of_face) {
    const auto for_each_entry = [&](const auto& action) {
      for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
        if (component_of_face[f] < 0) continue;
        const Range cells = range(f);
        for (std::size_t x = cells.x0; x <= cells.x1; ++x)
          for (std::size_t y = cells.y0; y <= cells.y1; ++y) action(x * side_ + y, static_cast<Index>(f));
      }
    };
    starts_.assign(side_ * side_ + 1, 0);
    for_each_entry([&](std::size_t column, Index) { ++starts_[column + 1]; });
    for (std::size_t i = 0; i < side_ * side_; ++i) starts_[i + 1] += starts_[i];
    faces_.resize(starts_.back());
    std::vector<std::size_t> next = starts_;
    for_each_entry([&](std::size_t column, Index face) { faces_[next[column]++] = face; });
  }

  const TriangleMesh& mesh_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high_ = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
  std::size_t side_ = 1;
  std::vector<std::size_t> starts_;
  std::vector<Index> faces_;
};

/// turn_sign(a, b, p) with p moved by (d^2, d), d -> 0+: zero only where a and b coincide.
int turn_sign_moved(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  const int sign = turn_sign(a, b, p);
  if (sign != 0) return sign;
  if (a.x() != b.x()) return b.x() > a.x() ? 1 : -1;
  if (a.y() != b.y()) return b.y() < a.y() ? 1 : -1;
  return 0;
}

enum class Meeting { none, above, on };

/// Where the face lies that a vertical line upward from p meets. The line stands beside p by an infinitesimal shift, so
/// that it meets no edge; whether p lies on the closed face is decided without the shift.
Meeting meet(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& p) {
  const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c);
  const Eigen::Vector3d high = a.cwiseMax(b).cwiseMax(c);
  if ((p.head<2>().array() < low.head<2>().array()).any() || (p.array() > high.array()).any()) return Meeting::none;

  int side = -2;  // not known yet
  if (p.z() >= low.z()) {
    side = side_sign(a, b, c, p);
    bool on = side == 0;
    for (int axis = 0; on && axis < 3; ++axis) {
      const Eigen::Vector2d q = without_axis(p, axis);
      const int s0 = turn_sign(without_axis(a, axis), without_axis(b, axis), q);
      const int s1 = turn_sign(without_axis(b, axis), without_axis(c, axis), q);
      const int s2 = turn_sign(without_axis(c, axis), without_axis(a, axis), q);
      on = std::min({s0, s1, s2}) >= 0 || std::max({s0, s1, s2}) <= 0;
    }
    if (on) return Meeting::on;
  }
  const Eigen::Vector2d q = without_axis(p, 2);
  const int turn = turn_sign_moved(without_axis(a, 2), without_axis(b, 2), q);
  if (turn == 0 || turn_sign_moved(without_axis(b, 2), without_axis(c, 2), q) != turn ||
      turn_sign_moved(without_axis(c, 2), without_axis(a, 2), q) != turn)
    return Meeting::none;
  // The normal of a face that turns counterclockwise points up: it is above what lies on its other side.
  return side == -2 || side * turn < 0 ? Meeting::above : Meeting::none;
}

/// Where a vertex lies with regard to another component.
struct Location {
  Index component = 0;
  bool on = false;      ///< on its surface
  bool inside = false;  ///< strictly inside
};

/// The components other than `own` that p is not strictly outside of, ascending.
std::vector<Location> locate(const TriangleMesh& mesh, const Columns& columns,
                             const std::vector<Index>& component_of_face, Index own, const Eigen::Vector3d& p) {
  std::vector<Location> meetings;
  for (const Index f : columns.at(p)) {
    const Index component = component_of_face[f];
    if (component == own) continue;
    const Triangle& face = mesh.faces[f];
    const Meeting meeting = meet(mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]], p);
    if (meeting != Meeting::none) meetings.push_back({component, meeting == Meeting::on, meeting == Meeting::above});
  }
  std::sort(meetings.begin(), meetings.end(),
            [](const Location& a, const Location& b) { return a.component < b.component; });
  std::vector<Location> locations;
  for (std::size_t i = 0; i < meetings.size();) {
    Location location{meetings[i].component, false, false};
    for (; i < meetings.size() && meetings[i].component == location.component; ++i) {
      location.on = location.on || meetings[i].on;
      location.inside = location.inside != meetings[i].inside;
    }
    location.inside = location.inside && !location.on;
    if (location.on || location.inside) locations.push_back(location);
  }
  return locations;
}

/// Keeps of `candidates` what is in `found` too, and remembers where something was strictly inside.
void keep_common(std::vector<Location>& candidates, const std::vector<Location>& found) {
  std::vector<Location> common;
  auto it = found.begin();
  for (const Location& candidate : candidates) {
    while (it != found.end() && it->component < candidate.component) ++it;
    if (it != found.end() && it->component == candidate.component)
      common.push_back({candidate.component, true, candidate.inside || it->inside});
  }
  candidates = std::move(common);
}

using Corners = std::array<Eigen::Vector3d, 3>;

Corners corners_of(const TriangleMesh& mesh, Index face) {
  const auto& [a, b, c] = mesh.faces[static_cast<std::size_t>(face)];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Whether an edge of the first face passes through the inside of the second, from one side to the other.
bool some_edge_passes(const Corners& edges, const Corners& face) {
  const auto& [a, b, c] = face;
  const std::array<int, 3> side{side_sign(a, b, c, edges[0]), side_sign(a, b, c, edges[1]),
                                side_sign(a, b, c, edges[2])};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (side[k] * side[next] >= 0) continue;
    const Eigen::Vector3d &p = edges[k], &q = edges[next];
    const int turn = side_sign(p, q, a, b);
    if (turn != 0 && side_sign(p, q, b, c) == turn && side_sign(p, q, c, a) == turn) return true;
  }
  return false;
}

bool boxes_meet(const Corners& e, const Corners& f) {
  const auto low = [](const Corners& x) { return x[0].cwiseMin(x[1]).cwiseMin(x[2]).eval(); };
  const auto high = [](const Corners& x) { return x[0].cwiseMax(x[1]).cwiseMax(x[2]).eval(); };
  return (low(e).array() <= high(f).array()).all() && (low(f).array() <= high(e).array()).all();
}

/// Leaves out the candidates that their component crosses.
void leave_out_crossed(const TriangleMesh& mesh, const Columns& columns, const std::vector<Index>& component_of_face,
                       std::vector<std::vector<Location>>& candidates) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (component_of_face[f] < 0) continue;
    std::vector<Location>& of_own = candidates[static_cast<std::size_t>(component_of_face[f])];
    if (of_own.empty()) continue;
    const Corners own = corners_of(mesh, static_cast<Index>(f));
    columns.for_each_near(static_cast<Index>(f), [&](Index other) {
      const auto candidate = std::find_if(of_own.begin(), of_own.end(), [&](const Location& location) {
        return location.component == component_of_face[static_cast<std::size_t>(other)];
      });
      if (candidate == of_own.end()) return;
      const Corners others = corners_of(mesh, other);
      if (boxes_meet(own, others) && (some_edge_passes(own, others) || some_edge_passes(others, own)))
        of_own.erase(candidate);
    });
  }
}

}  // namespace

std::vector<Index> count_enclosing_components(const TriangleMesh& mesh, const std::vector<Index>& component_of_face,
                                              Index component_count) {
  std::vector<Index> enclosing(static_cast<std::size_t>(component_count), 0);
  if (component_count < 2) return enclosing;
  const Columns columns(mesh, component_of_face);

  // The candidates of each component, from its vertices one by one; a component without any is done with.
  std::vector<std::vector<Location>> candidates(enclosing.size());
  std::vector<bool> seen(enclosing.size(), false);
  std::vector<Index> last_component(mesh.vertices.size(), -1);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const Index component = component_of_face[f];
    if (component < 0) continue;
    const auto c = static_cast<std::size_t>(component);
    if (seen[c] && candidates[c].empty()) continue;
    for (const Index v : mesh.faces[f]) {
      if (last_component[v] == component) continue;
      last_component[v] = component;
      const std::vector<Location> found = locate(mesh, columns, component_of_face, component, mesh.vertices[v]);
      if (seen[c]) {
        keep_common(candidates[c], found);
      } else {
        candidates[c] = found;
        seen[c] = true;
      }
    }
  }
  for (std::vector<Location>& of_component : candidates)
    std::erase_if(of_component, [](const Location& candidate) { return !candidate.inside; });
  leave_out_crossed(mesh, columns, component_of_face, candidates);
  for (std::size_t c = 0; c < enclosing.size(); ++c) enclosing[c] = static_cast<Index>(candidates[c].size());
  return enclosing;
}

}  // namespace pcm
