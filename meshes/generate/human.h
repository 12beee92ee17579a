// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "pcm/triangle_mesh.h"

/// The man of the pedestrian crash (PCM section 8): 75 kg, 1.75 m, 15 rigid segments, 20,452 faces. Metres and
/// kilograms.
///
/// Each segment has a frame of its own: the origin is the centre of the joint that carries it, the waist for the
/// abdomen and pelvis; x points forward, y to the left and z up as he stands with his arms hanging straight down. Then
/// all frames are parallel.
///
/// Masses, centres of mass and radii of gyration are Dempster's fractions as tabled by D. A. Winter, Biomechanics and
/// Motor Control of Human Movement, chapter Anthropometry; lengths of limbs are Drillis and Contini's from there. What
/// the table lacks is that of the surface's solid, homogeneous and scaled to the mass; human_segments() says where.
/// Lengths and places within the trunk, of the ear canal and in the foot are assumed, no measurements: heights of
/// waist, neck and shoulders, widths between hips and between shoulders. What is a fraction of them inherits that.
namespace pcm::generate {

/// A segment, the joint that carries it, and its mass properties.
struct HumanSegment {
  std::string name;                                 ///< such as "thigh_left"
  int parent = -1;                                  ///< index in human_segments(); -1 for the root
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();  ///< its centre in the parent's frame; in the own frame it is 0
  double abduction_degrees = 0;                     ///< turn about x against the parent in standing_pose()
  double mass = 0;
  Eigen::Vector3d center_of_mass = Eigen::Vector3d::Zero();  ///< in the own frame
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();     ///< about the centre of mass, along the own axes, kg m^2
};

/// All segments, parents before children: abdomen_and_pelvis (the root), thorax, head_and_neck, then of either side,
/// ending in _left and _right, upper_arm, forearm, hand, thigh, shank, foot. Those of the right are mirror images.
///
/// Inertia: about the two axes across head, upper arm, forearm, hand, thigh and shank it is by the tabled radius of
/// gyration, about the axis along them (z) it is the solid's. The foot's likewise, y and z across it and x along it.
/// Thorax, and abdomen and pelvis, have no radius in the table: the whole tensor is the solid's about the solid's own
/// centroid, taken to hold about the tabled centre of mass, though that lies 8 and 7 cm away.
///
/// Centres of mass are the table's for all, on the line from joint to joint, with these lengths: the head's from the
/// neck's joint to the ear canal, assumed 0.14 m above it; the foot's from the ankle to the head of metatarsal II,
/// assumed 0.13 m away, as tabled, not the whole foot's 0.266 m, with which 0.475 would put its mass at heel and toes;
/// the hand's from the wrist to the fingertips, 0.189 m, where the table goes to a knuckle only, so that its centre of
/// mass lies too far out and its inertia is too large.
const std::vector<HumanSegment>& human_segments();

/// Where a segment's frame is in the ground's: a point p of the segment is at rotation p + position.
struct SegmentPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// The poses of human_segments() as he stands upright, arms 12 degrees from the vertical, legs straight down and a
/// little apart: soles on z = 0, the waist above the origin.
std::vector<SegmentPose> standing_pose();

/// The surface of a segment in its own frame: closed, outward, a loft of ellipses or rounded rectangles. Segments that
/// share a joint overlap there; the others are apart in standing_pose(). Throws BadInput for an unknown name.
TriangleMesh human_segment(std::string_view name);

}  // namespace pcm::generate
