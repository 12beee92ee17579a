// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>

namespace pcm {

/// The double nearest to the number written in `text` (round to nearest, ties to even), whatever the locale.
///
/// Accepts the whole of `text` as an optional sign followed by a decimal number ("1", "-.5", "2.", "+3e-7") or a C
/// hexadecimal float ("0x1.8p-3"). Values below half the least denormal become a zero of their sign, as in strtod.
/// Empty where `text` is anything else, overflows, or spells an infinity or NaN. Cost: linear in the length.
std::optional<double> parse_number(std::string_view text);

}  // namespace pcm
