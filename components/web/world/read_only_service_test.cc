#include "web/world/read_only_service.hh"

#include <gtest/gtest.h>

namespace pongsim::web {
namespace {

TEST(IsHarmless, KnowsWhatOnlyTells) {
  for (const char* service :
       {"/gazebo/worlds", "/marker/list", "/world/w/scene/info", "/world/a_b/state", "/world/w/gui/info"}) {
    EXPECT_TRUE(isReadOnlyService(service)) << service;
  }
  for (const char* service :
       {"/world/w/control", "/world/w/create", "/server_control", "/marker", "/gazebo/resource_paths/add", "",
        "/world/", "/world//state", "/world/w", "/scene/info", "/world/w/x/scene/info"}) {
    EXPECT_FALSE(isReadOnlyService(service)) << service;
  }
}

}  // namespace
}  // namespace pongsim::web
