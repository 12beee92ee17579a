// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/page/check_recording.h"

#include <fmt/core.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "pcm/bad_input.h"

namespace pcm::simulate {
namespace {

void demand(bool fulfilled, const std::string& message) {
  if (!fulfilled) throw BadInput("recording: " + message);
}

bool is_finite_float(double x) {
  return std::abs(x) <= double{std::numeric_limits<float>::max()};  // false for NaN
}

bool are_finite_floats(const Eigen::Vector3d& x) {
  return is_finite_float(x.x()) && is_finite_float(x.y()) && is_finite_float(x.z());
}

bool is_rotation(const Eigen::Matrix3d& A) {
  return (A.transpose() * A - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= 1e-6 && A.determinant() > 0;
}

bool is_index(Index i, std::size_t size) {
  return i >= 0 && static_cast<std::size_t>(i) < size;
}

void check_surface(const RecordedSurface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  const auto name = [&] { return "surface '" + surface.name + "'"; };
  demand(!mesh.faces.empty(), name() + " has no faces");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    demand(are_finite_floats(mesh.vertices[i]), fmt::format("{}: vertex {} is not finite", name(), i));
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (const Index vertex : mesh.faces[i])
      demand(is_index(vertex, mesh.vertices.size()),
             fmt::format("{}: face {} names vertex {}, of {}", name(), i, vertex, mesh.vertices.size()));
  }
}

void check_pairing(const Recording& recording, const RecordedPairing& pairing) {
  for (const Index surface : {pairing.surface_E, pairing.surface_F})
    demand(is_index(surface, recording.surfaces.size()),
           fmt::format("pairing '{}' names surface {}, of {}", pairing.name, surface, recording.surfaces.size()));
}

void check_element(const Recording& recording, const RecordedElement& element, const std::string& when) {
  demand(is_index(element.pairing, recording.pairings.size()),
         fmt::format("{}: an element names pairing {}, of {}", when, element.pairing, recording.pairings.size()));
  const RecordedPairing& pairing = recording.pairings[static_cast<std::size_t>(element.pairing)];
  const Index master = element.master == Side::E ? pairing.surface_E : pairing.surface_F;
  const RecordedSurface& surface = recording.surfaces[static_cast<std::size_t>(master)];
  demand(is_index(element.face, surface.mesh.faces.size()),
         fmt::format("{}: an element of pairing '{}' names face {} of surface '{}', which has {}", when, pairing.name,
                     element.face, surface.name, surface.mesh.faces.size()));
  demand(is_finite_float(element.pressure),
         fmt::format("{}: the pressure on face {} of surface '{}' is not finite", when, element.face, surface.name));
}

void check_frame(const Recording& recording, const Frame& frame) {
  const std::string when = fmt::format("frame at t = {} s", frame.t);
  demand(is_finite_float(frame.t), when + ": the time is not finite");
  demand(frame.poses_W.size() == recording.surfaces.size(),
         fmt::format("{}: {} poses for {} surfaces", when, frame.poses_W.size(), recording.surfaces.size()));
  for (std::size_t i = 0; i < frame.poses_W.size(); ++i) {
    const Pose& pose = frame.poses_W[i];
    demand(
        are_finite_floats(pose.r) && is_rotation(pose.A),
        fmt::format("{}: the pose of surface '{}' is not finite, or not a rotation", when, recording.surfaces[i].name));
  }
  for (const RecordedElement& element : frame.elements) check_element(recording, element, when);
  for (const RecordedContact& contact : frame.contacts) {
    demand(is_index(contact.pairing, recording.pairings.size()),
           fmt::format("{}: a contact names pairing {}, of {}", when, contact.pairing, recording.pairings.size()));
    demand(are_finite_floats(contact.position_W) && are_finite_floats(contact.force_W),
           when + ": a contact's position or force is not finite");
  }
}

void check_series(const Series& series) {
  demand(series.t.size() == series.value.size(),
         fmt::format("series '{}': {} times and {} values", series.name, series.t.size(), series.value.size()));
  for (std::size_t i = 0; i < series.t.size(); ++i)
    demand(is_finite_float(series.t[i]) && (i == 0 || series.t[i] >= series.t[i - 1]),
           fmt::format("series '{}': times have to be finite and to ascend; number {} is {} s", series.name, i,
                       series.t[i]));
}

}  // namespace

void check_recording(const Recording& recording) {
  demand(!recording.surfaces.empty(), "no surfaces, nothing to show");
  demand(!recording.frames.empty(), "no frames, nothing to show");
  for (const RecordedSurface& surface : recording.surfaces) check_surface(surface);
  for (const RecordedPairing& pairing : recording.pairings) check_pairing(recording, pairing);
  for (const Frame& frame : recording.frames) check_frame(recording, frame);
  for (std::size_t i = 1; i < recording.frames.size(); ++i)
    demand(recording.frames[i].t > recording.frames[i - 1].t,
           fmt::format("the frame at t = {} s follows that at t = {} s", recording.frames[i].t,
                       recording.frames[i - 1].t));
  for (const Series& series : recording.series) check_series(series);
}

}  // namespace pcm::simulate
