// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/pictures/contact_picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "compare/io/pictures/svg.h"

namespace pcm::compare {
namespace {

// Lengths in pixels.
constexpr double kPanelWidth = 440, kGreatestHeight = 480, kGap = 28;
constexpr double kArrow = 7;  ///< half the length of an arrow head
constexpr double kArrowSpacing = 70;
constexpr double kSurroundings = 0.15;  ///< shown on each side of the contact, relative to its size

constexpr const char* kPolygon = "#0060a0";
constexpr const char* kEdge = "#cccccc";
constexpr const char* kActiveEdge = "#777777";
constexpr const char* kActive = "#c9d3da";

std::string text(double x, double y, double size, std::string_view words, std::string_view more = "") {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" font-size="{:g}"{}>{}</text>)"
                     "\n",
                     x, y, size, more, escaped(words));
}

/// Pale yellow at no penetration to dark red at the greatest.
std::string penetration_colour(double share) {
  constexpr std::array<std::array<double, 3>, 4> kStops{
      {{255, 245, 185}, {253, 187, 99}, {232, 94, 54}, {140, 10, 40}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  std::array<int, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] =
        static_cast<int>(std::lround(kStops[k][c] + (at - static_cast<double>(k)) * (kStops[k + 1][c] - kStops[k][c])));
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

/// A parallel projection; `right` and `up` span the picture.
struct Projection {
  Eigen::Vector3d right, up, towards_viewer;

  explicit Projection(const Eigen::Vector3d& towards)
      : up(std::abs(towards.z()) > 0.5 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ()), towards_viewer(towards) {
    right = up.cross(towards);
  }
  Eigen::Vector2d flat(const Eigen::Vector3d& x_Me) const { return {right.dot(x_Me), up.dot(x_Me)}; }
};

/// One surface as it is drawn: vertices in Me and what the answer says of each face.
struct DrawnSurface {
  Side side;
  const TriangleMesh& mesh;
  std::vector<Eigen::Vector3d> vertices_Me;
  std::vector<bool> active;         ///< by face
  std::vector<double> penetration;  ///< by face, m; 0 without an element

  DrawnSurface(Side which, const TriangleMesh& surface, const Pose& pose, const fast::Contact& contact)
      : side(which),
        mesh(surface),
        vertices_Me(surface.vertices),
        active(surface.faces.size()),
        penetration(surface.faces.size()) {
    if (side == Side::F)
      for (Eigen::Vector3d& x : vertices_Me) x = pose.A * x + pose.r;
    const fast::ActiveArea& area = side == Side::E ? contact.E : contact.F;
    for (const std::vector<Index>* faces : {&area.intersected, &area.inner})
      for (const Index face : *faces) active[static_cast<std::size_t>(face)] = true;
    std::vector<double> element_area(mesh.faces.size());
    for (const fast::Element& e : contact.elements) {
      if (e.master != side) continue;
      const auto face = static_cast<std::size_t>(e.master_face);
      element_area[face] += e.area;
      penetration[face] += e.area * e.penetration;
    }
    for (std::size_t i = 0; i < penetration.size(); ++i)
      if (element_area[i] > 0) penetration[i] /= element_area[i];
  }

  std::array<Eigen::Vector3d, 3> corners_Me(std::size_t face) const {
    const Triangle& v = mesh.faces[face];
    return {vertices_Me[static_cast<std::size_t>(v[0])], vertices_Me[static_cast<std::size_t>(v[1])],
            vertices_Me[static_cast<std::size_t>(v[2])]};
  }
};

/// A rectangle of the projection plane, m.
struct Window {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;

  void add(const Eigen::Vector2d& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  bool empty() const { return !(low.x() <= high.x()); }
  void widen() {
    const Eigen::Vector2d by = Eigen::Vector2d::Constant(kSurroundings * (high - low).maxCoeff());
    low -= by;
    high += by;
  }
};

/// What is to be seen of the contact; all of the surface where there is none.
Window window_around_contact(const Projection& projection, const DrawnSurface& surface, const fast::Contact& contact) {
  Window window;
  for (const fast::Crossing& crossing : contact.crossings) window.add(projection.flat(crossing.position_Me));
  for (std::size_t face = 0; face < surface.active.size(); ++face) {
    if (!surface.active[face]) continue;
    for (const Eigen::Vector3d& x : surface.corners_Me(face)) window.add(projection.flat(x));
  }
  if (window.empty())
    for (const Eigen::Vector3d& x : surface.vertices_Me) window.add(projection.flat(x));
  window.widen();
  return window;
}

/// One surface in its frame on the page.
class Panel {
 public:
  Panel(const DrawnSurface& surface, const fast::Contact& contact, const ViewAxis& view)
      : surface_(surface),
        contact_(contact),
        view_(view),
        projection_(view.towards_viewer_Me()),
        window_(window_around_contact(projection_, surface, contact)) {}

  /// Greatest pixels a metre at which it fits.
  double fitting_scale() const {
    const Eigen::Vector2d size = window_.high - window_.low;
    return std::min(kPanelWidth / size.x(), kGreatestHeight / size.y());
  }
  double height(double scale) const { return scale * (window_.high - window_.low).y(); }

  std::string drawn(double left, double top, double height, double scale, double greatest) const {
    const Place place{left + kPanelWidth / 2, top + height / 2, scale, height};
    const std::string clip = surface_.side == Side::E ? "frame_E" : "frame_F";
    const std::string frame =
        fmt::format(R"(x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}")", left, top, kPanelWidth, height);
    return fmt::format(R"(<clipPath id="{0}"><rect {1}/></clipPath>)"
                       "\n"
                       R"xml(<g clip-path="url(#{0})" stroke="{4}" stroke-width="0.5" stroke-linejoin="round">)xml"
                       "\n{2}{3}</g>\n"
                       R"(<rect {1} fill="none" stroke="#999999"/>)"
                       "\n",
                       clip, frame, faces(place, greatest), polygons(place), kEdge);
  }

  std::string heading() const {
    return fmt::format("Surface {}, seen from {}", surface_.side == Side::E ? "E" : "F", view_.name());
  }

  std::string note() const {
    const fast::ActiveArea& area = surface_.side == Side::E ? contact_.E : contact_.F;
    const auto elements = std::count_if(contact_.elements.begin(), contact_.elements.end(),
                                        [&](const fast::Element& e) { return e.master == surface_.side; });
    return fmt::format("{} faces: {} intersected, {} inner; {} contact elements", surface_.mesh.faces.size(),
                       area.intersected.size(), area.inner.size(), elements);
  }

 private:
  struct Place {
    double x, y, scale;  ///< of the window's centre on the page
    double height;       ///< of the frame

    /// Whether a triangle's bounding box on the page meets the frame.
    bool shows(const std::array<Eigen::Vector2d, 3>& p) const {
      const Eigen::Vector2d centre(x, y), half(kPanelWidth / 2, height / 2);
      const Eigen::Vector2d least = p[0].cwiseMin(p[1]).cwiseMin(p[2]), greatest = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
      return ((least - centre).array() <= half.array()).all() && ((greatest - centre).array() >= -half.array()).all();
    }
  };

  Eigen::Vector2d on_page(const Place& place, const Eigen::Vector3d& x_Me) const {
    const Eigen::Vector2d from_centre = projection_.flat(x_Me) - (window_.low + window_.high) / 2;
    return {place.x + place.scale * from_centre.x(), place.y - place.scale * from_centre.y()};
  }

  std::string faces(const Place& place, double greatest) const {
    struct Visible {
      double depth, cosine;
      std::size_t face;
    };
    std::vector<Visible> visible;
    for (std::size_t face = 0; face < surface_.mesh.faces.size(); ++face) {
      const auto [a, b, c] = surface_.corners_Me(face);
      const double cosine = (b - a).cross(c - a).stableNormalized().dot(projection_.towards_viewer);
      if (cosine > 0 && place.shows({on_page(place, a), on_page(place, b), on_page(place, c)}))
        visible.push_back({(a + b + c).dot(projection_.towards_viewer), cosine, face});
    }
    std::stable_sort(visible.begin(), visible.end(), [](const auto& a, const auto& b) { return a.depth < b.depth; });
    std::string drawn;
    for (const Visible& v : visible) drawn += face(place, v.face, v.cosine, greatest);
    return drawn;
  }

  std::string face(const Place& place, std::size_t face, double cosine, double greatest) const {
    const int grey = static_cast<int>(std::lround(215 + 32 * cosine));
    const double u = surface_.penetration[face];
    const bool active = surface_.active[face];
    const std::string fill = u > 0    ? penetration_colour(u / greatest)
                             : active ? kActive
                                      : fmt::format("#{0:02x}{0:02x}{0:02x}", grey);
    std::string points;
    for (const Eigen::Vector3d& x : surface_.corners_Me(face)) {
      const Eigen::Vector2d p = on_page(place, x);
      points += fmt::format("{}{:.1f},{:.1f}", points.empty() ? "" : " ", p.x(), p.y());
    }
    return fmt::format(R"(<polygon points="{}" fill="{}"{}/>)"
                       "\n",
                       points, fill, active ? fmt::format(R"( stroke="{}" stroke-width="0.8")", kActiveEdge) : "");
  }

  std::string polygons(const Place& place) const {
    std::string drawn;
    for (const fast::Polygon& polygon : contact_.polygons) {
      std::vector<Eigen::Vector2d> points;
      for (Index i = polygon.first; i < polygon.first + polygon.count; ++i)
        points.push_back(on_page(place, contact_.crossings[static_cast<std::size_t>(i)].position_Me));
      if (polygon.closed) points.push_back(points.front());
      std::string path;
      for (const Eigen::Vector2d& p : points)
        path += fmt::format("{}{:.1f},{:.1f}", path.empty() ? "" : " ", p.x(), p.y());
      drawn += fmt::format(R"(<polyline points="{}" fill="none" stroke="{}" stroke-width="2"/>)"
                           "\n",
                           path, kPolygon) +
               arrows(points);
    }
    return drawn;
  }

  /// Heads along the way, at least one.
  static std::string arrows(const std::vector<Eigen::Vector2d>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    if (!(length > 0)) return {};
    const double spacing = length / std::max(1.0, std::floor(length / kArrowSpacing));
    std::string drawn;
    double next = spacing / 2, passed = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Eigen::Vector2d way = points[i] - points[i - 1];
      const double step = way.norm();
      for (; step > 0 && next <= passed + step; next += spacing) {
        const Eigen::Vector2d along = way / step, across(-along.y(), along.x());
        const Eigen::Vector2d at = points[i - 1] + (next - passed) * along;
        const Eigen::Vector2d tip = at + kArrow * along, foot = at - kArrow * along;
        const Eigen::Vector2d left = foot + 0.7 * kArrow * across, right = foot - 0.7 * kArrow * across;
        drawn += fmt::format(R"(<polygon points="{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}" fill="{}" stroke="none"/>)"
                             "\n",
                             tip.x(), tip.y(), left.x(), left.y(), right.x(), right.y(), kPolygon);
      }
      passed += step;
    }
    return drawn;
  }

  const DrawnSurface& surface_;
  const fast::Contact& contact_;
  ViewAxis view_;
  Projection projection_;
  Window window_;
};

/// What the colours mean, in two lines.
std::string legend(double y, double greatest) {
  constexpr int kSteps = 24;
  constexpr double kStep = 7, kBarHeight = 12;
  double x = kMargin;
  std::string drawn = text(x, y + 11, kTextSize, "penetration: 0");
  x += 96;
  for (int i = 0; i < kSteps; ++i)
    drawn += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:g}" fill="{}"/>)"
                         "\n",
                         x + kStep * i, y, kStep + 0.3, kBarHeight, penetration_colour((i + 0.5) / kSteps));
  x += kStep * kSteps + 8;
  drawn += text(x, y + 11, kTextSize, fmt::format("{:.3g} m", greatest));
  x += 110;
  drawn += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="20" height="{:g}" fill="{}" stroke="{}"/>)"
                       "\n",
                       x, y, kBarHeight, kActive, kActiveEdge);
  drawn += text(x + 28, y + 11, kTextSize, "active face without element");
  x += 230;
  drawn += fmt::format(R"(<polyline points="{:.1f},{:.1f} {:.1f},{:.1f}" stroke="{}" stroke-width="2"/>)"
                       "\n",
                       x, y + 6, x + 30, y + 6, kPolygon);
  return drawn + text(x + 38, y + 11, kTextSize, "intersection polygon, circulation");
}

}  // namespace

