#include "msgs/scene/marker_message.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/marker.pb.h>
#include <ignition/msgs/marker_v.pb.h>

namespace pongsim::msgs {
namespace {

namespace im = ignition::msgs;

TEST(MarkerMessage, TellsWhatIsGivenAndLeavesTheRestOut) {
  im::Marker message;
  message.set_ns("path");
  message.set_id(7);
  message.set_type(im::Marker::BOX);
  const world::MarkerChange plain = *markerChange(message).value;
  EXPECT_EQ(plain.space, "path");
  EXPECT_EQ(plain.id, 7U);
  EXPECT_EQ(plain.type, world::Marker::Type::kBox);
  EXPECT_FALSE(plain.pose || plain.scale || plain.color || plain.isForAll);

  message.mutable_material()->mutable_diffuse()->set_g(1);
  message.mutable_lifetime()->set_sec(2);
  message.mutable_lifetime()->set_nsec(5);
  message.mutable_pose()->mutable_orientation()->set_z(0);
  const world::MarkerChange more = *markerChange(message).value;
  EXPECT_EQ(*more.color, Eigen::Vector4f(0, 1, 0, 1)) << "an opacity that is left out is no transparency";
  EXPECT_EQ(more.lifetime, Time(2'000'000'005));
  EXPECT_EQ(more.pose->rotation.w(), 1) << "a quaternion of zeros is no rotation";
}

TEST(MarkerMessage, RefusesTypesAndActionsThatThereAreNot) {
  im::Marker message;
  message.set_id(3);
  message.set_type(static_cast<im::Marker::Type>(99));
  EXPECT_EQ(markerChange(message).error, "marker 3 has an unknown type, 99");
  message.set_action(static_cast<im::Marker::Action>(4));
  EXPECT_EQ(markerChange(message).error, "marker 3 asks for an unknown action, 4");
}

TEST(MarkerMessage, OfAMarkerAddsItAgain) {
  world::MarkerChange change;
  change.space = "s";
  change.id = 2;
  change.type = world::Marker::Type::kLineStrip;
  change.isForAll = true;
  change.lifetime = Time(3'500'000'000);
  change.pose = Pose{{1, 2, 3}, Quaternion(0.5, 0.5, 0.5, 0.5)};
  change.scale = Vector3(1, 2, 3);
  change.color = Eigen::Vector4f(0, 0.25F, 0.5F, 0.75F);
  change.points = {{1, 0, 0}, {0, 1, 0}};
  change.text = "t";
  change.parent = "m::l";
  change.layer = -4;
  world::Markers markers;
  ASSERT_TRUE(markers.apply(change, Time(1)));
  im::Marker_V all;
  const auto& [key, marker] = *markers.all().begin();
  setMarker(key, *marker, Time(1), addMarker(all));
  ASSERT_EQ(markersIn(all).size(), 1U);
  const world::MarkerChange again = *markerChange(*markersIn(all)[0]).value;
  EXPECT_EQ(again.space, change.space);
  EXPECT_EQ(again.id, change.id);
  EXPECT_EQ(again.type, change.type);
  EXPECT_EQ(again.isForAll, change.isForAll);
  EXPECT_EQ(again.lifetime, change.lifetime);
  EXPECT_EQ(again.pose->position, change.pose->position);
  EXPECT_EQ(again.pose->rotation.coeffs(), change.pose->rotation.coeffs());
  EXPECT_EQ(*again.scale, *change.scale);
  EXPECT_EQ(*again.color, *change.color);
  EXPECT_EQ(again.points, change.points);
  EXPECT_EQ(again.text, change.text);
  EXPECT_EQ(again.parent, change.parent);
  EXPECT_EQ(again.layer, change.layer);
  EXPECT_EQ(worldOfMarkers(all), "");
  im::Marker removal;
  setMarkerRemoval(key, false, removal);
  EXPECT_EQ(markerChange(removal).value->action, world::MarkerChange::Action::kDelete);
  EXPECT_EQ(markerChange(removal).value->id, 2U);
  setWorldOfMarkers("court", all);
  EXPECT_EQ(worldOfMarkers(all), "court");
}

}  // namespace
}  // namespace pongsim::msgs
