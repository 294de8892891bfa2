#include "log/mcap/record_archive.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"

namespace pongsim::log::mcap {
namespace {

using namespace std::string_literals;

/// All fields of a record in their order, as text, to compare records without `==`.
class Told {
 public:
  void operator()(const auto&... fields) { (tell(fields), ...); }
  void rest(std::string_view bytes) { text_ += std::string(bytes) + ";"; }
  void block(std::string_view bytes) { rest(bytes); }
  const std::string& text() const { return text_; }

 private:
  template <std::unsigned_integral Number>
  void tell(Number number) {
    text_ += std::to_string(number) + ";";
  }
  void tell(Opcode opcode) { tell(static_cast<unsigned>(opcode)); }
  void tell(const std::string& text) { rest(text); }
  template <class Key, class Value>
  void tell(const std::map<Key, Value>& map) {
    for (const auto& [key, value] : map) (*this)(key, value);
  }
  template <class First, class Second>
  void tell(const std::vector<std::pair<First, Second>>& list) {
    for (const auto& [first, second] : list) (*this)(first, second);
  }
  std::string text_;
};

template <class Record>
std::string textOf(const Record& record) {
  Told told;
  Record::visit(record, told);
  return told.text();
}

/// Calls `use` with a record of each type, with no field empty.
void forSomeRecords(const auto& use) {
  use(Header{"ros2", "a library"});
  use(Footer{100, 200, 0xdeadbeef});
  use(Schema{1, "some.A", "protobuf", "description\0of it"s});
  use(Channel{2, 1, "/a", "cdr", {{"b", "2"}, {"a", ""}}});
  use(Message{2, 3, 4, 5, "payload"});
  use(Chunk{1, 2, 300, 0xabcdef, "zstd", "packed"});
  use(MessageIndex{2, {{7, 0}, {6, 40}, {7, 80}}});
  use(ChunkIndex{1, 2, 3, 4, {{1, 10}, {2, 20}}, 5, "lz4", 6, 7});
  use(Statistics{1000, 2, 3, 4, 5, 6, 7, 8, {{1, 999}, {2, 1}}});
  use(SummaryOffset{Opcode::kChunkIndex, 1, 2});
  use(DataEnd{0x12345678});
}

TEST(RecordArchive, HasTheBytesOfTheFormat) {
  std::string bytes = "before";
  appendRecord(Channel{2, 1, "/a", "cdr", {{"k", "vw"}}}, bytes);
  EXPECT_EQ(bytes,
            "before\x04\x20\0\0\0\0\0\0\0"
            "\x02\0\x01\0"
            "\x02\0\0\0/a\x03\0\0\0cdr"
            "\x0b\0\0\0\x01\0\0\0k\x02\0\0\0vw"s);
  bytes.clear();
  appendRecord(Chunk{1, 2, 3, 4, "", "xy"}, bytes);
  EXPECT_EQ(bytes,
            "\x06\x2a\0\0\0\0\0\0\0"
            "\x01\0\0\0\0\0\0\0\x02\0\0\0\0\0\0\0\x03\0\0\0\0\0\0\0\x04\0\0\0"
            "\0\0\0\0\x02\0\0\0\0\0\0\0xy"s);
}

TEST(RecordArchive, ReadsWhatItWrote) {
  forSomeRecords([]<class Record>(const Record& record) {
    std::string bytes;
    appendRecord(record, bytes);
    EXPECT_EQ(static_cast<Opcode>(bytes[0]), Record::kOpcode);
    ByteReader reader(std::string_view(bytes).substr(kRecordHead), 0, "record");
    EXPECT_EQ(textOf(readRecord<Record>(reader)), textOf(record));
    EXPECT_TRUE(reader.isAtEnd());
  });
}

TEST(RecordArchive, RefusesARecordThatIsCutOffAnywhere) {
  forSomeRecords([]<class Record>(const Record& record) {
    std::string bytes;
    appendRecord(record, bytes);
    const std::string_view content = std::string_view(bytes).substr(kRecordHead);
    // a message's data is the rest of the record
    const std::size_t least = std::is_same_v<Record, Message> ? 2 + 4 + 8 + 8 : content.size();
    for (std::size_t size = 0; size < least; ++size) {
      ByteReader reader(content.substr(0, size), 0, "record");
      EXPECT_THROW(readRecord<Record>(reader), Failure) << static_cast<int>(Record::kOpcode) << " of " << size;
    }
  });
}

TEST(RecordArchive, PassesOverWhatALaterVersionAdds) {
  std::string bytes;
  appendRecord(Header{"", "a"}, bytes);
  bytes += "more";
  ByteReader reader(std::string_view(bytes).substr(kRecordHead), 0, "header");
  EXPECT_EQ(readRecord<Header>(reader).library, "a");
}

TEST(RecordArchive, SaysWhereAListLies) {
  std::string bytes;
  appendRecord(Statistics{1, 2, 3, 4, 5, 6, 7, 8, {{1, 9}}}, bytes);
  // the list claims one byte less than its pair needs
  const std::size_t length = bytes.size() - 10 - 4;
  bytes[length] = 9;
  ByteReader reader(std::string_view(bytes).substr(kRecordHead), kRecordHead, "statistics");
  try {
    readRecord<Statistics>(reader);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.what(),
              "byte " + std::to_string(length + 6) + ": the statistics should have 8 more bytes, but has 7");
  }
}

}  // namespace
}  // namespace pongsim::log::mcap
