// SPDX-License-Identifier: Apache-2.0
#include "trace/outages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "trace/sample_store.h"
#include "trace/untold.h"

namespace syncline {
namespace {

constexpr std::size_t kCyclesOneByOne = 1U << 16;

/// Takes what is known from left to right.
class OutageFinder {
 public:
  OutageFinder(Nanoseconds from, Nanoseconds longest) : known_(from), longest_(longest) {}
  void known(Nanoseconds first, Nanoseconds last) {
    if (first - known_ > longest_) found_.push_back({known_, first});
    known_ = last;
  }
  std::vector<Outage> finish(Nanoseconds to) {
    known(to, to);
    return std::move(found_);
  }

 private:
  Nanoseconds known_, longest_;
  std::vector<Outage> found_;
};

}  // namespace

std::vector<Outage> outages(const SampleStore& store, Nanoseconds from, Nanoseconds to, Nanoseconds width) {
  if (store.empty()) return {};
  // Every cycle whose frame came back has one. Before the run and behind it there is no outage.
  const auto& trips = store.series(answered_signal(store));
  from = std::max(from, store.first_time());
  to = std::min(to, store.last_time() + 1);
  if (from >= to) return {};
  OutageFinder finder(from, store.longest_gap(Signal::kRoundTrip));
  if (trips.count(from, to) <= kCyclesOneByOne) {
    trips.for_each(from, to, [&finder](Nanoseconds time, float trip) {
      if (!std::isnan(trip)) finder.known(time, time);
    });
    return finder.finish(to);
  }
  std::vector<SeriesColumn> columns;
  trips.columns(from, to, width, columns);
  for (const auto& column : columns) {
    if (column.valid) finder.known(column.start, column.start + width);
  }
  return finder.finish(to);
}

}  // namespace syncline
