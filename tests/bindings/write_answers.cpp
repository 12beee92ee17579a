// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_answers FOLDER: draws 1,008 poses and writes them there with the engine's answers, for the tests of other
// languages to compare with: surfaces as OBJ files, and answers.txt, whose numbers are 64 bits in hexadecimal, doubles
// as they lie in memory.
//
// answers.txt: the number of pairings; for each of them a line with its two files, a line with mode, scheme, damping
// mode, the law's numbers in the order of pcm_law and the number of poses; for each of these a line with what is
// wanted, A by rows, r, v and w, and a line with the answer: its integers in the order of pcm_answer, those of E, F and
// the bound at the end; its doubles in the same order; and a checksum over its lists, see Checksum.
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "compare/poses/pairs.h"
#include "compare/poses/strata.h"
#include "pcm/engine.h"
#include "pcm/write_obj.h"
#include "tests/fast/varied_questions.h"

namespace pcm::fast {
namespace {

constexpr int kPosesOfPairing = 72;
constexpr std::uint64_t kSeed = 2003;

/// The exclusive or of all bits added, those of the i-th number rotated left by i modulo 64.
class Checksum {
 public:
  void add(std::uint64_t bits) { sum_ ^= std::rotl(bits, count_++ % 64); }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(Index i) { add(static_cast<std::uint64_t>(i)); }
  void add(bool b) { add(std::uint64_t{b}); }
  void add(Side side) { add(side == Side::F); }
  void add(const Eigen::Vector3d& x) {
    for (const double c : x) add(c);
  }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0;
  int count_ = 0;
};

/// Over elements, polygons, crossings and the active faces, each with all of its numbers in the order of the C
/// interface's structs, and the tangent's numbers by rows.
std::uint64_t checksum(const Contact& contact) {
  Checksum sum;
  for (const Element& element : contact.elements) {
    sum.add(element.master);
    for (const Index face : {element.master_face, element.slave_face}) sum.add(face);
    for (const double x : {element.area, element.penetration, element.normal_velocity, element.tangential_velocity,
                           element.normal_force, element.tangential_force})
      sum.add(x);
    for (const Eigen::Vector3d& x : {element.normal_Me, element.position_Me, element.force_Me}) sum.add(x);
  }
  for (const Polygon& polygon : contact.polygons) {
    sum.add(polygon.closed);
    for (const Index i : {polygon.first, polygon.count, polygon.patch}) sum.add(i);
  }
  for (const Crossing& crossing : contact.crossings) {
    sum.add(crossing.edge_side);
    for (const Index i : {crossing.edge[0], crossing.edge[1], crossing.face}) sum.add(i);
    sum.add(crossing.position_Me);
  }
  for (const ActiveArea* area : {&contact.E, &contact.F})
    for (const std::vector<Index>* faces : {&area->intersected, &area->inner})
      for (const Index face : *faces) sum.add(face);
  if (contact.tangent)
    for (const auto& row : contact.tangent->rowwise())
      for (const double x : row) sum.add(x);
  return sum.value();
}

/// A line of numbers.
class Line {
 public:
  void add(std::uint64_t bits) {
    char text[20];
    std::snprintf(text, sizeof text, "%016" PRIx64 " ", bits);
    text_ += text;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const Eigen::Vector3d& x) {
    for (const double c : x) add(c);
  }
  void write(std::ofstream& out) const { out << text_ << '\n'; }

