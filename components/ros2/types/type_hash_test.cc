#include "ros2/types/type_hash.hh"

#include <gtest/gtest.h>

#include "ros2/types/geometry_msgs.hh"
#include "ros2/types/sensor_msgs.hh"
#include "ros2/types/sha256.hh"

namespace pongsim::ros2 {
namespace {

// the examples of FIPS 180-4
TEST(Sha256, HashesTheExamplesOfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

// as in the type_description files of Jazzy's packages
TEST(TypeHash, IsThatOfJazzy) {
  EXPECT_EQ(typeHash<std_msgs::String>(), "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");
  EXPECT_EQ(typeHash<geometry_msgs::Twist>(),
            "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a");
}

}  // namespace
}  // namespace pongsim::ros2
