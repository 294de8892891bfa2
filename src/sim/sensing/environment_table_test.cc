#include "sim/sensing/environment_table.hh"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pongsim::sim {
namespace {

TEST(EnvironmentTable, ReadsNumbersByTheirColumns) {
  EnvironmentTable table;
  const std::string csv = "\xef\xbb\xbf h , \"t\",y, x,z,wind speed\r\n1,2,3,4,5,6\r\n\r\n-1,2e3, 3.5 ,\t4,\"5\",6";
  ASSERT_EQ(table.read(csv, {}).error, "");
  EXPECT_EQ(table.quantities, (std::vector<std::string>{"h", "wind speed"}));
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].time, 2);
  EXPECT_EQ(table.rows[0].place, Vector3(4, 3, 5));
  EXPECT_EQ(table.rows[1].time, 2000);
  EXPECT_EQ(table.rows[1].place, Vector3(4, 3.5, 5));
  EXPECT_EQ(table.rows[1].index, 1U);
  EXPECT_EQ(table.values, (std::vector<double>{1, 6, -1, 6}));
}

TEST(EnvironmentTable, TakesTheNamesThatItIsTold) {
  EnvironmentTable table;
  const EnvironmentSettings settings{.timeColumn = "when", .placeColumns = {"a", "b", "c"}};
  ASSERT_EQ(table.read("a,b,c,when,x\n1,2,3,4,5\n", settings).error, "");
  EXPECT_EQ(table.quantities, std::vector<std::string>{"x"});
  EXPECT_EQ(table.rows.at(0).time, 4);
}

TEST(EnvironmentTable, NamesTheLineThatItCannotRead) {
  const auto errorOf = [](const std::string& csv) {
    EnvironmentTable table;
    return table.read(csv, {}).error;
  };
  EXPECT_EQ(errorOf("t,x,y,z\n1,2,3\n"), "line 2 has 3 cells, where the first line has 4");
  EXPECT_EQ(errorOf("t,x,y,z\n\n1,2,3,four\n"), "line 3 has 'four' in the column 'z', which is not a finite number");
  EXPECT_EQ(errorOf("t,x,y,z\n" + std::string(100, '7') + "x,2,3,4\n").size(),
            std::string("line 2 has '' in the column 't', which is not a finite number").size() + 40);
  EXPECT_EQ(errorOf("x,y,z\n"), "it has no column 't', but x, y, z");
  EXPECT_EQ(errorOf("\n\n"), "its first line has no names of columns");
  EXPECT_EQ(errorOf("t,x,y,z\n\n"), "it has no values");
}

}  // namespace
}  // namespace pongsim::sim
