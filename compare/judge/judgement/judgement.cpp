// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement/judgement.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "compare/io/names.h"
#include "compare/judge/judgement/element_bounds.h"
#include "compare/judge/judgement/true_facts.h"
#include "compare/verify/bounds/rounding_bounds.h"

namespace pcm::compare {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string text_of(Index face) {
  return fmt::format("{}", face);
}
std::string text_of(const FacePair& pair) {
  return fmt::format("({}, {})", pair[0], pair[1]);
}
template <class Element>
std::string text_of_element(const Element& e) {
  return fmt::format("{} face {} on {}", name(e.master), e.master_face, e.slave_face);
}

/// Gathers what is judged; of a fact that is said of several things, the first wrong one tells.
class Facts {
 public:
  explicit Facts(const Tolerances& tolerances) : tolerances_(tolerances) {}

  void note(Fact fact, bool right, const std::string& text) {
    FactJudged& judged = of(fact);
    if (right || !judged.right) return;
    judged.right = false;
    judged.text = text;
  }

  /// A set of which each side may have what the other has not.
  void note_set(Fact fact, const std::string& text, std::int64_t lost, std::int64_t spurious) {
    note(fact, lost == 0 && spurious == 0, text);
    of(fact).lost += lost;
    of(fact).spurious += spurious;
  }

  template <class T>
  void equal(Fact fact, const std::optional<T>& given, const T& truth) {
    if (given) note(fact, *given == truth, fmt::format("engine {}, oracle {}", *given, truth));
  }

  /// Two ascending lists: the first thing that only one of them has tells.
  template <class T>
  void same_set(Fact fact, const std::string& whose, const std::optional<std::vector<T>>& given,
                const std::vector<T>& truth) {
    if (!given) return;
    std::vector<T> lost, spurious;
    std::set_difference(truth.begin(), truth.end(), given->begin(), given->end(), std::back_inserter(lost));
    std::set_difference(given->begin(), given->end(), truth.begin(), truth.end(), std::back_inserter(spurious));
    std::string text = fmt::format("{}engine {}, oracle {}", whose, given->size(), truth.size());
    if (!lost.empty()) text += fmt::format("; {} lost, the first {}", lost.size(), text_of(lost.front()));
    if (!spurious.empty())
      text += fmt::format("; {} spurious, the first {}", spurious.size(), text_of(spurious.front()));
    note_set(fact, text, std::ssize(lost), std::ssize(spurious));
  }

  /// `scale`: what an error is relative to. The truth itself is rounded once, which its bound counts.
  void value(Fact fact, const std::string& whose, double given, double truth, double derived, double scale) {
    if (derived == kInfinity) return;
    const double bound = tolerances_.of(fact).widen(derived, scale);
    note(fact, std::abs(given - truth) <= bound,
         fmt::format("{}engine {}, oracle {}, apart {:.3g}, bound {:.3g}", whose, given, truth, std::abs(given - truth),
                     bound));
  }

  void vector(Fact fact, const Eigen::Vector3d& given, const Eigen::Vector3d& truth, double derived, double scale) {
    if (derived == kInfinity) return;
    const double bound = tolerances_.of(fact).widen(derived, scale), apart = (given - truth).stableNorm();
    note(fact, apart <= bound,
         fmt::format("engine ({}, {}, {}), oracle ({}, {}, {}), apart {:.3g}, bound {:.3g}", given.x(), given.y(),
                     given.z(), truth.x(), truth.y(), truth.z(), apart, bound));
  }

  std::vector<FactJudged> sorted() && {
    std::sort(list_.begin(), list_.end(), [](const FactJudged& a, const FactJudged& b) { return a.fact < b.fact; });
    return std::move(list_);
  }

 private:
  FactJudged& of(Fact fact) {
    const auto known =
        std::find_if(list_.begin(), list_.end(), [fact](const FactJudged& judged) { return judged.fact == fact; });
    return known == list_.end() ? list_.emplace_back(FactJudged{fact, true, ""}) : *known;
  }

