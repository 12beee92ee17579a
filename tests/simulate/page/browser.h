// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/meshes/temporary_folder.h"

namespace pcm::simulate {

/// Whether chromium is on the path.
bool has_browser();

enum class Graphics : std::uint8_t { webgl, none };

using Pixel = std::array<int, 3>;     ///< red, green, blue, 0 to 255
using Place = std::array<double, 2>;  ///< in a window, px from its upper left corner

/// Chromium without a screen, showing one page; driven through its debugging pipe (Chrome DevTools Protocol), so that
/// keys and mouse are those a user's are. Throws std::runtime_error where the browser does not answer.
class Browser {
 public:
  Browser(const std::string& page, const std::string& fragment, int width, int height,
          Graphics graphics = Graphics::webgl);
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;
  ~Browser();

  /// What an expression is worth in the page, once it is settled where it is a promise.
  nlohmann::json evaluate(const std::string& expression);

  /// Waits, at most half a minute, until the expression is true; says whether it became so.
  bool wait_until(const std::string& expression);

  /// As named by KeyboardEvent.key.
  void press(const std::string& key, bool with_shift = false);
  void click(const Place& place);
  void drag(const Place& from, const Place& to);

  std::string screenshot_png();  ///< in base64
  std::vector<Pixel> pixels(const std::vector<Place>& places);

  /// Errors and warnings on the console, what was thrown and not caught, and what the page's policy refused.
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());
  void mouse(const char* type, const Place& place, bool is_down);
  nlohmann::json read();
  void note(const nlohmann::json& event);
  void start(int width, int height, Graphics graphics);
  void close() noexcept;

  TemporaryFolder folder_;
  pid_t process_ = -1;
  int to_browser_ = -1, from_browser_ = -1;
  int calls_ = 0;
  bool is_loaded_ = false;
  std::string session_, unread_;
  std::vector<std::string> errors_;
};

}  // namespace pcm::simulate
