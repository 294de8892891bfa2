#include "physics/hulls/chain_edges.hh"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace pongsim::physics {

namespace {

using Triangle = TriangleChain::Triangle;
using Index = std::uint32_t;

struct Pass {
  /// Both point numbers, the smaller one first.
  std::uint64_t edge;
  std::uint32_t triangle;
  bool isForwards;
};

std::vector<Pass> passesOf(const std::vector<Triangle>& triangles, bool withCaps) {
  std::vector<Pass> passes;
  passes.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    if (t.isCap && !withCaps) continue;
    for (const auto& [from, to] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
      passes.push_back({std::uint64_t{std::min(from, to)} << 32U | std::max(from, to), i, from < to});
    }
  }
  std::ranges::sort(passes, [](const Pass& a, const Pass& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
  });
  return passes;
}

/// Calls `work(first, end)` with the passes of each edge.
template <class Work>
void forEachEdge(const std::vector<Pass>& passes, Work&& work) {
  for (auto first = passes.begin(); first != passes.end();) {
    auto end = first;
    while (end != passes.end() && end->edge == first->edge) ++end;
    work(first, end);
    first = end;
  }
}

DirectedEdge edgeOf(std::uint64_t edge) { return {static_cast<Index>(edge >> 32U), static_cast<Index>(edge)}; }

}  // namespace

Sets::Sets(std::size_t count) : parents_(count) {
  for (std::size_t i = 0; i < count; ++i) parents_[i] = i;
}

std::size_t Sets::rootOf(std::size_t member) {
  while (parents_[member] != member) {
    parents_[member] = parents_[parents_[member]];
    member = parents_[member];
  }
  return member;
}

void Sets::unite(std::size_t a, std::size_t b) {
  const std::size_t rootA = rootOf(a), rootB = rootOf(b);
  parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

std::vector<DirectedEdge> boundaryOf(const std::vector<Triangle>& triangles) {
  std::vector<DirectedEdge> open;
  forEachEdge(passesOf(triangles, true), [&](auto first, auto end) {
    int sum = 0;
    for (auto pass = first; pass != end; ++pass) sum += pass->isForwards ? 1 : -1;
    const DirectedEdge edge = edgeOf(first->edge);
    for (; sum > 0; --sum) open.push_back(edge);
    for (; sum < 0; ++sum) open.push_back({edge.to, edge.from});
  });
  return open;
}

std::vector<std::vector<DirectedEdge>> connectedParts(const std::vector<DirectedEdge>& edges) {
  std::unordered_map<Index, std::size_t> numberOf;
  for (const DirectedEdge& edge : edges) {
    numberOf.try_emplace(edge.from, numberOf.size());
    numberOf.try_emplace(edge.to, numberOf.size());
  }
  Sets sets(numberOf.size());
  for (const DirectedEdge& edge : edges) sets.unite(numberOf[edge.from], numberOf[edge.to]);
  std::vector<std::vector<DirectedEdge>> parts;
  std::unordered_map<std::size_t, std::size_t> partOf;
  for (const DirectedEdge& edge : edges) {
    const auto [place, isNew] = partOf.try_emplace(sets.rootOf(numberOf[edge.from]), parts.size());
    if (isNew) parts.emplace_back();
    parts[place->second].push_back(edge);
  }
  return parts;
}

void addFan(const std::vector<DirectedEdge>& boundary, std::vector<Triangle>& triangles) {
  const Index apex = boundary.front().from;
  for (const auto& [from, to] : boundary) {
    if (from != apex && to != apex) triangles.push_back({to, from, apex, true});
  }
}

std::vector<Neighbours> neighboursIn(const std::vector<Triangle>& triangles) {
  std::vector<Neighbours> neighbours;
  forEachEdge(passesOf(triangles, false), [&](auto first, auto end) {
    if (end - first != 2) return;
    const auto second = first + 1;
    neighbours.push_back(
        {first->triangle, second->triangle, edgeOf(first->edge), first->isForwards == second->isForwards});
  });
  return neighbours;
}

void orientAlike(std::vector<Triangle>& triangles) {
  std::vector<std::vector<std::pair<std::size_t, bool>>> next(triangles.size());
  for (const Neighbours& pair : neighboursIn(triangles)) {
    next[pair.one].emplace_back(pair.other, pair.areTwisted);
    next[pair.other].emplace_back(pair.one, pair.areTwisted);
  }
  std::vector<bool> isDone(triangles.size()), isTurned(triangles.size());
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (isDone[i]) continue;
    isDone[i] = true;
    waiting.push_back(i);
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      for (const auto& [other, areTwisted] : next[at]) {
        if (isDone[other]) continue;
        isDone[other] = true;
        isTurned[other] = isTurned[at] != areTwisted;
        waiting.push_back(other);
      }
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (isTurned[i]) std::swap(triangles[i].b, triangles[i].c);
  }
}

void cancelOpposites(std::vector<Triangle>& triangles) {
  struct Entry {
    std::array<Index, 3> corners;
    int turn;
    std::size_t number;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    if (t.a == t.b || t.b == t.c || t.c == t.a) continue;
    std::array<Index, 3> corners{t.a, t.b, t.c};
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    const int turn = corners[1] < corners[2] ? 1 : -1;
    if (turn < 0) std::swap(corners[1], corners[2]);
    entries.push_back({corners, turn, i});
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.number < b.number;
  });
  std::vector<Triangle> rest;
  for (auto first = entries.begin(); first != entries.end();) {
    int sum = 0;
    auto end = first;
    for (; end != entries.end() && end->corners == first->corners; ++end) sum += end->turn;
    const auto& [a, b, c] = first->corners;
    const bool isCap = triangles[first->number].isCap;
    for (; sum > 0; --sum) rest.push_back({a, b, c, isCap});
    for (; sum < 0; ++sum) rest.push_back({a, c, b, isCap});
    first = end;
  }
  triangles = std::move(rest);
}

}  // namespace pongsim::physics
