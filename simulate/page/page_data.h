// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "simulate/record/recording.h"

namespace pcm::simulate {

/// What the page's scripts read, from a recording that check_recording lets pass. Arrays of numbers are
/// {"type": "Float32" | "Float64" | "Uint16" | "Uint32", "base64": little-endian numbers}. All but the frames' times is
/// rounded to Float32, 24 bits: pictures only.
///
///   title     string
///   surfaces  [{name, colour: [r, g, b], vertices: 3 a vertex, faces: 3 a face}]
///   pairings  [{name, surfaces: [E, F]}]
///   frames    {t, poses: 7 a surface and frame, quaternion (x, y, z, w) then position,
///              element_runs: [runs of frame 0, of frame 1, ...], run_master: 2 pairing + (0 master E, 1 master F) for
///              each run, run_length: elements in the run, face, pressure: for each element,
///              contacts: [contacts of frame 0, ...], contact_pairing, contact: 6 a contact, position then force}
///   times     [t, ...]: each list of times once, however many series share it
///   series    [{name, unit, plot, logarithmic, times: index into the above, value}]
nlohmann::json page_data(const Recording& recording);

}  // namespace pcm::simulate
