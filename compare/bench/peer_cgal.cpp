// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/version.h>

#include <boost/config/helper_macros.hpp>

#include "compare/bench/peer.h"
#include "compare/peers/cgal_pair.h"

namespace pcm::compare {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

/// A peer whose `prepare` places F.
template <class Kernel>
class Cgal : public Peer {
 public:
  using Mesh = typename CgalPair<Kernel>::Mesh;

  Cgal(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  void prepare(const Pose& pose) override { pair_.place(pose); }

 protected:
  CgalPair<Kernel> pair_;
};

template <class Kernel>
class SurfaceIntersection final : public Cgal<Kernel> {
 public:
  using Cgal<Kernel>::Cgal;

  std::int64_t query(const Pose& /*pose*/) override {
    std::vector<std::vector<typename Kernel::Point_3>> polylines;
    processing::surface_intersection(this->pair_.E, this->pair_.F, std::back_inserter(polylines));
    std::int64_t segments = 0;
    for (const auto& polyline : polylines) segments += static_cast<std::int64_t>(polyline.size()) - 1;
    return segments;
  }
};

/// Corefinement changes its operands, so it gets copies of them.
template <class Kernel>
class Corefinement final : public Cgal<Kernel> {
 public:
  using Cgal<Kernel>::Cgal;
  using typename Cgal<Kernel>::Mesh;

  void prepare(const Pose& pose) override {
    Cgal<Kernel>::prepare(pose);
    copy_E_ = this->pair_.E;
    copy_F_ = this->pair_.F;
    solid_ = Mesh();
  }

  std::int64_t query(const Pose& /*pose*/) override {
    processing::corefine_and_compute_intersection(copy_E_, copy_F_, solid_);
    return static_cast<std::int64_t>(solid_.number_of_faces());
  }

 private:
  Mesh copy_E_, copy_F_, solid_;
};

template <class Chosen>
PeerEntry cgal_entry(const char* who, const char* computes, const char* finds) {
  return {who,
          computes,
          finds,
          "libcgal-dev",
          false,
          [](const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
            return std::make_unique<Chosen>(mesh_E, mesh_F); }};
}

}  // namespace

std::vector<PeerEntry> cgal_peers() {
  constexpr const char* kInexact = "CGAL " BOOST_STRINGIZE(CGAL_VERSION) " inexact";
  constexpr const char* kExact = "CGAL " BOOST_STRINGIZE(CGAL_VERSION) " exact";
  return {
      cgal_entry<SurfaceIntersection<Inexact>>(kInexact, "surface_intersection", "segments"),
      cgal_entry<SurfaceIntersection<Exact>>(kExact, "surface_intersection", "segments"),
      cgal_entry<Corefinement<Inexact>>(kInexact, "corefinement", "faces"),
      cgal_entry<Corefinement<Exact>>(kExact, "corefinement", "faces"),
  };
}

}  // namespace pcm::compare
