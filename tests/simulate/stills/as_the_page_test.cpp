// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stills beside the page that a real browser shows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "simulate/page/page.h"
#include "simulate/page/page_files.h"
#include "simulate/stills/colours.h"
#include "simulate/stills/picture.h"
#include "tests/simulate/page/browser.h"
#include "tests/simulate/page/falling_box.h"

namespace pcm::simulate {
namespace {

using nlohmann::json;

/// The page, with its view as it opens, and a still's camera fitted to what its panel leaves free.
class StillBesideThePage : public testing::Test {
 protected:
  void SetUp() override {
    if (page_files().three.empty()) GTEST_SKIP() << "libjs-three was not installed when this was built";
    if (!has_browser()) GTEST_SKIP() << "no chromium here (Debian: chromium)";
  }

  void open(std::size_t frame) {
    browser_ = std::make_unique<Browser>(page(recording_), "#t=" + json(recording_.frames[frame].t).dump(), 1400, 800);
    ASSERT_TRUE(browser_->wait_until("window.pcmReady")) << "the page never got ready";
    const json view = browser_->evaluate(
        "(() => { const v = document.getElementById('view'), b = v.getBoundingClientRect();"
        "return [b.left, b.top, v.clientWidth, v.clientHeight, document.getElementById('panel').offsetWidth + 10]; "
        "})()");
    left_ = view[0];
    top_ = view[1];
    width_ = view[2].get<int>() - view[4].get<int>();
    height_ = view[3];
    view_ = view_of(recording_, width_, height_);
  }

  /// Where the still's camera sees a point, in the page's window, px.
  Place seen(const Eigen::Vector3d& x_W) const {
    const Eigen::Vector3d x_C = view_.camera.to_camera(x_W);
    const double scale = height_ / 2.0 / view_.camera.tan_half_height / -x_C.z();
    return {left_ + width_ / 2.0 + scale * x_C.x(), top_ + height_ / 2.0 - scale * x_C.y()};
  }
  Place on_page(const Eigen::Vector3d& x_W) {
    return browser_->evaluate("pcmProject(" + json({x_W.x(), x_W.y(), x_W.z()}).dump() + ")");
  }

  Recording recording_ = falling_box();
  std::unique_ptr<Browser> browser_;
  double left_ = 0, top_ = 0;   // of the view in the window, px
  int width_ = 0, height_ = 0;  // of what its panel leaves free, px
  RunView view_;
};

TEST_F(StillBesideThePage, HasTheSameCamera) {
  open(0);
  for (const Eigen::Vector3d& x_W :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1.2, -0.6, 0), Eigen::Vector3d(-1, 0.5, 0.7)}) {
    const Place still = seen(x_W), there = on_page(x_W);
    EXPECT_NEAR(still[0], there[0], 0.6) << x_W.transpose();
    EXPECT_NEAR(still[1], there[1], 0.6) << x_W.transpose();
  }
}

TEST_F(StillBesideThePage, HasTheSameColours) {
  const PressedFace most = most_pressed(recording_);
  const Frame& frame = recording_.frames[most.frame];
  open(most.frame);
  const RecordedContact& contact = frame.contacts.front();
  const double height = kBoxEdge / 2;
  // On three sides of the box, on the plate, on the arrow, beside all.
  std::vector<Eigen::Vector3d> places_W{{1, -0.4, 0.025},
                                        contact.position_W + 0.5 * view_.metres_per_newton * contact.force_W};
  for (const Eigen::Vector3d& x :
       {Eigen::Vector3d(0.06, 0.1, height), Eigen::Vector3d(height, 0.02, 0.11), Eigen::Vector3d(0.02, -height, 0.11)})
    places_W.push_back(box_point_W(recording_, most.frame, x));
  const Image still = picture(recording_, frame, view_);
  std::vector<Place> places;
  for (const Eigen::Vector3d& x_W : places_W) places.push_back(seen(x_W));
  places.push_back({left_ + width_ / 2.0, top_ + height_ - 10});
  const std::vector<Pixel> pixels = browser_->pixels(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Rgb& ours = still.at(static_cast<int>(places[i][0] - left_), static_cast<int>(places[i][1] - top_));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(ours[k], pixels[i][k], 2) << "place " << i << ", colour " << k;
  }
}

TEST(Colours, OfTheBarAreThePages) {
  std::string stops;
  for (const Rgb& stop : kColourStops) {
    char hex[8];
    std::snprintf(hex, sizeof hex, "%02x%02x%02x", stop[0], stop[1], stop[2]);
    stops += (stops.empty() ? "\"" : ", \"") + std::string(hex) + "\"";
  }
  EXPECT_NE(page_files().scripts.find("kColourStops = [" + stops + "]"), std::string::npos) << stops;
}

}  // namespace
}  // namespace pcm::simulate
