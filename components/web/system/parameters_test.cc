#include "web/system/parameters.hh"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "pongsim/program/network_interface.hh"

namespace pongsim::web {
namespace {

Element element(const std::string& name, const std::string& text, std::vector<Element> children = {}) {
  Element made;
  made.name = name;
  made.text = text;
  made.children = std::move(children);
  return made;
}

/// The parsed content of a `<plugin>`.
WebParameters read(std::vector<Element> children) {
  const Element plugin = element("plugin", "", std::move(children));
  WebParameters parameters;
  Declaration declaration;
  parameters.declare(declaration);
  Diagnostics diagnostics;
  EXPECT_TRUE(declaration.read(plugin, "web", diagnostics));
  EXPECT_TRUE(diagnostics.all().empty());
  parameters.readRest(plugin);
  return parameters;
}

TEST(WebParameters, AreThoseOfOurs) {
  const WebParameters parameters =
      read({element("port", "8080"), element("origin", "https://a.example"), element("origin", "https://b.example"),
            element("writing_origin", "https://c.example"), element("read_only", "true"),
            element("framing_origin", "http://localhost:*"), element("certificate", "c.pem"), element("key", "k.pem")});
  const ServerSettings settings = serverSettings(parameters, "", "");
  EXPECT_EQ(settings.port, 8080);
  EXPECT_EQ(settings.access.readingOrigins, (std::vector<std::string>{"https://a.example", "https://b.example"}));
  EXPECT_EQ(settings.access.writingOrigins, std::vector<std::string>{"https://c.example"});
  EXPECT_EQ(settings.framingOrigins, std::vector<std::string>{"http://localhost:*"});
  EXPECT_TRUE(settings.access.isReadOnly);
  EXPECT_EQ(settings.certificate, "c.pem");
  EXPECT_EQ(settings.key, "k.pem");
}

TEST(WebParameters, AreThoseOfLaunchsServer) {
  const WebParameters parameters = read(
      {element("publication_hz", "30"), element("authorization_key", "a"), element("admin_authorization_key", "b"),
       element("max_connections", "5"), element("queue_size_per_connection", "7"),
       element("ssl", "", {element("cert_file", "c.pem"), element("private_key_file", "k.pem")}),
       element("subscription_limit_per_connection", "",
               {element("subscription", "", {element("msg_type", "ignition.msgs.Image"), element("limit", "2")})})});
  EXPECT_EQ(parameters.gz.publicationHz, 30);
  EXPECT_EQ(parameters.gz.authorizationKey, "a");
  EXPECT_EQ(parameters.gz.adminAuthorizationKey, "b");
  EXPECT_EQ(parameters.gz.maxConnections, 5);
  EXPECT_EQ(parameters.gz.queueSizePerConnection, 7);
  EXPECT_EQ(parameters.gz.subscriptionLimits.at("ignition.msgs.Image"), 2);
  EXPECT_EQ(parameters.certificate, "c.pem");
  EXPECT_EQ(parameters.key, "k.pem");
}

TEST(WebParameters, SayWhatCantBeUsed) {
  for (const auto& [name, text] : {std::pair{"origin", "app.example"},
                                   {"writing_origin", "https://a.example/page"},
                                   {"framing_origin", "*"},
                                   {"framing_origin", "http://a.example;script-src"},
                                   {"key", "k.pem"},
                                   {"certificate", "c.pem"}}) {
    EXPECT_THROW(read({element(name, text)}), Error) << name;
  }
}

TEST(WebParameters, KeepTheServerOnThisMachineWithoutANetwork) {
  const ServerSettings settings = serverSettings({}, "", "");
  EXPECT_EQ(settings.addresses, std::vector<std::string>{"127.0.0.1"});
  EXPECT_FALSE(settings.access.isOpen);
  EXPECT_EQ(settings.access.token, "");
  EXPECT_EQ(pageAddress(settings, 9002), "http://127.0.0.1:9002/");
  EXPECT_FALSE(serverSettings({}, "127.0.0.1", "").access.isOpen);
}

TEST(WebParameters, AskForATokenInANetwork) {
  EXPECT_THROW(serverSettings({}, "nowhere0", ""), std::runtime_error);
  for (const NetworkInterface& each : networkInterfaces()) {
    if (each.address == "127.0.0.1") continue;
    const ServerSettings settings = serverSettings({}, each.name, "");
    EXPECT_TRUE(settings.access.isOpen);
    EXPECT_EQ(settings.access.token.size(), 32U);
    EXPECT_EQ(settings.addresses.size(), 2U);
    EXPECT_TRUE(pageAddress(settings, 1).ends_with(":1/?token=" + settings.access.token));
    EXPECT_EQ(serverSettings({}, each.address, "mine").access.token, "mine");
    return;
  }
  GTEST_SKIP() << "this machine has no network";
}

}  // namespace
}  // namespace pongsim::web
