// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/io/json/exact_json.h"
#include "pcm/contact.h"
#include "reference/vocabulary/answer.h"

namespace pcm::compare {

/// What `pcm contact` prints for one pose: the same keys in the same order whoever answered, then those that only one
/// of the two knows. SI units, resolved in Me; force and torque act on body E, the torque about Mf. `volume` is null
/// where a surface is open or the answer ambiguous. `work` is empty for the oracle, which counts nothing. `bound`,
/// where asked for, holds null for infinity.
Json contact_json(const fast::Contact& contact);
Json contact_json(const reference::Answer& answer);

/// Its value for the key `statistics`.
Json statistics_json(const fast::Statistics& statistics);

}  // namespace pcm::compare
