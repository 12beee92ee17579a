// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pages of the documentation lead where they say they do.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot{PCM_SOURCE_DIR};

/// The lines of a page that are not in a fenced block of code.
std::vector<std::string> prose_of(const fs::path& page) {
  std::ifstream in{page};
  std::vector<std::string> prose;
  bool in_code = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```"))
      in_code = !in_code;
    else if (!in_code)
      prose.push_back(line);
  }
  return prose;
}

/// A heading's anchor as GitHub and GitLab make it, but for headings of one text: lower case, no punctuation, a hyphen
/// for each blank.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '-' || c == '_' || byte >= 0x80)
      anchor += static_cast<char>(std::tolower(byte));
    else if (c == ' ')
      anchor += '-';
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  for (const std::string& line : prose_of(page)) {
    const std::size_t marks = line.find_first_not_of('#');
    if (marks > 0 && marks <= 6 && line[marks] == ' ') anchors.insert(anchor_of(line.substr(marks + 1)));
  }
  return anchors;
}

/// The targets of [words](target) and ![picture](target) that lie in this repository.
std::vector<std::string> links_of(const fs::path& page) {
  static const std::regex pattern{R"re(\]\(([^)\s]+)\))re"};
  std::vector<std::string> links;
  for (const std::string& line : prose_of(page)) {
    for (std::sregex_iterator match{line.begin(), line.end(), pattern}, end; match != end; ++match) {
      const std::string target = (*match)[1];
      if (target.find("://") == std::string::npos && !target.starts_with("mailto:")) links.push_back(target);
    }
  }
  return links;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> pages{kRoot / "README.md"};
  for (const auto& entry : fs::directory_iterator{kRoot / "docs"}) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

TEST(Links, LeadToFilesAndHeadingsThatExist) {
  int links = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& link : links_of(page)) {
      ++links;
      const std::size_t hash = link.find('#');
      const std::string file = link.substr(0, hash);
      const fs::path target = file.empty() ? page : page.parent_path() / file;
      ASSERT_TRUE(fs::exists(target)) << page << " leads to " << link;
      if (hash != std::string::npos) {
        EXPECT_TRUE(anchors_of(target).contains(link.substr(hash + 1))) << page << " leads to " << link;
      }
    }
  }
  EXPECT_GT(links, 20) << "hardly a link was read";
}

TEST(Links, EveryPageIsReachedFromTheReadme) {
  std::set<fs::path> reached{fs::weakly_canonical(kRoot / "README.md")};
  std::vector<fs::path> open(reached.begin(), reached.end());
  while (!open.empty()) {
    const fs::path page = open.back();
    open.pop_back();
    for (const std::string& link : links_of(page)) {
      const fs::path target = fs::weakly_canonical(page.parent_path() / link.substr(0, link.find('#')));
      if (target.extension() == ".md" && reached.insert(target).second) open.push_back(target);
    }
  }
  for (const fs::path& page : pages()) EXPECT_TRUE(reached.contains(fs::weakly_canonical(page))) << page;
}

TEST(Links, AnchorsAreMadeOfHeadings) {
  EXPECT_EQ(anchor_of("What is guaranteed, and what is not"), "what-is-guaranteed-and-what-is-not");
  EXPECT_EQ(anchor_of("`pcm bench` S/p"), "pcm-bench-sp");
}

}  // namespace
