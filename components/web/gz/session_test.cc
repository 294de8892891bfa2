#include "web/gz/session.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/bytes.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/publishers.pb.h>
#include <ignition/msgs/scene.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#include <ignition/msgs/stringmsg_v.pb.h>

#include <optional>

#include "support/web/recorded_client.hh"
#include "support/web/stepped_world.hh"

namespace pongsim::web::gz {
namespace {

namespace im = ignition::msgs;

class GzSessionTest : public testing::Test {
 protected:
  /// Sends a request and returns the response.
  std::vector<std::string> say(const std::string& text) {
    session().text(text);
    return client_->takeBinaries();
  }
  std::string answer(const std::string& text) {
    const auto all = say(text);
    return all.size() == 1 ? all.front() : std::to_string(all.size()) + " answers";
  }
  /// Sends a request, and steps until there are responses.
  std::vector<std::string> answersOfTheWorld(const std::string& text) {
    session().text(text);
    std::vector<std::string> all;
    world_.stepUntil([&] {
      for (const std::string& each : client_->takeBinaries()) all.push_back(each);
      return !all.empty();
    });
    return all;
  }
  /// @return The payload after the third comma as a message; checks the header.
  template <class M>
  static M message(const std::string& head, const std::string& frame) {
    EXPECT_TRUE(frame.starts_with(head)) << frame;
    M read;
    EXPECT_TRUE(read.ParseFromString(frame.substr(std::min(head.size(), frame.size()))));
    return read;
  }
  static std::string errorOf(const std::string& topic, const std::string& frame) {
    return message<im::StringMsg>("error," + topic + ",ignition.msgs.StringMsg,", frame).data();
  }
  GzSession& session() {
    if (!session_) session_.emplace(client_, worlds_, assets_, settings_, nullptr);
    return *session_;
  }
  static std::string text(const std::string& data) {
    im::StringMsg message;
    message.set_data(data);
    return message.SerializeAsString();
  }

