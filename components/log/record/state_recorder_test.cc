#include "log/record/state_recorder.hh"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "pongsim/simulation.hh"

namespace pongsim::log {
namespace {

class NoWriter final : public Writer {
 public:
  void write(const Record&) override {}
  void close() override {}
};

TEST(StateRecorder, ReportsWhatTheCallbackThrowsOnItsThread) {
  Diagnostics diagnostics;
  const auto simulation =
      Simulation::fromText("<sdf version='1.9'><world name='w'/></sdf>", "w.sdf", {.loadSystems = false}, diagnostics);
  ASSERT_NE(simulation, nullptr);
  NoWriter writer;
  StateRecorder recorder(Scene(simulation->world()), writer, "/world/w/changed_state",
                         [](const Message&) { throw std::runtime_error("the disk is full"); });
  recorder.record();
  try {
    recorder.finish();
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_STREQ(failure.what(), "the disk is full");
  }
}

}  // namespace
}  // namespace pongsim::log
