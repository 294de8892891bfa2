#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ign/bridge.hh"
#include "support/process.hh"
#include "support/wait_until.hh"

namespace pongsim::ign {

/// A transport with a bridge, and ign-transport programs in other processes.
class BridgedPeers : public testing::Test {
 protected:
  /// @param program The peers.
  BridgedPeers(std::string program, Generation generation)
      : program_(std::move(program)), bridge_(node_, log_, "127.0.0.1", generation) {}

  /// Gives the bridge and its peers a partition of their own.
  static void usePartition(const std::string& name) {
    setenv("IGN_PARTITION", (name + "_" + std::to_string(getpid())).c_str(), 1);
    setenv("IGN_IP", "127.0.0.1", 1);
  }

  void step() {
    transport_.dispatchFor(std::chrono::milliseconds(1));
    bridge_.update();
  }
  /// Steps until the condition holds.
  bool stepUntil(const std::function<bool()>& condition) {
    return test::waitUntil([&] {
      step();
      return condition();
    });
  }
  std::unique_ptr<test::Process> peer(std::vector<std::string> words, const std::string& isReady = "ready") {
    words.insert(words.begin(), program_);
    auto process = std::make_unique<test::Process>(words);
    if (!isReady.empty()) {
      EXPECT_TRUE(process->waitForOutput(isReady)) << process->error();
    }
    return process;
  }
  bool stepUntilSaid(const test::Process& process, const std::string& text) {
    return stepUntil([&] { return process.output().find(text) != std::string::npos; });
  }

  const std::string program_;
  Transport transport_{{.network = false}};
  Node node_ = transport_.node();
  Logger log_{"test"};
  Bridge bridge_;
};

}  // namespace pongsim::ign
