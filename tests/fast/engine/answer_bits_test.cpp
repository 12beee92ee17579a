// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every bit of answers, bounds and derivatives included, is what it was. That the answers are right is for other tests;
// this one notices what these allow, as a bound that is weaker by half and still kept. Whoever changes an answer on
// purpose puts the new hashes into answer_bits.csv, which a failing test leaves where it ran: the columns tell which
// part of which answers is another one.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "meshes/generate/boxes.h"
#include "meshes/generate/bubbles.h"
#include "meshes/generate/round.h"
#include "pcm/engine.h"
#include "tests/fast/answer_hash.h"
#include "tests/fast/engine/kept_table.h"
#include "tests/fast/exact_draw.h"

namespace pcm::fast::answer_bits_test {
namespace {

using Eigen::Vector3d;

constexpr const char* kColumns = "bodies,scheme,master,touching,polygons,areas,elements,force,statistics,bound,tangent";

/// What answers consist of, each with a hash of its own.
struct Hashes {
  int touching = 0;
  test::Hash polygons, areas, elements, force, statistics, bound, tangent;

  void add(const Contact& contact) {
    touching += contact.touching ? 1 : 0;
    test::add_polygons(polygons, contact);
    test::add(areas, contact.E);
    test::add(areas, contact.F);
    areas.add(contact.volume);
    for (const Element& element : contact.elements) test::add(elements, element);
    elements.add(contact.too_deep);
    elements.add(contact.max_penetration);
    force.add(contact.force_Me);
    force.add(contact.torque_Me);
    test::add(statistics, contact.statistics);
    if (contact.bound) test::add(bound, *contact.bound);
    if (contact.tangent) test::add(tangent, *contact.tangent);
  }
  std::string text() const {
    std::string text = std::to_string(touching);
    for (const test::Hash& hash : {polygons, areas, elements, force, statistics, bound, tangent}) {
      std::array<char, 17> digits{};
      std::snprintf(digits.data(), digits.size(), "%016" PRIx64, hash.value());
      text += ',' + std::string(digits.data());
    }
    return text;
  }
};

struct Bodies {
  std::string name;
  TriangleMesh E, F;
  double extent;  ///< of offsets drawn, m
};

TriangleMesh stretched(TriangleMesh mesh, const Vector3d& by) {
  for (Vector3d& x : mesh.vertices) x = x.cwiseProduct(by);
  return mesh;
}

std::vector<Bodies> all_bodies() {
  const TriangleMesh box = generate::gridded_box(Vector3d(1, 1, 1), {2, 3, 2});
  const TriangleMesh sphere = generate::icosphere(1, 2);
  return {{"bubbles", generate::bubble(), generate::bubble(), 0.2},
          {"spheres", sphere, sphere, 1.1},
          {"torus and box", generate::torus(1, 0.3, 16, 8), generate::box(Vector3d(2, 1, 0.5)), 1},
          {"boxes", box, box, 0.7},
          {"sheet and sphere", generate::rectangle(2, 2, 5, 5), sphere, 0.9},
          {"needles", stretched(sphere, {1, 0x1p-12, 0x1p-6}), stretched(sphere, {0x1p-8, 1, 0x1p-8}), 0x1p-7}};
}

/// Drawn ones, ones on a lattice where features coincide, those moved by ulps, and those turned by less than 2^-30.
Pose pose_of(test::ExactDraw& draw, int i, double extent) {
  if (i % 4 == 0) return {draw.rotation(), draw.vector(extent)};
  int exponent = 0;
  std::frexp(extent, &exponent);
  Pose pose{Eigen::Matrix3d::Identity(), std::ldexp(1, exponent) * draw.lattice_vector()};
  if (i % 4 == 2) {
    for (double& x : pose.r) x = std::nextafter(x, draw.between(-16, 16));
  }
  if (i % 4 == 3) {
    const double turn = draw.between(-0x1p-30, 0x1p-30);
    pose.A(0, 1) = -turn;
    pose.A(1, 0) = turn;
  }
  return pose;
}

/// Those of all hashes, and one with friction and one with damping alone: bounds ask for each.
std::vector<ContactLaw> all_laws() {
  std::vector<ContactLaw> laws;
  for (const test::Law& law : test::laws()) laws.push_back(law.law);
  ContactLaw damped = laws[1], friction = laws[1];
  damped.friction = 0;
  friction.damping = 0;
  laws.insert(laws.end(), {damped, friction});
  return laws;
}

std::string row_of(const Bodies& bodies, Scheme scheme, Mode mode) {
  const Surface E(bodies.E), F(bodies.F);
  test::ExactDraw draw;
  const std::vector<ContactLaw> laws = all_laws();
  Workspace workspace;
  Wanted wanted;
  wanted.bound = wanted.tangent = true;
  Hashes hashes;
  for (int i = 0; i < 96; ++i) {
    const Pose pose = pose_of(draw, i, bodies.extent);
    const Velocity velocity{draw.vector(1), draw.vector(2)};
    hashes.add(evaluate(Pairing(E, F, laws[static_cast<std::size_t>(i) % laws.size()], mode, scheme), pose, velocity,
                        wanted, workspace));
  }
  const char* const master = mode == Mode::both ? "both" : mode == Mode::E ? "E" : "F";
  return bodies.name + ',' + (scheme == Scheme::clipped ? "clipped" : "barycentric") + ',' + master + ',' +
         hashes.text();
}

TEST(AnswerBits, AreWhatTheyWere) {
  std::vector<std::string> rows{kColumns};
  for (const Bodies& bodies : all_bodies()) {
    for (const Scheme scheme : {Scheme::barycentric, Scheme::clipped}) {
      for (const Mode mode : {Mode::E, Mode::F, Mode::both}) rows.push_back(row_of(bodies, scheme, mode));
    }
  }
  test::expect_kept(rows, "answer_bits.csv");
}

}  // namespace
}  // namespace pcm::fast::answer_bits_test
