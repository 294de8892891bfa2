#include "pongsim/program/nearest_word.hh"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

namespace pongsim {

namespace {

// In thirds of a letter: the wrong case costs a third of a wrong letter.
constexpr int kLetterCost = 3;
constexpr int kCaseCost = 1;
// Longer words are not typing errors, and would take long to compare.
constexpr std::size_t kLongestWord = 256;

int substitutionCost(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char letter) { return std::tolower(static_cast<unsigned char>(letter)); };
  return lower(a) == lower(b) ? kCaseCost : kLetterCost;
}

/// Optimal string alignment distance: insertions, deletions, substitutions, swaps of neighbours.
int distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<int> beforeLast(width), last(width), current(width);
  for (std::size_t j = 0; j < width; ++j) last[j] = static_cast<int>(j) * kLetterCost;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = static_cast<int>(i) * kLetterCost;
    for (std::size_t j = 1; j < width; ++j) {
      current[j] = std::min(
          {last[j] + kLetterCost, current[j - 1] + kLetterCost, last[j - 1] + substitutionCost(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], beforeLast[j - 2] + kLetterCost);
      }
    }
    std::swap(beforeLast, last);
    std::swap(last, current);
  }
  return last[b.size()];
}

/// @return The length of the common prefix.
std::ptrdiff_t commonPrefix(std::string_view a, std::string_view b) {
  return std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
}

}  // namespace

std::string_view nearestWord(std::string_view word, std::span<const std::string_view> known) {
  if (word.empty() || word.size() > kLongestWord) return {};
  std::string_view nearest;
  // a third of the letters may be wrong, at least one, but never all of them
  const int letters = static_cast<int>(word.size());
  int nearestDistance = std::min(std::max(letters, 3) * kLetterCost / 3 + 1, letters * kLetterCost);
  for (std::string_view candidate : known) {
    if (candidate.size() > 2 * kLongestWord) continue;
    const int candidateDistance = distance(word, candidate);
    // of two equally near words, prefer the one with the longer common prefix: "Twst" means "Twist" rather than "Test"
    const bool isAsNear = candidateDistance == nearestDistance && !nearest.empty();
    if (candidateDistance < nearestDistance ||
        (isAsNear && commonPrefix(word, candidate) > commonPrefix(word, nearest))) {
      nearest = candidate;
      nearestDistance = candidateDistance;
    }
  }
  return nearest;
}

std::string didYouMean(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view nearest = nearestWord(word, known);
  return nearest.empty() ? std::string() : "did you mean '" + std::string(nearest) + "'?";
}

}  // namespace pongsim
