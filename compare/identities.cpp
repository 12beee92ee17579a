// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/identities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/identity_constructions.h"
#include "compare/identity_support.h"
#include "compare/known_answer_bodies.h"
#include "reference/identities.h"
#include "reference/oracle.h"

namespace pcm::compare {
namespace {

std::string in_words(Mode mode, Scheme scheme) {
  return fmt::format("mode {}, {}",
                     mode == Mode::E   ? "E"
                     : mode == Mode::F ? "F"
                                       : "both",
                     scheme == Scheme::barycentric ? "barycentric" : "clipped");
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

/// The pair with its bodies exchanged: the motion is that of E relative to F, resolved in Mf.
Posed exchanged(const Posed& posed) {
  Posed other = posed;
  std::swap(other.E, other.F);
  if (other.law.layers) std::swap(other.law.layers->c_E, other.law.layers->c_F);
  const Eigen::Matrix3d back = posed.pose.A.transpose();
  other.pose.A = back;
  other.pose.r = -ordered_product(back, posed.pose.r);
  other.velocity.w = -ordered_product(back, posed.velocity.w);
  other.velocity.v = -ordered_product(back, posed.velocity.v - ordered_cross(posed.velocity.w, posed.pose.r));
  return other;
}

/// Action and reaction. The exchanged pair rounds the vertices of the other body, so only poses count whose decisions
/// hold for all roundings.
void exchange(const Posed& posed, Findings& findings) {
  const Posed other = exchanged(posed);
  for (const Scheme scheme : kSchemes)
    for (const Mode mode : {Mode::E, Mode::F}) {
      const Mode same_master = mode == Mode::E ? Mode::F : Mode::E;
      Wanted force_only;
      force_only.polygons = force_only.areas = false;
      const auto certified = [&](const Posed& asked, Mode master) {
        const reference::Oracle oracle(asked.E, asked.F, asked.law, master);
        return oracle.answer(reference::Problem::rounded, asked.pose, asked.velocity, force_only).certified;
      };
      if (!certified(posed, mode) || !certified(other, same_master)) continue;
      const fast::Contact direct = answer(posed, mode, scheme), opposite = answer(other, same_master, scheme);
      const Eigen::Vector3d force = -ordered_product(posed.pose.A, opposite.force_Me);
      // About Me there, about Mf here.
      const Eigen::Vector3d torque =
          -ordered_product(posed.pose.A, opposite.torque_Me) - ordered_cross(posed.pose.r, force);
      RoundingScale scale = rounding_scale(posed, direct);
      scale.torque += posed.pose.r.norm() * scale.force;
      expect_close(findings, in_words(mode, scheme), scale, force - direct.force_Me, torque - direct.torque_Me);
    }
}

Wanted with_bounds() {
  Wanted wanted;
  wanted.bound = true;
  return wanted;
}

void reorder(const Posed& posed, Findings& findings) {
  PoseRandom random(1, 0, 0, posed.stream);
  Posed other = posed;
  other.E = reordered(posed.E, random);
  other.F = reordered(posed.F, random);
  for (const Scheme scheme : kSchemes) {
    const fast::Contact plain = answer(posed, Mode::both, scheme, with_bounds());
    // A tie may be decided another way by the new order.
    if (plain.work.tie_breaks > 0) continue;
    const fast::Contact permuted = answer(other, Mode::both, scheme, with_bounds());
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

void split_slave(const Posed& posed, Findings& findings) {
  const Posed whole = elastic(posed);
  Posed parts = whole;
  parts.E = split(whole.E);
  for (const Scheme scheme : kSchemes) {
    const fast::Contact plain = answer(whole, Mode::F, scheme), of_parts = answer(parts, Mode::F, scheme);
    expect_close(findings, in_words(Mode::F, scheme), rounding_scale(whole, plain), of_parts.force_Me - plain.force_Me,
                 of_parts.torque_Me - plain.torque_Me);
  }
}

void split_master(const Posed& posed, Findings& findings) {
  const Posed whole = elastic(posed);
  Posed parts = whole;
  parts.E = split(whole.E);
  const fast::Contact plain = answer(whole, Mode::E, Scheme::clipped),
                      of_parts = answer(parts, Mode::E, Scheme::clipped);
  expect_close(findings, in_words(Mode::E, Scheme::clipped), rounding_scale(whole, plain),
               of_parts.force_Me - plain.force_Me, of_parts.torque_Me - plain.torque_Me);
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

/// Those whose rounding S / p measures.
std::vector<Posed> tame(std::vector<Posed> poses) {
  std::erase_if(poses, [](const Posed& posed) { return posed.made_to_hurt; });
  return poses;
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
  const std::vector<Posed> generic = tame(poses_where(all, "/generic/", 4000));
  // The pairs of the hard strata have dyadic coordinates, so the middles of their edges are doubles.
  const std::vector<Posed> dyadic = tame(poses_where(all, "/generic/", 200));
  const std::vector<Posed> small = poses_where(all, "", 200);
  const std::vector<Posed> some = poses_where(posed_pairs(seed, 1), "", full ? 2000 : 200);

  std::vector<IdentityResult> results;
  results.push_back(over_poses("mode both is the mean of the two", "F(both) = (F(E) + F(F)) / 2, torque alike",
                               Sharpness::bits, all, both_is_the_mean));
  results.push_back(over_poses("bodies exchanged (certified poses)",
                               "mode E of (E, F) and mode F of (F, E): opposite forces, torques about one marker",
                               Sharpness::rounding, full ? generic : dyadic, exchange));
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
  results.push_back(over_poses("slave faces split in their planes", "no elastic force or torque changes",
                               Sharpness::rounding, dyadic, split_slave));
  if (std::find(kSchemes.begin(), kSchemes.end(), Scheme::clipped) != kSchemes.end())
    results.push_back(over_poses("master faces split in their planes (clipped)", "no elastic force or torque changes",
                                 Sharpness::rounding, dyadic, split_master));
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
