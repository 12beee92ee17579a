// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

#include "pcm/contact.h"
#include "pcm/inputs.h"
#include "pcm/triangle_mesh.h"

namespace pcm::compare {

/// Whence a surface is looked at: along a coordinate axis of Me, from very far.
struct ViewAxis {
  int axis = 2;           ///< 0, 1, 2: x, y, z
  bool negative = false;  ///< from the negative side

  Eigen::Vector3d towards_viewer_Me() const;
  std::string name() const;  ///< e.g. "-x"
};

/// "x", "-x" and so on; none for another word.
std::optional<ViewAxis> view_axis_named(std::string_view word);

/// The axis from which most of E's clipped active area is seen from outside: that of the greatest component of its
/// vector area.
ViewAxis best_view(const fast::Contact& contact);

/// A contact at one pose, drawn as an SVG picture: surface E seen from `view`, surface F from the opposite side. Faces
/// turned to the viewer are drawn back to front by their barycentres, which suits surfaces that hide little of
/// themselves. Active faces are outlined; those with contact elements are coloured by penetration (clipped scheme: the
/// area-weighted mean over the face's elements). The intersection polygons are drawn over both surfaces, with arrows in
/// the direction of their circulation.
struct ContactPicture {
  const TriangleMesh& mesh_E;
  const TriangleMesh& mesh_F;
  Pose pose;
  const fast::Contact& contact;  ///< with polygons, areas and elements
  ViewAxis view;
  std::string title;
  std::string caption;  ///< what the legend does not say: bodies, pose, law; wrapped
};

std::string svg(const ContactPicture& picture);

}  // namespace pcm::compare
