#include "web/server/waker.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "support/wait_until.hh"
#include "web/server/server.hh"
#include "web/test/raw_client.hh"

namespace pongsim::web {
namespace {

using pongsim::test::waitUntil;

class Counter final : public Callee {
 public:
  explicit Counter(std::function<void()> then = {}) : then_(std::move(then)) {}
  void called() override {
    thread = std::this_thread::get_id();
    ++calls;
    if (then_) then_();
  }
  std::atomic<int> calls = 0;
  std::atomic<std::thread::id> thread;

 private:
  std::function<void()> then_;
};

/// A session whose counter is called regularly.
class CountedProtocol final : public Protocol {
 public:
  explicit CountedProtocol(std::shared_ptr<Counter> counter) : counter_(std::move(counter)) {}
  std::vector<std::string> names() const override { return {""}; }
  std::unique_ptr<Session> open(const std::string&, const std::shared_ptr<Client>& opened) override {
    client = opened;
    client->sendText("hello");
    return std::make_unique<CountedSession>(client->callRegularly(counter_));
  }
  std::shared_ptr<Client> client;

 private:
  class CountedSession final : public Session {
   public:
    explicit CountedSession(std::shared_ptr<void> regularly) : regularly_(std::move(regularly)) {}
    void text(std::string_view) override {}
    void binary(std::span<const std::byte>) override {}

   private:
    std::shared_ptr<void> regularly_;
  };

  std::shared_ptr<Counter> counter_;
};

class WakerTest : public testing::Test {
 protected:
  WakerTest() {
    ServerSettings settings;
    settings.port = 0;
    server_ = std::make_unique<Server>(settings, log_, std::vector<Protocol*>{&protocol_});
    visitor_ = std::make_unique<test::RawClient>(server_->port());
    visitor_->open();
    EXPECT_EQ(visitor_->next().value().payload, "hello");
  }

  std::shared_ptr<Counter> regular_ = std::make_shared<Counter>();
  CountedProtocol protocol_{regular_};
  Logger log_{"web"};
  std::unique_ptr<Server> server_;
  std::unique_ptr<test::RawClient> visitor_;
};

TEST_F(WakerTest, CallsRegularlyUntilTheSessionEnds) {
  EXPECT_TRUE(waitUntil([&] { return regular_->calls > 5; }));
  EXPECT_NE(regular_->thread.load(), std::this_thread::get_id());
  visitor_.reset();
  EXPECT_TRUE(waitUntil([&] { return server_->clients() == 0; }));
  const int last = regular_->calls;
  // a server that still made regular calls would do so with this one
  const auto other = std::make_shared<Counter>();
  std::shared_ptr<void> regularly;
  const auto begin = std::make_shared<Counter>([&] { regularly = protocol_.client->callRegularly(other); });
  protocol_.client->callSoon(begin);
  ASSERT_TRUE(waitUntil([&] { return other->calls > 5; }));
  EXPECT_EQ(regular_->calls, last);
}

TEST_F(WakerTest, CallsSoonOnTheServersThreadAndThoseWhomTheseAdd) {
  const auto second = std::make_shared<Counter>();
  const auto first = std::make_shared<Counter>([&] { protocol_.client->callSoon(second); });
  protocol_.client->callSoon(first);
  EXPECT_TRUE(waitUntil([&] { return second->calls == 1; }));
  EXPECT_EQ(first->calls, 1);
  EXPECT_EQ(first->thread.load(), second->thread.load());
  EXPECT_NE(first->thread.load(), std::this_thread::get_id());
}

TEST_F(WakerTest, OutlivesWhatFailsAndWhoCallsThemselvesForEver) {
  protocol_.client->callSoon(std::make_shared<Counter>([] { throw std::runtime_error("it does"); }));
  std::shared_ptr<Counter> again;
  again = std::make_shared<Counter>([&] { protocol_.client->callSoon(again); });
  protocol_.client->callSoon(again);
  EXPECT_TRUE(waitUntil([&] { return again->calls > 100; }));
  // sockets have their turn meanwhile
  EXPECT_FALSE(test::RawClient(server_->port()).get("/").empty());
  server_.reset();
  const int last = again->calls;
  protocol_.client->callSoon(again);
  EXPECT_EQ(again->calls, last);
}

}  // namespace
}  // namespace pongsim::web
