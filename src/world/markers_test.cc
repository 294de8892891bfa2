#include "world/markers.hh"

#include <gtest/gtest.h>

namespace pongsim::world {
namespace {

using enum MarkerChange::Action;
using MarkerType = Marker::Type;

MarkerChange sphere(std::uint64_t id, Time lifetime = Time(0)) {
  MarkerChange change;
  change.space = "s";
  change.id = id;
  change.type = MarkerType::kSphere;
  change.lifetime = lifetime;
  return change;
}

MarkerChange removal(MarkerChange::Action action, const std::string& space, std::uint64_t id = 0) {
  MarkerChange change;
  change.action = action;
  change.space = space;
  change.id = id;
  return change;
}

TEST(Markers, KeepWhatAChangeLeavesOut) {
  Markers markers;
  MarkerChange first = sphere(1);
  first.pose = Pose{{1, 2, 3}, Quaternion::Identity()};
  first.color = Eigen::Vector4f(1, 0, 0, 1);
  first.points = {{1, 0, 0}};
  ASSERT_TRUE(markers.apply(first, Time(0)));
  MarkerChange second = sphere(1);
  second.type = MarkerType::kNone;
  second.scale = Vector3(2, 2, 2);
  ASSERT_TRUE(markers.apply(second, Time(0)));
  const Marker& marker = *markers.all().at({"s", 1});
  EXPECT_EQ(marker.type, MarkerType::kSphere);
  EXPECT_EQ(marker.X_ParentMarker.position, Vector3(1, 2, 3));
  EXPECT_EQ(marker.scale, Vector3(2, 2, 2));
  EXPECT_EQ(marker.color, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_EQ(marker.points.size(), 1U);
}

TEST(Markers, GetAFreeNumberIfTheyHaveNone) {
  Markers markers;
  const auto first = markers.apply(sphere(0), Time(0)), second = markers.apply(sphere(0), Time(0));
  EXPECT_NE(first.value->second, second.value->second);
  EXPECT_EQ(markers.all().size(), 2U);
}

TEST(Markers, GoWhenTheirTimeIsOver) {
  Markers markers;
  markers.apply(sphere(1, Time(10)), Time(5));
  markers.apply(sphere(2, Time(20)), Time(5));
  markers.apply(sphere(3), Time(5));
  EXPECT_TRUE(markers.advance(Time(14)).empty());
  EXPECT_EQ(markers.all().size(), 3U);
  EXPECT_EQ(markers.advance(Time(15)), (std::vector<Markers::Key>{{"s", 1}}));
  EXPECT_FALSE(markers.all().contains({"s", 1}));
  markers.advance(Time(25));
  EXPECT_EQ(markers.all().size(), 1U);
}

TEST(Markers, StayForEverWhereTheirEndCanNotBeCounted) {
  Markers markers;
  markers.apply(sphere(1, Time::max()), Time(5));
  markers.advance(Time::max());
  EXPECT_EQ(markers.all().size(), 1U);
}

TEST(Markers, WithALifetimeGoWhenTimeGoesBack) {
  Markers markers;
  markers.apply(sphere(1, Time(100)), Time(0));
  markers.apply(sphere(2), Time(0));
  markers.advance(Time(50));
  markers.advance(Time(0));
  EXPECT_FALSE(markers.all().contains({"s", 1}));
  EXPECT_TRUE(markers.all().contains({"s", 2})) << "as in Fortress";
}

TEST(Markers, AreRemovedOneByOneByNameSpaceOrAll) {
  Markers markers;
  for (std::uint64_t id = 1; id <= 3; ++id) markers.apply(sphere(id), Time(0));
  MarkerChange other = sphere(1);
  other.space = "t";
  markers.apply(other, Time(0));
  EXPECT_TRUE(markers.apply(removal(kDelete, "s", 2), Time(0)));
  EXPECT_EQ(markers.apply(removal(kDelete, "s", 2), Time(0)).error, "there is no marker 2 of the name space 's'");
  EXPECT_TRUE(markers.apply(removal(kDeleteAll, "s"), Time(0)));
  EXPECT_EQ(markers.all().size(), 1U);
  EXPECT_EQ(markers.apply(removal(kDeleteAll, "s"), Time(0)).error, "there are no markers of the name space 's'");
  EXPECT_TRUE(markers.apply(removal(kDeleteAll, ""), Time(0)));
  EXPECT_TRUE(markers.all().empty());
}

TEST(Markers, AreRefusedBeyondTheLimitsAndChangeNothing) {
  Markers markers;
  MarkerChange none = sphere(1);
  none.type = MarkerType::kNone;
  EXPECT_EQ(markers.apply(none, Time(0)).error, "marker 1 of the name space 's' has no type");
  MarkerChange points = sphere(1);
  points.points.resize(Markers::kMostPoints);
  ASSERT_TRUE(markers.apply(points, Time(0)));
  EXPECT_TRUE(markers.apply(points, Time(0))) << "they replace the old ones";
  points.id = 2;
  points.points.resize(1);
  EXPECT_NE(markers.apply(points, Time(0)).error.find("too many points"), std::string::npos);
  points.points.clear();
  points.text = "x";
  EXPECT_NE(markers.apply(points, Time(0)).error.find("too many points or letters"), std::string::npos);
  MarkerChange words = sphere(2);
  words.text.assign(Markers::kLongestText + 1, 'x');
  EXPECT_NE(markers.apply(words, Time(0)).error.find("more than 1000 characters"), std::string::npos);
  for (std::uint64_t id = 2; id <= Markers::kMost; ++id) ASSERT_TRUE(markers.apply(sphere(id), Time(0)));
  const std::uint64_t version = markers.version();
  EXPECT_NE(markers.apply(sphere(0), Time(0)).error.find("10000 markers"), std::string::npos);
  EXPECT_TRUE(markers.apply(sphere(2), Time(0))) << "one that is there can still be changed";
  EXPECT_EQ(markers.version(), version + 1);
}

}  // namespace
}  // namespace pongsim::world
