// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "compare/explain/answer_map.h"
#include "compare/io/pictures/svg.h"

namespace pcm::compare {
namespace {

constexpr double kCell = 8;  ///< pixels, of a grid with 33 cells a side; larger grids have smaller ones
constexpr double kPanel = 33 * kCell;
constexpr double kGap = 28;
constexpr std::size_t kListed = 8;

/// Told apart by people who do not see red or green; answers beyond these share the last one.
constexpr std::array kColours = {"#e8ecf0", "#4477aa", "#ee9944", "#66ccbb",
                                 "#aa3377", "#ccbb44", "#8899aa", "#bbbbbb"};
static_assert(kColours.size() == kListed);

const char* colour_of(std::size_t answer) {
  return kColours[std::min(answer, kListed - 1)];
}

std::string panel(const AnswerMap& map, const MappedAnswers& row, double left, double top) {
  const double cell = kPanel / static_cast<double>(map.grid.side());
  std::string drawn, wrong;
  for (std::size_t up = 0; up < map.grid.side(); ++up) {
    const std::size_t first = up * map.grid.side();
    const double y = top + kPanel - static_cast<double>(up + 1) * cell;
    const auto colour = [&](std::size_t right) { return colour_of(row.answers[first + right]); };
    for (std::size_t right = 0, end = 0; right < map.grid.side(); right = end) {
      end = right + 1;
      while (end < map.grid.side() && colour(end) == colour(right)) ++end;
      drawn += fmt::format(R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="{}"/>)"
                           "\n",
                           left + static_cast<double>(right) * cell, y, static_cast<double>(end - right) * cell, cell,
                           colour(right));
    }
    for (std::size_t right = 0; right < map.grid.side(); ++right) {
      if (row.answers[first + right] == map.rows.front().answers[first + right]) continue;
      wrong += fmt::format("M{:.2f} {:.2f}l{:.2f} {:.2f}m0 {:.2f}l{:.2f} {:.2f}",
                           left + static_cast<double>(right) * cell, y, cell, cell, -cell, -cell, cell);
    }
  }
  if (!wrong.empty())
    drawn += fmt::format(R"(<path d="{}" stroke="{}" stroke-width="1" fill="none"/>)"
                         "\n",
                         wrong, kBlack);
  return drawn + fmt::format(R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="none" stroke="{}"/>)"
                             "\n",
                             left, top, kPanel, kPanel, kBlack);
}

std::string text(double x, double y, double size, const std::string& words) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" font-size="{:g}">{}</text>)"
                     "\n",
                     x, y, size, escaped(words));
}

std::string legend(const AnswerMap& map, double top) {
  std::string drawn;
  const std::size_t listed = std::min(map.answers.size(), kListed);
  for (std::size_t i = 0; i < listed; ++i) {
    const std::size_t row = i / 4, column = i % 4;
    const double x = kMargin + static_cast<double>(column) * 210, y = top + static_cast<double>(row) * kLine;
    const bool stands_for_more = i + 1 == kListed && map.answers.size() > kListed;
    const std::string words = stands_for_more ? fmt::format("{} other answers", map.answers.size() - kListed + 1)
                                              : fmt::format("{}: {}", i + 1, map.answers[i]);
    drawn += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="12" height="12" fill="{}" stroke="{}"/>)"
                         "\n",
                         x, y - 10.5, colour_of(i), kBlack) +
             text(x + 18, y, kTextSize, words);
  }
  return drawn;
}

}  // namespace

std::string answer_map_svg(const AnswerMap& map, const std::string& title) {
  const double top = 100;
  std::string drawn = text(kMargin, 40, kTitleSize, title);
  drawn += text(
      kMargin, 62, kTextSize,
      fmt::format("A pose a cell, {} by {} of them about the middle, {:.3g} m (an ulp) apart: r_{} to the right, "
                  "r_{} upwards. Colours are answers,",
                  map.grid.side(), map.grid.side(), map.grid.ulp, "xyz"[map.grid.axes[0]], "xyz"[map.grid.axes[1]]));
  drawn += text(kMargin, 62 + kLine, kTextSize,
                "that is, which edges pass through which faces; crossed out where the answer is not the oracle's.");
  for (std::size_t k = 0; k < map.rows.size(); ++k) {
    const double left = kMargin + static_cast<double>(k) * (kPanel + kGap);
    const std::size_t wrong = map.wrong(map.rows[k]);
    drawn +=
        text(left, top + 8, kHeadingSize,
             k == 0 ? map.rows[k].who : fmt::format("{}: {} of {} wrong", map.rows[k].who, wrong, map.grid.cells()));
    drawn += panel(map, map.rows[k], left, top + 18);
  }
  const double below = top + 18 + kPanel + 24;
  drawn += legend(map, below + 8);
  const double width = 2 * kMargin + static_cast<double>(map.rows.size()) * (kPanel + kGap) - kGap;
  return svg_document(width, below + 2 * kLine + kMargin, title, "Answers at poses an ulp apart", drawn);
}

}  // namespace pcm::compare
