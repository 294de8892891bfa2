#include "web/server/server.hh"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/temp_folder.hh"
#include "support/wait_until.hh"
#include "support/web/echo_protocol.hh"
#include "web/test/raw_client.hh"

namespace pongsim::web {
namespace {

using pongsim::test::waitUntil;
using test::RawClient;

constexpr const char* kEcho = "Sec-WebSocket-Protocol: other, echo\r\n";

/// Keeps its clients, also beyond the ends of their connections.
class KeepingEchoProtocol final : public EchoProtocol {
 public:
  std::unique_ptr<Session> open(const std::string& name, const std::shared_ptr<Client>& client) override {
    const std::lock_guard lock(mutex_);
    clients_.push_back(client);
    return EchoProtocol::open(name, client);
  }
  std::shared_ptr<Client> client(std::size_t number) {
    const std::lock_guard lock(mutex_);
    return clients_.at(number);
  }

 private:
  std::mutex mutex_;
  std::vector<std::shared_ptr<Client>> clients_;
};

class ServerTest : public testing::Test {
 protected:
  ServerTest() {
    settings_.port = 0;
    settings_.page = folder_.path() / "page";
    std::filesystem::create_directory(settings_.page);
    std::ofstream(settings_.page / "index.html") << "<title>page</title>";
    std::ofstream(settings_.page / "main.js") << "run()";
    std::ofstream(settings_.page / "main.js.gz") << "compressed";
    std::ofstream(folder_.path() / "secret.txt") << "secret";
  }
  int start() {
    server_ = std::make_unique<Server>(settings_, log_, std::vector<Protocol*>{&protocol_});
    return server_->port();
  }
  /// @return A client that has been greeted and has not sent anything yet.
  std::unique_ptr<RawClient> greeted(int receiveBuffer = 0) {
    auto client = std::make_unique<RawClient>(server_->port(), receiveBuffer);
    EXPECT_TRUE(client->open("/", kEcho).starts_with("HTTP/1.1 101"));
    EXPECT_EQ(client->next().value().payload, "hello echo");
    return client;
  }