  std::shared_ptr<Worlds> worlds_ = std::make_shared<Worlds>();
  SteppedWorld world_{worlds_};
  std::shared_ptr<RecordedClient> client_ = std::make_shared<RecordedClient>();
  RecordedAssets assets_;
  GzSettings settings_;
  std::optional<GzSession> session_;
};

TEST_F(GzSessionTest, TellsDefinitionsWorldsAndTopics) {
  const auto publisher = world_.node().advertise<im::StringMsg>("/said");
  const Subscription subscription = world_.node().subscribe<im::StringMsg>("/asked", [](const auto&) {});
  session();
  ASSERT_TRUE(world_.stepUntil([&] { return worlds_->topics().size() == 2; }));
  EXPECT_TRUE(answer("protos,,,").starts_with("syntax = \"proto3\";\npackage ignition.msgs;\n"));
  EXPECT_EQ(message<im::StringMsg_V>("pub,worlds,ignition.msgs.StringMsg_V,", answer("worlds,,,")).data(0), "w");
  const auto topics = message<im::StringMsg_V>("pub,topics,ignition.msgs.StringMsg_V,", answer("topics,,,"));
  ASSERT_EQ(topics.data_size(), 1);
  EXPECT_EQ(topics.data(0), "/said");
  const auto types = message<im::Publishers>("pub,topics-types,ignition.msgs.Publishers,", answer("topics-types,,,"));
  ASSERT_EQ(types.publisher_size(), 1);
  EXPECT_EQ(types.publisher(0).topic(), "/said");
  EXPECT_EQ(types.publisher(0).msg_type(), "ignition.msgs.StringMsg");
}

TEST_F(GzSessionTest, AsksTheWorldForItsScene) {
  const Service service =
      world_.node().serve<im::Empty, im::Scene>("/world/w/scene/info", [](const auto&, im::Scene& scene) {
        scene.set_name("w");
        return true;
      });
  session();
  ASSERT_TRUE(world_.stepUntil([&] { return !worlds_->services().empty(); }));
  const auto frames = answersOfTheWorld("scene,w,,");
  EXPECT_EQ(message<im::Scene>("pub,scene,ignition.msgs.Scene,", frames.at(0)).name(), "w");
  // as in Fortress, an empty response if there is no such service
  EXPECT_EQ(answer("scene,other,,"), "pub,scene,ignition.msgs.Scene,");
  EXPECT_EQ(answersOfTheWorld("particle_emitters,w,,").at(0), "pub,particle_emitters,ignition.msgs.ParticleEmitter_V,");
}

TEST_F(GzSessionTest, HearsAndIsHeard) {
  settings_.publicationHz = 1e9;
  auto publisher = world_.node().advertise<im::StringMsg>("/said");
  std::vector<std::string> received;
  const Subscription subscription = world_.node().subscribe<im::StringMsg>(
      "/asked", [&](const im::StringMsg& message) { received.push_back(message.data()); });
  EXPECT_TRUE(say("sub,/said,,").empty());
  ASSERT_TRUE(world_.stepUntil([&] {
    client_->free();
    return publisher.hasSubscribers();
  }));
  im::StringMsg said;
  said.set_data("a,b");
  publisher.publish(said);
  client_->free();
  EXPECT_EQ(client_->takeBinaries(), std::vector<std::string>{"pub,/said,ignition.msgs.StringMsg," + text("a,b")});
  EXPECT_TRUE(say("adv,/asked,gz.msgs.StringMsg,").empty());
  EXPECT_TRUE(say("pub,/asked,ignition.msgs.StringMsg," + text("x,y")).empty());
  EXPECT_TRUE(say("pub_in,/asked,StringMsg," + text("z")).empty());
  ASSERT_TRUE(world_.stepUntil([&] { return received.size() == 2; }));
  EXPECT_EQ(received, (std::vector<std::string>{"x,y", "z"}));
  EXPECT_TRUE(say("unsub,/said,,").empty());
  EXPECT_TRUE(world_.stepUntil([&] { return !publisher.hasSubscribers(); }));
}

TEST_F(GzSessionTest, CallsServices) {
  const Service service =
      world_.node().serve<im::StringMsg, im::Boolean>("/s", [](const im::StringMsg& request, im::Boolean& reply) {
        reply.set_data(true);
        return request.data() == "yes" ? ServiceAnswer(true) : ServiceAnswer::refused("it says no");
      });
  session();
  ASSERT_TRUE(world_.stepUntil([&] { return !worlds_->services().empty(); }));
  EXPECT_TRUE(message<im::Boolean>("req,/s,ignition.msgs.Boolean,",
                                   answersOfTheWorld("req,/s,ignition.msgs.StringMsg," + text("yes")).at(0))
                  .data());
  const auto refused = answersOfTheWorld("req,/s,ignition.msgs.StringMsg," + text("no"));
  ASSERT_EQ(refused.size(), 2U);
  EXPECT_EQ(refused[0], "req,/s,ignition.msgs.Boolean,");
  EXPECT_NE(errorOf("/s", refused[1]).find("it says no"), std::string::npos);
  EXPECT_EQ(message<im::StringMsg>("req,/none,ignition.msgs.StringMsg,", answer("req,/none,Empty,")).data(),
            "service_not_found");
  EXPECT_EQ(errorOf("/s", answer("req,/s,Empty,")), "the service takes ignition.msgs.StringMsg, not 'Empty'");
  EXPECT_EQ(errorOf("/s", answer("req,/s,StringMsg,\xff\xff")), "2 bytes are not of type ignition.msgs.StringMsg");
}

TEST_F(GzSessionTest, HandsOutAssets) {
  assets_.files["model://m/a.dae"] = "mesh";
  const std::string head = "asset,model://m/a.dae,ignition.msgs.Bytes,";
  EXPECT_EQ(message<im::Bytes>(head, answer("asset,,,model://m/a.dae")).data(), "mesh");
  EXPECT_EQ(message<im::Bytes>(head, answer("asset,model://m/a.dae,,")).data(), "mesh");
  EXPECT_EQ(answer("asset,,,/etc/passwd"), "asset,/etc/passwd,ignition.msgs.StringMsg," + text("asset_not_found"));
  EXPECT_EQ(answer("asset,,,"), "asset,,ignition.msgs.StringMsg," + text("asset_uri_missing"));
}

TEST_F(GzSessionTest, AsksForTheKey) {
  settings_.authorizationKey = "user,key";
  settings_.adminAuthorizationKey = "admin";
  EXPECT_EQ(errorOf("", answer("protos,,,")), "say 'auth,,,KEY' first");
  for (const char* wrong : {"auth,,,", "auth,,,user", "auth,,,user,key2", "auth,,,adminadmin"}) {
    EXPECT_EQ(answer(wrong), "invalid") << wrong;
  }
  EXPECT_EQ(answer("auth,,,user,key"), "authorized");
  EXPECT_TRUE(answer("protos,,,").starts_with("syntax"));
}

TEST_F(GzSessionTest, LetsInWithoutAKeyWhereThereIsNone) { EXPECT_EQ(answer("auth,,,anything"), "authorized"); }

TEST_F(GzSessionTest, LetsWhoMayOnlyLookChangeNothing) {
  client_->setMayWrite(false);
  const Service state =
      world_.node().serve<im::Empty, im::Scene>("/world/w/scene/info", [](const auto&, auto&) { return true; });
  const Service control =
      world_.node().serve<im::StringMsg, im::Boolean>("/world/w/control", [](const auto&, auto&) { return true; });
  session();
  ASSERT_TRUE(world_.stepUntil([&] { return worlds_->services().size() == 2; }));
  EXPECT_EQ(errorOf("/world/w/control", answer("req,/world/w/control,StringMsg,")), "this client is read-only");
  EXPECT_EQ(errorOf("/t", answer("pub,/t,StringMsg,")), "this client is read-only");
  EXPECT_EQ(errorOf("/t", answer("adv,/t,StringMsg,")), "this client is read-only");
  EXPECT_EQ(answersOfTheWorld("req,/world/w/scene/info,Empty,").at(0), "req,/world/w/scene/info,ignition.msgs.Scene,");
}

TEST_F(GzSessionTest, AnswersRubbishWithAWord) {
  EXPECT_EQ(errorOf("", answer("")), "a message must have four parts: operation,topic,type,payload");
  EXPECT_EQ(errorOf("/t", answer("dance,/t,,")), "there is no operation 'dance'");
  EXPECT_EQ(errorOf("/t", answer("pub,/t,Nonsense,")), "there is no message type 'Nonsense'");
  EXPECT_EQ(errorOf("/t", answer("adv,/t,Nonsense,")), "there is no message type 'Nonsense'");
  EXPECT_NE(errorOf("a b", answer("pub,a b,StringMsg,")).find("has a space"), std::string::npos);
  EXPECT_NE(errorOf("/t", answer("throttle,/t,na,fast")), "");
  for (int i = 0; i < 200; ++i) say("adv,/many" + std::to_string(i) + ",StringMsg,");
  EXPECT_EQ(errorOf("/more", answer("adv,/more,StringMsg,")), "a client can publish on at most 100 topics");
  std::string noise(1000, '\0');
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<char>(i * 37 % 251);
  session().binary(std::as_bytes(std::span(noise)));
}

TEST_F(GzSessionTest, AnswersEarlyQuestionsForTopicsWhenTheWorldHasSaidWhatThereIs) {
  const auto publisher = world_.node().advertise<im::StringMsg>("/said");
  EXPECT_TRUE(say("topics,,,").empty());
  EXPECT_TRUE(say("topics-types,,,").empty());
  world_.step();
  client_->free();
  const auto answers = client_->takeBinaries();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(message<im::StringMsg_V>("pub,topics,ignition.msgs.StringMsg_V,", answers[0]).data(0), "/said");
  EXPECT_EQ(message<im::Publishers>("pub,topics-types,ignition.msgs.Publishers,", answers[1]).publisher_size(), 1);
}

}  // namespace
}  // namespace pongsim::web::gz
