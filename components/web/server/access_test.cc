#include "web/server/access.hh"

#include <gtest/gtest.h>

#include <string>

namespace pongsim::web {
namespace {

using Kind = Permission::Kind;

constexpr const char* kHost = "127.0.0.1:9002";

Kind kindOf(const AccessRules& rules, const Visit& visit) { return judgeClient(rules, visit).kind; }

TEST(Access, LetsItsOwnPageAndProgramsWrite) {
  EXPECT_EQ(kindOf({}, {kHost, "http://127.0.0.1:9002", ""}), Kind::kWrite);
  EXPECT_EQ(kindOf({}, {"localhost:9002", "http://localhost:9002", ""}), Kind::kWrite);
  EXPECT_EQ(kindOf({}, {"[::1]:9002", "https://[::1]:9002", ""}), Kind::kWrite);
  EXPECT_EQ(kindOf({}, {kHost, "", ""}), Kind::kWrite);
}

TEST(Access, RefusesForeignPages) {
  for (const char* origin : {"https://evil.example", "http://127.0.0.1:9003", "http://localhost:9002", "null",
                             "http://127.0.0.1:9002.evil.example", "file://"}) {
    const Permission permission = judgeClient({}, {kHost, origin, ""});
    EXPECT_EQ(permission.kind, Kind::kRefused) << origin;
    EXPECT_EQ(permission.status, 403);
    EXPECT_NE(permission.why.find(origin), std::string::npos) << permission.why;
  }
}

TEST(Access, AdvisesOnlyWhatTheOptionAccepts) {
  const auto whyNot = [](const char* origin) { return judgeClient({}, {kHost, origin, ""}).why; };
  EXPECT_NE(whyNot("https://evil.example").find("--web-origin https://evil.example"), std::string::npos);
  EXPECT_NE(whyNot("file://").find("--web-origin file://"), std::string::npos);
  for (const char* origin : {"null", "https://evil.example/path"})
    EXPECT_EQ(whyNot(origin).find("--web-origin"), std::string::npos) << whyNot(origin);
}

TEST(Access, RefusesNamesThatAreNotThisMachines) {
  AccessRules rules{.hostNames = {"robot"}};
  for (const char* host : {"evil.example:9002", "robot:9002", "192.0.2.7", "", "127.0.0.1.evil.example"}) {
    EXPECT_EQ(judgeClient(rules, {host, "http://" + std::string(host), ""}).status, 421) << host;
    EXPECT_EQ(judgePage(rules, {host, "", ""}).kind, Kind::kRefused) << host;
  }
  rules.isOpen = true;
  for (const char* host : {"192.0.2.7:9002", "ROBOT:9002", "[2001:db8::1]:9002", "robot"})
    EXPECT_EQ(judgePage(rules, {host, "", ""}).kind, Kind::kRead) << host;
  for (const char* host : {"evil.example:9002", "robots", "192.0.2.7.evil.example", "[evil]"})
    EXPECT_EQ(judgePage(rules, {host, "", ""}).kind, Kind::kRefused) << host;
}

TEST(Access, LetsNamedPagesLookAndThoseThatAreNamedSoWrite) {
  const AccessRules rules{.readingOrigins = {"https://app.gazebosim.org"}, .writingOrigins = {"https://mine.example"}};
  EXPECT_EQ(kindOf(rules, {kHost, "https://app.gazebosim.org", ""}), Kind::kRead);
  EXPECT_EQ(kindOf(rules, {kHost, "https://mine.example", ""}), Kind::kWrite);
  EXPECT_EQ(kindOf(rules, {kHost, "http://mine.example", ""}), Kind::kRefused);
}

TEST(Access, LetsNobodyWriteWhereItIsReadOnly) {
  const AccessRules rules{.isReadOnly = true, .writingOrigins = {"https://mine.example"}};
  EXPECT_EQ(kindOf(rules, {kHost, "", ""}), Kind::kRead);
  EXPECT_EQ(kindOf(rules, {kHost, "https://mine.example", ""}), Kind::kRead);
}

TEST(Access, AsksForTheToken) {
  const AccessRules rules{.token = "secret"};
  EXPECT_EQ(judgeClient(rules, {kHost, "", ""}).status, 401);
  EXPECT_EQ(judgeClient(rules, {kHost, "", "Secret"}).status, 401);
  EXPECT_EQ(kindOf(rules, {kHost, "", "secret"}), Kind::kWrite);
  // the token does not make a foreign page acceptable
  EXPECT_EQ(judgeClient(rules, {kHost, "https://evil.example", "secret"}).status, 403);
  EXPECT_EQ(judgePage(rules, {kHost, "", ""}).kind, Kind::kRead);
}

TEST(Access, TellsSecretsApart) {
  EXPECT_TRUE(isSameSecret("abc", "abc"));
  for (const char* other : {"", "a", "abd", "abcabc", "abcd"}) EXPECT_FALSE(isSameSecret(other, "abc")) << other;
}

TEST(Access, MakesAnotherTokenEachTime) {
  const std::string token = randomToken();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, randomToken());
}

TEST(Access, SaysWhatIsNoOrigin) {
  for (const char* right : {"https://app.gazebosim.org", "http://localhost:8080", "file://"})
    EXPECT_EQ(originError(right), "") << right;
  for (const char* wrong : {"", "*", "app.gazebosim.org", "https://a.org/", "https://a.org/x", "https://", "://a",
                            "https://*.a.org", "https://A.org", "https://me@a.org"})
    EXPECT_NE(originError(wrong), "") << wrong;
}

}  // namespace
}  // namespace pongsim::web