  const Tolerances& tolerances_;
  std::vector<FactJudged> list_;
};

void judge_faces(Side side, const GivenArea& given, const reference::ActiveArea& truth, Facts& facts) {
  const std::string whose = fmt::format("{}: ", name(side));
  facts.same_set(Fact::intersected_faces, whose, given.intersected, truth.intersected);
  facts.same_set(Fact::inner_faces, whose, given.inner, truth.inner);
  if (given.active)
    facts.same_set(Fact::active_faces, whose, given.active, active_faces(truth.intersected, truth.inner));
}

void judge_polygons(const GivenAnswer& given, const reference::Answer& truth, Facts& facts) {
  facts.equal(Fact::polygons, given.polygons, std::int64_t{std::ssize(truth.polygons)});
  const auto closed = std::count_if(truth.polygons.begin(), truth.polygons.end(),
                                    [](const reference::Polygon& polygon) { return polygon.closed; });
  facts.equal(Fact::closed_polygons, given.closed_polygons, std::int64_t{closed});
}

/// Areas where faces lie in one plane are those of the tie rule: it decides which faces are active at all.
void judge_areas(const Question& question, const GivenAnswer& given, const reference::Answer& truth, Facts& facts) {
  const bool has_area = truth.undefined_areas == 0, has_volume = has_area && truth.volume.has_value();
  if (!(has_area && (given.E.area || given.F.area)) && !(has_volume && given.volume)) return;
  const AreaBounds bounds = RoundingBounds(question, truth).area();
  if (given.E.area)
    facts.value(Fact::area, "E: ", *given.E.area, truth.E.limit_area, bounds.area_E, truth.E.limit_area);
  if (given.F.area)
    facts.value(Fact::area, "F: ", *given.F.area, truth.F.limit_area, bounds.area_F, truth.F.limit_area);
  if (given.volume && has_volume)
    facts.value(Fact::volume, "", *given.volume, *truth.volume, bounds.volume, *truth.volume);
}

/// Whether the list tells enough of each element: in the clipped scheme its area says whether it may be a sliver.
bool can_be_held(const Question& question, const std::vector<GivenElement>& elements) {
  return question.scheme == Scheme::barycentric ||
         std::all_of(elements.begin(), elements.end(), [](const GivenElement& e) { return e.area.has_value(); });
}

void judge_element_list(const std::vector<GivenElement>& given, const ElementsHeld& held,
                        const reference::Answer& truth, Facts& facts) {
  std::string text = fmt::format("engine {}, oracle {}", given.size(), truth.elements.size());
  if (!held.missing.empty())
    text += fmt::format("; {} lost, the first {}", held.missing.size(), text_of_element(*held.missing.front()));
  if (!held.spurious.empty())
    text += fmt::format("; {} spurious, the first {}", held.spurious.size(), text_of_element(*held.spurious.front()));
  facts.note_set(Fact::elements, text, std::ssize(held.missing), std::ssize(held.spurious));
  for (const ElementsHeld::Common& e : held.common) {
    const std::string whose = text_of_element(*e.truth) + ": ";
    if (e.given->area)
      facts.value(Fact::element_area, whose, *e.given->area, e.truth->area, e.area_bound, e.truth->area);
    if (e.given->penetration)
      facts.value(Fact::element_penetration, whose, *e.given->penetration, e.truth->penetration, e.penetration_bound,
                  e.truth->penetration);
  }
}

void judge_forces(const Question& question, const GivenAnswer& given, const reference::Answer& truth, Facts& facts) {
  if (given.element_count && question.scheme == Scheme::barycentric)
    facts.equal(Fact::elements, given.element_count, std::int64_t{std::ssize(truth.elements)});
  const bool has_list = given.elements && can_be_held(question, *given.elements);
  if (!has_list && !given.force_Me && !given.torque_Me) return;
  // Without a list that tells enough, only the bounds count.
  const std::vector<GivenElement> none;
  const std::vector<GivenElement>& listed = has_list ? *given.elements : none;
  const ElementsHeld held = hold_elements(question, listed, truth);
  if (has_list) judge_element_list(listed, held, truth, facts);
  if (given.force_Me) facts.vector(Fact::force, *given.force_Me, truth.force_Me, held.force_bound, truth.force_scale);
  if (given.torque_Me)
    facts.vector(Fact::torque, *given.torque_Me, truth.torque_Me, held.torque_bound, truth.torque_scale);
}

}  // namespace

bool gives(const GivenAnswer& given, Fact fact) {
  const auto of_either = [&](auto GivenArea::*value) { return given.E.*value || given.F.*value; };
  const auto of_an_element = [&](auto GivenElement::*value) {
    return given.elements && std::all_of(given.elements->begin(), given.elements->end(),
                                         [value](const GivenElement& e) { return (e.*value).has_value(); });
  };
  switch (fact) {
    case Fact::touching:
      return given.touching.has_value();
    case Fact::crossing_pairs:
      return given.crossing_pairs.has_value();
    case Fact::intersected_faces:
      return of_either(&GivenArea::intersected);
    case Fact::inner_faces:
      return of_either(&GivenArea::inner);
    case Fact::active_faces:
      return of_either(&GivenArea::active);
    case Fact::polygons:
      return given.polygons.has_value();
    case Fact::closed_polygons:
      return given.closed_polygons.has_value();
    case Fact::elements:
      return given.elements || given.element_count;
    case Fact::area:
      return of_either(&GivenArea::area);
    case Fact::volume:
      return given.volume.has_value();
    case Fact::element_area:
      return of_an_element(&GivenElement::area);
    case Fact::element_penetration:
      return of_an_element(&GivenElement::penetration);
    case Fact::force:
      return given.force_Me.has_value();
    case Fact::torque:
      return given.torque_Me.has_value();
  }
  return false;
}

std::vector<FactJudged> judge_facts(const Question& question, const GivenAnswer& given, const reference::Answer& truth,
                                    const Tolerances& tolerances) {
  Facts facts(tolerances);
  facts.equal(Fact::touching, given.touching, truth.touching);
  if (given.crossing_pairs)
    facts.same_set(Fact::crossing_pairs, "", given.crossing_pairs, true_crossing_pairs(question, truth));
  judge_faces(Side::E, given.E, truth.E, facts);
  judge_faces(Side::F, given.F, truth.F, facts);
  judge_polygons(given, truth, facts);
  judge_areas(question, given, truth, facts);
  judge_forces(question, given, truth, facts);
  return std::move(facts).sorted();
}

}  // namespace pcm::compare
