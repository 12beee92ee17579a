// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "simulate/stills/image.h"

namespace pcm::simulate {

/// The bytes of a PNG file, by libpng: 8 bits a colour, sRGB, no time or text in it, so that one image is always the
/// same bytes with one version of libpng and zlib. Throws BadInput where libpng refuses, as for an image without
/// pixels.
std::string png_bytes(const Image& image);

}  // namespace pcm::simulate
