// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/stills/stills.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "simulate/record/recorded_run.h"
#include "simulate/record/recording_of_run.h"
#include "simulate/scenes/read_scene.h"
#include "simulate/stills/picture.h"
#include "tests/meshes/expect_bad_input.h"
#include "tests/meshes/temporary_folder.h"
#include "tests/simulate/page/falling_box.h"
#include "tests/simulate/stills/decoded_png.h"

namespace pcm::simulate {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Stills, ShowTheRecordedFrameNextToTheirInstant) {
  std::vector<Frame> frames(3);
  frames[1].t = 0.5;
  frames[2].t = 0.75;
  const auto t_next_to = [&frames](double t) { return frame_next_to(t, frames).t; };
  EXPECT_EQ(t_next_to(0), 0);
  EXPECT_EQ(t_next_to(0.24), 0);
  EXPECT_EQ(t_next_to(0.25), 0);  // equally near
  EXPECT_EQ(t_next_to(0.26), 0.5);
  EXPECT_EQ(t_next_to(0.5), 0.5);
  EXPECT_EQ(t_next_to(0.7), 0.75);
  EXPECT_EQ(t_next_to(2), 0.75);
  frames.resize(1);
  EXPECT_EQ(t_next_to(2), 0);
}

TEST(Stills, AreThePicturesOfTheirFramesAndTheSameBytesEachTime) {
  const TemporaryFolder temporary;
  const Recording recording = falling_box();
  const std::vector<double> instants{0.0, 0.5, 1.234};
  const std::vector<fs::path> files = write_stills(temporary.path(), recording, instants);
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[2], temporary.path() / "still_1.234.png");
  const RunView view = view_of(recording);
  for (std::size_t i = 0; i < 3; ++i) {
    const Image image = decoded_png(bytes_of(files[i]));
    EXPECT_EQ(image.width, kStillWidth);
    EXPECT_EQ(image.pixels, picture(recording, frame_next_to(instants[i], recording.frames), view).pixels);
  }
  const std::string first = bytes_of(files[1]);
  EXPECT_NE(first, bytes_of(files[2]));
  write_stills(temporary.path(), recording, {0.5});
  EXPECT_EQ(bytes_of(files[1]), first);
}

TEST(Stills, SayWhereTheyCannotBeWrittenAndWhatIsNoRecording) {
  expect_bad_input([] { write_stills("/dev/null", falling_box(), {0}); }, "still_0.png: ");
  const TemporaryFolder temporary;
  expect_bad_input([&] { write_stills(temporary.path(), Recording{}, {0}); }, "");
}

/// The stills of a short run in this folder, stopped at every checkpoint or not.
std::vector<std::string> stills_of_bubbles(const fs::path& folder, bool is_stopped) {
  const std::string text(built_in_scenes().front().text);
  Scene scene = parse_scene(text, "bubbles");
  scene.duration = 0.5;
  scene.output.checkpoint_interval = 0.1;
  std::string notice;
  while (!RecordedRun(scene, text, folder, notice).run([is_stopped] { return is_stopped; }, {})) {
  }
  RecordedRun finished(scene, text, folder, notice);
  const Recording recording = recording_of_run(folder, scene, finished.simulation().model());
  std::vector<std::string> stills;
  for (const fs::path& file : write_stills(folder, recording, {0.11, 0.46, 0.5})) stills.push_back(bytes_of(file));
  return stills;
}

TEST(Stills, AreTheSameBytesHoweverOftenTheRunWasStopped) {
  const TemporaryFolder temporary;
  const std::vector<std::string> whole = stills_of_bubbles(temporary.path() / "whole", false);
  EXPECT_EQ(whole, stills_of_bubbles(temporary.path() / "stopped", true));
  EXPECT_GT(whole[0].size(), 1000U);
}

}  // namespace
}  // namespace pcm::simulate
