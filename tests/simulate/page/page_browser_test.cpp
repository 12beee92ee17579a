// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page in a real browser.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "simulate/page/page.h"
#include "simulate/page/page_files.h"
#include "tests/simulate/page/browser.h"
#include "tests/simulate/page/falling_box.h"

namespace {

using namespace pcm;
using namespace pcm::simulate;
using nlohmann::json;

class PageInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (page_files().three.empty()) GTEST_SKIP() << "libjs-three was not installed when this was built";
    if (!has_browser()) GTEST_SKIP() << "no chromium here (Debian: chromium)";
  }

  Browser& open(const std::string& fragment = "", int width = 1200, int height = 800,
                Graphics graphics = Graphics::webgl) {
    browser_ = std::make_unique<Browser>(page_, fragment, width, height, graphics);
    EXPECT_TRUE(browser_->wait_until("window.pcmReady")) << "the page never got ready";
    return *browser_;
  }
  void TearDown() override {
    if (!browser_) return;
    for (const std::string& error : browser_->errors()) ADD_FAILURE() << "on the console: " << error;
  }

  double time() { return browser_->evaluate("pcmTime"); }
  /// The middle of an element of the page.
  Place place_of(const std::string& selector) {
    return browser_->evaluate(
        "(() => { const b = document.querySelector('" + selector +
        "').getBoundingClientRect(); return [(b.left + b.right) / 2, (b.top + b.bottom) / 2]; })()");
  }
  std::string text_of(const std::string& selector) {
    return browser_->evaluate("document.querySelector('" + selector + "').textContent");
  }
  Place place_of(const Eigen::Vector3d& x_W) {
    return browser_->evaluate("pcmProject(" + json({x_W.x(), x_W.y(), x_W.z()}).dump() + ")");
  }
  /// Where the middle plot shows this share of its times.
  Place place_in_plot(double share) {
    const json box = browser_->evaluate(
        "(() => { const b = document.querySelectorAll('.axes')[1].getBoundingClientRect();"
        "return [b.left, b.right, b.top + 30]; })()");
    const double left = box[0].get<double>() + 58, right = box[1].get<double>() - 18;  // kMargin in plots.js
    return {left + share * (right - left), box[2]};
  }

  Recording recording_ = falling_box();
  std::string page_ = page_files().three.empty() ? "" : page(recording_);
  std::unique_ptr<Browser> browser_;
};

bool is_red(const Pixel& p) {
  return p[0] > 90 && p[0] > 2 * p[1] && p[0] > 2 * p[2];
}

/// The fragment that opens a page at a frame.
std::string at_frame(const Recording& recording, std::size_t frame) {
  return "#t=" + json(recording.frames[frame].t).dump();
}

TEST_F(PageInBrowser, BeginsPausedAtTheFirstFrame) {
  Browser& browser = open();
  EXPECT_EQ(time(), 0);
  EXPECT_EQ(browser.evaluate("new Promise(done => setTimeout(() => done(pcmTime), 300))"), 0);
  EXPECT_EQ(browser.evaluate("document.querySelectorAll('#view canvas').length"), 1) << "no scene is drawn";
  EXPECT_EQ(browser.evaluate("[...document.querySelectorAll('.plot h2')].map(h => h.firstChild.textContent.trim())"),
            json({"Energy", "Force on the box", "Motion", "Step size"}));
  EXPECT_EQ(browser.evaluate("document.title"), recording_.title);
}

TEST_F(PageInBrowser, PlaysAndPausesByButtonAndSpaceBar) {
  Browser& browser = open();
  browser.click(place_of("#play"));
  EXPECT_TRUE(browser.wait_until("pcmTime > 0.2")) << time();
  EXPECT_EQ(text_of("#play"), "Pause");
  browser.press(" ");  // goes to the button, which has the focus
  const double paused = time();
  EXPECT_LT(paused, 1.5);
  EXPECT_EQ(browser.evaluate("new Promise(done => setTimeout(() => done(pcmTime), 300))"), paused);
  browser.evaluate("document.activeElement.blur()");
  browser.press(" ");
  EXPECT_TRUE(browser.wait_until("pcmTime === 1.5")) << time();
  EXPECT_EQ(text_of("#play"), "Play");
  browser.press(" ");  // from the beginning again
  EXPECT_TRUE(browser.wait_until("pcmTime > 0 && pcmTime < 1")) << time();
  browser.press(" ");
  EXPECT_EQ(text_of("#play"), "Play");
}

TEST_F(PageInBrowser, PlaysAtTheSpeedChosen) {
  Browser& browser = open();
  const auto rate_at = [&](const std::string& speed) -> double {
    return browser.evaluate("(async () => { document.getElementById('speed').value = '" + speed +
                            "'; const frame = () => new Promise(requestAnimationFrame);"
                            "document.getElementById('play').click(); await frame(); await frame();"
                            "const t = pcmTime, stamp = performance.now();"
                            "while (performance.now() < stamp + 500) await frame();"
                            "const rate = (pcmTime - t) / (performance.now() - stamp) * 1000;"
                            "document.getElementById('play').click(); return rate; })()");
  };
  EXPECT_NEAR(rate_at("1"), 1, 0.4);
  EXPECT_NEAR(rate_at("0.1"), 0.1, 0.04);
}

