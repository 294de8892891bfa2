// Measures the cost of a world of 1,000 moving models in browsers, with 60 frames per second: on the simulation's
// thread per step, on the server's per second, on the wire per frame.
//   web_benchmark [MODELS]

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/log.hh"
#include "pongsim/simulation.hh"
#include "web/frames/pose_feed.hh"
#include "web/server/server.hh"
#include "web/test/raw_client.hh"

namespace pongsim::web {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kDefaultModels = 1000;
constexpr std::chrono::seconds kDuration{10};
constexpr std::chrono::milliseconds kStep{1};
constexpr double kFramesASecond = 60;
constexpr std::uint64_t kKey = 1;

/// Bodies that fly apart without collisions.
std::string flyingWorld(int models) {
  std::string text = "<sdf version='1.9'><world name='w'><gravity>0 0 0</gravity>";
  for (int i = 0; i < models; ++i) {
    text += "<model name='m" + std::to_string(i) + "'><pose>" + std::to_string(3 * i) +
            " 0 0 0 0 0</pose><link name='link'/></model>";
  }
  return text + "</world></sdf>";
}

/// Sends the frames of a channel to each client.
class FrameProtocol final : public Protocol {
 public:
  explicit FrameProtocol(std::shared_ptr<PoseChannel> channel) : channel_(std::move(channel)) {}
  std::vector<std::string> names() const override { return {""}; }
  std::unique_ptr<Session> open(const std::string&, const std::shared_ptr<Client>& client) override {
    return std::make_unique<FrameSession>(channel_->open(client, kKey, [](std::uint64_t) { return std::string(); }));
  }

 private:
  class FrameSession final : public Session {
   public:
    explicit FrameSession(std::shared_ptr<void> opened) : opened_(std::move(opened)) {}
    void text(std::string_view) override {}
    void binary(std::span<const std::byte>) override {}

   private:
    std::shared_ptr<void> opened_;
  };

  std::shared_ptr<PoseChannel> channel_;
};

/// A client that reads as fast as possible.
class Reader {
 public:
  explicit Reader(int port) : client_(port), thread_([this] { read(); }) {}
  ~Reader() {
    mustEnd_ = true;
    thread_.join();
  }
  std::atomic<std::uint64_t> frames = 0;
  std::atomic<std::uint64_t> bytes = 0;

 private:
  void read() {
    client_.open();
    while (!mustEnd_) {
      const auto message = client_.next();
      if (!message) return;
      ++frames;
      bytes += message->payload.size();
    }
  }

  test::RawClient client_;
  std::atomic<bool> mustEnd_ = false;
  std::thread thread_;
};

/// Processor time of the thread of that name in this process [s].
double threadSeconds(const std::string& name) {
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string called;
    std::ifstream(task.path() / "comm") >> called;
    if (called != name) continue;
    std::uint64_t nanoseconds = 0;
    std::ifstream(task.path() / "schedstat") >> nanoseconds;
    return static_cast<double>(nanoseconds) * 1e-9;
  }
  return 0;
}

struct Cost {
  /// Of the simulation's thread [us]: medians of steps with and without a copied frame, which a busy machine affects
  /// little.
  double idleMicroseconds = 0;
  double frameMicroseconds = 0;
  /// Both combined, per step of a world in real time with all its frames.
  double stepMicroseconds = 0;
  /// As a fraction of one core.
  double serverShare = 0;
  double framesASecond = 0;
  double bytesAFrame = 0;
};

double median(std::span<const double> sorted) { return sorted.empty() ? 0 : sorted[sorted.size() / 2]; }

/// Threshold between steps without and with a copied frame [us].
constexpr double kFrameFrom = 1;

/// @param durations Of all steps [us].
void noteSteps(std::vector<double> durations, Cost& cost) {
  std::ranges::sort(durations);
  const std::span<const double> all(durations);
  const auto frames = static_cast<std::size_t>(durations.end() - std::ranges::lower_bound(durations, kFrameFrom));
  cost.idleMicroseconds = median(all.first(all.size() - frames));
  cost.frameMicroseconds = median(all.last(frames));
  cost.stepMicroseconds = cost.idleMicroseconds + cost.frameMicroseconds * kFramesASecond * toSeconds(kStep);
}

/// Steps in real time with this many clients.
Cost measure(int models, int clients) {
  Diagnostics diagnostics;
  const auto simulation = Simulation::fromText(flyingWorld(models), "bench.sdf", {}, diagnostics);
  if (!simulation) std::exit(1);
  const auto channel = std::make_shared<PoseChannel>("w", [] {});
  PoseFeed feed(simulation->world(), channel);
  FrameProtocol protocol(channel);
  const Logger log("bench");
  ServerSettings settings;
  settings.port = 0;
  const Server server(settings, log, {&protocol});
  for (const Model& each : simulation->world().models()) Model(each).setVelocity({0, 1, 0}, {0, 0, 1});
  std::vector<std::unique_ptr<Reader>> readers;
  for (int i = 0; i < clients; ++i) readers.push_back(std::make_unique<Reader>(server.port()));

  StepInfo step;
  std::vector<double> durations;
  const auto begin = Clock::now();
  const double serverBegin = threadSeconds("web");
  while (Clock::now() < begin + kDuration) {
    simulation->step(1);
    step.time = simulation->time();
    ++step.iteration;
    const auto before = Clock::now();
    feed.update(step);
    durations.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before).count());
    std::this_thread::sleep_until(begin + step.iteration * kStep);
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  Cost cost;
  cost.serverShare = (threadSeconds("web") - serverBegin) / seconds;
  for (const auto& reader : readers) {
    cost.framesASecond += static_cast<double>(reader->frames) / seconds / clients;
    if (reader->frames > 0)
      cost.bytesAFrame += static_cast<double>(reader->bytes) / static_cast<double>(reader->frames) / clients;
  }
  noteSteps(std::move(durations), cost);
  // the last frame unblocks the readers
  for (const auto& reader : readers) {
    const std::uint64_t last = reader->frames;
    while (reader->frames == last) {
      simulation->step(1);
      step.time = simulation->time();
      ++step.iteration;
      feed.update(step);
    }
  }
  return cost;
}

int run(int count, char** words) {
  const int models = count > 1 ? std::atoi(words[1]) : kDefaultModels;
  if (count > 2 || models < 1) {
    std::fprintf(stderr, "pongsim_web_bench: error: takes one number of models, or nothing\n");
    return 2;
  }
  std::printf("%d moving models, steps of 1 ms in real time, %lld s each\n", models,
              static_cast<long long>(kDuration.count()));
  std::printf("%8s %10s %10s %10s %16s %10s %12s\n", "clients", "step [us]", "idle [us]", "frame [us]",
              "server [% core]", "frames/s", "bytes/frame");
  for (const int clients : {0, 1, 4}) {
    const Cost cost = measure(models, clients);
    std::printf("%8d %10.3f %10.3f %10.1f %16.2f %10.1f %12.0f\n", clients, cost.stepMicroseconds,
                cost.idleMicroseconds, cost.frameMicroseconds, cost.serverShare * 100, cost.framesASecond,
                cost.bytesAFrame);
  }
  return 0;
}

}  // namespace
}  // namespace pongsim::web

int main(int count, char** words) { return pongsim::web::run(count, words); }
