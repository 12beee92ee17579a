// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include "compare/contestants/contestant.h"
#include "compare/peers/cgal_pair.h"

namespace {

using namespace pcm;
using namespace pcm::compare;
namespace processing = CGAL::Polygon_mesh_processing;

using Pair = CgalPair<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Mesh = Pair::Mesh;

/// Adds up the area of the faces of the intersection by the surface that they come from.
struct AreaBySurface : processing::Corefinement::Default_visitor<Mesh> {
  const Mesh* E = nullptr;
  const Mesh* F = nullptr;
  double* area_E = nullptr;
  double* area_F = nullptr;

  void after_face_copy(Mesh::Face_index face, const Mesh& from, Mesh::Face_index /*copy*/, Mesh& /*into*/) const {
    if (&from == E) *area_E += processing::face_area(face, from);
    if (&from == F) *area_F += processing::face_area(face, from);
  }
};

/// Corefinement as its manual has it: exact decisions, points of intersection rounded.
class Cgal final : public Contestant {
 public:
  Cgal(const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) : pair_(mesh_E, mesh_F) {}

  GivenAnswer answer(const PosedQuestion& question) override {
    pair_.place(question.pose);
    GivenAnswer answer;
    answer.touching = processing::do_intersect(pair_.E, pair_.F);
    intersect(answer);
    return answer;
  }

 private:
  /// Corefinement changes its operands, so it gets copies of them. Where the intersection is no manifold it says so and
  /// has no answer.
  void intersect(GivenAnswer& answer) const {
    Mesh E = pair_.E, F = pair_.F, solid;
    double area_E = 0, area_F = 0;
    AreaBySurface areas;
    areas.E = &E;
    areas.F = &F;
    areas.area_E = &area_E;
    areas.area_F = &area_F;
    if (!processing::corefine_and_compute_intersection(E, F, solid, CGAL::parameters::visitor(areas))) return;
    answer.volume = processing::volume(solid);
    answer.E.area = area_E;
    answer.F.area = area_F;
  }

  Pair pair_;
};

}  // namespace

int main() {
  return pcm::compare::converse_as<Cgal>();
}
