// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/picture.h"

#include <algorithm>
#include <map>
#include <vector>

#include "simulate/stills/arrow.h"
#include "simulate/stills/canvas.h"
#include "simulate/stills/colours.h"

namespace pcm::simulate {
namespace {

// In the diagonals of what all frames fill.
constexpr double kLongestArrow = 0.2, kShortestArrow = 1e-4, kArrowWidth = 0.0032;
constexpr double kNear = 0.01;  // of the distance of what is looked at

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

/// The box of the boxes of all surfaces in all frames, as the page has it.
Eigen::AlignedBox3d box_of_run(const Recording& recording) {
  std::vector<Eigen::AlignedBox3d> boxes_S;
  for (const RecordedSurface& surface : recording.surfaces) boxes_S.push_back(box_of(surface.mesh));
  Eigen::AlignedBox3d box_W;
  for (const Frame& frame : recording.frames) {
    for (std::size_t s = 0; s < boxes_S.size(); ++s) {
      for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner = boxes_S[s].corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
        box_W.extend(frame.poses_W[s].A * corner + frame.poses_W[s].r);
      }
    }
  }
  return box_W;
}

CameraTriangle face_seen(const Recording& recording, const Frame& frame, std::size_t surface, std::size_t face,
                         const Camera& camera) {
  const TriangleMesh& mesh = recording.surfaces[surface].mesh;
  const Pose& pose = frame.poses_W[surface];
  CameraTriangle triangle_C;
  for (std::size_t k = 0; k < 3; ++k)
    triangle_C[k] = camera.to_camera(pose.A * mesh.vertices[static_cast<std::size_t>(mesh.faces[face][k])] + pose.r);
  return triangle_C;
}

/// Of length 1, on the side that is seen; zero where the triangle has no area.
Eigen::Vector3d seen_normal(const CameraTriangle& triangle_C) {
  const Eigen::Vector3d normal_C =
      (triangle_C[1] - triangle_C[0]).cross(triangle_C[2] - triangle_C[0]).stableNormalized();
  return normal_C.dot(triangle_C[0]) > 0 ? Eigen::Vector3d(-normal_C) : normal_C;
}

void draw_surfaces(const Recording& recording, const Frame& frame, const Camera& camera, Canvas& canvas) {
  const Eigen::Vector3d up_C = camera.A_CW.col(2);
  for (std::size_t s = 0; s < recording.surfaces.size(); ++s) {
    for (std::size_t f = 0; f < recording.surfaces[s].mesh.faces.size(); ++f) {
      const CameraTriangle triangle_C = face_seen(recording, frame, s, f, camera);
      canvas.draw(triangle_C, lit(recording.surfaces[s].colour, seen_normal(triangle_C), up_C), Hiding::by_depth);
    }
  }
}

/// By surface and face; where a face carries several elements, the greatest counts.
std::map<std::pair<Index, Index>, double> pressures(const Recording& recording, const Frame& frame) {
  std::map<std::pair<Index, Index>, double> pressures;
  for (const RecordedElement& element : frame.elements) {
    const RecordedPairing& pairing = recording.pairings[static_cast<std::size_t>(element.pairing)];
    double& pressure = pressures[{element.master == Side::E ? pairing.surface_E : pairing.surface_F, element.face}];
    pressure = std::max(pressure, element.pressure);
  }
  return pressures;
}

void draw_elements(const Recording& recording, const Frame& frame, const RunView& view, Canvas& canvas) {
  const double limit = view.greatest_pressure > 0 ? view.greatest_pressure : 1;
  for (const auto& [place, pressure] : pressures(recording, frame)) {
    const auto [surface, face] = place;
    canvas.draw(
        face_seen(recording, frame, static_cast<std::size_t>(surface), static_cast<std::size_t>(face), view.camera),
        bar_colour(pressure / limit), Hiding::none);
  }
}

void draw_arrows(const Frame& frame, const RunView& view, Canvas& canvas) {
  for (const RecordedContact& contact : frame.contacts) {
    const Eigen::Vector3d along_W = view.metres_per_newton * contact.force_W;
    if (!(along_W.norm() > kShortestArrow * view.size)) continue;
    const Eigen::Vector3d from_C = view.camera.to_camera(contact.position_W);
    const Eigen::Vector3d to_C = view.camera.to_camera(contact.position_W + along_W);
    for (const CameraTriangle& triangle_C : arrow(from_C, to_C, kArrowWidth * view.size))
      canvas.draw(triangle_C, kArrowColour, Hiding::none);
  }
}

}  // namespace

RunView view_of(const Recording& recording, int width, int height) {
  Eigen::AlignedBox3d box_W = box_of_run(recording);
  if (box_W.isEmpty()) box_W.extend(Eigen::Vector3d(0, 0, 0));
  RunView view;
  view.width = width;
  view.height = height;
  view.camera = camera_on(box_W, static_cast<double>(width) / height);
  if (box_W.diagonal().norm() > 0) view.size = box_W.diagonal().norm();
  double greatest_force = 0;
  for (const Frame& frame : recording.frames) {
    for (const RecordedElement& e : frame.elements)
      view.greatest_pressure = std::max(view.greatest_pressure, e.pressure);
    for (const RecordedContact& contact : frame.contacts)
      greatest_force = std::max(greatest_force, contact.force_W.norm());
  }
  if (greatest_force > 0) view.metres_per_newton = kLongestArrow * view.size / greatest_force;
  return view;
}

Image picture(const Recording& recording, const Frame& frame, const RunView& view) {
  const Camera& camera = view.camera;
  Canvas canvas(view.width, view.height, camera.tan_half_height, kNear * camera.distance, kBackgroundColour);
  draw_surfaces(recording, frame, camera, canvas);
  draw_elements(recording, frame, view, canvas);
  draw_arrows(frame, view, canvas);
  return canvas.image();
}

}  // namespace pcm::simulate
