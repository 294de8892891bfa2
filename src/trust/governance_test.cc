#include "trust/governance.hh"

#include <gtest/gtest.h>

#include "pongsim/program/keystore.hh"

namespace pongsim::trust {
namespace {

// The file that sros2 writes by default, for domain 0.
constexpr const char* kSros2 = R"(<?xml version="1.0" encoding="UTF-8"?>
<dds>
  <domain_access_rules>
    <domain_rule>
      <domains>
        <id>0</id>
      </domains>
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>SIGN</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <metadata_protection_kind>SIGN</metadata_protection_kind>
          <data_protection_kind>ENCRYPT</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
)";

std::string refusalFor(const std::string& text, int domain = 0) {
  try {
    requireDomain("g.p7s", readGovernance("g.p7s", text), domain);
  } catch (const KeystoreError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Governance, IsOfTheDomainsThatItNames) {
  EXPECT_EQ(refusalFor(kSros2), "");
  EXPECT_EQ(refusalFor(kSros2, 1), "g.p7s has no rule for DDS domain 1");
  EXPECT_EQ(refusalFor(replaced(kSros2, "<id>0</id>", "<id_range><max>5</max></id_range>"), 5), "");
}

TEST(Governance, IsRefusedWhereItCanNotBeRead) {
  EXPECT_EQ(refusalFor("<dds>"), "g.p7s:1: the XML is malformed");
  EXPECT_EQ(refusalFor("<dds/>"), "g.p7s:1: <dds> has no <domain_access_rules>");
  EXPECT_EQ(refusalFor(replaced(kSros2, "SIGN", "HIDE")),
            "g.p7s:12: 'HIDE' is not a kind of protection: use NONE, SIGN or ENCRYPT");
  EXPECT_EQ(refusalFor(replaced(kSros2, "<topic_expression>*</topic_expression>", "")),
            "g.p7s:14: <topic_rule> has no <topic_expression>");
}

}  // namespace
}  // namespace pongsim::trust