  pongsim::test::TempFolder folder_;
  Logger log_{"web"};
  ServerSettings settings_;
  KeepingEchoProtocol protocol_;
  std::unique_ptr<Server> server_;
};

TEST_F(ServerTest, ServesThePageWithAStrictPolicy) {
  const int port = start();
  const std::string index = RawClient(port).get("/");
  EXPECT_TRUE(index.starts_with("HTTP/1.1 200")) << index;
  EXPECT_NE(index.find("<title>page</title>"), std::string::npos);
  EXPECT_NE(index.find("content-security-policy: default-src 'none'; script-src 'self';"), std::string::npos) << index;
  EXPECT_NE(index.find("x-content-type-options: nosniff"), std::string::npos);
  EXPECT_EQ(index.find("unsafe"), std::string::npos);
  EXPECT_TRUE(RawClient(port).get("/main.js").ends_with("run()"));
}

TEST_F(ServerTest, CountsWhatClientsAreSent) {
  start();
  const auto client = greeted();
  ASSERT_EQ(settings_.traffic->all().size(), 1U);
  const auto traffic = settings_.traffic->all()[0];
  EXPECT_EQ(traffic->address(), "127.0.0.1");
  EXPECT_EQ(traffic->protocol(), "echo");
  const auto sent = protocol_.client(0);
  sent->traffic().name(5, "/a");
  sent->sendData(5, 1, {"head", Payload("body!")});
  EXPECT_EQ(client->next().value().payload, "headbody!");
  EXPECT_TRUE(waitUntil([&] { return traffic->counts().contains("/a") && traffic->counts().at("/a").messages == 1; }));
  EXPECT_EQ(traffic->counts().at("/a").bytes, 9U);
}

TEST_F(ServerTest, LetsOnlyNamedPagesShowItInAFrame) {
  const auto endsWith = [&](const char* policy) {
    return RawClient(start()).get("/").find(std::string("; frame-ancestors ") + policy + "\r\n") != std::string::npos;
  };
  EXPECT_TRUE(endsWith("'none'"));
  settings_.framingOrigins = {"http://localhost:*", "https://lab.example"};
  EXPECT_TRUE(endsWith("http://localhost:* https://lab.example"));
}

TEST_F(ServerTest, SendsTheCompressedFileToWhoTakesIt) {
  const std::string answer = RawClient(start()).get("/main.js", "Accept-Encoding: br, gzip\r\n");
  EXPECT_TRUE(answer.ends_with("compressed")) << answer;
  EXPECT_NE(answer.find("content-encoding: gzip"), std::string::npos);
  EXPECT_NE(answer.find("content-type: text/javascript"), std::string::npos);
}

TEST_F(ServerTest, DoesNotLeaveThePagesFolder) {
  const int port = start();
  std::filesystem::create_symlink(folder_.path() / "secret.txt", settings_.page / "link.txt");
  for (const char* path : {"/../secret.txt", "/%2e%2e/secret.txt", "//etc/passwd", "/..%2fsecret.txt", "/link.txt",
                           "/nothing.js", "/main"}) {
    const std::string answer = RawClient(port).get(path);
    EXPECT_FALSE(answer.ends_with("secret") || answer.find("root:") != std::string::npos) << path;
    EXPECT_FALSE(answer.starts_with("HTTP/1.1 200")) << path << ": " << answer;
  }
}

TEST_F(ServerTest, FollowsNoLinkToACompressedFile) {
  const int port = start();
  std::filesystem::create_symlink(folder_.path() / "secret.txt", settings_.page / "index.html.gz");
  const std::string answer = RawClient(port).get("/", "Accept-Encoding: gzip\r\n");
  EXPECT_TRUE(answer.ends_with("<title>page</title>")) << answer;
}

TEST_F(ServerTest, RefusesForeignHostsAndPages) {
  const int port = start();
  EXPECT_TRUE(RawClient(port).get("/", {}, "evil.example").substr(8, 5) == " 421 ");
  EXPECT_TRUE(RawClient(port).open("/", kEcho, "evil.example").substr(8, 5) == " 421 ");
  const std::string head = RawClient(port).open("/", std::string(kEcho) + "Origin: https://evil.example\r\n");
  EXPECT_TRUE(head.substr(8, 5) == " 403 ") << head;
  EXPECT_EQ(server_->clients(), 0U);
}

TEST_F(ServerTest, RefusesOtherProtocolsThanWebSocket) {
  const int port = start();
  for (const char* protocol : {"chess", "h2c"}) {
    RawClient client(port);
    client.send("GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                "\r\nConnection: Upgrade\r\nUpgrade: " + protocol + "\r\n\r\n");
    EXPECT_TRUE(client.finish()) << protocol;
  }
  EXPECT_TRUE(RawClient(port).open("/", kEcho).starts_with("HTTP/1.1 101"));
}

TEST_F(ServerTest, LetsAPageLookThatIsNamed) {
  settings_.access.readingOrigins = {"https://app.example"};
  RawClient client(start());
  EXPECT_TRUE(client.open("/", std::string(kEcho) + "Origin: https://app.example\r\n").starts_with("HTTP/1.1 101"));
  client.next();
  client.sendText("may I?");
  EXPECT_EQ(client.next().value().payload, "no");
}

TEST_F(ServerTest, AsksForTheToken) {
  settings_.access.token = "0123";
  const int port = start();
  EXPECT_TRUE(RawClient(port).open("/", kEcho).substr(8, 5) == " 401 ");
  EXPECT_TRUE(RawClient(port).open("/?token=0124", kEcho).substr(8, 5) == " 401 ");
  EXPECT_TRUE(RawClient(port).open("/?token=0123", kEcho).starts_with("HTTP/1.1 101"));
  EXPECT_TRUE(
      RawClient(port).open("/", std::string(kEcho) + "Authorization: Bearer 0123\r\n").starts_with("HTTP/1.1 101"));
  EXPECT_TRUE(RawClient(port).get("/").starts_with("HTTP/1.1 200"));
  EXPECT_TRUE(RawClient(port).get("/assets/x.png").substr(8, 5) == " 401 ");
}

TEST_F(ServerTest, ServesWhatTheWorldNeedsAndNothingElse) {
  std::ofstream(folder_.path() / "a b.png") << "picture";
  settings_.findAsset = [this](std::string_view address) -> std::optional<std::filesystem::path> {
    if (address == "/a b.png") return folder_.path() / "a b.png";
    if (address == "/passwd") return "/etc/passwd";
    return {};
  };
  const int port = start();
  EXPECT_TRUE(RawClient(port).get("/assets/a%20b.png").ends_with("picture"));
  EXPECT_TRUE(RawClient(port).get("/assets/other.png").starts_with("HTTP/1.1 404"));
  // of a type that worlds do not use
  EXPECT_TRUE(RawClient(port).get("/assets/passwd").starts_with("HTTP/1.1 404"));
}

TEST_F(ServerTest, SpeaksTheProtocolThatTheClientNames) {
  const int port = start();
  RawClient named(port);
  const std::string head = named.open("/", kEcho);
  EXPECT_NE(head.find("echo"), std::string::npos) << head;
  EXPECT_EQ(named.next().value().payload, "hello echo");
  RawClient without(port);
  without.open();
  EXPECT_EQ(without.next().value().payload, "hello ");
}

TEST_F(ServerTest, CarriesMessagesOfAnySizeAndInPieces) {
  start();
  const auto client = greeted();
  const std::string large(3'000'000, 'x');
  EXPECT_TRUE(client->sendText(large));
  EXPECT_EQ(client->next().value().payload, large);
  EXPECT_TRUE(client->sendFrame(2, "one ", false));
  EXPECT_TRUE(client->sendFrame(0, "two", true));
  const auto message = client->next().value();
  EXPECT_EQ(message.opcode, 2);
  EXPECT_EQ(message.payload, "echo:one two");
}

TEST_F(ServerTest, ClosesWhoSendsTooMuch) {
  settings_.limits.messageBytes = 1000;
  start();
  const auto large = greeted();
  large->sendText(std::string(1001, 'x'));
  EXPECT_EQ(large->next().value().closeCode(), 1009);
  const auto inPieces = greeted();
  for (int i = 0; i < 11; ++i) inPieces->sendFrame(i == 0 ? 1 : 0, std::string(100, 'x'), false);
  EXPECT_EQ(inPieces->next().value().closeCode(), 1009);
  // announces 2^62 bytes
  const auto liar = greeted();
  liar->send(std::string("\x82\xff\x40\0\0\0\0\0\0\0\0\0\0\0abc", 17));
  const auto answer = liar->next();
  EXPECT_TRUE(!answer || answer->closeCode() != 0);
  EXPECT_EQ(greeted()->isConnected(), true);
}

TEST_F(ServerTest, ReadsAMessageThatIsTooLongToItsEndSoThatTheReasonArrives) {
  start();
  const auto client = greeted();
  EXPECT_TRUE(client->sendText(std::string(std::size_t{5} << 20, 'x')));
  EXPECT_EQ(client->next().value().closeCode(), 1009);
}

TEST_F(ServerTest, ClosesWhoSendsRubbish) {
  start();
  const auto notText = greeted();
  notText->sendText("\xff\xfe");
  const auto answer = notText->next();
  EXPECT_TRUE(!answer || answer->opcode == 8);
  const auto unknown = greeted();
  unknown->sendFrame(7, "x");
  const auto refusal = unknown->next();
  EXPECT_TRUE(!refusal || refusal->opcode == 8);
  RawClient noHttp(server_->port());
  noHttp.send(std::string(5000, '\x01'));
  EXPECT_EQ(greeted()->isConnected(), true);
}

TEST_F(ServerTest, ClosesTheOneClientWhoseSessionFails) {
  start();
  const auto bad = greeted(), good = greeted();
  bad->sendText("fail");
  EXPECT_EQ(bad->next().value().closeCode(), 1011);
  good->sendText("still there?");
  EXPECT_EQ(good->next().value().payload, "still there?");
}

TEST_F(ServerTest, ClosesAfterWhatMustNotBeLost) {
  start();
  const auto client = greeted();
  client->sendText("last");
  client->sendText("close");
  EXPECT_EQ(client->next().value().payload, "last");
  const auto end = client->next().value();
  EXPECT_EQ(end.closeCode(), 1008);
  EXPECT_EQ(end.payload.substr(2), "you asked");
}

TEST_F(ServerTest, AClientThatReadsLateGetsTheLatest) {
  start();
  const auto client = greeted(4096);
  const std::shared_ptr<Client> sender = protocol_.client(0);
  // far more than sockets can buffer
  constexpr int kFrames = 400;
  for (int i = 0; i < kFrames; ++i) sender->sendData(1, 1, {.head = std::to_string(i) + " ", .body = Payload(1 << 20)});
  int count = 0;
  int latest = -1;
  while (latest != kFrames - 1) {
    const auto message = client->next();
    ASSERT_TRUE(message);
    latest = std::stoi(message->payload);
    ++count;
  }
  EXPECT_LE(count, 10);
  EXPECT_EQ(sender->dropped(), static_cast<std::uint64_t>(kFrames - count));
}

TEST_F(ServerTest, ClosesWhoNeverReadsWhatMustNotBeLost) {
  settings_.limits.waitingBytes = 1 << 20;
  start();
  const auto client = greeted(4096);
  const std::shared_ptr<Client> sender = protocol_.client(0);
  for (int i = 0; i < 100; ++i) sender->sendBinary({.head = {}, .body = Payload(1 << 17)});
  // all queued messages, then the close frame
  std::optional<RawClient::Message> message;
  do message = client->next();
  while (message && message->opcode != 8);
  EXPECT_TRUE(!message || message->closeCode() == 1008);
  EXPECT_TRUE(waitUntil([&] { return server_->clients() == 0; }));
}

TEST_F(ServerTest, RefusesClientsBeyondTheLimit) {
  settings_.limits.clients = 2;
  start();
  const auto one = greeted(), two = greeted();
  EXPECT_TRUE(RawClient(server_->port()).open("/", kEcho).substr(8, 5) == " 503 ");
}

TEST_F(ServerTest, ServesANewClientAtOnceWhateverWaits) {
  settings_.limits.connections = 20;
  // no handshake ends by itself while the test runs
  settings_.limits.handshake = std::chrono::hours(1);
  start();
  const auto honest = greeted();
  std::vector<std::unique_ptr<RawClient>> slow;
  for (int i = 0; i < 60; ++i) {
    slow.push_back(std::make_unique<RawClient>(server_->port()));
    if (i % 2 == 0) slow.back()->send("GET / HTTP/1.1\r\nHost: ");
  }
  EXPECT_TRUE(RawClient(server_->port()).get("/main.js").ends_with("run()"));
  EXPECT_TRUE(greeted()->isConnected());
  // clients are not closed for others
  honest->sendText("still there?");
  EXPECT_EQ(honest->next().value().payload, "still there?");
}

TEST_F(ServerTest, BoundsTheHandshakesOfAPeer) {
  settings_.limits.handshakesOfAPeer = 3;
  settings_.limits.handshake = std::chrono::hours(1);
  const int port = start();
  std::vector<std::unique_ptr<RawClient>> slow;
  for (int i = 0; i < 4; ++i) slow.push_back(std::make_unique<RawClient>(port));
  // the first one has been closed for the fourth; the others still get answers
  EXPECT_TRUE(slow.back()->get("/main.js").ends_with("run()"));
  EXPECT_EQ(slow.front()->get("/main.js"), "");
  EXPECT_TRUE(slow.at(1)->get("/main.js").ends_with("run()"));
}

TEST_F(ServerTest, SaysThatThereAreNoFileDescriptorsLeft) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the undefined-behaviour sanitizer needs file descriptors to tell an object's type";
#endif
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  // from too few for anything to enough; each time it starts, or says why not
  bool hasStarted = false;
  for (rlim_t more = 0; more < 30 && !hasStarted; ++more) {
    const int next = dup(0);
    ::close(next);
    const rlimit few{static_cast<rlim_t>(next) + more, before.rlim_max};
    setrlimit(RLIMIT_NOFILE, &few);
    try {
      start();
      hasStarted = true;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("the server can't be started: "), std::string::npos) << error.what();
    }
    server_.reset();
  }
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_TRUE(hasStarted);
}

TEST_F(ServerTest, Holds200Clients) {
  start();
  std::vector<std::unique_ptr<RawClient>> clients;
  for (int i = 0; i < 200; ++i) clients.push_back(greeted());
  EXPECT_EQ(server_->clients(), 200U);
  for (const auto& client : clients) client->sendText("x");
  for (const auto& client : clients) EXPECT_EQ(client->next().value().payload, "x");
  clients.clear();
  EXPECT_TRUE(waitUntil([&] { return server_->clients() == 0; }));
}

TEST_F(ServerTest, AClientThatIsHeldBeyondItsEndDoesNothing) {
  start();
  greeted();
  const std::shared_ptr<Client> held = protocol_.client(0);
  EXPECT_TRUE(waitUntil([&] { return server_->clients() == 0; }));
  held->sendText("x");
  server_.reset();
  held->sendData(1, 1, {.head = "x", .body = {}});
  held->close(1000, "");
}

TEST_F(ServerTest, SaysThatAPortIsTaken) {
  settings_.port = start();
  try {
    Server second(settings_, log_, {&protocol_});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(),
              "port " + std::to_string(settings_.port) +
                  " of 127.0.0.1 can't be opened: another program uses it; choose another with --web PORT or <port>");
  }
}

TEST_F(ServerTest, SaysThatACertificateCantBeUsed) {
  settings_.certificate = folder_.path() / "nothing.pem";
  settings_.key = settings_.certificate;
  EXPECT_THROW(start(), std::runtime_error);
  settings_.certificate = settings_.key = folder_.path() / "secret.txt";
  EXPECT_THROW(start(), std::runtime_error);
  // the next client without it is unaffected
  settings_.certificate = settings_.key = "";
  start();
  EXPECT_TRUE(greeted()->isConnected());
}

}  // namespace
}  // namespace pongsim::web
