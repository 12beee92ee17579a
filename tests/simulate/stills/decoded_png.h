// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "simulate/stills/image.h"

namespace pcm::simulate {

/// The image in the bytes of a PNG file, by libpng; an empty one and a failure of the test where they are none.
Image decoded_png(const std::string& bytes);

}  // namespace pcm::simulate
