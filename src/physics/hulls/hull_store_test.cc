#include "physics/hulls/hull_store.hh"

#include <gtest/gtest.h>

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string_view>

#include "physics/hulls/hull_code.hh"
#include "physics/shapes/margin.hh"
#include "pongsim/program/log_sink.hh"
#include "pongsim/random.hh"
#include "support/solids.hh"
#include "support/temp_folder.hh"

namespace pongsim::physics {
namespace {

namespace fs = std::filesystem;

description::Mesh meshWith(description::TriangleMesh triangles, const Vector3& scale = {1, 1, 1}) {
  description::Mesh mesh;
  mesh.scale = scale;
  mesh.triangles = std::make_shared<const description::TriangleMesh>(std::move(triangles));
  return mesh;
}

std::vector<Hull> hullsOf(const description::Geometry& geometry, const fs::path& folder = {}) {
  HullStore store(folder);
  return store.find(requestFor(geometry));
}

const description::TriangleMesh& bowl() {
  static const description::TriangleMesh mesh = test::bowl(0.2, 0.01, 24, 8);
  return mesh;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  return files;
}

TEST(HullStore, KeepsTheHullOfWhatIsConvex) {
  // to the bit the hull of all vertices
  for (const description::TriangleMesh& mesh :
       {test::boxBetween({0, 0, 0}, {1, 2, 3}), test::turned({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 40)}) {
    EXPECT_EQ(hullsOf(meshWith(mesh)), std::vector{makeHull(mesh.vertices)});
  }
  EXPECT_GT(hullsOf(meshWith(bowl())).size(), 10U);
}

TEST(HullStore, DoesWhatTheFileSays) {
  description::Mesh mesh = meshWith(bowl());
  const std::vector<Hull> usual = hullsOf(mesh);
  mesh.optimization = description::MeshOptimization::kConvexHull;
  EXPECT_EQ(hullsOf(mesh), std::vector{makeHull(bowl().vertices)});
  mesh.optimization = description::MeshOptimization::kConvexDecomposition;
  EXPECT_LE(hullsOf(mesh).size(), 16U);
  EXPECT_GT(hullsOf(mesh).size(), 8U);
  mesh.maxConvexHulls = 4;
  EXPECT_LE(hullsOf(mesh).size(), 4U);
  // coarse voxels see nothing of it
  mesh.maxConvexHulls = 64;
  const std::size_t fine = hullsOf(mesh).size();
  mesh.voxelResolution = 1000;
  EXPECT_LT(hullsOf(mesh).size(), fine);
  mesh.voxelResolution = 1;
  EXPECT_EQ(hullsOf(mesh).size(), 1U);
}

TEST(HullStore, FillsAnOpenMeshUnlessItIsToBeDecomposed) {
  // half a ball's skin
  std::vector<std::pair<double, double>> line;
  for (int i = 0; i <= 8; ++i) line.emplace_back(std::sin(M_PI / 2 * i / 8), -std::cos(M_PI / 2 * i / 8));
  description::TriangleMesh skin = test::turned(line, 32);
  // from the rim back to the axis
  std::erase_if(skin.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t i) { return i % 9 == 0 || i % 9 == 8; });
  });
  description::Mesh mesh = meshWith(skin);
  EXPECT_EQ(hullsOf(mesh).size(), 1U);
  mesh.optimization = description::MeshOptimization::kConvexDecomposition;
  mesh.maxConvexHulls = 40;
  const std::vector<Hull> sheets = hullsOf(mesh);
  EXPECT_GT(sheets.size(), 10U);
  for (const Hull& sheet : sheets) EXPECT_EQ(sheet.margin, marginFor(1));
}

TEST(HullStore, MirrorsAndScales) {
  const Vector3 scale(-1, 2, 0.5);
  const description::TriangleMesh iron = test::angleIron(1, 1);
  const std::vector<Hull> hulls = hullsOf(meshWith(iron, scale));
  ASSERT_EQ(hulls.size(), 2U);
  Eigen::AlignedBox3d box;
  for (const Hull& hull : hulls) {
    for (const Vector3& corner : hull.corners) box.extend(corner);
  }
  EXPECT_NEAR(box.min().x(), -3, 0.01);
  EXPECT_NEAR(box.max().x(), 0, 0.01);
  EXPECT_NEAR(box.max().z(), 1, 0.01);
  EXPECT_NEAR(box.max().y(), 1, 0.01);
}

TEST(HullStore, TakesTheSameBitsFromItsFolder) {
  const pongsim::test::TempFolder folder;
  const std::vector<Hull> cold = hullsOf(meshWith(bowl()), folder.path());
  ASSERT_EQ(filesIn(folder.path()).size(), 1U);
  EXPECT_EQ(hullsOf(meshWith(bowl()), folder.path()), cold);
  EXPECT_EQ(hullsOf(meshWith(bowl())), cold);
  // it is the file that is taken
  const fs::path file = filesIn(folder.path()).at(0);
  const assets::FileCache cache(folder.path());
  std::vector<Hull> other = cold;
  other.pop_back();
  ASSERT_EQ(cache.keep(file.stem().string(), encodeHulls(other)), "");
  EXPECT_EQ(hullsOf(meshWith(bowl()), folder.path()), other);
}

