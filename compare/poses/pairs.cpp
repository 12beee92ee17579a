// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/poses/pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "compare/poses/greatest_extent.h"
#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/degenerate/hard_bodies.h"
#include "meshes/generate/degenerate/lattice_tetrahedra.h"
#include "meshes/generate/degenerate/sunken_blocks.h"
#include "meshes/generate/parts.h"
#include "meshes/generate/round.h"
#include "pcm/read_mesh.h"

namespace pcm::compare {
namespace {

/// Coordinates rounded to multiples of 2^-12: sums, differences and quarters of them are exact.
TriangleMesh on_dyadic_grid(TriangleMesh mesh) {
  for (Eigen::Vector3d& x : mesh.vertices)
    for (int j = 0; j < 3; ++j) x[j] = std::ldexp(std::nearbyint(std::ldexp(x[j], 12)), -12);
  mesh.name += " on a grid of 2^-12";
  return mesh;
}

/// A file's name such that Markdown, CSV and JSON can hold it, and file names again.
std::string label(std::string name) {
  constexpr std::string_view kSigns = " +-.()=@";
  for (char& c : name) {
    const bool alphanumeric = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (!alphanumeric && kSigns.find(c) == std::string_view::npos) c = '_';
  }
  return name;
}

struct PairCost {
  std::string_view pair;
  PoseCost barycentric;
  PoseCost clipped;
};

/// Of the pairs that cost more than a few milliseconds.
constexpr PairCost kPairCosts[] = {
    {"bubble-bubble", {5.5, 42}, {64, 420}},
    {"pyramid-bubble", {8.7, 1}, {44, 4.7}},
    {"icosphere-plate", {3.8, 42}, {57, 290}},
    {"bumpy-bumpy", {89, 0}, {490, 0}},
    {"torus-plate", {7.8, 70}, {110, 640}},
    {"gear-gear", {43, 120}, {1800, 6700}},
    {"knot-box", {7.7, 71}, {140, 710}},
    {"box-gridded box", {1.9, 4.8}, {18, 180}},
    {"socket-ball", {24, 44}, {270, 340}},
    {"wedge-box", {2, 1}, {13, 9.5}},
    {"cylinder-cone", {5.7, 12}, {31, 180}},
    {"gridded cubes", {0, 0}, {40, 0}},
    {"slab-gridded cube", {0, 0}, {18, 0}},
    {"small icospheres", {0, 0}, {30, 0}},
    {"small tori", {0, 0}, {110, 0}},
    {"small gear-slab", {0, 0}, {50, 0}},
    {"elephant-hand", {30, 230}, {610, 2600}},
    {"femur-knot", {41, 290}, {840, 3700}},
    {"fandisk-pinion", {120, 67}, {800, 4300}},
    {"rotor-pinion", {27, 110}, {270, 1200}},
    {"elephant-elephant", {30, 250}, {570, 2900}},
};

/// A pair with variants is a whole family: it counts as so many pairs in the hard strata.
constexpr std::int64_t kFamilyWeight = 4;

/// Poses that cost less, in milliseconds, are asked as if they cost this. The barycentric one is as great as it must be
/// for a third of all poses to fall to pairs of 2,000 faces or more.
constexpr double kSmallBarycentricCost = 35;
constexpr double kSmallCost = 1.5;

/// Of other small pairs in the strata that are not hard, so that large ones have the bulk of these.
constexpr std::int64_t kHalfShare = kWholeShare / 2;

/// Of pairs that are made to hurt, where they take part in these strata too.
constexpr std::int64_t kSmallShare = kWholeShare / 16;

class PairList {
 public:
  void add_general(std::string name, TriangleMesh mesh_E, TriangleMesh mesh_F,
                   std::int64_t greatest_share = kWholeShare) {
    add(std::move(name), std::move(mesh_E), std::move(mesh_F));
    pairs.back().greatest_share = greatest_share;
  }
  void add_hard(std::string name, TriangleMesh mesh_E, TriangleMesh mesh_F) {
    add(std::move(name), on_dyadic_grid(std::move(mesh_E)), on_dyadic_grid(std::move(mesh_F)));
    pairs.back().for_hard_strata = true;
    pairs.back().for_all_strata = false;
  }
  /// Coordinates as they are, which must be dyadic. `greatest_share`: in the strata that are not hard; 0: no part
  /// there.
  void add_hurting(std::string name, TriangleMesh mesh_E, TriangleMesh mesh_F, std::int64_t greatest_share) {
    add(std::move(name), std::move(mesh_E), std::move(mesh_F));
    pairs.back().for_hard_strata = true;
    pairs.back().for_all_strata = greatest_share > 0;
    pairs.back().made_to_hurt = true;
    pairs.back().greatest_share = greatest_share;
  }
  /// The same and the pair with its bodies exchanged, each with its own name and so with poses of its own.
  void add_both_orders(const std::string& name_E, const TriangleMesh& mesh_E, const std::string& name_F,
                       const TriangleMesh& mesh_F, std::int64_t greatest_share) {
    add_hurting(name_E + "-" + name_F, mesh_E, mesh_F, greatest_share);
    add_hurting(name_F + "-" + name_E, mesh_F, mesh_E, greatest_share);
  }
  /// `pair_of(number)` gives its pairs, without a part in the strata that are not hard.
  template <class PairOf>
  void add_family(const std::string& name, const PairOf& pair_of) {
    constexpr std::uint64_t kPairs = 48;
    auto [first_E, first_F] = pair_of(0);
    add_hurting(name, std::move(first_E), std::move(first_F), 0);
    for (std::uint64_t number = 1; number < kPairs; ++number) pairs.back().variants.push_back(pair_of(number));
  }
  void add_files(std::string name, const std::filesystem::path& file_E, const std::filesystem::path& file_F,
                 std::vector<std::string>& missing) {
    ++turn_;  // The laws of the others don't depend on what is installed.
    for (const std::filesystem::path& file : {file_E, file_F})
      if (std::error_code ignored; !std::filesystem::is_regular_file(file, ignored)) {
        missing.push_back(name);
        return;
      }
    --turn_;
    add(std::move(name), read_mesh(file_E), read_mesh(file_F));
    pairs.back().file_E = file_E;
    pairs.back().file_F = file_F;
  }

