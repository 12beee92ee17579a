// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace pcm::compare {

/// Text that LaTeX sets as it stands.
std::string latex_escaped(std::string_view text);

/// The tables of a Markdown text, in its order, each as a `longtable` with the rules of the package booktabs and the
/// heading above it as a comment: to be taken into a report by \input. One that is too wide for a page in portrait is
/// cut into several, each with the leading columns of words. Of Markdown it knows what our own tables are made of:
/// columns to the left and to the right, **bold**, `code` and [links](of which the words stay).
std::string latex_tables(std::string_view markdown);

}  // namespace pcm::compare