TEST(HullStore, MakesAnewWhatIsBrokenOrOfSomethingElse) {
  const pongsim::test::TempFolder folder;
  const std::vector<Hull> cold = hullsOf(meshWith(bowl()), folder.path());
  const fs::path file = filesIn(folder.path()).at(0);
  const auto size = fs::file_size(file);
  fs::resize_file(file, size / 2);
  EXPECT_EQ(hullsOf(meshWith(bowl()), folder.path()), cold);
  EXPECT_EQ(fs::file_size(file), size);
  // whole, but no hulls, or hulls far from the mesh
  const assets::FileCache cache(folder.path());
  for (const std::string& foreign :
       {std::string("nonsense"), encodeHulls({{{{5, 5, 5}}, 0}}), encodeHulls({{{{0, 0, 0}}, 9}})}) {
    ASSERT_EQ(cache.keep(file.stem().string(), foreign), "");
    EXPECT_EQ(hullsOf(meshWith(bowl()), folder.path()), cold);
    EXPECT_EQ(fs::file_size(file), size);
  }
}

TEST(HullStore, NamesItsFilesByAllThatCounts) {
  const pongsim::test::TempFolder folder;
  description::Mesh mesh = meshWith(bowl());
  hullsOf(mesh, folder.path());
  hullsOf(meshWith(bowl(), {1, 1, 2}), folder.path());
  mesh.optimization = description::MeshOptimization::kConvexDecomposition;
  hullsOf(mesh, folder.path());
  mesh.maxConvexHulls = 3;
  hullsOf(mesh, folder.path());
  description::TriangleMesh other = bowl();
  other.vertices[0].x() += 1e-12;
  hullsOf(meshWith(other), folder.path());
  EXPECT_EQ(filesIn(folder.path()).size(), 5U);
  // what is quick to make has none
  hullsOf(meshWith(test::angleIron(1, 1)), folder.path());
  EXPECT_EQ(filesIn(folder.path()).size(), 5U);
}

TEST(HullStore, WorksWhereNothingCanBeKept) {
  const pongsim::test::TempFolder folder;
  const fs::path file = folder.write("file", "");
  EXPECT_EQ(hullsOf(meshWith(bowl()), file / "x"), hullsOf(meshWith(bowl())));
}

TEST(HullStore, WorksOutManySideBySideWithTheSameBits) {
  std::vector<HullRequest> requests;
  for (int i = 0; i < 6; ++i) requests.push_back(requestFor(meshWith(test::bowl(0.2, 0.01 + 0.002 * i, 16, 4))));
  requests.push_back(requests[2]);
  requests.emplace_back();
  HullStore all;
  all.prepare(requests);
  for (int i = 0; i < 7; ++i) {
    HullStore alone;
    EXPECT_EQ(all.find(requests[static_cast<std::size_t>(i)]), alone.find(requests[static_cast<std::size_t>(i)]));
  }
}

TEST(HullStore, BearsWhatIsNoBody) {
  description::TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(hullsOf(meshWith(flat)), std::vector{makeHull(flat.vertices)});
  flat.triangles = {{0, 0, 0}, {1, 1, 2}};
  EXPECT_EQ(hullsOf(meshWith(flat)), std::vector{makeHull(flat.vertices)});
  flat.triangles.clear();
  EXPECT_EQ(hullsOf(meshWith(flat)), std::vector{makeHull(flat.vertices)});
  EXPECT_TRUE(hullsOf(meshWith({})).empty());
  // beyond all measure
  EXPECT_EQ(hullsOf(meshWith(bowl(), {1e300, 1, 1})).size(), 1U);
}

/// Triangles in disorder.
description::TriangleMesh soupOf(std::size_t count) {
  Random random(3, "soup");
  description::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 3 * count; ++i) {
    mesh.vertices.push_back(Vector3(random.uniform(), random.uniform(), random.uniform()));
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  return mesh;
}

TEST(HullStore, EndsInSecondsWithTrianglesInDisorderAndSaysThatTheyAreOne) {
  int count = 0;
  const LogSink sink(LogLevel::kWarning, [&](const LogRecord& record) {
    if (record.message.find("not as its real shape") != std::string_view::npos) ++count;
  });
  const std::clock_t begin = std::clock();
  const description::TriangleMesh many = soupOf(100'000);
  EXPECT_EQ(hullsOf(meshWith(many)), std::vector{makeHull(many.vertices)});
  EXPECT_LE(hullsOf(meshWith(soupOf(5'000))).size(), 64U);
  // in optimized programs 3 s on a fast processor; without a bound it takes minutes
  EXPECT_LT(std::clock() - begin, 120 * CLOCKS_PER_SEC);
  EXPECT_EQ(count, 2);
}

TEST(HullStore, LooksAtALargeMeshAsIfItWereCoarse) {
  // 240,000 triangles
  const description::TriangleMesh mesh = test::bowl(0.2, 0.01, 500, 120);
  const std::vector<Hull> hulls = hullsOf(meshWith(mesh));
  EXPECT_GT(hulls.size(), 20U);
  EXPECT_LE(hulls.size(), 64U);
}

}  // namespace
}  // namespace pongsim::physics
