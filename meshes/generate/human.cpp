// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/generate/human.h"

#include <algorithm>
#include <utility>

#include "meshes/base/floating_point_environment.h"
#include "meshes/generate/deterministic_trigonometry.h"
#include "meshes/generate/human_surfaces.h"
#include "meshes/generate/loft.h"
#include "meshes/generate/solid_moments.h"
#include "pcm/bad_input.h"

namespace pcm::generate {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A row of Winter's table, of a segment whose tabled length runs from its origin to `distal`.
struct TabledSegment {
  double mass = 0;            ///< kg of 75 kg
  Vector3d distal;            ///< the other landmark, in the own frame, m
  double center_of_mass = 0;  ///< from the origin, of the length
  double gyration = 0;        ///< radius about the centre of mass across the length, of the length
};

/// Of the diagonal alone: a segment that is symmetric in y has no products of inertia with y, and the solid's product
/// in x and z counts only where the whole tensor is the solid's.
Matrix3d diagonal(double xx, double yy, double zz) {
  Matrix3d inertia = Matrix3d::Zero();
  inertia.diagonal() << xx, yy, zz;
  return inertia;
}

/// Mass properties of a segment along z, or along x as the foot, whose name is also that of its shape.
HumanSegment tabled(std::string name, const TabledSegment& table, LoftAxis along = LoftAxis::z) {
  const SolidMoments solid = solid_moments(human::surface(name));
  const Vector3d& d = table.distal;
  const double length_squared = d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  const double across = table.mass * (table.gyration * table.gyration * length_squared);
  HumanSegment segment;
  segment.name = std::move(name);
  segment.mass = table.mass;
  segment.center_of_mass = table.center_of_mass * d;
  segment.inertia = along == LoftAxis::z ? diagonal(across, across, table.mass * solid.unit_inertia(2, 2))
                                         : diagonal(table.mass * solid.unit_inertia(0, 0), across, across);
  return segment;
}

/// Mass properties of a segment of the trunk: the tensor is that of the solid, which is symmetric in y.
HumanSegment of_solid(std::string name, double mass, double height_of_center_of_mass) {
  const SolidMoments solid = solid_moments(human::surface(name));
  HumanSegment segment;
  segment.name = std::move(name);
  segment.mass = mass;
  segment.center_of_mass = {0, 0, height_of_center_of_mass};
  segment.inertia = mass * solid.unit_inertia;
  for (const int axis : {0, 2}) segment.inertia(1, axis) = segment.inertia(axis, 1) = 0;
  return segment;
}

/// The list under construction.
class Segments {
 public:
  /// Adds a segment in the median plane; returns its index.
  int add(HumanSegment segment, int parent, const Vector3d& joint) {
    segment.parent = parent;
    segment.joint = joint;
    list_.push_back(std::move(segment));
    return static_cast<int>(list_.size()) - 1;
  }

  /// Adds that segment of one side, given as that of the left.
  int add_side(HumanSegment left, bool right, int parent, Vector3d joint, double abduction_degrees = 0) {
    left.name += right ? "_right" : "_left";
    if (right) joint.y() = 0.0 - joint.y();
    const int index = add(std::move(left), parent, joint);
    list_[index].abduction_degrees = right ? 0.0 - abduction_degrees : abduction_degrees;
    return index;
  }

  std::vector<HumanSegment> take() { return std::move(list_); }

