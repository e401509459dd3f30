// SPDX-License-Identifier: Apache-2.0
#include "trace/arrival_bathtub.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trace/min_max_series.h"

namespace syncline {
namespace {

constexpr int kPointsADecade = 8;
constexpr double kFewestBelow = 10;  // arrivals: a probability that rests on fewer is chance

/// What the rarest rooms have in common: beyond `room` they become rarer by e each `scale` ns.
struct ExponentialTail {
  double probability = 0, room = 0, scale = 0;
};

/// `rooms` in any order; the smallest ones stand in front afterwards.
std::optional<ExponentialTail> tail_of(std::vector<double>& rooms) {
  if (rooms.size() < kFewestArrivals) return std::nullopt;
  const auto rare = std::clamp<std::size_t>(rooms.size() / 100, 20, 1'000);
  const auto edge = rooms.begin() + static_cast<std::ptrdiff_t>(rare);
  std::nth_element(rooms.begin(), edge, rooms.end());
  double beyond = 0;
  for (auto room = rooms.begin(); room != edge; ++room) beyond += *edge - *room;
  const auto count = static_cast<double>(rare);
  return ExponentialTail{count / static_cast<double>(rooms.size()), *edge, beyond / count};
}

std::vector<ArrivalBathtub::Point> wall_of(std::vector<double> rooms) {
  std::vector<ArrivalBathtub::Point> wall;
  const auto count = static_cast<double>(rooms.size());
  if (rooms.empty()) return wall;
  const auto tail = tail_of(rooms);
  const double smallest = *std::ranges::min_element(rooms);
  const int points = static_cast<int>(std::lround(-std::log10(ArrivalBathtub::kLeastProbability))) * kPointsADecade;
  auto end = rooms.end();
  for (int i = 0; i <= points; ++i) {
    const double probability = std::pow(10.0, -static_cast<double>(i) / kPointsADecade);
    if (probability * count >= kFewestBelow) {
      // From point to point fewer are looked at.
      const auto rank = std::min(static_cast<std::ptrdiff_t>(probability * count), end - rooms.begin() - 1);
      std::nth_element(rooms.begin(), rooms.begin() + rank, end);
      wall.push_back({probability, rooms[static_cast<std::size_t>(rank)], false});
      end = rooms.begin() + rank + 1;
      continue;
    }
    if (!tail) break;
    double room = tail->room - tail->scale * std::log(tail->probability / probability);
    // What has happened is not rarer than it was, and rarer is never better.
    if (probability * count <= 1) room = std::min(room, smallest);
    room = std::min(room, wall.empty() ? room : wall.back().room);
    wall.push_back({probability, room, true});
  }
  return wall;
}

}  // namespace

std::optional<ArrivalBathtub::Point> ArrivalBathtub::room(const std::vector<Point>& wall, double probability) {
  // Points are a tenth of a decade apart at least: the next rarer one keeps less.
  const auto found =
      std::ranges::find_if(wall, [&](const Point& point) { return point.probability <= probability * (1 + 1e-9); });
  return found == wall.end() ? std::nullopt : std::optional(*found);
}

std::optional<ArrivalBathtub::Point> ArrivalBathtub::less_than(const std::vector<Point>& wall, double need) {
  const auto found = std::ranges::find_if(wall, [&](const Point& point) { return point.room < need; });
  if (found == wall.end()) return std::nullopt;
  // Between two points the more probable one may be meant: it is told.
  return Point{found == wall.begin() ? 1 : std::prev(found)->probability, need, found->extrapolated};
}

ArrivalBathtub arrival_bathtub(const MinMaxSeries& phase, Nanoseconds period, Nanoseconds begin, Nanoseconds end) {
  ArrivalBathtub bathtub;
  std::vector<double> phases;
  double along = 0, across = 0;
  const auto whole = static_cast<double>(period);
  phase.for_each(begin, end, [&](Nanoseconds, float value) {
    if (std::isnan(value)) return;
    phases.push_back(static_cast<double>(value));
    const double turn = 2 * std::numbers::pi * phases.back() / whole;
    along += std::cos(turn);
    across += std::sin(turn);
  });
  bathtub.count = phases.size();
  if (phases.empty()) return bathtub;
  double middle = std::atan2(across, along) / (2 * std::numbers::pi) * whole;
  if (middle < 0) middle += whole;
  std::vector<double> late;
  late.reserve(phases.size());
  for (auto& at : phases) {
    if (at - middle > whole / 2) at -= whole;
    if (at - middle < -whole / 2) at += whole;
    late.push_back(whole - at);
  }
  bathtub.late = wall_of(std::move(late));
  bathtub.early = wall_of(std::move(phases));
  return bathtub;
}

}  // namespace syncline
