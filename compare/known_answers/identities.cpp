// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/known_answers/identities.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/bodies/known_answer_bodies.h"
#include "compare/io/names.h"
#include "compare/known_answers/identity_constructions.h"
#include "compare/known_answers/identity_loads.h"
#include "compare/known_answers/identity_support.h"
#include "reference/oracle.h"
#include "reference/proofs/identities.h"

namespace pcm::compare {
namespace {

std::string in_words(Mode mode, Scheme scheme) {
  return fmt::format("mode {}, {}", name(mode), name(scheme));
}

/// A difference, with where it was found.
std::string found_in(const std::string& what, const std::string& difference) {
  return difference.empty() ? "" : what + ": " + difference;
}

void both_is_the_mean(const Posed& posed, Findings& findings) {
  for (const Scheme scheme : kSchemes) {
    const fast::Contact E = answer(posed, Mode::E, scheme), F = answer(posed, Mode::F, scheme);
    const fast::Contact both = answer(posed, Mode::both, scheme);
    const bool mean = both.force_Me == 0.5 * (E.force_Me + F.force_Me) &&
                      both.torque_Me == 0.5 * (E.torque_Me + F.torque_Me) &&
                      both.element_count == E.element_count + F.element_count;
    findings.same(mean ? "" : in_words(Mode::both, scheme) + ": not the mean");
  }
}

/// The engine's answer as callers get it, which forms elements in another way than one with bounds; and its bound.
fast::Contact bounded_answer(const Posed& posed, Mode mode, Scheme scheme) {
  fast::Contact contact = answer(posed, mode, scheme);
  Wanted wanted;
  wanted.bound = true;
  contact.bound = answer(posed, mode, scheme, wanted).bound;
  return contact;
}

/// The barycentric scheme only: which slivers the clipped one drops depends on how far F reaches at most, as its box
/// says.
void place_beforehand(const Posed& posed, Findings& findings) {
  Posed at_rest = posed;
  at_rest.velocity = Velocity();
  const Posed placed = placed_beforehand(at_rest);
  if (!fit_for_contact(placed)) return;
  const fast::Contact plain = answer(at_rest, Mode::both, Scheme::barycentric);
  fast::Contact other = answer(placed, Mode::both, Scheme::barycentric);
  other.torque_Me = plain.torque_Me;  // About Me there.
  findings.same(difference(plain, other));
}

/// Action and reaction: `load` is asked of the pair and of the pair exchanged, in mode E and in mode F.
///
/// A law for faces and their points, it holds of any surfaces that pose one problem both ways; so vertices must not be
/// rounded, for which body's are is what changes when the bodies do. That matters where a force jumps: before faces of
/// one surface that lie on one another in one plane (a figure of eight's caps) the tie goes by face index, on F as
/// rounded by which of them a rounding has put in front. Without rounding, nothing is asked of the surfaces. What the
/// tie rule of crossings decides, in which E's vertices come first, it may decide another way.
template <class Load>
void exchange(const Posed& posed, Findings& findings, const Load& load) {
  const Posed direct = without_rounding(posed), exchanged = exchanged_pair(direct);
  if (!fit_for_contact(direct) || answer(direct, Mode::E, Scheme::clipped).work.tie_breaks > 0) return;
  for (const Scheme scheme : kSchemes)
    for (const Mode mode : {Mode::E, Mode::F}) {
      const Mode same_master = mode == Mode::E ? Mode::F : Mode::E;
      expect_one_load(findings, in_words(mode, scheme), load(direct, mode, scheme),
                      seen_from_E(load(exchanged, same_master, scheme), direct.pose));
    }
}

BoundedLoad engine_load(const Posed& posed, Mode mode, Scheme scheme) {
  return load_of(bounded_answer(posed, mode, scheme));
}

reference::Answer oracle_answer(const Posed& posed, Mode mode, Scheme scheme) {
  Wanted wanted;
  wanted.polygons = false;
  const reference::Oracle oracle(posed.E, posed.F, posed.law, mode, scheme);
  return oracle.answer(reference::Problem::rounded, posed.pose, posed.velocity, wanted);
}

BoundedLoad oracle_load(const Posed& posed, Mode mode, Scheme scheme) {
  return load_of(oracle_answer(posed, mode, scheme));
}

void reorder(const Posed& posed, Findings& findings) {
  PoseRandom random(1, 0, 0, posed.stream);
  Posed other = posed;
  other.E = reordered(posed.E, random);
  other.F = reordered(posed.F, random);
  for (const Scheme scheme : kSchemes) {
    const fast::Contact plain = bounded_answer(posed, Mode::both, scheme);
    // A tie may be decided another way by the new order.
    if (plain.work.tie_breaks > 0) continue;
    const fast::Contact permuted = bounded_answer(other, Mode::both, scheme);
    const bool alike = plain.crossings.size() == permuted.crossings.size() && plain.patches == permuted.patches &&
                       plain.E.inner.size() == permuted.E.inner.size() &&
                       plain.F.inner.size() == permuted.F.inner.size();
    findings.same(alike ? "" : "crossings, patches or inner faces differ in number");
    expect_within_bounds(findings, in_words(Mode::both, scheme), plain, permuted);
  }
}

Posed scaled(const Posed& posed, double s) {
  Posed other = posed;
  for (TriangleMesh* mesh : {&other.E, &other.F})
    for (Eigen::Vector3d& x : mesh->vertices) x *= s;
  other.pose.r *= s;
  other.velocity.v *= s;
  other.law.slip_velocity *= s;
  other.law.transition_depth *= s;
  other.law.max_penetration *= s;
  return other;
}

void scale_lengths(const Posed& posed, int step, Findings& findings) {
  for (const Scheme scheme : kSchemes) {
    const fast::Contact plain = answer(posed, Mode::both, scheme);
    for (int k = -40; k <= 40; k += step) {
      Similarity similarity;
      similarity.length = std::ldexp(1.0, k);
      findings.same(
          found_in(fmt::format("2^{}, {}", k, in_words(Mode::both, scheme)),
                   difference(plain, answer(scaled(posed, similarity.length), Mode::both, scheme), similarity)));
    }
  }
}

Posed negated(const Posed& posed, const Eigen::Vector3d& signs) {
  Posed other = posed;
  for (TriangleMesh* mesh : {&other.E, &other.F})
    for (Eigen::Vector3d& x : mesh->vertices) x = x.cwiseProduct(signs);
  other.pose.A = signs.asDiagonal() * posed.pose.A * signs.asDiagonal();
  for (Eigen::Vector3d* x : {&other.pose.r, &other.velocity.v, &other.velocity.w}) *x = x->cwiseProduct(signs);
  return other;
}

void negate_axes(const Posed& posed, Findings& findings) {
  for (const Scheme scheme : kSchemes) {
    const fast::Contact plain = answer(posed, Mode::both, scheme);
    if (plain.work.tie_breaks > 0) continue;
    for (Eigen::Index kept = 0; kept < 3; ++kept) {
      Similarity similarity;
      similarity.signs = -Eigen::Vector3d::Ones();
      similarity.signs[kept] = 1;
      findings.same(
          found_in(fmt::format("all but axis {}, {}", kept, in_words(Mode::both, scheme)),
                   difference(plain, answer(negated(posed, similarity.signs), Mode::both, scheme), similarity)));
    }
  }
}

/// The elastic law of a pair, clamped as it is: faces split carry elements of their own, at other velocities.
Posed elastic(Posed posed) {
  ContactLaw law = stiffness(posed.law.stiffness);
  law.max_penetration = posed.law.max_penetration;
  posed.law = law;
  return posed;
}

/// The same pose with another E.
Posed with_E(Posed posed, TriangleMesh mesh) {
  posed.E = std::move(mesh);
  return posed;
}

/// The slave's depth below a point, and what of the master is active, are matters of the slave as a set of oriented
/// points, and of the order of faces that lie on one another in one plane. Splitting keeps both, so this holds of any
/// surface. The two problems differ in nothing else: F is rounded in one way.
template <class Load>
void split_slave(const Posed& posed, Findings& findings, const Load& load) {
  const Posed whole = elastic(posed), parts = with_E(whole, split(whole.E));
  for (const Scheme scheme : kSchemes)
    expect_one_load(findings, in_words(Mode::F, scheme), load(whole, Mode::F, scheme), load(parts, Mode::F, scheme));
}

/// SplitMasterFaces says of which faces this holds, and why. Quarters of the large faces before a slave that is open or
/// folded are rarely all active; of halves, cut in several ways, both often are.
template <class Answer>
void split_master(const Posed& posed, Findings& findings, const Answer& answer_to) {
  const Posed whole = elastic(posed);
  PoseRandom random(2, 0, 0, posed.stream);
  const auto plain = answer_to(whole, Mode::E, Scheme::clipped);
  for (int cuts = 0; cuts < 4; ++cuts) {
    const SplitMesh split_E = cuts == 0 ? quartered(whole.E) : halved(whole.E, random);
    const auto of_parts = answer_to(with_E(whole, split_E.mesh), Mode::E, Scheme::clipped);
    const SplitMasterFaces faces(posed.F, split_E.whole, plain.E, of_parts.E);
    const auto chosen = [&](Index face) { return faces.carries_the_same(face); };
    const auto part_chosen = [&](Index part) { return chosen(split_E.whole[static_cast<std::size_t>(part)]); };
    expect_one_load(findings, in_words(Mode::E, Scheme::clipped), load_of_faces(plain, posed.pose, chosen),
                    load_of_faces(of_parts, posed.pose, part_chosen));
  }
}

void prove_areas(const Posed& posed, Findings& findings) {
  for (const reference::Problem problem : {reference::Problem::rounded, reference::Problem::exact}) {
    const reference::Identities proven = reference::prove_identities(posed.E, posed.F, problem, posed.pose);
    if (!proven.applicable) continue;
    findings.same(proven.vector_areas_cancel ? "" : "the vector areas do not cancel");
    findings.same(proven.fluxes_agree ? "" : "the three fluxes differ");
    findings.same(proven.limit_closes ? "" : "the areas that the tie rule gives do not close");
  }
}

void leave_out_what_is_not_wanted(const Posed& posed, Findings& findings) {
  for (const Scheme scheme : kSchemes) {
    const fast::Contact all = answer(posed, Mode::both, scheme);
    for (int bits = 0; bits < 16; ++bits) {
      const Wanted wanted{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
      const fast::Contact part = answer(posed, Mode::both, scheme, wanted);
      const bool same = part.touching == all.touching && (!wanted.areas || part.volume == all.volume) &&
                        (!wanted.polygons || part.crossings.size() == all.crossings.size()) &&
                        (!wanted.force || (part.force_Me == all.force_Me && part.torque_Me == all.torque_Me));
      findings.same(same ? "" : fmt::format("other bits with only a part wanted, {}", in_words(Mode::both, scheme)));
    }
  }
}

std::vector<Posed> poses_where(const std::vector<Posed>& poses, const std::string& word, std::size_t most_faces) {
  std::vector<Posed> chosen;
  for (const Posed& posed : poses)
    if (posed.where.find(word) != std::string::npos && posed.E.faces.size() + posed.F.faces.size() <= most_faces)
      chosen.push_back(posed);
  return chosen;
}

}  // namespace

std::vector<IdentityResult> check_identities(std::uint64_t seed, Extent extent) {
  const bool full = extent == Extent::full;
  // Surfaces are prepared anew for every answer, which large ones make the bulk of the work.
  const std::vector<Posed> all = poses_where(posed_pairs(seed, full ? 3 : 1), "", full ? 4000 : 700);
  const std::vector<Posed> generic = poses_where(all, "/generic/", 4000);
  const std::vector<Posed> small_generic = poses_where(all, "/generic/", 200);
  std::vector<Posed> dyadic = small_generic;
  std::erase_if(dyadic, [](const Posed& posed) { return !has_exact_middles(posed.E); });
  const std::vector<Posed> small = poses_where(all, "", 200);
  const std::vector<Posed> some = poses_where(posed_pairs(seed, 1), "", full ? 2000 : 200);

  std::vector<IdentityResult> results;
  results.push_back(over_poses("mode both is the mean of the two", "F(both) = (F(E) + F(F)) / 2, torque alike",
                               Sharpness::bits, all, both_is_the_mean));
  results.push_back(over_poses("F placed beforehand",
                               "at rest, with F's vertices rounded into Me: the same answer (barycentric)",
                               Sharpness::bits, all, place_beforehand));
  const std::string exchanged_statement =
      "mode E of (E, F) and mode F of (F, E): opposite forces, torques about one marker";
  results.push_back(over_poses("bodies exchanged", exchanged_statement, Sharpness::rounding,
                               full ? generic : small_generic,
                               [](const Posed& posed, Findings& findings) { exchange(posed, findings, engine_load); }));
  results.push_back(over_poses("bodies exchanged (oracle)", exchanged_statement, Sharpness::rounding, small_generic,
                               [](const Posed& posed, Findings& findings) { exchange(posed, findings, oracle_load); }));
  results.push_back(over_poses("faces and vertices reordered", "the same answer, sums to rounding, where nothing ties",
                               Sharpness::rounding, all, reorder));
  const int step = full ? 1 : 8;
  results.push_back(
      over_poses("all lengths times 2^k, k = -40 to 40",
                 "lengths 2^k, areas 2^2k, volume and force 2^3k, torque 2^4k, ties included", Sharpness::bits, some,
                 [step](const Posed& posed, Findings& findings) { scale_lengths(posed, step, findings); }));
  results.push_back(over_poses("two axes negated in both frames",
                               "vectors change their signs with the axes, where nothing ties", Sharpness::bits, all,
                               negate_axes));
  const std::string split_statement = "no elastic force or torque changes";
  results.push_back(
      over_poses("slave faces split in their planes", split_statement, Sharpness::rounding, dyadic,
                 [](const Posed& posed, Findings& findings) { split_slave(posed, findings, engine_load); }));
  results.push_back(
      over_poses("slave faces split (oracle)", split_statement, Sharpness::rounding, dyadic,
                 [](const Posed& posed, Findings& findings) { split_slave(posed, findings, oracle_load); }));
  const std::string master_statement = "no elastic force or torque changes but by parts that are no longer active";
  results.push_back(
      over_poses("master faces split in their planes (clipped)", master_statement, Sharpness::rounding, dyadic,
                 [](const Posed& posed, Findings& findings) { split_master(posed, findings, bounded_answer); }));
  results.push_back(
      over_poses("master faces split (clipped, oracle)", master_statement, Sharpness::rounding, dyadic,
                 [](const Posed& posed, Findings& findings) { split_master(posed, findings, oracle_answer); }));
  results.push_back(over_poses("vector areas and fluxes of the clipped areas",
                               "the vector areas sum to zero, three fluxes give one volume (oracle, both problems)",
                               Sharpness::exact, small, prove_areas));
  results.push_back(over_poses("parts not wanted are left out", "the rest keeps its bits", Sharpness::bits, some,
                               leave_out_what_is_not_wanted));
  results.push_back(flush_flanks(full ? 20 : 5));
  results.push_back(plate_with_pin());
  results.push_back(threads_and_workspaces(some));
  results.push_back(jobs_of_verify(seed, full ? 240 : 60));
  return results;
}

}  // namespace pcm::compare