TEST_F(PageInBrowser, IsScrubbedBySliderKeysAndPlots) {
  Browser& browser = open();
  browser.click(place_of("#slider"));
  EXPECT_NEAR(time(), 0.75, 0.02);
  browser.evaluate(
      "(() => { const s = document.getElementById('slider'); s.value = 0.7;"
      "s.dispatchEvent(new Event('input')); })()");
  EXPECT_NEAR(time(), 0.7, 1e-12);
  browser.press("ArrowRight");
  EXPECT_NEAR(time(), 0.71, 1e-12);
  browser.press("ArrowLeft", true);
  EXPECT_NEAR(time(), 0.61, 1e-12);
  browser.press("End");
  EXPECT_EQ(time(), 1.5);
  browser.press("Home");
  EXPECT_EQ(time(), 0);
  browser.click(place_in_plot(1.0 / 3));
  EXPECT_NEAR(time(), 0.5, 0.005) << "a pixel is 4 ms";
  const double cursor = browser.evaluate("document.querySelector('.cursor').getBoundingClientRect().left");
  EXPECT_NEAR(cursor, place_in_plot(1.0 / 3)[0], 1.5);
  EXPECT_NE(text_of("#time").find("frame 51 of 151"), std::string::npos) << text_of("#time");
  browser.drag(place_in_plot(0.2), place_in_plot(0.8));
  EXPECT_NEAR(time(), 1.2, 0.005);
}

TEST_F(PageInBrowser, OpensAtTheInstantAskedFor) {
  Browser& browser = open("#t=1.25");
  EXPECT_EQ(time(), 1.25);
  const auto go_to = [&](const std::string& fragment) {
    browser.evaluate(
        "new Promise(done => { addEventListener('hashchange', () => setTimeout(done), {once: true});"
        "location.hash = '" +
        fragment + "'; })");
    return time();
  };
  EXPECT_EQ(go_to("#t=0.25"), 0.25);
  EXPECT_EQ(go_to("#t=nonsense"), 0.25);
  EXPECT_EQ(go_to("#t=99"), 1.5);
}

TEST_F(PageInBrowser, NamesTheForcesOfTheInstant) {
  const std::size_t deepest = most_pressed(recording_).frame;
  Browser& browser = open(at_frame(recording_, deepest));
  const double force = recording_.frames[deepest].contacts.at(0).force_W.norm();
  ASSERT_TRUE(force > 1000 && force < 9999) << "the expected text below is in kN";
  EXPECT_EQ(text_of("#contacts"), "box on plate" + json(std::round(force / 10) / 100).dump() + "\u00a0kN");
  browser.press("Home");
  EXPECT_EQ(text_of("#contacts"), "no contact");
}

// Red where the camera sees the box at that instant, and not where it sees it at the other one.
TEST_F(PageInBrowser, ShowsTheBoxWhereItIs) {
  // On the upper face, beside the arrow; on the sides towards the camera and towards x.
  const std::vector<Eigen::Vector3d> box_points{{0.13, 0.13, 0.2}, {0, -0.2, 0.1}, {0.2, -0.1, 0.1}};
  const std::vector<std::size_t> frames{0, 100};  // at 0 and 1 s
  for (const std::size_t frame : frames) {
    Browser& browser = open(at_frame(recording_, frame));
    for (const std::size_t other : frames) {
      std::vector<Place> places;
      for (const Eigen::Vector3d& point : box_points) places.push_back(place_of(box_point_W(recording_, other, point)));
      const std::vector<Pixel> pixels = browser.pixels(places);
      for (std::size_t k = 0; k < pixels.size(); ++k)
        EXPECT_EQ(is_red(pixels[k]), frame == other)
            << "frame " << frame << ", point " << k << " of frame " << other << ": " << json(pixels[k]);
    }
  }
}

TEST_F(PageInBrowser, ColoursTheMostPressedElementLikeTheEndOfTheBar) {
  const PressedFace pressed = most_pressed(recording_);
  const TriangleMesh& box = recording_.surfaces[1].mesh;
  Eigen::Vector3d barycentre = Eigen::Vector3d::Zero();
  for (const Index vertex : box.faces[static_cast<std::size_t>(pressed.element.face)])
    barycentre += box.vertices[static_cast<std::size_t>(vertex)] / 3;
  Browser& browser = open(at_frame(recording_, pressed.frame));
  const std::vector<Place> places{place_of(box_point_W(recording_, pressed.frame, barycentre))};
  const Pixel end_of_bar{0xfd, 0xe7, 0x25};
  const Pixel pixel = browser.pixels(places).at(0);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(pixel[k], end_of_bar[k], 2) << json(pixel);
  browser.click(place_of("#through"));  // now the box's sides hide it
  EXPECT_TRUE(is_red(browser.pixels(places).at(0))) << json(browser.pixels(places));
}