  std::vector<SurfacePair> pairs;

 private:
  void add(std::string name, TriangleMesh mesh_E, TriangleMesh mesh_F) {
    SurfacePair pair;
    pair.name = std::move(name);
    pair.law = verification_law(turn_++, mesh_E, mesh_F);
    pair.E = std::move(mesh_E);
    pair.F = std::move(mesh_F);
    for (const PairCost& cost : kPairCosts)
      if (cost.pair == pair.name) {
        pair.barycentric_cost = cost.barycentric;
        pair.clipped_cost = cost.clipped;
      }
    pairs.push_back(std::move(pair));
  }

  std::size_t turn_ = 0;
};

/// Every second pair is the one before with its bodies exchanged.
std::array<TriangleMesh, 2> sunken_blocks_in_either_order(std::uint64_t number) {
  std::array<TriangleMesh, 2> pair = degenerate::sunken_blocks(number / 2);
  if (number % 2 == 1) std::swap(pair[0], pair[1]);
  return pair;
}

void add_hurting_pairs(PairList& list) {
  using namespace degenerate;
  using namespace generate;
  list.add_family("lattice tetrahedra", lattice_tetrahedra);

  // Thin or tiny parts: thinner than the penetration, or far smaller than the body.
  const TriangleMesh cube = box({1, 1, 1}), spike = fan_tipped_spike(0x1p-20), thin_plate = plate(1, 1, 0x1p-20, 2, 2);
  const TriangleMesh thin_needle = needle(0x1p-16), cubes = shrinking_cubes(4, 15);
  list.add_both_orders("spike", spike, "thin plate", thin_plate, kSmallShare);
  list.add_both_orders("spike", spike, "gridded cube", gridded_box(1, 2), 0);
  list.add_both_orders("needle", thin_needle, "cube", cube, kSmallShare);
  list.add_hurting("needles", thin_needle, thin_needle, 0);
  list.add_both_orders("thin plate", thin_plate, "cube", cube, kSmallShare);
  list.add_both_orders("shrinking cubes", cubes, "cube", cube, kSmallShare);
  list.add_hurting("shrinking cubes", cubes, cubes, 0);

  // Open surfaces.
  const TriangleMesh sheet = rectangle(1, 1, 2, 2), tray = open_box({1, 1, 0.5});
  list.add_both_orders("cube", cube, "sheet", sheet, kSmallShare);
  list.add_both_orders("cube", cube, "tray", tray, kSmallShare);
  list.add_both_orders("tray", tray, "sheet", sheet, kSmallShare / 2);
  // Edges of the beam pass through the sheet up to five times.
  list.add_both_orders("beam", box({1.5, 0.25, 0.25}), "folded sheet", folded_sheet(6, 0.125, 0.25), kSmallShare / 2);
  list.add_both_orders("cube without a face", without_face(cube, 3), "small wedge", on_dyadic_grid(wedge(45, 1, 1, 1)),
                       kSmallShare);

  // Cavities, folds, several windings, several components.
  const TriangleMesh star = pentagram(), eight = figure_of_eight();
  list.add_both_orders("hollow cube", hollow_cube(0.5), "cube", cube, kSmallShare);
  list.add_both_orders("pentagram", star, "cube", cube, kSmallShare);
  list.add_both_orders("figure of eight", eight, "cube", cube, kSmallShare);
  list.add_both_orders("pentagram", star, "figure of eight", eight, 0);
  // Small enough for whole faces of it to lie in the loop of negative winding.
  list.add_both_orders("figure of eight", eight, "small gridded cube", gridded_box(0.25, 2), 0);
  list.add_both_orders("square chain", torus_chain(3, 1, 0.25, 4, 4), "square ring", torus(1, 0.25, 4, 4), 0);
  const TriangleMesh chain = torus_chain(3, 0.5, 0.125, 16, 8), link = torus(0.5, 0.125, 16, 8);
  list.add_general("torus chain-torus", chain, link, kSmallShare);
  list.add_general("torus-torus chain", link, chain, kSmallShare);

  // A line in one plate leaves the stack through several of them: what lies before a face must not be guessed.
  list.add_hurting("plate stack-gridded cube", plate_stack(8, 0x1p-3, 0x1p-7), gridded_box(0.5, 2), 0);
  // A small turn about its marker moves the body far.
  list.add_hurting("cube-cube off its marker", cube, box({16, -0.5, -0.5}, {17, 0.5, 0.5}), kSmallShare);
  // Lines of edges that go on along other edges at other depths.
  list.add_family("sunken blocks", sunken_blocks_in_either_order);
}

}  // namespace

ContactLaw verification_law(std::size_t turn, const TriangleMesh& mesh_E, const TriangleMesh& mesh_F) {
  const double size = std::min(greatest_extent(mesh_E), greatest_extent(mesh_F));
  ContactLaw law;
  law.stiffness = 5.9e5;
  switch (turn % 4) {
    case 0:
      law.damping = 1000;
      law.transition_depth = size / 1024;
      law.friction = 0.25;
      law.slip_velocity = size / 64;
      break;
    case 1:
      break;
    case 2:
      law.layers = LayerStiffness{1.2e6, std::numeric_limits<double>::infinity()};
      law.damping = 500;
      law.damping_mode = DampingMode::full;
      law.friction = 0.5;
      break;
    default:
      law.layers = LayerStiffness{3.2e7, 2.1e7};
      law.damping = 2e5;
      law.damping_mode = DampingMode::compression;
      law.friction = 0.4;
      law.slip_velocity = size / 256;
      law.max_penetration = size / 16;
      break;
  }
  return law;
}

double SurfacePair::cost(Stratum stratum, Scheme scheme) const {
  const PoseCost& costs = scheme == Scheme::clipped ? clipped_cost : barycentric_cost;
  return stratum == Stratum::nested ? costs.nested : costs.usual;
}

std::int64_t SurfacePair::share(Stratum stratum, Scheme scheme) const {
  const bool nested = stratum == Stratum::nested;
  if (const double cost_here = cost(stratum, scheme); cost_here > 0) {
    const auto whole = static_cast<double>(hard(stratum) ? kWholeShare : greatest_share);
    const double small = scheme == Scheme::clipped || nested ? kSmallCost : kSmallBarycentricCost;
    return std::max<std::int64_t>(1, std::llround(whole * std::min(1.0, small / cost_here)));
  }
  const std::int64_t usual = faces() > 20000 ? kWholeShare / 16 : faces() > 8000 ? kWholeShare / 4 : kWholeShare;
  if (hard(stratum)) return variants.empty() ? usual : kFamilyWeight * usual;
  return std::min(greatest_share, nested && faces() > 2000 ? std::max(kWholeShare / 16, usual / 8) : usual);
}

std::vector<SurfacePair> built_in_pairs(const std::filesystem::path& real_surfaces, std::vector<std::string>& missing) {
  using namespace generate;
  PairList list;
  list.add_general("bubble-bubble", bubble(), bubble());
  list.add_general("pyramid-bubble", pyramid(), bubble());
  list.add_general("icosphere-plate", icosphere(0.5, 3), plate(2, 2, 0.25, 20, 20));
  list.add_general("bumpy-bumpy", bumpy_sphere(), bumpy_sphere());
  list.add_general("torus-plate", torus(0.5, 0.2, 48, 24), plate(2, 2, 0.25));
  list.add_general("gear-gear", spur_gear(20, 0.1, 0.5, 4, 2), spur_gear(20, 0.1, 0.5, 4, 2));
  list.add_general("knot-box", knotted_tube(0.5, 0.1, 96, 12), box({1.5, 1, 0.5}));
  list.add_general("box-gridded box", box({1, 1, 1}), gridded_box(1, 4), kHalfShare);
  list.add_general("socket-ball", socket(1.01, 0.5, 32, 16), icosphere(1, 3));
  list.add_general("wedge-box", wedge(30, 1, 1, 4), box({1.5, 1.5, 0.5}), kHalfShare);
  list.add_general("cylinder-cone", cylinder(0.3, 1, 24, 4, 2), cone(0.5, 1, 24, 4, 2), kHalfShare);

  list.add_hard("cube-cube", box({1, 1, 1}), box({1, 1, 1}));
  list.add_hard("slab-gridded cube", box({2, 2, 0.5}), gridded_box(1, 3));
  list.add_hard("gridded cubes", gridded_box(1, 2), gridded_box(1, 2));
  list.add_hard("wedges", wedge(45, 1, 1, 1), wedge(45, 1, 1, 1));
  list.add_hard("small icosphere-plate", icosphere(0.5, 1), plate(1, 1, 0.25, 2, 2));
  list.add_hard("small icospheres", icosphere(0.5, 1), icosphere(0.5, 1));
  list.add_hard("cylinder-cube", cylinder(0.5, 1, 12), box({1, 1, 1}));
  list.add_hard("small pyramid-cube", pyramid(), box({1, 1, 1}));
  list.add_hard("small tori", torus(0.5, 0.25, 8, 6), torus(0.5, 0.25, 8, 6));
  list.add_hard("small gear-slab", spur_gear(6, 0.25, 0.5, 2), box({1, 1, 0.5}));

  const auto file = [&](const char* surface) { return real_surfaces / (std::string(surface) + ".off"); };
  list.add_files("elephant-hand", file("elephant"), file("hand"), missing);
  list.add_files("femur-knot", file("femur"), file("knot1"), missing);
  list.add_files("fandisk-pinion", file("fandisk"), file("pinion"), missing);
  list.add_files("rotor-pinion", file("rotor"), file("pinion"), missing);
  list.add_files("elephant-elephant", file("elephant"), file("elephant"), missing);

  add_hurting_pairs(list);
  return std::move(list.pairs);
}

std::filesystem::path installed_real_surfaces() {
  std::error_code error;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", error);
  return executable.parent_path().parent_path() / "cgal-demo" / "data" / "meshes";
}

std::string pair_name(const std::string& name_E, const std::string& name_F) {
  return label(name_E) + "-" + label(name_F);
}

void tell_apart(std::vector<SurfacePair>& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (pairs[j].name == pairs[i].name) pairs[i].name += " (" + std::to_string(i + 1) + ")";
}

SurfacePair pair_from_files(const std::filesystem::path& file_E, const std::filesystem::path& file_F) {
  SurfacePair pair;
  pair.name = pair_name(file_E.stem().string(), file_F.stem().string());
  pair.E = read_mesh(file_E);
  pair.F = read_mesh(file_F);
  pair.file_E = file_E;
  pair.file_F = file_F;
  pair.law = verification_law(0, pair.E, pair.F);
  pair.for_hard_strata = true;
  return pair;
}

}  // namespace pcm::compare
