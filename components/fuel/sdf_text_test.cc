#include "fuel/sdf_text.hh"

#include <gtest/gtest.h>

#include <random>

namespace pongsim::fuel {
namespace {

std::string pathsOf(std::string_view file) {
  std::string all;
  for (const XmlText& each : xmlTexts(file)) {
    all += each.path + "=" + each.text + ";";
    EXPECT_LE(each.end, file.size());
  }
  return all;
}

TEST(XmlTexts, AreThoseOfElementsWithoutOthers) {
  EXPECT_EQ(pathsOf("<?xml version='1.0'?><a><b x='>' y=\"<\"> 1 &amp; 2\n</b><c/><d>3<e>4</e>5</d></a>"),
            "/a/b=1 & 2;/a/d/e=4;");
  EXPECT_EQ(pathsOf("<a><!-- <b>1</b> --><b>2<!-- 3 --></b><c><![CDATA[<d>4</d>]]></c></a>"), "");
}

TEST(XmlTexts, EndWhereTheFileIsNoXml) {
  EXPECT_EQ(pathsOf("<a><b>1</b><c"), "/a/b=1;");
  EXPECT_EQ(pathsOf("</a></b><c>1</c>"), "/c=1;");
  EXPECT_EQ(pathsOf("<a><!-- <b>1</b>"), "");
  EXPECT_EQ(pathsOf(""), "");
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_EQ(pathsOf(deep), "");
}

TEST(XmlTexts, OutliveWhatIsDamaged) {
  const std::string whole = "<?xml version='1.0'?><!-- x --><a b='c'><d>&amp;e</d><![CDATA[f]]><g/><h> i </h></a>";
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    std::string text = whole;
    for (int count = 0; count < 3; ++count) text[random() % text.size()] = whole[random() % whole.size()];
    text.resize(random() % (text.size() + 1));
    for (const XmlText& each : xmlTexts(text)) {
      ASSERT_LT(each.begin, each.end) << text;
      ASSERT_LE(each.end, text.size()) << text;
    }
  }
}

TEST(FuelAddresses, AreFoundInFiles) {
  EXPECT_EQ(fuelAddressesInXml("<a><uri>https://h/1.0/o/models/m</uri><uri>https://h/x</uri><u>model://m</u></a>"),
            std::vector<std::string>{"https://h/1.0/o/models/m"});
  EXPECT_EQ(fuelAddressesInQuotes("dependencies { uri: \"https://h/1.0/o/models/m\" }\nlicense: \"https://h\" \""),
            std::vector<std::string>{"https://h/1.0/o/models/m"});
}

TEST(FuelAddresses, ReplaceThoseOfTheModelWhereFortressDoesIt) {
  FuelAddress address = *parseFuelAddress("https://fuel.gazebosim.org/1.0/Owner/models/My Model/3");
  const auto has = [](const std::string& file) { return file == "a b&.png"; };
  const std::string prefix = "https://fuel.gazebosim.org/1.0/owner/models/my model/3/files/";
  const auto replaced = [&](const std::string& open, const std::string& close) {
    return withFuelAddresses(open + "model://My Model/a b&amp;.png" + close, address, has) ==
           open + prefix + "a b&amp;.png" + close;
  };
  EXPECT_TRUE(replaced("<sdf><model><link><visual><geometry><mesh><uri>", "</uri></mesh>"));
  EXPECT_TRUE(replaced("<material><script><uri>\n ", " </uri></script>"));
  EXPECT_TRUE(replaced("<material><pbr><metal><albedo_map>", "</albedo_map>"));
  EXPECT_TRUE(replaced("<actor><skin><filename>", "</filename>"));
  EXPECT_TRUE(replaced("<actor><animation name='x'><filename>", "</filename>"));
  EXPECT_FALSE(replaced("<include><uri>", "</uri></include>"));
  EXPECT_FALSE(replaced("<plugin><filename>", "</filename></plugin>"));
  EXPECT_FALSE(replaced("<!-- <mesh><uri>", "</uri></mesh> -->"));
  // a file that the model does not contain may be in another model
  const std::string other = "<mesh><uri>model://other/b.png</uri></mesh>";
  EXPECT_EQ(withFuelAddresses(other, address, has), other);
}

}  // namespace
}  // namespace pongsim::fuel
