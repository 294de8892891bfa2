#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "web/server/session.hh"
#include "web/server/traffic.hh"

namespace pongsim::web {

/// A client for tests that records what it is sent. As in the server, data is queued until the test frees the socket.
class RecordedClient final : public Client {
 public:
  void sendText(std::string text) override {
    const std::lock_guard lock(mutex_);
    texts_.push_back(std::move(text));
  }
  void sendBinary(Frame frame) override {
    const std::lock_guard lock(mutex_);
    binaries_.push_back(bytesOf(frame));
  }
  void sendData(std::uint64_t key, std::size_t most, Frame frame) override {
    const std::lock_guard lock(mutex_);
    std::vector<std::function<Frame()>>& waiting = waiting_[key];
    if (waiting.size() >= most) {
      waiting.erase(waiting.begin());
      ++dropped_;
    }
    waiting.push_back([frame] { return frame; });
  }
  void sendWhenFree(std::uint64_t key, std::function<Frame()> make) override {
    const std::lock_guard lock(mutex_);
    waiting_[key] = {std::move(make)};
  }
  std::shared_ptr<void> callRegularly(std::weak_ptr<Callee> callee) override {
    const std::lock_guard lock(mutex_);
    const auto regular = std::make_shared<std::weak_ptr<Callee>>(std::move(callee));
    regulars_.push_back(regular);
    return regular;
  }
  /// The call is made when the test frees the socket.
  void callSoon(std::shared_ptr<Callee> callee) override {
    const std::lock_guard lock(mutex_);
    callees_.push_back(std::move(callee));
  }
  void forget(std::uint64_t key) override {
    const std::lock_guard lock(mutex_);
    waiting_.erase(key);
  }
  void close(std::uint16_t code, std::string reason) override {
    const std::lock_guard lock(mutex_);
    closed_ = {code, std::move(reason)};
  }
  bool mayWrite() const override { return mayWrite_; }
  std::uint64_t dropped() const override { return dropped_; }
  ClientTraffic& traffic() override { return traffic_; }

  void setMayWrite(bool may) { mayWrite_ = may; }

  /// Makes the socket take everything that is queued.
  void free() {
    std::vector<std::shared_ptr<Callee>> callees;
    {
      const std::lock_guard lock(mutex_);
      callees.swap(callees_);
      for (const auto& each : regulars_) {
        const auto regular = each.lock();
        const auto callee = regular ? regular->lock() : nullptr;
        if (callee) callees.push_back(callee);
      }
    }
    for (const auto& callee : callees) callee->called();
    std::map<std::uint64_t, std::vector<std::function<Frame()>>> waiting;
    {
      const std::lock_guard lock(mutex_);
      waiting.swap(waiting_);
    }
    for (const auto& [key, makers] : waiting) {
      for (const auto& make : makers) {
        const Frame frame = make();
        if (frame.size() == 0) continue;
        const std::lock_guard lock(mutex_);
        (frame.isText ? texts_ : binaries_).push_back(bytesOf(frame));
        traffic_.add(key, frame.size());
      }
    }
  }

  /// @return What has arrived since the last call.
  std::vector<std::string> takeTexts() {
    const std::lock_guard lock(mutex_);
    return std::exchange(texts_, {});
  }
  std::vector<std::string> takeBinaries() {
    const std::lock_guard lock(mutex_);
    return std::exchange(binaries_, {});
  }
  std::pair<int, std::string> closed() const {
    const std::lock_guard lock(mutex_);
    return closed_;
  }

 private:
  static std::string bytesOf(const Frame& frame) {
    const auto body = frame.body.bytes();
    return frame.head + std::string(reinterpret_cast<const char*>(body.data()), body.size());
  }

  ClientTraffic traffic_{1, "127.0.0.1", "test"};
  mutable std::mutex mutex_;
  bool mayWrite_ = true;
  std::uint64_t dropped_ = 0;
  std::vector<std::string> texts_;
  std::vector<std::string> binaries_;
  std::map<std::uint64_t, std::vector<std::function<Frame()>>> waiting_;
  std::vector<std::shared_ptr<Callee>> callees_;
  std::vector<std::weak_ptr<std::weak_ptr<Callee>>> regulars_;
  std::pair<int, std::string> closed_;
};

/// Files for tests.
class RecordedAssets final : public AssetSource {
 public:
  std::map<std::string, std::string, std::less<>> files;

  Asset fetch(std::string_view address) const override {
    const auto found = files.find(address);
    if (found == files.end()) return {"", "", "there is no file '" + std::string(address) + "'"};
    return {found->second, "application/octet-stream", ""};
  }
};

}  // namespace pongsim::web
