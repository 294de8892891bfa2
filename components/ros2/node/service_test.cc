#include "ros2/node/service.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "ros2/node/names.hh"
#include "support/process.hh"
#include "support/test_domain.hh"
#include "support/wait_until.hh"

namespace pongsim::ros2 {
namespace {

/// Like example_interfaces/srv/AddTwoInts.
struct AddTwoInts {
  static constexpr const char* kName = "example_interfaces/srv/AddTwoInts";
  struct Request {
    static constexpr const char* kName = "example_interfaces/srv/AddTwoInts_Request";
    std::int64_t a = 0;
    std::int64_t b = 0;
    static void visit(auto& self, auto&& field) {
      field("a", self.a);
      field("b", self.b);
    }
  };
  struct Response {
    static constexpr const char* kName = "example_interfaces/srv/AddTwoInts_Response";
    std::int64_t sum = 0;
    static void visit(auto& self, auto&& field) { field("sum", self.sum); }
  };
};

/// A service whose response has grown with each version.
struct Measure {
  static constexpr const char* kName = "example_interfaces/srv/Measure";
  struct Request {
    static constexpr const char* kName = "example_interfaces/srv/Measure_Request";
    std::int32_t sensor = 0;
    static void visit(auto& self, auto&& field) { field("sensor", self.sensor); }
  };
  struct OlderResponse {
    static constexpr const char* kName = "example_interfaces/srv/Measure_Response";
    double value = 0;
    static void visit(auto& self, auto&& field) { field("value", self.value); }
  };
  struct Response {
    static constexpr const char* kName = "example_interfaces/srv/Measure_Response";
    double value = 0;
    std::string unit;
    static void visit(auto& self, auto&& field) {
      field("value", self.value);
      field("unit", self.unit);
    }
  };
  struct NewerResponse {
    static constexpr const char* kName = "example_interfaces/srv/Measure_Response";
    std::string unit;
    double value = 0;
    static void visit(auto& self, auto&& field) {
      field("unit", self.unit);
      field("value", self.value);
    }
  };
  static OlderResponse toOlder(const Response& response) { return {response.value}; }
  static NewerResponse toNewer(const Response& response) { return {response.unit, response.value}; }
};

/// What a client of another version knows.
template <class Answer>
struct MeasureOf {
  static constexpr const char* kName = Measure::kName;
  using Request = Measure::Request;
  using Response = Answer;
};

class ServiceTest : public testing::Test {
 protected:
  /// Calls on another thread, because this one answers.
  template <class Service>
  std::optional<typename Service::Response> callOf(const std::string& service, const typename Service::Request& request,
                                                   std::chrono::seconds timeout = test::kDeadline) {
    auto answer =
        std::async(std::launch::async, [&] { return RosClient<Service>(peer_, service).call(request, timeout); });
    while (answer.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) node_.mailbox().dispatch();
    return answer.get();
  }
  std::optional<AddTwoInts::Response> call(std::int64_t a, std::int64_t b) {
    return callOf<AddTwoInts>("/add", {a, b});
  }

  const int domain_ = test::testDomain();
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {}};
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "peer"}};
};

TEST_F(ServiceTest, AnswersWithTheSum) {
  const auto server = serveAtOnce<AddTwoInts>(
      node_, "/add", [](const AddTwoInts::Request& request) { return AddTwoInts::Response{request.a + request.b}; });
  EXPECT_EQ(server->name(), "/add");
  for (std::int64_t i = 0; i < 5; ++i) {
    const auto answer = call(i, 2);
    ASSERT_TRUE(answer.has_value());
    EXPECT_EQ(answer->sum, i + 2);
  }
}

TEST_F(ServiceTest, AnswersEachClientInTheVersionOfItsType) {
  const auto server = serveAtOnce<Measure>(node_, "/measure", [](const Measure::Request&) {
    return Measure::Response{2.5, "m"};
  });
  const auto older = callOf<MeasureOf<Measure::OlderResponse>>("/measure", {});
  ASSERT_TRUE(older.has_value());
  EXPECT_EQ(older->value, 2.5);
  const auto own = callOf<Measure>("/measure", {});
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(own->unit, "m");
  const auto newer = callOf<MeasureOf<Measure::NewerResponse>>("/measure", {});
  ASSERT_TRUE(newer.has_value());
  EXPECT_EQ(newer->unit, "m");
  EXPECT_EQ(newer->value, 2.5);
}

TEST_F(ServiceTest, MayAnswerLaterFromAnotherThread) {
  std::thread later;
  const auto server =
      serve<AddTwoInts>(node_, "/add", [&](const AddTwoInts::Request& request, const Responder<AddTwoInts>& responder) {
        later = std::thread([responder, sum = request.a + request.b] { responder.answer({sum}); });
      });
  const auto answer = call(40, 2);
  later.join();
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->sum, 42);
}

TEST_F(ServiceTest, EachOfManyClientsGetsItsOwnAnswer) {
  const auto server = serveAtOnce<AddTwoInts>(
      node_, "/add", [](const AddTwoInts::Request& request) { return AddTwoInts::Response{request.a + request.b}; });
  std::atomic<int> right = 0;
  std::vector<std::jthread> clients;
  for (std::int64_t i = 0; i < 5; ++i) {
    clients.emplace_back([&, i] {
      RosClient<AddTwoInts> client(peer_, "/add");
      for (std::int64_t j = 0; j < 20; ++j) {
        const auto answer = client.call({100 * i, j}, test::kDeadline);
        if (answer && answer->sum == 100 * i + j) ++right;
      }
      ++right;
    });
  }
  const auto end = std::chrono::steady_clock::now() + 2 * test::kDeadline;
  while (right < 5 * 21 && std::chrono::steady_clock::now() < end) {
    node_.mailbox().dispatch();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(right, 5 * 21);
}

TEST_F(ServiceTest, RepliesToAClientThatIsDiscoveredWhileItEnds) {
  bool isAnswered = false;
  auto server = serveAtOnce<AddTwoInts>(node_, "/add", [&](const AddTwoInts::Request& request) {
    isAnswered = true;
    return AddTwoInts::Response{request.a + request.b};
  });
  const TypeInfo asked = typeInfo<AddTwoInts::Request>(), answered = typeInfo<AddTwoInts::Response>();
  const auto writer =
      peerParticipant_.makeWriter({requestOnWire("/add"), ddsTypeName(asked.name), asked.hash, kDefaultQos});
  ASSERT_TRUE(test::waitUntil([&] { return writer->hasReaders(); }));
  const std::vector<std::byte> request = toCdr(AddTwoInts::Request{40, 2});
  writer->write(request.size(), [&](std::span<std::byte> place) { std::ranges::copy(request, place.begin()); });
  ASSERT_TRUE(test::waitUntil([&] {
    node_.mailbox().dispatch();
    return isAnswered;
  }));
  std::atomic<bool> hasReply = false;
  std::unique_ptr<Reader> reader;
  std::jthread late([&] {
    reader = peerParticipant_.makeReader({replyOnWire("/add"), ddsTypeName(answered.name), answered.hash, kDefaultQos},
                                         [&](const Sample&) { hasReply = true; });
  });
  server.reset();
  EXPECT_TRUE(hasReply);
}

TEST_F(ServiceTest, WhereNobodyServesThereIsNoAnswer) {
  EXPECT_FALSE(RosClient<AddTwoInts>(peer_, "/add").call({1, 2}, std::chrono::milliseconds(50)).has_value());
}

}  // namespace
}  // namespace pongsim::ros2
