#include "sim/inputs/recording.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "sim/inputs/recording_writer.hh"
#include "support/file_size_limit.hh"
#include "support/temp_folder.hh"

namespace pongsim::sim {
namespace {

class RecordingTest : public testing::Test {
 protected:
  RecordingTest() {
    Element plugin;
    plugin.name = "plugin";
    plugin.attributes.push_back({"filename", "some-system", {}});
    plugin.children.push_back({});
    plugin.children.back().name = "port";
    plugin.children.back().text = "9002";
    start_.version = "1";
    start_.file = "/a/world.sdf";
    start_.sdf = "<sdf/>";
    start_.files = {{"/a/mesh.stl", 7}};
    start_.worlds = {"w", "v"};
    start_.systems = {plugin};
    start_.seed = 5;
    start_.paused = true;
    passage_.world = 1;
    passage_.runs = {{Passage::Kind::kStep, 3}, {Passage::Kind::kIntake, 1}, {Passage::Kind::kPausedStep, 2}};
    passage_.intakes = {{{{4, {"/t", "ignition.msgs.Int32", 2}, {std::byte{1}, std::byte{0}}}},
                         {{{"/t", "ignition.msgs.Int32", 2}, 9}},
                         {{5, "/s", {std::byte{3}}}}}};
    passage_.folders = {"/models"};
    passage_.changes.push_back({.kind = OutsideChange::Kind::kInsertText,
                                .system = "ros2#3",
                                .source = {false, "<sdf/>", "resource_string"},
                                .options = {.name = "box", .pose = Pose()}});
    passage_.hashes = {1, 2, 3};
  }

  /// Writes a recording with one passage.
  void write() {
    RecordingWriter writer(file_, start_);
    writer.write(frameWith(FrameKind::kPassage, passage_));
    writer.write(frameWith(FrameKind::kUnrecordedChange, UnrecordedChange{1, 77}));
    writer.write(frameWith(FrameKind::kWorldEnd, WorldEnd{1, 99}));
    EXPECT_TRUE(writer.finish());
  }
  std::string content() const {
    std::ifstream stream(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void replace(const std::string& content) const { std::ofstream(file_, std::ios::binary) << content; }

  const test::TempFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "run.inputs";
  RunStart start_;
  Passage passage_;
};

TEST_F(RecordingTest, ReadsWhatWasWritten) {
  write();
  EXPECT_TRUE(isRecording(file_));
  Outcome<Recording> read = readRecording(file_);
  ASSERT_TRUE(read) << read.error;
  EXPECT_EQ(read->cut, "");
  EXPECT_EQ(read->start.file, start_.file);
  EXPECT_EQ(read->start.sdf, start_.sdf);
  EXPECT_EQ(read->start.files, start_.files);
  EXPECT_EQ(read->start.systems, start_.systems);
  EXPECT_EQ(read->start.seed, 5U);
  EXPECT_TRUE(read->start.paused);
  ASSERT_EQ(read->tapes.size(), 2U);
  EXPECT_TRUE(read->tapes[0].passages.empty());
  EXPECT_EQ(read->tapes[1].endHash, 99U);
  EXPECT_EQ(read->tapes[1].unrecordedAfter, 77U);
  ASSERT_EQ(read->tapes[1].passages.size(), 1U);
  const Passage& passage = read->tapes[1].passages.front();
  ASSERT_EQ(passage.runs.size(), 3U);
  EXPECT_EQ(passage.runs[2].kind, Passage::Kind::kPausedStep);
  EXPECT_EQ(passage.runs[2].count, 2U);
  ASSERT_EQ(passage.intakes.size(), 1U);
  EXPECT_EQ(passage.intakes[0].messages[0].place, passage_.intakes[0].messages[0].place);
  EXPECT_EQ(passage.intakes[0].messages[0].bytes, passage_.intakes[0].messages[0].bytes);
  EXPECT_EQ(passage.intakes[0].left[0].count, 9U);
  EXPECT_EQ(passage.intakes[0].requests[0].service, "/s");
  EXPECT_EQ(passage.folders, passage_.folders);
  EXPECT_EQ(passage.hashes, passage_.hashes);
  ASSERT_EQ(passage.changes.size(), 1U);
  EXPECT_EQ(passage.changes[0].kind, OutsideChange::Kind::kInsertText);
  EXPECT_EQ(passage.changes[0].system, "ros2#3");
  EXPECT_EQ(passage.changes[0].source.text, "<sdf/>");
  EXPECT_EQ(passage.changes[0].options.name, "box");
  EXPECT_TRUE(passage.changes[0].options.pose.has_value());
}

TEST_F(RecordingTest, IsReadUpToWhereItIsCutOffOrDamaged) {
  write();
  const std::string whole = content();
  std::size_t sound = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    replace(whole.substr(0, size));
    Outcome<Recording> read = readRecording(file_);
    if (!read) continue;
    ++sound;
    EXPECT_NE(read->cut, "") << size;
    EXPECT_LE(read->tapes[1].passages.size(), 1U);
  }
  EXPECT_GT(sound, 0U);
  for (std::size_t place = kRecordingMark.size(); place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x10);
    replace(damaged);
    Outcome<Recording> read = readRecording(file_);
    EXPECT_TRUE(!read || !read->cut.empty()) << place;
  }
}

TEST_F(RecordingTest, RefusesOtherFiles) {
  replace("<sdf/>");
  EXPECT_FALSE(isRecording(file_));
  EXPECT_EQ(readRecording(file_).error, "is not a recording of inputs by this version");
  EXPECT_FALSE(isRecording(folder_.path() / "none"));
  EXPECT_FALSE(readRecording(folder_.path() / "none"));
  replace(std::string(kRecordingMark));
  EXPECT_EQ(readRecording(file_).error, "is cut off before the run begins");
}

TEST_F(RecordingTest, RefusesFramesThatPromiseMoreThanTheyHave) {
  RecordingWriter writer(file_, start_);
  StateArchive archive;
  std::uint32_t world = 0;
  std::uint64_t many = std::uint64_t{1} << 60;
  archive(world);
  archive(many);
  writer.write(frameOf(FrameKind::kPassage, archive.take()));
  EXPECT_TRUE(writer.finish());
  EXPECT_NE(readRecording(file_).error.find("is not a sound recording of inputs"), std::string::npos);
  write();
  passage_.world = 2;
  RecordingWriter other(file_, start_);
  other.write(frameWith(FrameKind::kPassage, passage_));
  EXPECT_NE(readRecording(file_).error.find("it has more worlds than it says"), std::string::npos);
}

TEST_F(RecordingTest, SaysThatTheDiskIsFull) {
  RecordingWriter writer(file_, start_);
  EXPECT_FALSE(writer.hasFailed());
  const test::FileSizeLimit limit(300);
  for (int i = 0; i < 10; ++i) writer.write(frameWith(FrameKind::kPassage, passage_));
  EXPECT_TRUE(writer.hasFailed());
  EXPECT_EQ(writer.finish().error, "can't record inputs in '" + file_.string() + "': File too large");
}

TEST_F(RecordingTest, CannotBeWrittenWhereThereIsNoFolder) {
  EXPECT_THROW(RecordingWriter(folder_.path() / "none" / "run.inputs", start_), std::runtime_error);
}

}  // namespace
}  // namespace pongsim::sim
