// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/bounds/clipped_error.h"

#include <gtest/gtest.h>

#include <utility>

#include "fast/bounds/element_error.h"
#include "fast/posed/posed_pair.h"
#include "fast/surface/prepare_surface.h"
#include "meshes/generate/boxes.h"

namespace pcm::fast {
namespace {

/// An engine that sees a part of a face which the exact problem's lines surely do not meet has all of it too much.
TEST(ViewError, OfAPartOfAFaceThatIsNotInViewIsAllOfIt) {
  const FaceGeometry face({Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(-1, 2, 0), Eigen::Vector3d(1, -1, 0)});
  const MasterPrism prism(face);
  const FaceError face_error(face, Eigen::Vector3d::Zero());
  const PrismError error(prism, face_error, Side::E, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  ViewScratch scratch;
  ContactLaw law;
  law.max_penetration = 0.5;
  ViewError view(scratch, prism, error, law);
  VisiblePart part(7);
  part.moments.area = 0.25;
  part.moments.depth = 0.125;
  part.moments.greatest = 0.75;
  const ElementError found = view.of_element(part, face_error);
  EXPECT_EQ(found.area, 6 * 0.25);
  EXPECT_EQ(found.volume, 6 * 0.125);
  EXPECT_EQ(found.penetration, 0.5);
  // A foot is on the master, and so is any other.
  EXPECT_GE(found.foot_Me.x(), 2);
  EXPECT_GE(found.foot_Me.y(), 3);
  EXPECT_LT((found.foot_Me - Eigen::Vector3d(2, 3, 0)).norm(), 1e-14);
}

/// A face of F, 2^-48 m wide, and one of E beside it.
TEST(ViewError, IsNotKnownWhereTheMastersVerticesMayMoveByMoreThanAPartOfItsWidth) {
  const PreparedSurface slave = prepare_surface(generate::box({4, 1, -1}, {5, 2, 1}));
  const FaceGeometry needle({Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(2, 0x1p-48, 0)});
  const MasterPrism prism(needle);
  PosedPair posed;
  posed.place(slave, slave, {}, 0, false);
  WorkCounters work;
  SeenCorners corners;
  for (std::size_t k = 0; k < 3; ++k) corners.points[k] = prism.see(posed.face_Me(Side::E, 0)[k], work);
  for (const auto& [rounding, is_known] : {std::pair(0x1p-56, true), {0x1p-52, false}}) {
    const Eigen::Vector3d rounding_Me(0, rounding, 0);  // in the face's plane: its lines do not tilt
    const FaceError face_error(needle, rounding_Me);
    ASSERT_TRUE(face_error.normal_known);
    const PrismError error(prism, face_error, Side::F, rounding_Me, rounding_Me);
    ViewScratch scratch;
    ViewError view(scratch, prism, error, {});
    EXPECT_TRUE(view.known());
    view.see(posed[Side::E], 0, false, corners, nullptr, work);
    EXPECT_TRUE(scratch.sights.empty());
    EXPECT_EQ(view.known(), is_known);
  }
}

}  // namespace
}  // namespace pcm::fast
