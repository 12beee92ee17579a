// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/bounds/clipped_error.h"

#include <gtest/gtest.h>

#include "fast/bounds/element_error.h"

namespace pcm::fast {
namespace {

/// An engine that sees a part of a face which the exact problem's lines surely do not meet has all of it too much.
TEST(ViewError, OfAPartOfAFaceThatIsSurelyUnseenIsAllOfIt) {
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

}  // namespace
}  // namespace pcm::fast
