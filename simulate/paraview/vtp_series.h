// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "simulate/record/recording.h"

namespace pcm::simulate {

/// A recording for ParaView: frames.pvd, which names a file N.vtp for each frame with all surfaces in place. Points in
/// m, as floats; by cell: `pressure`, Pa, the greatest where a face carries several elements, and `surface`, its
/// number (compare/io/vtp.h). Throws BadInput where the folder can't be written to.
void write_vtp_series(const std::filesystem::path& folder, const Recording& recording);

}  // namespace pcm::simulate
