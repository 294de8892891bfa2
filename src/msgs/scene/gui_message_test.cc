#include "msgs/scene/gui_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/gui.pb.h>

namespace pongsim::msgs {
namespace {

Element element(const char* name, const char* text = "") {
  Element made;
  made.name = name;
  made.text = text;
  return made;
}

TEST(GuiMessage, HasThePluginsInTheirOrderWithWhatStandsInThem) {
  Element first = element("plugin");
  first.attributes = {{"filename", "KeyPublisher", {}}, {"name", "Key Publisher", {}}};
  Element settings = element("ignition-gui");
  settings.children = {element("title", "a < b")};
  first.children = {settings, element("topic", "/keys")};
  Element second = element("plugin");
  second.attributes = {{"filename", "Plotting", {}}};
  Element gui = element("gui");
  gui.attributes = {{"fullscreen", "1", {}}};
  gui.children = {element("camera"), first, second};

  ignition::msgs::GUI message;
  setGui(gui, message);
  EXPECT_TRUE(message.fullscreen());
  ASSERT_EQ(message.plugin_size(), 2);
  EXPECT_EQ(message.plugin(0).name(), "Key Publisher");
  EXPECT_EQ(message.plugin(0).filename(), "KeyPublisher");
  EXPECT_EQ(message.plugin(0).innerxml(),
            "<ignition-gui>\n  <title>a &lt; b</title>\n</ignition-gui>\n<topic>/keys</topic>\n");
  EXPECT_EQ(message.plugin(1).filename(), "Plotting");
  EXPECT_EQ(message.plugin(1).innerxml(), "");
}

TEST(GuiMessage, IsEmptyWhereTheFileSaysNothing) {
  ignition::msgs::GUI message;
  message.add_plugin();
  setGui(std::nullopt, message);
  EXPECT_EQ(message.ByteSizeLong(), 0U);
}

}  // namespace
}  // namespace pongsim::msgs
