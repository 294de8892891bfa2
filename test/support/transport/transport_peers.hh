#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::test {

/// A transport in a domain of its own, and processes that it talks to.
class TransportPeersTest : public testing::Test {
 protected:
  static std::unique_ptr<Process> peer(std::vector<std::string> arguments,
                                       const Process::Options& options = Process::Options()) {
    arguments.insert(arguments.begin(), TRANSPORT_PEER);
    return std::make_unique<Process>(arguments, options);
  }

  static std::unique_ptr<Process> listener(const std::string& topic = "/chatter") {
    auto process = peer({"listen", topic});
    EXPECT_TRUE(process->waitForOutput("ready")) << process->error();
    return process;
  }

  const int domain_ = testDomain();
  Transport transport_;
  Node node_ = transport_.node();
};

}  // namespace pongsim::test
