// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bindings/c/inputs.h"

#include <limits>
#include <string>

#include "bindings/c/guard.h"

namespace pcm::c {

namespace {

[[noreturn]] void refuse(const char* what, std::int64_t value, const char* values) {
  throw BadCall(std::string(what) + " is " + std::to_string(value) + "; it must be " + values);
}

void require_numbered(const char* what, std::size_t count) {
  if (count > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw BadInput(std::string("surface: ") + std::to_string(count) + " " + what +
                   "; at most 2147483647 can be numbered");
}

DampingMode damping_mode_from(std::int32_t mode) {
  switch (mode) {
    case PCM_DAMPING_NO_TENSION:
      return DampingMode::no_tension;
    case PCM_DAMPING_FULL:
      return DampingMode::full;
    case PCM_DAMPING_COMPRESSION:
      return DampingMode::compression;
    default:
      refuse("law: damping_mode", mode, "PCM_DAMPING_NO_TENSION, PCM_DAMPING_FULL or PCM_DAMPING_COMPRESSION");
  }
}

}  // namespace

TriangleMesh mesh_from(const double* vertices, std::size_t vertex_count, const std::int32_t* faces,
                       std::size_t face_count) {
  require_numbered("vertices", vertex_count);
  require_numbered("faces", face_count);
  if (vertex_count > 0) given(vertices, "vertices");
  if (face_count > 0) given(faces, "faces");
  TriangleMesh mesh;
  mesh.name = "surface";
  mesh.vertices.reserve(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) mesh.vertices.emplace_back(vertices + 3 * i);
  mesh.faces.reserve(face_count);
  for (std::size_t i = 0; i < face_count; ++i) mesh.faces.push_back({faces[3 * i], faces[3 * i + 1], faces[3 * i + 2]});
  return mesh;
}

pcm_law default_law() {
  const ContactLaw law;
  pcm_law result{};
  result.size = sizeof result;
  result.stiffness = law.stiffness;
  result.damping = law.damping;
  result.transition_depth = law.transition_depth;
  result.friction = law.friction;
  result.slip_velocity = law.slip_velocity;
  result.max_penetration = law.max_penetration;
  result.damping_mode = PCM_DAMPING_NO_TENSION;
  return result;
}

ContactLaw law_from(const pcm_law& law) {
  if (law.reserved != 0) refuse("law: reserved", law.reserved, "0; call pcm_law_init first");
  ContactLaw result;
  result.stiffness = law.stiffness;
  if (law.layer_stiffness_E != 0 || law.layer_stiffness_F != 0)
    result.layers = LayerStiffness{law.layer_stiffness_E, law.layer_stiffness_F};
  result.damping = law.damping;
  result.transition_depth = law.transition_depth;
  result.friction = law.friction;
  result.slip_velocity = law.slip_velocity;
  result.max_penetration = law.max_penetration;
  result.damping_mode = damping_mode_from(law.damping_mode);
  return result;
}

Mode mode_from(std::int32_t mode) {
  switch (mode) {
    case PCM_MODE_E:
      return Mode::E;
    case PCM_MODE_F:
      return Mode::F;
    case PCM_MODE_BOTH:
      return Mode::both;
    default:
      refuse("mode", mode, "PCM_MODE_E, PCM_MODE_F or PCM_MODE_BOTH");
  }
}

Scheme scheme_from(std::int32_t scheme) {
  if (scheme != PCM_BARYCENTRIC && scheme != PCM_CLIPPED) refuse("scheme", scheme, "PCM_BARYCENTRIC or PCM_CLIPPED");
  return scheme == PCM_CLIPPED ? Scheme::clipped : Scheme::barycentric;
}

Side side_from(std::int32_t side) {
  if (side != PCM_E && side != PCM_F) refuse("side", side, "PCM_E or PCM_F");
  return side == PCM_E ? Side::E : Side::F;
}

Wanted wanted_from(std::uint32_t flags) {
  constexpr std::uint32_t kAll = PCM_WANTED_POLYGONS | PCM_WANTED_AREAS | PCM_WANTED_FORCE | PCM_WANTED_ELEMENTS |
                                 PCM_WANTED_BOUND | PCM_WANTED_STATISTICS | PCM_WANTED_TANGENT;
  if ((flags & ~kAll) != 0)
    refuse("wanted", flags, "a sum of PCM_WANTED_POLYGONS, PCM_WANTED_AREAS, ..., PCM_WANTED_TANGENT");
  const auto has = [flags](std::uint32_t flag) { return (flags & flag) != 0; };
  Wanted wanted;
  wanted.polygons = has(PCM_WANTED_POLYGONS);
  wanted.areas = has(PCM_WANTED_AREAS);
  wanted.force = has(PCM_WANTED_FORCE);
  wanted.elements = has(PCM_WANTED_ELEMENTS);
  wanted.bound = has(PCM_WANTED_BOUND);
  wanted.statistics = has(PCM_WANTED_STATISTICS);
  wanted.tangent = has(PCM_WANTED_TANGENT);
  return wanted;
}

Pose pose_from(const double* A, const double* r) {
  Pose pose;
  pose.A = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&given(A, "A"));
  pose.r = Eigen::Map<const Eigen::Vector3d>(&given(r, "r"));
  return pose;
}

Velocity velocity_from(const double* v, const double* w) {
  Velocity velocity;
  if (v != nullptr) velocity.v = Eigen::Map<const Eigen::Vector3d>(v);
  if (w != nullptr) velocity.w = Eigen::Map<const Eigen::Vector3d>(w);
  return velocity;
}

}  // namespace pcm::c