 private:
  std::vector<HumanSegment> list_;
};

void add_arm(Segments& segments, bool right, int thorax) {
  constexpr double kAbductionDegrees = 12;
  using human::kForearm, human::kHand, human::kUpperArm;
  const int upper_arm = segments.add_side(tabled("upper_arm", {2.10, {0, 0, -kUpperArm}, 0.436, 0.322}), right, thorax,
                                          {0, human::kHalfShoulderWidth, human::kWaistToShoulder}, kAbductionDegrees);
  const int forearm = segments.add_side(tabled("forearm", {1.20, {0, 0, -kForearm}, 0.430, 0.303}), right, upper_arm,
                                        {0, 0, -kUpperArm});
  segments.add_side(tabled("hand", {0.45, {0, 0, -kHand}, 0.506, 0.297}), right, forearm, {0, 0, -kForearm});
}

void add_leg(Segments& segments, bool right, int pelvis) {
  using human::kShank, human::kThigh;
  const int thigh = segments.add_side(tabled("thigh", {7.50, {0, 0, -kThigh}, 0.433, 0.323}), right, pelvis,
                                      {0, human::kHalfHipWidth, -human::kWaistToHip});
  const int shank =
      segments.add_side(tabled("shank", {3.4875, {0, 0, -kShank}, 0.433, 0.302}), right, thigh, {0, 0, -kThigh});
  const Vector3d head_of_metatarsal(0.12, 0, -0.05);  // 0.13 from the ankle
  segments.add_side(tabled("foot", {1.0875, head_of_metatarsal, 0.50, 0.475}, LoftAxis::x), right, shank,
                    {0, 0, -kShank});
}

std::vector<HumanSegment> make_segments() {
  const DefaultFloatingPoint environment;  // The list is kept: the first caller's must not stay in it.
  using human::kWaistToHip, human::kWaistToNeck;
  Segments segments;
  const int pelvis = segments.add(of_solid("abdomen_and_pelvis", 21.075, -0.27 * kWaistToHip), -1, {0, 0, 0});
  // The table counts the thorax from the neck downwards.
  const int thorax = segments.add(of_solid("thorax", 16.20, (1 - 0.82) * kWaistToNeck), pelvis, {0, 0, 0});
  const Vector3d ear_canal(0, 0, 0.14);
  segments.add(tabled("head_and_neck", {6.075, ear_canal, 1.0, 0.495}), thorax, {0, 0, kWaistToNeck});
  for (const bool right : {false, true}) {
    add_arm(segments, right, thorax);
    add_leg(segments, right, pelvis);
  }
  return segments.take();
}

/// The mirror image in the plane y = 0, outward again.
TriangleMesh mirrored(TriangleMesh mesh) {
  for (Vector3d& vertex : mesh.vertices) vertex.y() = 0.0 - vertex.y();
  for (Triangle& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

/// Written out, so that the order of operations is fixed.
Vector3d turned_about_x(const Vector3d& p, const CosineSine& by) {
  return {p.x(), by.cosine * p.y() - by.sine * p.z(), by.sine * p.y() + by.cosine * p.z()};
}

}  // namespace

const std::vector<HumanSegment>& human_segments() {
  static const std::vector<HumanSegment> segments = make_segments();
  return segments;
}

std::vector<SegmentPose> standing_pose() {
  constexpr double kWaistHeight = human::kAnkleHeight + human::kShank + human::kThigh + human::kWaistToHip;
  std::vector<SegmentPose> poses;
  std::vector<double> degrees;  // about x, each segment against the ground
  for (const HumanSegment& segment : human_segments()) {
    const bool is_root = segment.parent < 0;
    const double parent_degrees = is_root ? 0 : degrees[segment.parent];
    const Vector3d parent_position = is_root ? Vector3d(0, 0, kWaistHeight) : poses[segment.parent].position;
    degrees.push_back(parent_degrees + segment.abduction_degrees);

    SegmentPose pose;
    pose.position = parent_position + turned_about_x(segment.joint, cosine_sine_of_degrees(parent_degrees));
    const auto [cosine, sine] = cosine_sine_of_degrees(degrees.back());
    pose.rotation << 1, 0, 0, 0, cosine, 0.0 - sine, 0, sine, cosine;
    poses.push_back(pose);
  }
  return poses;
}

TriangleMesh human_segment(std::string_view name) {
  const auto& segments = human_segments();
  if (std::none_of(segments.begin(), segments.end(), [&](const HumanSegment& s) { return s.name == name; })) {
    throw BadInput("there is no segment '" + std::string(name) + "' of the human");
  }
  constexpr std::string_view kLeft = "_left", kRight = "_right";
  TriangleMesh mesh;
  if (name.ends_with(kRight)) {
    mesh = mirrored(human::surface(name.substr(0, name.size() - kRight.size())));
  } else {
    mesh = human::surface(name.ends_with(kLeft) ? name.substr(0, name.size() - kLeft.size()) : name);
  }
  mesh.name = std::string(name);
  return mesh;
}

}  // namespace pcm::generate
