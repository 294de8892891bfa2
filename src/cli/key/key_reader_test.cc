#include "cli/key/key_reader.hh"

#include <gtest/gtest.h>

namespace pongsim::cli {
namespace {

std::vector<std::int32_t> codes(std::string_view bytes) {
  KeyReader reader;
  std::vector<std::int32_t> all;
  for (const Key& key : reader.read(bytes)) all.push_back(key.code);
  for (const Key& key : reader.endSequence()) all.push_back(key.code);
  return all;
}

using Codes = std::vector<std::int32_t>;

TEST(KeyReader, KnowsTheArrowsInEachOfTheirForms) {
  const Codes arrows{16777234, 16777235, 16777236, 16777237};
  EXPECT_EQ(codes("\x1b[D\x1b[A\x1b[C\x1b[B"), arrows);
  EXPECT_EQ(codes("\x1bOD\x1bOA\x1bOC\x1bOB"), arrows);
  EXPECT_EQ(codes("\x1b[1;5D\x1b[1;2A\x1b[1;5C\x1b[1;2B"), arrows);
}

TEST(KeyReader, GivesLettersInUpperCaseAndWhatElseIsAscii) {
  EXPECT_EQ(codes("wW09 ."), (Codes{87, 87, 48, 57, 32, 46}));
}

TEST(KeyReader, KnowsTheKeysWithoutALetter) {
  EXPECT_EQ(codes("\r\n\t\x7f\b\x1b"), (Codes{16777220, 16777220, 16777217, 16777219, 16777219, 16777216}));
}

TEST(KeyReader, TakesAnArrowThatComesInPieces) {
  KeyReader reader;
  EXPECT_TRUE(reader.read("\x1b").empty());
  EXPECT_TRUE(reader.isWaiting());
  EXPECT_TRUE(reader.read("[").empty());
  EXPECT_EQ(reader.read("A"), (std::vector<Key>{{16777235, "up"}}));
  EXPECT_FALSE(reader.isWaiting());
}

TEST(KeyReader, TellsEscapeFromASequence) {
  EXPECT_EQ(codes("\x1b\x1b[A"), (Codes{16777216, 16777235}));
  EXPECT_EQ(codes("\x1bw"), (Codes{16777216, 87}));
  KeyReader reader;
  reader.read("\x1b");
  EXPECT_EQ(reader.endSequence(), (std::vector<Key>{{16777216, "escape"}}));
  reader.read("\x1b[");
  EXPECT_TRUE(reader.endSequence().empty());
}

TEST(KeyReader, LeavesOutWhatIsNoKnownKey) {
  EXPECT_EQ(codes("\x1b[3~\x01\xc3\xa4\x1b[15~a"), (Codes{65}));
  EXPECT_EQ(codes("\x1b[" + std::string(100, '1') + "a").back(), 65);
}

}  // namespace
}  // namespace pongsim::cli
