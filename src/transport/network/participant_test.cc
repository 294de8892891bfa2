#include "transport/network/participant.hh"

#include <gtest/gtest.h>

namespace pongsim::transport {

TEST(ParticipantName, IsReadAsItWasWritten) {
  const ParticipantName first{4711, std::nullopt};
  const ParticipantName another{4711, ParticipantId{1, 15, 0xab, 0, 0xff, 0, 0, 0, 9, 0, 0, 1}};
  EXPECT_EQ(textOf(first), "pongsim/4711");
  EXPECT_EQ(textOf(another), "pongsim/4711/010fab00ff00000009000001");
  EXPECT_EQ(readParticipantName(textOf(first)), first);
  EXPECT_EQ(readParticipantName(textOf(another)), another);
}

TEST(ParticipantName, IsNoneForOtherPrograms) {
  for (const char* text : {"", "/", "RTPSParticipant", "pongsim", "pongsim/", "pongsim/x", "pongsim/1/", "pongsim/1/01",
                           "pongsim/1/010fab00ff0000000900000g", "pongsim/1/010fab00ff000000090000011"}) {
    EXPECT_EQ(readParticipantName(text), ParticipantName()) << text;
  }
}

}  // namespace pongsim::transport
