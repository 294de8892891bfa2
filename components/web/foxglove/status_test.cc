#include "web/foxglove/status.hh"

#include <gtest/gtest.h>

#include "support/web/recorded_client.hh"

namespace pongsim::web::foxglove {
namespace {

TEST(Status, IsWhatTheProtocolSaysWhateverTheText) {
  RecordedClient client;
  sendStatus(client, StatusLevel::kError, "a \"b\" \xff");
  EXPECT_EQ(client.takeTexts(), std::vector<std::string>{R"({"level":2,"message":"a \"b\" )"
                                                         "\xef\xbf\xbd"
                                                         R"(","op":"status"})"});
}

}  // namespace
}  // namespace pongsim::web::foxglove