TEST_F(PageInBrowser, DrawsForcesAsArrows) {
  const std::size_t deepest = most_pressed(recording_).frame;
  Browser& browser = open(at_frame(recording_, deepest));
  const RecordedContact& contact = recording_.frames[deepest].contacts.at(0);
  // Halfway along the arrow, the whole length of which follows from the page's scale.
  const double length = browser.evaluate("pcmArrowLength()").get<double>() * contact.force_W.norm();
  const Eigen::Vector3d middle = contact.position_W + 0.5 * length * contact.force_W.normalized();
  const Pixel arrow{0xc2, 0x00, 0x6b};
  const auto is_arrow = [&] {
    const Pixel pixel = browser.pixels({place_of(middle)}).at(0);
    return std::abs(pixel[0] - arrow[0]) + std::abs(pixel[1] - arrow[1]) + std::abs(pixel[2] - arrow[2]) < 6;
  };
  EXPECT_TRUE(is_arrow());
  browser.evaluate(
      "(() => { const s = document.getElementById('arrow-scale'); s.value = -1;"
      "s.dispatchEvent(new Event('input')); })()");
  EXPECT_FALSE(is_arrow()) << "a tenth as long, it does not come so far";
}

TEST_F(PageInBrowser, ShowsPlotsAndSaysSoWithoutWebGL) {
  Browser& browser = open("#t=0.5", 1200, 800, Graphics::none);
  EXPECT_NE(text_of("#no-scene").find("no WebGL"), std::string::npos);
  EXPECT_GT(browser.evaluate("document.getElementById('no-scene').offsetHeight"), 20);
  EXPECT_EQ(time(), 0.5);
  // Pixels of the first line's colour, #0072b2.
  const int ink = browser.evaluate(R"js((() => {
    const canvas = document.querySelector(".plot canvas");
    const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    let ink = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i] < 40 && Math.abs(data[i + 1] - 0x72) < 30 && data[i + 2] > 0x90) ++ink;
    return ink;
  })())js");
  EXPECT_GT(ink, 200);
  browser.press(" ");
  EXPECT_TRUE(browser.wait_until("pcmTime > 0.6")) << time();
}

TEST_F(PageInBrowser, FitsWideAndNarrowWindows) {
  for (const auto& [width, height] : {std::array{1200, 800}, std::array{420, 800}}) {
    Browser& browser = open("", width, height);
    EXPECT_LE(browser.evaluate("document.documentElement.scrollWidth - innerWidth"), 0) << width;
    EXPECT_GT(browser.evaluate("document.querySelector('#view canvas').clientHeight"), 200) << width;
    EXPECT_GT(browser.evaluate("document.getElementById('plots').clientHeight"), 150) << width;
    const Place play = place_of("#play");
    EXPECT_LT(play[1], height - 10) << width;
    EXPECT_LT(place_of("#speed")[0], width - 10);
    // The box's corners are in sight.
    const Place corner = place_of(box_point_W(recording_, 0, {-0.2, -0.2, 0.2}));
    EXPECT_TRUE(corner[0] > 0 && corner[0] < width && corner[1] > 0 && corner[1] < height) << json(corner);
  }
}

// Names are the user's; what is in them is text.
TEST_F(PageInBrowser, ShowsNamesAsTheyAre) {
  const std::string hostile = "</script><script>window.hacked = 1</script><b>&amp;{{data}}\u00e4";
  recording_.title = recording_.surfaces[1].name = recording_.pairings[0].name = hostile;
  recording_.series[0].name = recording_.series[0].plot = hostile;
  page_ = page(recording_);
  Browser& browser = open(at_frame(recording_, most_pressed(recording_).frame));
  EXPECT_EQ(browser.evaluate("window.hacked === undefined"), true);
  EXPECT_EQ(browser.evaluate("document.title"), hostile);
  EXPECT_EQ(browser.evaluate("document.querySelector('.plot h2').firstChild.textContent.trim()"), hostile);
  for (const std::string selector : {"h1", "#surfaces label:last-child", "#contacts td"})
    EXPECT_EQ(text_of(selector), hostile) << selector;
}

TEST_F(PageInBrowser, OfOneFrameShowsIt) {
  recording_.frames.resize(1);
  recording_.series.clear();
  page_ = page(recording_);
  Browser& browser = open();
  EXPECT_EQ(time(), 0);
  browser.press(" ");
  browser.press("ArrowRight");
  EXPECT_EQ(time(), 0);
  EXPECT_EQ(text_of("#play"), "Play");
  EXPECT_TRUE(is_red(browser.pixels({place_of(box_point_W(recording_, 0, {0, -0.2, 0.1}))}).at(0)));
}

// For looking at: PCM_KEEP_PAGES names a folder where it is left.
TEST_F(PageInBrowser, IsKeptWhereAskedFor) {
  const char* folder = std::getenv("PCM_KEEP_PAGES");
  if (folder == nullptr) GTEST_SKIP() << "PCM_KEEP_PAGES names no folder";
  write_page(std::filesystem::path{folder} / "falling_box.html", recording_);
}

}  // namespace
