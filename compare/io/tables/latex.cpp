// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/io/tables/latex.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "compare/io/characters_in.h"

namespace pcm::compare {
namespace {

/// Characters that a line of an A4 page in portrait holds in \\footnotesize with the margins of the class article,
/// blanks between columns counted as three each. In \\scriptsize it holds a few more, in \\tiny with narrow gaps half
/// as many again.
constexpr std::size_t kLine = 80, kSmallLine = 92, kTinyLine = 120;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

/// The cells of a line "| a | b |"; a bar within one is written "\|".
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  std::string cell;
  line = trimmed(line);
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == '|') {
      cell += line[++i];
    } else if (line[i] == '|') {
      cells.emplace_back(trimmed(cell));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  if (!trimmed(cell).empty()) cells.emplace_back(trimmed(cell));
  return cells;
}

bool is_row(std::string_view line) {
  return trimmed(line).starts_with('|');
}

/// Whether a line is the second of a table, e.g. "|---|--:|".
bool is_rule(std::string_view line) {
  return is_row(line) && line.find_first_not_of("|-: \t\r") == std::string_view::npos &&
         line.find('-') != std::string_view::npos;
}

/// What stands between two marks that begin at `at`; none where they don't.
std::optional<std::string_view> between(std::string_view text, std::size_t at, std::string_view open,
                                        std::string_view close) {
  if (text.substr(at, open.size()) != open) return std::nullopt;
  const std::size_t begin = at + open.size(), end = text.find(close, begin);
  if (end == std::string_view::npos) return std::nullopt;
  return text.substr(begin, end - begin);
}

std::string inline_latex(std::string_view text) {
  std::string latex;
  for (std::size_t i = 0; i < text.size();) {
    if (const auto bold = between(text, i, "**", "**")) {
      latex += "\\textbf{" + inline_latex(*bold) + "}";
      i += bold->size() + 4;
    } else if (const auto code = between(text, i, "`", "`")) {
      latex += "\\texttt{" + latex_escaped(*code) + "}";
      i += code->size() + 2;
    } else if (const auto words = between(text, i, "[", "](")) {
      const std::size_t end = text.find(')', i + words->size());
      latex += inline_latex(*words);
      i = end == std::string_view::npos ? text.size() : end + 1;
    } else {
      latex += latex_escaped(text.substr(i, 1));
      ++i;
    }
  }
  return latex;
}

using Row = std::vector<std::string>;

std::string row_of(const Row& cells, const std::vector<std::size_t>& columns) {
  std::string row;
  for (const std::size_t k : columns) {
    if (k != columns.front()) row += " & ";
    if (k < cells.size()) row += inline_latex(cells[k]);
  }
  return row + " \\\\\n";
}

/// Of the longest cell of each column, with three blanks behind, in characters.
std::vector<std::size_t> widths_of(const std::vector<Row>& rows, std::size_t columns) {
  std::vector<std::size_t> widths(columns, 3);
  for (const Row& row : rows)
    for (std::size_t k = 0; k < std::min(columns, row.size()); ++k)
      widths[k] = std::max(widths[k], characters_in(row[k]) + 3);
  return widths;
}

/// Columns of each part that a table is cut into where it is too wide for a page: the leading columns of words, which
/// say what a row is of, or the first column, stand in all of them.
std::vector<std::vector<std::size_t>> parts_of(const std::vector<std::size_t>& widths, const std::string& columns) {
  std::size_t leading = std::clamp<std::size_t>(columns.find('r'), 1, columns.size());
  // Where words alone fill half a line the first column has to do.
  if (2 * std::accumulate(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(leading), std::size_t{0}) >
      kTinyLine)
    leading = 1;
  std::vector<std::size_t> head(leading);
  std::iota(head.begin(), head.end(), std::size_t{0});
  const std::size_t head_width = std::accumulate(widths.begin(), widths.begin() + std::ssize(head), std::size_t{0});
  std::vector<std::vector<std::size_t>> parts{head};
  std::size_t width = head_width;
  for (std::size_t k = leading; k < widths.size(); ++k) {
    if (parts.back().size() > leading && width + widths[k] > kTinyLine) {
      parts.push_back(head);
      width = head_width;
    }
    parts.back().push_back(k);
    width += widths[k];
  }
  return parts;
}

std::string longtable(const std::vector<Row>& rows, const std::string& columns, const std::vector<std::size_t>& part,
                      std::size_t width) {
  std::string letters;
  for (const std::size_t k : part) letters += columns[k];
  std::string table = width <= kLine        ? "{\\footnotesize\n"
                      : width <= kSmallLine ? "{\\scriptsize\n"
                                            : "{\\tiny\\setlength{\\tabcolsep}{2pt}\n";
  table += fmt::format("\\begin{{longtable}}{{{}}}\n\\toprule\n{}\\midrule\n\\endhead\n", letters,
                       row_of(rows.front(), part));
  for (std::size_t i = 1; i < rows.size(); ++i) table += row_of(rows[i], part);
  return table + "\\bottomrule\n\\end{longtable}}\n";
}

/// The table whose heading is line `at`, which it leaves behind itself.
std::string table_at(const std::vector<std::string_view>& lines, std::size_t& at) {
  std::vector<Row> rows{cells_of(lines[at])};
  const Row rule = cells_of(lines[at + 1]);
  for (at += 2; at < lines.size() && is_row(lines[at]); ++at) rows.push_back(cells_of(lines[at]));
  std::string columns;
  for (const std::string& cell : rule) columns += cell.ends_with(':') ? 'r' : 'l';
  const std::vector<std::size_t> widths = widths_of(rows, columns.size());
  std::string tables;
  for (const std::vector<std::size_t>& part : parts_of(widths, columns)) {
    std::size_t width = 0;
    for (const std::size_t k : part) width += widths[k];
    tables += longtable(rows, columns, part, width);
  }
  return tables;
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        escaped += '\\';
        escaped += c;
        break;
      case '\\':
        escaped += "\\textbackslash{}";
        break;
      case '~':
        escaped += "\\textasciitilde{}";
        break;
      case '^':
        escaped += "\\textasciicircum{}";
        break;
      case '<':
        escaped += "\\textless{}";
        break;
      case '>':
        escaped += "\\textgreater{}";
        break;
      case '|':
        escaped += "\\textbar{}";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string latex_tables(std::string_view markdown) {
  const std::vector<std::string_view> lines = lines_of(markdown);
  std::string latex = "% For a document with \\usepackage{booktabs,longtable}.\n";
  std::string_view title;
  for (std::size_t i = 0; i < lines.size();) {
    if (lines[i].starts_with('#')) title = trimmed(lines[i].substr(lines[i].find_first_not_of('#')));
    if (i + 1 < lines.size() && is_row(lines[i]) && is_rule(lines[i + 1])) {
      latex += fmt::format("\n% {}\n", title);
      latex += table_at(lines, i);
    } else {
      ++i;
    }
  }
  return latex;
}

}  // namespace pcm::compare
