// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/verify/routes/contact_fields.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <type_traits>

namespace pcm::compare {
namespace {

/// An answer as words, one field after the other.
class Words {
 public:
  struct Entry {
    std::string_view field;
    std::uint64_t word;
    bool operator==(const Entry& other) const { return field == other.field && word == other.word; }
  };

  /// Of what `wanted` asks for.
  Words(const fast::Contact& contact, const Wanted& wanted) {
    for_each_field(contact, [&](const Field& field, const auto& value) {
      if (field.asked == Asked::work || !is_answered(field.asked, wanted)) return;
      name_ = field.name;
      add(value);
    });
  }

  const std::vector<Entry>& entries() const { return entries_; }

 private:
  void add(double x) { entries_.push_back({name_, std::bit_cast<std::uint64_t>(x)}); }
  template <class T>
  requires(std::is_integral_v<T> || std::is_enum_v<T>) void add(T x) {
    entries_.push_back({name_, static_cast<std::uint64_t>(x)});
  }
  void add(const Eigen::Vector3d& x) {
    for (int i = 0; i < 3; ++i) add(x[i]);
  }
  void add(const fast::Tangent& x) {
    for (const double entry : x.reshaped()) add(entry);
  }
  template <class T>
  void add_list(const T& list) {
    add(list.size());
    for (const Index index : list) add(index);
  }
  void add(const std::array<Index, 2>& list) { add_list(list); }
  void add(const std::vector<Index>& list) { add_list(list); }

  std::string_view name_;
  std::vector<Entry> entries_;
};

bool is_empty(const Eigen::Vector3d& x) {
  return x.isZero(0);
}
bool is_empty(const fast::Tangent& x) {
  return x.isZero(0);
}
bool is_empty(const std::vector<Index>& list) {
  return list.empty();
}
template <class T>
bool is_empty(const T& x) {
  return x == T{};
}

/// The first field that was not asked for and holds something all the same.
std::string_view field_not_asked_for(const fast::Contact& contact, const Wanted& wanted) {
  if (!is_answered(Asked::polygons, wanted) && !contact.crossings.empty()) return "crossings";
  if (!is_answered(Asked::polygons, wanted) && !contact.polygons.empty()) return "polygons";
  if (!is_answered(Asked::elements, wanted) && !contact.elements.empty()) return "elements";
  if (!wanted.bound && contact.bound) return "bound";
  if (!wanted.tangent && contact.tangent) return "tangent";
  std::string_view found;
  for_each_field(contact, [&](const Field& field, const auto& value) {
    if (found.empty() && !is_answered(field.asked, wanted) && !is_empty(value)) found = field.name;
  });
  return found;
}

}  // namespace

std::vector<Field> all_fields() {
  fast::Contact one_of_each;
  one_of_each.crossings.emplace_back();
  one_of_each.polygons.emplace_back();
  one_of_each.elements.emplace_back();
  one_of_each.bound.emplace();
  one_of_each.tangent.emplace(fast::Tangent::Zero());
  std::vector<Field> all;
  for_each_field(one_of_each, [&all](const Field& field, const auto&) {
    if (std::none_of(all.begin(), all.end(), [&](const Field& known) { return known.name == field.name; }))
      all.push_back(field);
  });
  return all;
}

bool is_answered(Asked asked, const Wanted& wanted) {
  const bool force = wants_force(wanted);
  switch (asked) {
    case Asked::touch:
    case Asked::work:
      return true;
    case Asked::activity:
      return wanted.polygons || wanted.areas || force;
    case Asked::polygons:
      return wanted.polygons;
    case Asked::areas:
      return wanted.areas;
    case Asked::force:
      return force;
    case Asked::elements:
      return wanted.elements;
    case Asked::statistics:
      return wanted.elements || wanted.statistics;
    case Asked::bound:
      return wanted.bound;
    case Asked::tangent:
      return wanted.tangent;
  }
  return false;
}

std::string difference_in_bits(const fast::Contact& whole, const fast::Contact& partial, const Wanted& wanted) {
  Wanted compared = wanted;
  compared.bound = whole.bound && partial.bound;
  compared.tangent = whole.tangent && partial.tangent;
  compared.force = wanted.force || wanted.bound || wanted.tangent;
  const Words expected(whole, compared), given(partial, compared);
  const auto [a, b] = std::mismatch(expected.entries().begin(), expected.entries().end(), given.entries().begin(),
                                    given.entries().end());
  if (a != expected.entries().end() || b != given.entries().end()) {
    const auto show = [](const auto& at, const auto& end) {
      return at == end ? std::string("nothing") : fmt::format("{} {:#018x}", at->field, at->word);
    };
    return fmt::format("{} where the whole answer has {}", show(b, given.entries().end()),
                       show(a, expected.entries().end()));
  }
  if (wanted.bound && !partial.bound) return "no bound";
  if (wanted.tangent && !partial.tangent) return "no tangent";
  if (const std::string_view field = field_not_asked_for(partial, wanted); !field.empty())
    return fmt::format("{}, which nobody asked for", field);
  return "";
}

}  // namespace pcm::compare
