// SPDX-FileCopyrightText: 2026 The pcm authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulate/page/browser.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace pcm::simulate {
namespace {

using nlohmann::json;

constexpr int kPatience = 60'000;  // ms, for one answer

/// Both ends closed in programs that are started, but for those that are given to them.
std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return ends;
}

/// The number that Windows has for a key, which the browser wants too.
int key_code(const std::string& key) {
  if (key == " ") return 32;
  if (key == "End") return 35;
  if (key == "Home") return 36;
  if (key == "ArrowLeft") return 37;
  if (key == "ArrowRight") return 39;
  throw std::runtime_error("key " + key);
}

}  // namespace

bool has_browser() {
  return std::system("command -v chromium >/dev/null 2>&1") == 0;
}

Browser::Browser(const std::string& page, const std::string& fragment, int width, int height, Graphics graphics) {
  try {
    start(width, height, graphics);
    const json target = call("Target.createTarget", {{"url", "about:blank"}});
    session_ = call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}}).at("sessionId");
    for (const char* domain : {"Page", "Runtime", "Log"}) call(std::string{domain} + ".enable");
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
    is_loaded_ = false;
    call("Page.navigate", {{"url", "file://" + folder_.write("page.html", page).string() + fragment}});
    while (!is_loaded_) note(read());
  } catch (...) {
    close();
    throw;
  }
}

Browser::~Browser() {
  close();
}

void Browser::start(int width, int height, Graphics graphics) {
  std::signal(SIGPIPE, SIG_IGN);  // a browser that is gone is told by what write returns
  // The sandbox needs rights that containers do not give; the page is ours.
  std::vector<std::string> words{"chromium",
                                 "--headless",
                                 "--no-sandbox",
                                 "--disable-gpu",
                                 "--hide-scrollbars",
                                 "--no-first-run",
                                 "--remote-debugging-pipe",
                                 "--user-data-dir=" + folder_.path("profile"),
                                 "--window-size=" + std::to_string(width) + "," + std::to_string(height)};
  if (graphics == Graphics::webgl)
    words.insert(words.end(), {"--use-angle=swiftshader", "--enable-unsafe-swiftshader"});
  else
    words.emplace_back("--disable-3d-apis");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const std::array<int, 2> commands = make_pipe(), answers = make_pipe();
  to_browser_ = commands[1];
  from_browser_ = answers[0];
  // The browser reads from 3 and writes to 4; by way of numbers that are neither.
  const int read_end = fcntl(commands[0], F_DUPFD_CLOEXEC, 10), write_end = fcntl(answers[1], F_DUPFD_CLOEXEC, 10);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, read_end, 3);
  posix_spawn_file_actions_adddup2(&actions, write_end, 4);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, folder_.path("log").c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // with its children in one group, to be ended together
  const int failed = posix_spawnp(&process_, "chromium", &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  for (const int end : {commands[0], answers[1], read_end, write_end}) ::close(end);
  if (failed != 0) process_ = -1;
  if (failed != 0) throw std::runtime_error("could not start chromium");
}

void Browser::close() noexcept {
  for (const int end : {to_browser_, from_browser_}) {
    if (end >= 0) ::close(end);
  }
  if (process_ > 0) {
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
}

json Browser::read() {
  std::size_t end = unread_.find('\0');
  while (end == unread_.npos) {
    pollfd waiting{from_browser_, POLLIN, 0};
    if (poll(&waiting, 1, kPatience) <= 0) throw std::runtime_error("the browser does not answer");
    std::array<char, 65536> bytes{};
    const ssize_t count = ::read(from_browser_, bytes.data(), bytes.size());
    if (count <= 0) throw std::runtime_error("the browser has gone");
    const std::size_t before = unread_.size();
    unread_.append(bytes.data(), static_cast<std::size_t>(count));
    end = unread_.find('\0', before);
  }
  json message = json::parse(unread_.substr(0, end));
  unread_.erase(0, end + 1);
  return message;
}

void Browser::note(const json& event) {
  const std::string method = event.value("method", "");
  if (method == "Page.loadEventFired") is_loaded_ = true;
  if (method == "Runtime.exceptionThrown") errors_.push_back(event["params"]["exceptionDetails"].dump());
  if (method == "Log.entryAdded") {
    const json& entry = event["params"]["entry"];
    if (entry["level"] == "error") errors_.push_back(entry["text"]);  // warnings are those of the graphics driver
  }
  if (method == "Runtime.consoleAPICalled") {
    const json& params = event["params"];
    if (params["type"] == "error" || params["type"] == "warning") errors_.push_back(params["args"].dump());
  }
}

json Browser::call(const std::string& method, const json& parameters) {
  json message{{"id", ++calls_}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  const std::string text = message.dump() + '\0';
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t count = write(to_browser_, text.data() + written, text.size() - written);
    if (count < 0) throw std::runtime_error("the browser has gone");
    written += static_cast<std::size_t>(count);
  }
  while (true) {
    const json answer = read();
    note(answer);
    if (answer.value("id", 0) != calls_) continue;
    if (answer.contains("error")) throw std::runtime_error(method + ": " + answer["error"].dump());
    return answer["result"];
  }
}

json Browser::evaluate(const std::string& expression) {
  const json answer =
      call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails"))
    throw std::runtime_error(expression.substr(0, 200) + ": " + answer["exceptionDetails"].dump());
  return answer["result"].value("value", json{});
}

bool Browser::wait_until(const std::string& expression) {
  return evaluate("new Promise(done => { const end = performance.now() + 3e4; const look = () => " + expression +
                  " ? done(true) : performance.now() > end ? done(false) : setTimeout(look, 5); look(); })");
}

void Browser::press(const std::string& key, bool with_shift) {
  json event{{"type", "keyDown"},
             {"key", key},
             {"code", key == " " ? "Space" : key},
             {"windowsVirtualKeyCode", key_code(key)},
             {"modifiers", with_shift ? 8 : 0}};
  if (key == " ") event["text"] = key;
  call("Input.dispatchKeyEvent", event);
  event.erase("text");
  event["type"] = "keyUp";
  call("Input.dispatchKeyEvent", event);
}

void Browser::mouse(const char* type, const Place& place, bool is_down) {
  call("Input.dispatchMouseEvent", {{"type", type},
                                    {"x", place[0]},
                                    {"y", place[1]},
                                    {"button", is_down ? "left" : "none"},
                                    {"buttons", is_down ? 1 : 0},
                                    {"clickCount", is_down ? 1 : 0}});
}

void Browser::click(const Place& place) {
  drag(place, place);
}

void Browser::drag(const Place& from, const Place& to) {
  mouse("mouseMoved", from, false);
  mouse("mousePressed", from, true);
  if (to != from) mouse("mouseMoved", to, true);
  mouse("mouseReleased", to, true);
}

std::string Browser::screenshot_png() {
  return call("Page.captureScreenshot", {{"format", "png"}}).at("data");
}

std::vector<Pixel> Browser::pixels(const std::vector<Place>& places) {
  // The browser decodes it, so that no library has to.
  return evaluate(R"js((async () => {
    const image = new Image();
    image.src = "data:image/png;base64,)js" +
                  screenshot_png() + R"js(";
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.width;
    canvas.height = image.height;
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return )js" + json(places).dump() +
                  R"js(.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data].slice(0, 3));
  })())js")
      .get<std::vector<Pixel>>();
}

}  // namespace pcm::simulate