 private:
  std::string text_;
};

std::uint64_t length(const auto& list) {
  return list.size();
}

Line answer_line(const Contact& contact) {
  Line line;
  const ForceBound bound = contact.bound.value_or(ForceBound{});
  for (const std::uint64_t i :
       {std::uint64_t{contact.touching}, std::uint64_t{contact.nested}, std::uint64_t{contact.ambiguous},
        std::uint64_t{contact.has_volume}, std::uint64_t{contact.penetration_exceeded},
        static_cast<std::uint64_t>(contact.too_deep), static_cast<std::uint64_t>(contact.undefined_areas),
        static_cast<std::uint64_t>(contact.patches), length(contact.polygons), length(contact.crossings),
        static_cast<std::uint64_t>(contact.element_count), length(contact.elements), length(contact.E.intersected),
        length(contact.E.inner), length(contact.F.intersected), length(contact.F.inner),
        std::uint64_t{contact.bound.has_value()}, std::uint64_t{bound.flipped}})
    line.add(i);
  line.add(contact.force_Me);
  line.add(contact.torque_Me);
  line.add(contact.max_penetration);
  line.add(contact.volume);
  for (const ActiveArea* area : {&contact.E, &contact.F}) {
    line.add(area->area);
    line.add(area->vector_area_Me);
  }
  line.add(bound.force_Me);
  line.add(bound.torque_Me);
  line.add(bound.penetration_at_least);
  line.add(bound.penetration_at_most);
  const Statistics& statistics = contact.statistics;
  for (const double x : {statistics.patch_area, statistics.mean_penetration, statistics.max_pressure,
                         statistics.mean_pressure, statistics.max_normal_velocity, statistics.max_tangential_velocity})
    line.add(x);
  line.add(statistics.centre_of_pressure_Me);
  line.add(checksum(contact));
  return line;
}

Line question_line(std::uint64_t wanted, const compare::DrawnPose& drawn) {
  Line line;
  line.add(wanted);
  for (int row = 0; row < 3; ++row) line.add(Eigen::Vector3d(drawn.pose.A.row(row)));
  for (const Eigen::Vector3d& x : {drawn.pose.r, drawn.velocity.v, drawn.velocity.w}) line.add(x);
  return line;
}

Line pairing_line(const Pairing& pairing) {
  Line line;
  const ContactLaw& law = pairing.law();
  line.add(static_cast<std::uint64_t>(pairing.mode()));
  line.add(static_cast<std::uint64_t>(pairing.scheme()));
  line.add(static_cast<std::uint64_t>(law.damping_mode));
  const LayerStiffness layers = law.layers.value_or(LayerStiffness{0, 0});
  for (const double x : {law.stiffness, layers.c_E, layers.c_F, law.damping, law.transition_depth, law.friction,
                         law.slip_velocity, law.max_penetration})
    line.add(x);
  line.add(std::uint64_t{kPosesOfPairing});
  return line;
}

struct Tally {
  int poses = 0;
  int touching = 0;
};

/// All strata but `nested`, which has surfaces of its own.
constexpr compare::Stratum kStrata[] = {compare::Stratum::generic,    compare::Stratum::generic,
                                        compare::Stratum::grazing,    compare::Stratum::separated,
                                        compare::Stratum::degenerate, compare::Stratum::near_degenerate};

void write_poses(const Pairing& pairing, const compare::FeaturePair& features, std::uint64_t number, std::ofstream& out,
                 Tally& tally) {
  Workspace workspace;
  for (std::uint64_t i = 0; i < kPosesOfPairing; ++i) {
    const compare::Stratum stratum = kStrata[i % std::size(kStrata)];
    const compare::PoseRandom random(kSeed, static_cast<std::uint64_t>(stratum), number, i);
    const compare::DrawnPose drawn = compare::draw_pose(stratum, features, random);
    const std::uint64_t number_of_wanted = (i + 9 * number) % test::kAllWanted;
    Wanted wanted = test::wanted_by_number(number_of_wanted);
    wanted.tangent = i % 3 != 0;
    const Contact& contact = evaluate(pairing, drawn.pose, drawn.velocity, wanted, workspace);
    question_line(number_of_wanted + (wanted.tangent ? test::kAllWanted : 0), drawn).write(out);
    answer_line(contact).write(out);
    ++tally.poses;
    if (contact.touching) ++tally.touching;
  }
}

Tally write_answers(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream out(folder / "answers.txt");
  Tally tally;
  const std::vector<compare::SurfacePair> all = test::varied_pairs();
  out << 2 * all.size() << '\n';
  std::uint64_t number = 0;
  for (const compare::SurfacePair& pair : all) {
    const std::string file_E = std::to_string(number) + "_E.obj", file_F = std::to_string(number) + "_F.obj";
    write_obj(pair.E, folder / file_E);
    write_obj(pair.F, folder / file_F);
    const Surface E(pair.E), F(pair.F);
    const compare::FeaturePair features(pair.E, pair.F);
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      const Pairing pairing(E, F, pair.law, static_cast<Mode>(number % 3), scheme);
      out << file_E << ' ' << file_F << '\n';
      pairing_line(pairing).write(out);
      write_poses(pairing, features, number++, out, tally);
    }
  }
  return tally;
}

}  // namespace
}  // namespace pcm::fast

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const pcm::fast::Tally tally = pcm::fast::write_answers(argv[1]);
  std::printf("%d poses, %d touching\n", tally.poses, tally.touching);
  // Poses that miss would compare nothing.
  return tally.poses >= 1000 && 2 * tally.touching > tally.poses ? 0 : 1;
}
