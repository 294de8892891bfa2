#include "trust/permissions.hh"

#include <gtest/gtest.h>

#include <functional>

namespace pongsim::trust {
namespace {

std::string domains(const std::string& which = "<id_range><min>0</min><max>232</max></id_range>") {
  return "<domains>" + which + "</domains>";
}

std::string topics(const std::string& use, const std::string& pattern) {
  return "<" + use + "><topics><topic>" + pattern + "</topic></topics></" + use + ">";
}

std::string grant(const std::string& rules, const std::string& subject = "CN=/robot") {
  return "<grant name='robot'><subject_name>" + subject +
         "</subject_name><validity><not_before>2020-01-01T00:00:00</not_before>"
         "<not_after>2200-01-01T00:00:00</not_after></validity>" +
         rules + "<default>DENY</default></grant>";
}

std::string document(const std::string& grants) { return "<dds><permissions>" + grants + "</permissions></dds>"; }

std::string allow(const std::string& what) { return "<allow_rule>" + domains() + what + "</allow_rule>"; }
std::string deny(const std::string& what) { return "<deny_rule>" + domains() + what + "</deny_rule>"; }

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const KeystoreError& error) {
    return error.what();
  }
  return "";
}

std::string refusalOf(const std::string& text) {
  return refusal([&text] { readPermissions("p.xml", text); });
}

SecureIdentity identityWith(const std::string& rules) {
  SecureIdentity identity;
  identity.rules = readPermissions("p.xml", document(grant(rules))).front().rules;
  return identity;
}

TEST(Permissions, LetTheFirstRuleDecideThatKnowsATopic) {
  const SecureIdentity identity =
      identityWith(deny(topics("publish", "/secret/*")) + allow(topics("publish", "*") + topics("subscribe", "/a?")));
  EXPECT_TRUE(isPermitted(identity, 0, TopicUse::kPublish, "/any/topic"));
  EXPECT_FALSE(isPermitted(identity, 0, TopicUse::kPublish, "/secret/a/b"));
  EXPECT_TRUE(isPermitted(identity, 0, TopicUse::kSubscribe, "/ab"));
  EXPECT_FALSE(isPermitted(identity, 0, TopicUse::kSubscribe, "/abc"));
}

TEST(Permissions, CountInTheirDomainsOnly) {
  const SecureIdentity identity = identityWith("<allow_rule>" + domains("<id>3</id><id_range><min>7</min></id_range>") +
                                               topics("publish", "*") + "</allow_rule>");
  for (const int domain : {3, 7, 232}) EXPECT_TRUE(isPermitted(identity, domain, TopicUse::kPublish, "/a")) << domain;
  for (const int domain : {0, 4, 6}) EXPECT_FALSE(isPermitted(identity, domain, TopicUse::kPublish, "/a")) << domain;
}

TEST(Permissions, AreRefusedWhereTheyContradictThemselves) {
  EXPECT_EQ(refusalOf(document(grant(allow(topics("publish", "*")) + deny(topics("publish", "/a"))))),
            "p.xml:1: contradiction: topic '/a' is denied after '*' has been allowed, and the first rule counts");
  EXPECT_EQ(refusalOf(document(grant(deny(topics("subscribe", "/a")) + allow(topics("subscribe", "/a"))))),
            "p.xml:1: contradiction: topic '/a' is allowed after '/a' has been denied, and the first rule counts");
  EXPECT_EQ(refusalOf(document(grant(deny(topics("publish", "/a")) + allow(topics("subscribe", "/a"))))), "");
  EXPECT_EQ(refusalOf(document(grant(deny(topics("publish", "/a")) + allow(topics("publish", "*"))))), "");
  for (const char* narrow : {"/a?", "/a[!b]"}) {
    const std::string rules = deny(topics("publish", narrow)) + allow(topics("publish", "/a*"));
    EXPECT_EQ(refusalOf(document(grant(rules))), "") << narrow;
  }
  EXPECT_EQ(refusalOf(document("<grant name='r'><subject_name>CN=r</subject_name><validity>"
                               "<not_before>2030-01-01T00:00:00</not_before><not_after>2020-01-01T00:00:00</not_after>"
                               "</validity></grant>")),
            "p.xml:1: <validity> ends before it begins");
}

TEST(Permissions, AreRefusedWhereTheyCanNotBeRead) {
  EXPECT_EQ(refusalOf("<dds><permissions>"), "p.xml:1: the XML is malformed");
  EXPECT_EQ(refusalOf("<permissions/>"), "p.xml: its outermost element is not <dds>");
  EXPECT_EQ(refusalOf("<dds/>"), "p.xml:1: <dds> has no <permissions>");
  EXPECT_EQ(refusalOf(document("")), "p.xml:1: <permissions> has no <grant>");
  EXPECT_EQ(refusalOf(document("<grant/>")), "p.xml:1: <grant> has no name");
  EXPECT_EQ(refusalOf(document("<grant name='a'/>")), "p.xml:1: <grant> does not begin with <subject_name>");
  EXPECT_EQ(refusalOf(document(grant(""))),
            "p.xml:1: <grant> has neither <allow_rule> nor <deny_rule> after <validity>");
  EXPECT_EQ(refusalOf(document(grant("<allow_rule/>"))), "p.xml:1: <allow_rule> does not begin with <domains>");
  EXPECT_EQ(refusalOf(document(grant("<allow_rule><domains/></allow_rule>"))), "p.xml:1: <domains> is empty");
  EXPECT_EQ(refusalOf(document(grant("<allow_rule>" + domains("<id>x</id>") + "</allow_rule>"))),
            "p.xml:1: 'x' is not a DDS domain");
  EXPECT_EQ(refusalOf(document(grant(allow("<listen/>")))),
            "p.xml:1: <listen> is not <publish>, <subscribe> or <relay>");
  EXPECT_EQ(refusalOf(document(grant(allow("<publish><topics/></publish>")))), "p.xml:1: <topics> has no <topic>");
  EXPECT_EQ(refusalOf(document(grant(allow(topics("publish", " "))))), "p.xml:1: <topic> is empty");
}

TEST(Permissions, AreOfOneSubject) {
  const auto one = readPermissions("p.xml", document(grant(allow(topics("publish", "*")), "CN=a, O=b")));
  EXPECT_EQ(grantOf("p.xml", one, "CN=a,O=b").subject, "CN=a, O=b");
  EXPECT_EQ(refusal([&] { grantOf("p.xml", one, "CN=b"); }), "p.xml grants nothing to CN=b, but to CN=a, O=b");
  const std::string same = grant(allow(topics("publish", "*")));
  const auto two = readPermissions("p.xml", document(same + same));
  EXPECT_EQ(refusal([&] { grantOf("p.xml", two, "CN=/robot"); }),
            "p.xml has several grants for CN=/robot, of which only one would apply");
}

TEST(Permissions, AreRefusedBeforeTheyBeginAndWhereTheyAllowNothing) {
  Grant later;
  later.validFrom = std::time(nullptr) + 100'000;
  later.validUntil = later.validFrom + 1;
  EXPECT_TRUE(refusal([&] { requireUsable("p.xml", later, -1); }).starts_with("p.xml is not valid before 20"));
  Grant empty;
  empty.validUntil = std::time(nullptr) + 1000;
  EXPECT_EQ(refusal([&] { requireUsable("p.xml", empty, -1); }), "p.xml allows nothing");
}

}  // namespace
}  // namespace pongsim::trust
