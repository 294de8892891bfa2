#include "sdf/schema/default_elements.hh"

#include "sdf/text/document.hh"
#include "sdf/text/print.hh"
#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

/// @return What is printed of an `<sdf>` element with that content, on one line.
std::string completed(const std::string& content, int version = 9) {
  const std::string number = "1." + std::to_string(version);
  Diagnostics diagnostics;
  Element root = *parseDocument("<sdf version='" + number + "'>" + content + "</sdf>", nullptr, diagnostics);
  addDefaultElements(root, version);
  std::string line;
  for (const char letter : printDocument(root)) {
    if (letter == '\n') line.erase(line.find_last_not_of(' ') + 1);
    const bool isIndent = letter == ' ' && (line.empty() || line.back() == '>');
    if (letter != '\n' && !isIndent) line += letter;
  }
  const std::string begin = "<?xml version=\"1.0\"?><sdf version=\"" + number + "\">", end = "</sdf>";
  EXPECT_TRUE(line.starts_with(begin) && line.ends_with(end)) << line;
  return line.substr(begin.size(), line.size() - begin.size() - end.size());
}

// Each is what libsdformat's `ign sdf -p` prints.
TEST(DefaultElements, GiveAWorldWhatItMustHaveInTheOrderOfTheFormat) {
  EXPECT_EQ(completed("<world name='w'/>"),
            "<world name=\"w\"><gravity>0 0 -9.8</gravity>"
            "<magnetic_field>5.5645e-6 22.8758e-6 -42.3884e-6</magnetic_field><atmosphere type=\"adiabatic\"/>"
            "<physics type=\"ode\"><max_step_size>0.001</max_step_size><real_time_factor>1.0</real_time_factor>"
            "<real_time_update_rate>1000</real_time_update_rate></physics><scene><ambient>0.4 0.4 0.4 1.0</ambient>"
            "<background>.7 .7 .7 1</background><shadows>true</shadows></scene></world>");
}

TEST(DefaultElements, StandBehindWhatTheFileHas) {
  EXPECT_EQ(completed("<model name='m'><link name='l'><inertial><inertia><izz>2</izz></inertia></inertial></link>"
                      "</model>"),
            "<model name=\"m\"><link name=\"l\"><inertial><inertia><izz>2</izz><ixx>1.0</ixx><ixy>0.0</ixy>"
            "<ixz>0.0</ixz><iyy>1.0</iyy><iyz>0.0</iyz></inertia></inertial></link></model>");
}

TEST(DefaultElements, AreTextsThatAFileLeavesEmpty) {
  EXPECT_EQ(completed("<model name='m'><pose relative_to=''/><static></static></model>"),
            "<model name=\"m\"><pose>0 0 0 0 0 0</pose><static>false</static></model>");
}

TEST(DefaultElements, HavePlaceholdersForNamesThatTheFormatCannotGive) {
  const std::string visual = "<visual name=\"v\"><geometry><sphere><radius>1</radius></sphere></geometry>";
  EXPECT_EQ(completed("<model name='m'><link name='l'><visual name='v'><geometry><sphere/></geometry>"
                      "<material><script/></material></visual></link></model>"),
            "<model name=\"m\"><link name=\"l\">" + visual +
                "<material><script><uri>__default__</uri><name>__default__</name></script></material></visual></link>"
                "</model>");
}

TEST(DefaultElements, OfPartsWithAFileOfTheirOwnAreWhatThatSays) {
  // although the format requires a link in an actor, and no noise in an axis
  EXPECT_EQ(completed("<actor name='a'/>"), "<actor name=\"a\"><script/></actor>");
  const std::string begin = "<model name=\"m\"><link name=\"l\"><sensor name=\"s\" type=\"imu\"><imu>";
  EXPECT_EQ(completed("<model name='m'><link name='l'><sensor name='s' type='imu'><imu><angular_velocity><x/>"
                      "</angular_velocity></imu></sensor></link></model>"),
            begin + "<angular_velocity><x><noise type=\"none\"/></x></angular_velocity></imu></sensor></link></model>");
}

TEST(DefaultElements, KeepWhatNobodyKnowsBehindTheRest) {
  EXPECT_EQ(completed("<model name='m' unknown='1' my:own='2'><thing a='b'>text</thing><a:b><c>1</c></a:b>"
                      "<link name='l'/></model>"),
            "<model name=\"m\" my:own=\"2\"><link name=\"l\"/><thing a=\"b\">text</thing><a:b><c>1</c></a:b></model>");
}

TEST(DefaultElements, AreThoseOfTheVersion) {
  const std::string joint = "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis/></joint>";
  const auto limits = [&](int version) {
    const std::string text = completed("<model name='m'>" + joint + "</model>", version);
    return text.substr(text.find("<limit>"), text.find("</limit>") - text.find("<limit>"));
  };
  EXPECT_EQ(limits(9), "<limit><lower>-1e16</lower><upper>1e16</upper>");
  EXPECT_EQ(limits(12), "<limit><lower>-inf</lower><upper>inf</upper>");
  EXPECT_EQ(completed("<model name='m'><plugin filename='f'/></model>", 12),
            "<model name=\"m\"><plugin filename=\"f\"/></model>");
  const std::string later = "<model name='m'><link name='l'><inertial auto='true'/></link></model>";
  EXPECT_EQ(completed(later, 9), "<model name=\"m\"><link name=\"l\"><inertial/></link></model>");
  EXPECT_EQ(completed(later, 12), "<model name=\"m\"><link name=\"l\"><inertial auto=\"true\"/></link></model>");
}

TEST(DefaultElements, LeavePluginsAsTheyAre) {
  const std::string plugin = "<plugin filename=\"f\" name=\"n\"><physics/><b/><a>1</a></plugin>";
  EXPECT_EQ(completed("<model name='m'>" + plugin + "</model>"), "<model name=\"m\">" + plugin + "</model>");
}

}  // namespace
}  // namespace pongsim::sdf::test
