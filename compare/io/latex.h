// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace pcm::compare {

/// Text that LaTeX sets as it stands.
std::string latex_escaped(std::string_view text);

/// The tables of a Markdown text, in its order, each as a `longtable` of the package booktabs, with the heading above
/// it as a comment: to be taken into a report by \input. Of Markdown it knows what our own tables are made of: columns
/// to the left and to the right, **bold**, `code` and [links](of which the words stay).
std::string latex_tables(std::string_view markdown);

}  // namespace pcm::compare
