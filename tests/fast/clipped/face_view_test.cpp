// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast/clipped/face_view.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "fast/surface/prepare_surface.h"
#include "meshes/generate/boxes.h"

namespace pcm::fast {
namespace {

// In the plane of a flat side each sight takes exact numbers.
TEST(OwnCorners, LooksAtEachVertexOnceForEachMasterFaceAndSeesIt) {
  const PreparedSurface box = prepare_surface(generate::gridded_box(Eigen::Vector3d(1, 0.7, 0.3), {4, 3, 2}));
  Pose pose;
  pose.A = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto faces = static_cast<Index>(box.mesh.faces.size());
  for (const Side master : {Side::E, Side::F}) {
    PosedPair posed;
    posed.place(box, box, pose, 0, false);
    for (Index master_face = 0; master_face < faces; ++master_face) {
      const MasterPrism prism(face_with_sure_normal(posed.face_Me(master, master_face)));
      const auto seen_before = posed.work.predicates;
      std::set<Index> looked_at;
      OwnSights sights(prism, box.face(master_face));
      for (Index face = 0; face < faces; ++face) {
        const SeenCorners corners = own_corners(posed[master], face, sights, posed.work);
        for (std::size_t k = 0; k < 3; ++k) {
          const Index v = box.face(face)[k];
          const int shared = corner_at(box.face(master_face), v);
          ASSERT_EQ(corners.is_shared()[k], shared >= 0);
          if (shared < 0) looked_at.insert(v);
          WorkCounters none;
          ASSERT_EQ(corners.points[k],
                    shared >= 0 ? MasterPrism::corner(shared) : prism.see(posed.vertex_Me(master, v), none));
        }
      }
      ASSERT_EQ(looked_at.size(), box.mesh.vertices.size() - 3);
      ASSERT_EQ(posed.work.predicates - seen_before, static_cast<std::int64_t>(looked_at.size()));
    }
    EXPECT_GT(posed.work.exact_predicates, 100);
  }
}

}  // namespace
}  // namespace pcm::fast
