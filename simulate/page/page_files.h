// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "simulate/record/recording.h"

namespace pcm::simulate {

/// The files that a page is put together from; they are compiled in (embed.cmake).
struct PageFiles {
  std::string_view html;           ///< page.html: each {{name}} stands for what is put there
  std::string_view css;            ///< page.css
  std::string_view scripts;        ///< our own, one after the other
  std::string_view three;          ///< three.js; empty where it was not installed when this was built
  std::string_view three_licence;  ///< its notice, which goes with it
};

/// Those this program was built with.
const PageFiles& page_files();

/// `page` out of these files.
std::string page(const Recording& recording, const PageFiles& files);

}  // namespace pcm::simulate
