#include "support/sdf/load_support.hh"

namespace pongsim::sdf::test {
namespace {

constexpr std::string_view kTriangle = "<point>0 0</point><point>4 0</point><point>0 4</point>";

Loaded loadPolylines(const std::string& content, const std::string& holder = "collision") {
  return loadLink("<" + holder + " name='c'><geometry>\n" + content + "</geometry></" + holder + ">");
}

const description::Polyline& polylineOf(const Loaded& loaded) {
  return std::get<description::Polyline>(loaded.model().links.at(0).collisions.at(0).geometry);
}

TEST(Polyline, IsReadAndFilled) {
  const Loaded loaded =
      loadPolylines("<polyline>" + std::string(kTriangle) + "<point>0 0</point><height>2</height></polyline>");
  EXPECT_EQ(loaded.messages, Messages());
  const description::Polyline& polyline = polylineOf(loaded);
  EXPECT_EQ(polyline.height, 2);
  // the last point is the first one
  ASSERT_EQ(polyline.lines.size(), 1U);
  EXPECT_EQ(polyline.lines[0].size(), 3U);
  ASSERT_NE(polyline.triangles, nullptr);
  EXPECT_EQ(polyline.triangles->triangles.size(), 8U);
}

TEST(Polyline, HasHolesWhereOthersStandInIt) {
  const Loaded loaded =
      loadPolylines("<polyline>" + std::string(kTriangle) +
                    "</polyline><polyline><point>1 1</point><point>2 1</point><point>1 2</point></polyline>");
  EXPECT_EQ(loaded.messages, Messages());
  EXPECT_EQ(polylineOf(loaded).lines.size(), 2U);
  EXPECT_EQ(polylineOf(loaded).height, 1);
  // a ring of six triangles above and below, two on each of six sides
  EXPECT_EQ(polylineOf(loaded).triangles->triangles.size(), 24U);
}

TEST(Polyline, SaysWhyItIsNotFilled) {
  const std::string triangle = "<polyline>" + std::string(kTriangle) + "</polyline>";
  EXPECT_EQ(loadPolylines("<polyline/>").messages, Messages{"t.sdf:5:1: warning: a polyline of collision 'c' of link "
                                                            "'l' of model 'm' has fewer than three different points"});
  EXPECT_EQ(loadPolylines(triangle + "\n" + triangle).messages,
            Messages{"t.sdf:5:1: warning: the polylines of collision 'c' of link 'l' of model 'm' cross or touch: it "
                     "will not collide"});
  EXPECT_EQ(loadPolylines(triangle + "\n" + triangle, "visual").messages,
            Messages{"t.sdf:5:1: warning: the polylines of visual 'c' of link 'l' of model 'm' cross or touch: it will "
                     "not be seen"});
  std::string many;
  for (int i = 0; i < 5000; ++i) many += "<point>" + std::to_string(i) + " 1</point>";
  EXPECT_EQ(loadPolylines("<polyline><point>0 0</point>" + many + "</polyline>").messages,
            Messages{"t.sdf:5:1: warning: the polylines of collision 'c' of link 'l' of model 'm' have more than 5000 "
                     "points: it will not collide"});
  EXPECT_EQ(polylineOf(loadPolylines("<polyline/>")).triangles, nullptr);
}

TEST(Polyline, SaysWhatIsWrong) {
  EXPECT_EQ(loadPolylines("<polyline>" + std::string(kTriangle) + "<height>0</height></polyline>").messages,
            Messages{"t.sdf:5:65: error: <height> is '0', which is not a finite number above zero"});
  EXPECT_EQ(loadPolylines("<polyline>" + std::string(kTriangle) + "<point>1 inf</point></polyline>").messages,
            Messages{"t.sdf:5:65: error: <point> is '1 inf', which is not two finite numbers"});
  EXPECT_EQ(loadPolylines("<polyline>" + std::string(kTriangle) + "</polyline>\n<polyline><height>2</height>" +
                          "<point>1 1</point><point>2 1</point><point>1 2</point></polyline>")
                .messages,
            Messages{"t.sdf:6:1: warning: a polyline of collision 'c' of link 'l' of model 'm' has another height than "
                     "the first: the first is used"});
}

}  // namespace
}  // namespace pongsim::sdf::test
