#include "web/frames/frame.hh"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace pongsim::web {
namespace {

template <class Number>
Number at(const Payload& payload, std::size_t place) {
  Number number{};
  std::memcpy(&number, payload.bytes().data() + place, sizeof number);
  return number;
}

const std::vector<FramePose> kTwo{{7, {1, 2, 3, 0, 0, 0, 1}}, {8, {4, 5, 6, 0, 1, 0, 0}}};

TEST(Frame, HasWhatItsHeadSays) {
  std::vector<FramePose> before;
  const Payload frame = encodeFrame({5'000'000'000, 5000, 0.5, true, 3}, kTwo, before);
  ASSERT_EQ(frame.size(), 48U + 2 * 32);
  EXPECT_EQ(at<std::uint32_t>(frame, 0), 0x31465750U);
  EXPECT_EQ(at<std::uint32_t>(frame, 4), 1U);
  EXPECT_EQ(at<std::uint64_t>(frame, 8), 5'000'000'000U);
  EXPECT_EQ(at<std::uint64_t>(frame, 16), 5000U);
  EXPECT_EQ(at<double>(frame, 24), 0.5);
  EXPECT_EQ(at<std::uint32_t>(frame, 32), 1U);
  EXPECT_EQ(at<std::uint32_t>(frame, 40), 3U);
  EXPECT_EQ(at<std::uint32_t>(frame, 44), 2U);
  EXPECT_EQ(at<std::uint32_t>(frame, 80), 8U);
  EXPECT_EQ(at<float>(frame, 84), 4.F);
  EXPECT_EQ(at<float>(frame, 100), 1.F);
}

TEST(Frame, HasOnlyWhatHasMoved) {
  std::vector<FramePose> before;
  encodeFrame({}, kTwo, before);
  std::vector<FramePose> now = kTwo;
  now[1].pose[2] = 7;
  const Payload moved = encodeFrame({}, now, before);
  EXPECT_EQ(at<std::uint32_t>(moved, 4), 0U);
  EXPECT_EQ(at<std::uint32_t>(moved, 44), 1U);
  EXPECT_EQ(at<std::uint32_t>(moved, 48), 8U);
  EXPECT_EQ(encodeFrame({}, now, before).size(), 48U);
  before.clear();
  EXPECT_EQ(at<std::uint32_t>(encodeFrame({}, now, before), 44), 2U);
}

}  // namespace
}  // namespace pongsim::web