Eigen::Vector3d ViewAxis::towards_viewer_Me() const {
  Eigen::Vector3d towards = Eigen::Vector3d::Zero();
  towards[axis] = negative ? -1 : 1;
  return towards;
}

std::string ViewAxis::name() const {
  return std::string(negative ? "-" : "+") + "xyz"[axis];
}

std::optional<ViewAxis> view_axis_named(std::string_view word) {
  ViewAxis view;
  view.negative = !word.empty() && word.front() == '-';
  if (!word.empty() && (word.front() == '-' || word.front() == '+')) word.remove_prefix(1);
  const std::size_t axis = std::string_view("xyz").find(word);
  if (word.size() != 1 || axis == std::string_view::npos) return {};
  view.axis = static_cast<int>(axis);
  return view;
}

ViewAxis best_view(const fast::Contact& contact) {
  const Eigen::Vector3d& area_Me = contact.E.vector_area_Me;
  ViewAxis view;
  if (area_Me.cwiseAbs().maxCoeff(&view.axis) == 0) return {};
  view.negative = area_Me[view.axis] < 0;
  return view;
}

std::string svg(const ContactPicture& picture) {
  const DrawnSurface E(Side::E, picture.mesh_E, picture.pose, picture.contact);
  const DrawnSurface F(Side::F, picture.mesh_F, picture.pose, picture.contact);
  const Panel panel_E(E, picture.contact, picture.view);
  const Panel panel_F(F, picture.contact, {picture.view.axis, !picture.view.negative});
  double greatest = 0;
  for (const DrawnSurface* surface : {&E, &F})
    for (const double u : surface->penetration) greatest = std::max(greatest, u);

  // One scale for both, so that they can be compared.
  const double scale = std::min(panel_E.fitting_scale(), panel_F.fitting_scale());
  const double height = std::max(panel_E.height(scale), panel_F.height(scale));
  const double width = 2 * kMargin + 2 * kPanelWidth + kGap, top = 94;
  std::string drawn = text(kMargin, 34, kTitleSize, picture.title, R"( font-weight="bold")");
  double left = kMargin;
  for (const Panel* panel : {&panel_E, &panel_F}) {
    drawn += text(left, 64, kHeadingSize, panel->heading(), R"( font-weight="bold")");
    drawn += text(left, 82, kTextSize, panel->note());
    drawn += panel->drawn(left, top, height, scale, greatest);
    left += kPanelWidth + kGap;
  }
  double y = top + height + 18;
  drawn += legend(y, greatest);
  y += 42;
  for (const std::string& line : wrapped(picture.caption, characters_in(width - 2 * kMargin))) {
    drawn += text(kMargin, y, kTextSize, line);
    y += kLine;
  }
  return svg_document(width, y, picture.title, picture.caption, drawn);
}

}  // namespace pcm::compare
