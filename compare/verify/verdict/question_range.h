// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pcm/inputs.h"

/// What can be asked: questions from files are refused as they are read, so that none is taken for a disagreement.
namespace pcm::compare {

/// A number of a law, with the key that files give it by.
struct LawNumber {
  std::string_view key;
  double value;
};
std::vector<LawNumber> numbers_of(const ContactLaw& law);

/// The verdict's bounds are relative ones of products of up to two of the law's numbers with an area and a depth, or
/// velocities: they hold as long as none of these products leaves the range of normal doubles. Within these limits
/// there is room for areas times depths from 2^-600 to 2^600.
inline constexpr double kLeastOfLaw = 0x1p-200, kGreatestOfLaw = 0x1p200;

/// Whether a law's number is 0, infinite or within these limits.
bool is_zero_infinite_or_between(double x, double least, double greatest);

/// Throws BadInput where the engine refuses the law, or where one of its numbers exceeds the limits above; that is
/// called by its key, or as `name` says.
void require_in_range(const ContactLaw& law, std::string (*name)(std::string_view key) = nullptr);
/// Throws BadInput where the engine, or one of its scenes, refuses the state.
void require_in_range(const Pose& pose, const Velocity& velocity);

}  // namespace pcm::compare
