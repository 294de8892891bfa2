#include "fuel/http.hh"

#include <gtest/gtest.h>

#include "fuel/failure.hh"

namespace pongsim::fuel {
namespace {

// Requests themselves are tested by test/test_download.py and test/test_faults.py.

TEST(Http, KnowsWhoseAnAddressIs) {
  EXPECT_EQ(originOf("https://Fuel.Gazebosim.org/1.0/x?y#z"), "https://fuel.gazebosim.org");
  EXPECT_EQ(originOf("http://h:8000"), "http://h:8000");
  EXPECT_EQ(originOf("https://h?x=/"), "https://h");
  // everything before "@" is user information (RFC 3986, 3.2.1), so the server is "evil"
  EXPECT_NE(originOf("https://fuel.gazebosim.org@evil/x"), "https://fuel.gazebosim.org");
  EXPECT_EQ(originOf("nothing"), "nothing");
}

TEST(Http, ReadsHeaders) {
  Answer answer;
  EXPECT_EQ(answer.length(), 0U);
  answer.headers = {{"content-length", "5000000000"}, {"etag", "x"}};
  EXPECT_EQ(answer.length(), 5'000'000'000U);
  EXPECT_EQ(answer.header("etag"), "x");
  EXPECT_EQ(answer.header("range"), "");
}

TEST(Http, TellsWhatPasses) {
  Answer answer;
  answer.url = "https://h/x";
  for (const int status : {500, 503, 429}) {
    answer.status = status;
    EXPECT_THROW(refuse(answer), PassingFailure) << status;
  }
  for (const int status : {400, 401, 403, 404, 410, 416}) {
    answer.status = status;
    try {
      refuse(answer);
    } catch (const PassingFailure&) {
      ADD_FAILURE() << status;
    } catch (const Failure& failure) {
      EXPECT_NE(std::string(failure.what()).find("(status " + std::to_string(status) + ")"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace pongsim::fuel
