#include "sound.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace pongsim::sound_test {
namespace {

using std::chrono::milliseconds;

Element element(const std::string& name, const std::string& text, std::vector<Element> children = {}) {
  Element made;
  made.name = name;
  made.text = text;
  made.children = std::move(children);
  return made;
}

Element sourceWith(const std::string& changed = "", const std::string& text = "") {
  Element source =
      element("source", "",
              {element("id", "7"), element("pose", "1 2 3 0 0 0"), element("attenuation_function", "Linear"),
               element("attenuation_shape", "sphere"), element("inner_radius", "3"), element("falloff_distance", "8"),
               element("volume_level", ".9"), element("playing", "true"), element("play_duration", "2")});
  for (Element& child : source.children) {
    if (child.name == changed) child.text = text;
  }
  return source;
}

/// @return What is said of a source, and what is made of it.
std::vector<std::string> saidOf(const Element& said, SoundSource& source) {
  Diagnostics diagnostics;
  std::vector<std::string> messages;
  try {
    source = readSource(said, diagnostics);
  } catch (const Error& error) {
    messages.push_back("refused: " + error.diagnostic().message);
  }
  for (const Diagnostic& each : diagnostics.all()) messages.push_back(each.message);
  return messages;
}

TEST(Sound, IsReadFromTheFile) {
  SoundSource source;
  EXPECT_TRUE(saidOf(sourceWith(), source).empty());
  EXPECT_EQ(source.id, 7);
  EXPECT_EQ(source.X_ParentSource.position, Vector3(1, 2, 3));
  EXPECT_EQ(source.innerRadius, 3);
  EXPECT_EQ(source.falloffDistance, 8);
  EXPECT_EQ(source.volume, 0.9);
  EXPECT_TRUE(source.plays);
  EXPECT_EQ(source.duration, std::chrono::seconds(2));
}

TEST(Sound, IsMovedToWhatItCanBe) {
  using Words = std::vector<std::string>;
  SoundSource source;
  EXPECT_EQ(saidOf(sourceWith("inner_radius", "-2"), source), Words{"<inner_radius> is -2: 0 is used"});
  EXPECT_EQ(saidOf(sourceWith("falloff_distance", "3"), source), Words{"<falloff_distance> is 3: 4 is used"});
  EXPECT_EQ(source.falloffDistance, 4);
  EXPECT_EQ(saidOf(sourceWith("volume_level", "1.5"), source), Words{"<volume_level> is 1.5: 1 is used"});
  EXPECT_EQ(saidOf(sourceWith("volume_level", "-1"), source), Words{"<volume_level> is -1: 0 is used"});
  EXPECT_EQ(saidOf(sourceWith("pose", ""), source), Words{"this <source> has no <pose>: it is where its parent is"});
}

TEST(Sound, IsRefusedWhereItIsNone) {
  using Words = std::vector<std::string>;
  SoundSource source;
  for (const char* name : {"id", "attenuation_function", "attenuation_shape", "inner_radius", "falloff_distance",
                           "volume_level", "playing", "play_duration"}) {
    EXPECT_EQ(saidOf(sourceWith(name, ""), source), Words{std::string("refused: no <") + name + "> is given"});
  }
  EXPECT_EQ(saidOf(sourceWith("attenuation_function", "cubic"), source),
            Words{"refused: <attenuation_function> is 'cubic'"});
  EXPECT_EQ(saidOf(sourceWith("id", "-1"), source), Words{"refused: <id> must be zero or more"});
  EXPECT_EQ(saidOf(sourceWith("pose", "1 2 3"), source), Words{"refused: <pose> is '1 2 3', which is not six numbers"});
  EXPECT_EQ(saidOf(sourceWith("inner_radius", "inf"), source),
            Words{"refused: <inner_radius> must be a finite number"});
  EXPECT_EQ(saidOf(sourceWith("play_duration", "-1"), source), Words{"refused: <play_duration> must be 0 to 1e9 s"});
}

TEST(Sound, FallsLinearlyFromTheInnerRadiusOn) {
  const SoundSource source{.innerRadius = 3, .falloffDistance = 8, .volume = 0.9};
  EXPECT_EQ(volumeAt(source, 0), 0.9);
  EXPECT_EQ(volumeAt(source, 3), 0.9);
  EXPECT_NEAR(volumeAt(source, 4), 0.9 * 0.8, 1e-15);
  EXPECT_NEAR(volumeAt(source, 7.5), 0.09, 1e-15);
  EXPECT_EQ(volumeAt(source, 8), 0);
  EXPECT_EQ(volumeAt(source, 80), 0);
}

TEST(Microphone, HearsWhatIsLoudEnough) {
  EXPECT_TRUE(isHeard(0.4, {.threshold = 0.4}));
  EXPECT_FALSE(isHeard(0.39, {.threshold = 0.4}));
  EXPECT_TRUE(isHeard(1e-5, {}));
  EXPECT_FALSE(isHeard(0.9e-5, {}));
  EXPECT_FALSE(isHeard(0, {.threshold = -1}));
}

TEST(Playing, EndsAfterItsDurationAndBeginsAgain) {
  Playing playing({.plays = true, .duration = milliseconds(10)});
  playing.update(milliseconds(1));
  playing.update(milliseconds(11));
  EXPECT_TRUE(playing.is());
  playing.update(milliseconds(12));
  EXPECT_FALSE(playing.is());
  playing.play();
  playing.update(milliseconds(20));
  EXPECT_TRUE(playing.is());
  // does not begin anew
  playing.play();
  playing.update(milliseconds(25));
  playing.update(milliseconds(31));
  EXPECT_FALSE(playing.is());
}

TEST(Playing, IsPlayedAndStopped) {
  Playing playing({.plays = false});
  playing.update(milliseconds(1));
  EXPECT_FALSE(playing.is());
  playing.play();
  EXPECT_FALSE(playing.is());
  playing.update(milliseconds(2));
  playing.update(milliseconds(900'000));
  EXPECT_TRUE(playing.is());
  playing.stop();
  playing.play();
  playing.update(milliseconds(900'001));
  EXPECT_FALSE(playing.is());
}

}  // namespace
}  // namespace pongsim::sound_test
