// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/support/every_event.h"
#include "trace/fault_log.h"

/// Which return to order ends which fault that lasts.
namespace syncline {
namespace {

template <class What>
Event told(Nanoseconds time, int slave, What what = {}) {
  return Event{time, slave, what};
}

struct Pair {
  const char* name;
  Event fault, order;
  bool own_slave;  // it is over for the slave that the order is told of, and for no other
};

std::vector<Pair> pairs() {
  using Reference = events::ReferenceClockChanged;
  events::CableChanged broken, healed;
  healed.healed = true;
  events::LongCycles longer, usual;
  longer.begun = true;
  usual.begun = false;
  events::StaleProcessData stale, fresh;
  stale.begun = true;
  fresh.begun = false;
  Reference gone, back;
  gone.what = Reference::What::kNoSystemTime;
  back.what = Reference::What::kPresent;
  return {{"slave", told<events::SlaveLost>(1, 3), told<events::SlaveFound>(2, 3), true},
          {"cable", told(1, 3, broken), told(2, 3, healed), true},
          {"long cycles", told(1, 3, longer), told(2, 3, usual), true},
          {"stale data", told(1, 3, stale), told(2, 3, fresh), true},
          {"link", told<events::LinkDown>(1, -1), told<events::LinkUp>(2, -1), false},
          {"slaves out of sync", told<events::SlavesOutOfSync>(1, 3), told<events::SlavesInSync>(2, -1), false},
          {"slaves unknown", told<events::SlavesSyncUnknown>(1, -1), told<events::SlavesInSync>(2, -1), false},
          {"not monitored", told<events::SlavesSyncUnknown>(1, -1), told<events::SlavesNotMonitored>(2, -1), false},
          {"master", told<events::MasterOutOfSync>(1, -1), told<events::MasterInSync>(2, -1), false},
          {"reference clock", told(1, 3, gone), told(2, 3, back), false}};
}

bool is_over(const Event& fault, const Event& order) {
  FaultLog log;
  log.add(fault);
  EXPECT_EQ(log.lasting().size(), 1U);
  log.add(order);
  return log.lasting().empty();
}

TEST(FaultEnd, IsToldByItsOwnReturnToOrder) {
  for (const auto& pair : pairs()) {
    EXPECT_TRUE(is_over(pair.fault, pair.order)) << pair.name;
    auto before = pair.order;
    before.time = 0;
    EXPECT_FALSE(is_over(pair.fault, before)) << pair.name << ": it came earlier";
    auto other = pair.order;
    other.slave = pair.order.slave + 1;
    if (pair.own_slave) {
      EXPECT_FALSE(is_over(pair.fault, other)) << pair.name << ": another slave";
    }
  }
}

/// One slave that came back in sync says nothing of the others.
TEST(FaultEnd, OneSlaveInSyncIsNotAll) {
  EXPECT_FALSE(is_over(told<events::SlavesOutOfSync>(1, 3), told<events::SlavesInSync>(2, 3)));
}

TEST(FaultEnd, IsNotToldByAnother) {
  for (const auto& fault : pairs()) {
    for (const auto& order : pairs()) {
      const bool known = fault.fault.kind() == kind_of<events::SlavesSyncUnknown> &&
                         (order.order.is<events::SlavesInSync>() || order.order.is<events::SlavesNotMonitored>());
      const bool sync = fault.fault.is<events::SlavesOutOfSync>() && order.order.is<events::SlavesInSync>();
      if (fault.name == order.name || known || sync) continue;
      EXPECT_FALSE(is_over(fault.fault, order.order)) << fault.name << " by " << order.name;
    }
  }
}

/// Of all kinds of events, those that end or begin nothing change nothing.
TEST(FaultEnd, NewsChangeNothing) {
  for (const auto& pair : pairs()) {
    for (auto event : test::one_of_each()) {
      if (meaning_of(event) != EventMeaning::kNews || event.is<events::SlavesNotMonitored>()) continue;
      event.time = 2;
      event.slave = pair.fault.slave;
      EXPECT_FALSE(is_over(pair.fault, event)) << pair.name << ' ' << event.what.index();
    }
  }
}

}  // namespace
}  // namespace syncline
