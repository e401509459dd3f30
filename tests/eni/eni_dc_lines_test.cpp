// SPDX-License-Identifier: Apache-2.0
// Each DC setting writes its lines and no others: the exported text with a setting and without it, line by line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "tests/support/sample_devices.h"

namespace syncline::eni {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two servos behind a coupler: 1 ms, SYNC0, bus shift.
Project machine() {
  Project project = sample::project({sample::coupler(), sample::servo(), sample::servo()});
  project.master.dc.dcm.mode = DcmMode::kBusShift;
  project.master.dc.sync_window.enabled = false;
  project.master.dc.show_64bit_system_time = false;
  return project;
}

/// Lines without indentation. Places in the image are left out: what lies behind a line that comes or goes moves.
std::vector<std::string> lines(const Project& project) {
  std::istringstream text(write_eni(compile(project).value().config));
  std::vector<std::string> out;
  for (std::string line; std::getline(text, line);) {
    line.erase(0, line.find_first_not_of(' '));
    if (line.starts_with("<InputOffs>") || line.starts_with("<OutputOffs>") || line.starts_with("<ByteSize>")) continue;
    out.push_back(line);
  }
  return out;
}

struct Changes {
  std::vector<std::string> removed, added;
};

/// Longest common subsequence; what is not in it came or went.
Changes changes(const Project& before, const Project& after) {
  const auto l = lines(before), r = lines(after);
  std::vector<std::vector<std::uint32_t>> common(l.size() + 1, std::vector<std::uint32_t>(r.size() + 1));
  for (std::size_t i = l.size(); i-- > 0;) {
    for (std::size_t j = r.size(); j-- > 0;) {
      common[i][j] = l[i] == r[j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
    }
  }
  Changes out;
  std::size_t i = 0, j = 0;
  while (i < l.size() || j < r.size()) {
    if (i < l.size() && j < r.size() && l[i] == r[j]) {
      ++i;
      ++j;
    } else if (j == r.size() || (i < l.size() && common[i + 1][j] >= common[i][j + 1])) {
      out.removed.push_back(l[i++]);
    } else {
      out.added.push_back(r[j++]);
    }
  }
  return out;
}

template <class Edit>
Changes edited(Edit edit) {
  const Project before = machine();
  Project after = before;
  edit(after);
  return changes(before, after);
}

/// The values of an element among lines.
std::vector<std::string> values(const std::vector<std::string>& lines, const std::string& element) {
  std::vector<std::string> out;
  for (const auto& line : lines) {
    if (line.starts_with("<" + element + ">")) {
      out.push_back(line.substr(element.size() + 2, line.find("</") - element.size() - 2));
    }
  }
  return out;
}

TEST(DcLines, SyncWindowIsOneBrdOf092C) {
  const auto change = edited([](Project& project) { project.master.dc.sync_window.enabled = true; });
  EXPECT_THAT(change.removed, IsEmpty());
  EXPECT_THAT(change.added,
              testing::UnorderedElementsAre("<Cmd>", "<State>SAFEOP</State>", "<State>OP</State>",
                                            "<Comment>DC: sync window</Comment>", "<Cmd>7</Cmd>", "<Adp>0</Adp>",
                                            "<Ado>2348</Ado>", "<DataLength>4</DataLength>", "</Cmd>"));
}

TEST(DcLines, BusShiftIsOneApwrOf0910) {
  for (const auto mode : {DcmMode::kMasterShift, DcmMode::kOff}) {
    const auto change = edited([mode](Project& project) { project.master.dc.dcm.mode = mode; });
    EXPECT_THAT(change.added, IsEmpty());
    EXPECT_THAT(change.removed, testing::UnorderedElementsAre(
                                    "<Cmd>", "<State>PREOP</State>", "<State>SAFEOP</State>", "<State>OP</State>",
                                    "<Comment>DC: steer reference clock (bus shift)</Comment>", "<Cmd>2</Cmd>",
                                    "<Adp>65535</Adp>", "<Ado>2320</Ado>", "<DataLength>4</DataLength>", "</Cmd>"));
  }
}

TEST(DcLines, A64BitSystemTimeIsTheLengthOfTheArmw) {
  const auto change = edited([](Project& project) { project.master.dc.show_64bit_system_time = true; });
  EXPECT_THAT(change.removed, ElementsAre("<DataLength>4</DataLength>"));
  EXPECT_THAT(change.added, ElementsAre("<DataLength>8</DataLength>"));
}

TEST(DcLines, ContinuousCompensationTurnsTheNopIntoALatch) {
  const auto change = edited([](Project& project) { project.master.dc.continuous_propagation_compensation = true; });
  EXPECT_THAT(change.removed, ElementsAre("<Comment>DC: room for receive time latch</Comment>", "<Cmd>0</Cmd>"));
  EXPECT_THAT(change.added, ElementsAre("<Comment>DC: latch receive times</Comment>", "<Cmd>8</Cmd>"));
}

TEST(DcLines, TheReferenceClockIsAddressedAndFlagged) {
  const auto change = edited([](Project& project) { project.master.dc.reference_clock = 2; });
  EXPECT_THAT(change.removed,
              testing::UnorderedElementsAre("<ReferenceClock>1</ReferenceClock>", "<ReferenceClock>0</ReferenceClock>",
                                            "<Adp>65535</Adp>", "<Adp>65535</Adp>"));
  EXPECT_THAT(change.added,
              testing::UnorderedElementsAre("<ReferenceClock>0</ReferenceClock>", "<ReferenceClock>1</ReferenceClock>",
                                            "<Adp>65534</Adp>", "<Adp>65534</Adp>"));
}

TEST(DcLines, APotentialReferenceClockIsOneFlag) {
  const auto change = edited([](Project& project) { project.slaves[2].dc.potential_reference_clock = true; });
  EXPECT_THAT(change.removed, ElementsAre("<PotentialReferenceClock>0</PotentialReferenceClock>"));
  EXPECT_THAT(change.added, ElementsAre("<PotentialReferenceClock>1</PotentialReferenceClock>"));
}

TEST(DcLines, ACycleIsItsRegisterAndItsElement) {
  const auto change = edited([](Project& project) { project.slaves[2].dc.sync0.cycle_factor = 2; });
  EXPECT_THAT(values(change.added, "CycleTime0"), ElementsAre("2000000"));
  EXPECT_THAT(values(change.added, "Data"), ElementsAre("80841e0000000000"));
  EXPECT_THAT(change.removed, testing::SizeIs(2));
  EXPECT_THAT(change.added, testing::SizeIs(2));
}

TEST(DcLines, AShiftIsItsRegisterAndItsElement) {
  const auto change = edited([](Project& project) { project.slaves[2].dc.sync0.shift = 250'000; });
  EXPECT_THAT(values(change.added, "ShiftTime"), ElementsAre("250000"));
  EXPECT_THAT(values(change.added, "Data"), ElementsAre("90d0030000000000"));
  EXPECT_THAT(change.removed, testing::SizeIs(2));
  EXPECT_THAT(change.added, testing::SizeIs(2));
}

TEST(DcLines, Sync1IsTheSecondHalfOfItsRegisterAndItsElement) {
  const auto with_sync1 = [](Project& project) {
    for (auto& slave : project.slaves) {
      if (slave.device.dc) slave.device.dc->op_modes.front().assign_activate = 0x0700;
    }
  };
  Project before = machine();
  with_sync1(before);
  Project after = before;
  after.slaves[2].dc.sync1.shift = 125'000;
  const auto change = changes(before, after);
  EXPECT_THAT(values(change.added, "CycleTime1"), ElementsAre("125000"));
  EXPECT_THAT(values(change.added, "Data"), ElementsAre("40420f0048e80100"));
  EXPECT_THAT(change.removed, testing::SizeIs(2));
  EXPECT_THAT(change.added, testing::SizeIs(2));
}

/// The Ado of each command among lines of which nothing but whole commands and elements is left.
TEST(DcLines, ASlaveWithoutModeHasNone) {
  const auto change = edited([](Project& project) { select_op_mode(project.slaves[2], ""); });
  EXPECT_THAT(change.added, IsEmpty());
  EXPECT_THAT(values(change.removed, "Ado"),
              testing::UnorderedElementsAre("2432", "2432", "2432", "2432", "2464", "2448", "2472"));
  EXPECT_THAT(values(change.removed, "ReferenceClock"), ElementsAre("0"));
  EXPECT_THAT(values(change.removed, "CycleTime0"), ElementsAre("1000000"));
  EXPECT_EQ(std::ranges::count(change.removed, "<InitCmd>"), std::ranges::count(change.removed, "</InitCmd>"));
}

TEST(DcLines, WithoutDcThereIsNone) {
  const auto change = edited([](Project& project) {
    project.master.dc.sync_window.enabled = true;
    project.master.dc.enabled = false;
  });
  EXPECT_THAT(change.added, IsEmpty());
  // Nothing but DC registers was taken out ...
  for (const auto& ado : values(change.removed, "Ado")) {
    EXPECT_TRUE(std::stoi(ado) >= 0x900 && std::stoi(ado) < 0xA00) << ado;
  }
  // ... and none is left but in the commands of the master, which every tool writes.
  Project off = machine();
  off.master.dc.enabled = false;
  const auto config = compile(off).value().config;
  for (const auto& slave : config.slaves) {
    EXPECT_FALSE(slave.dc);
    for (const auto& cmd : slave.init_cmds) EXPECT_TRUE(cmd.ado < 0x900 || cmd.ado >= 0xA00) << cmd.comment;
  }
  for (const auto& cmd : config.cyclic[0].frames[0].commands) {
    EXPECT_TRUE(is_logical(cmd.command) || cmd.ado < 0x900) << cmd.comment;
  }
}

TEST(DcLines, WhatIsOnlyForTheRunningMasterWritesNone) {
  const auto change = edited([](Project& project) {
    project.master.dc.sync_window.settle_time_ms = 3000;
    project.master.dc.sync_window.exponent = 9;
    project.master.dc.burst_total = 500;
    project.master.dc.delay_rounds = 5;
    project.master.dc.start_time_safety = 20 * kMillisecond;
    project.master.dc.loop.speed_counter_start = 0x0800;
  });
  EXPECT_THAT(change.removed, IsEmpty());
  EXPECT_THAT(change.added, IsEmpty());
}

/// What only could lead the clocks has no times of its own; whoever has SYNC signals, or leads, has them.
TEST(EniDcLines, TimesBelongToThoseWhoUseTheClock) {
  const auto text_of = [](const SlaveDcConfig& dc) {
    NetworkConfig config;
    config.slaves.emplace_back().dc = dc;
    return write_eni(config);
  };
  SlaveDcConfig dc;
  dc.potential_reference_clock = true;
  EXPECT_THAT(text_of(dc), testing::Not(testing::HasSubstr("<CycleTime0>")));
  dc.assign_activate = 0x0300;
  EXPECT_THAT(text_of(dc), testing::HasSubstr("<CycleTime0>0<"));
  dc.assign_activate = 0;
  dc.reference_clock = true;
  EXPECT_THAT(text_of(dc), testing::HasSubstr("<CycleTime0>0<"));
}

}  // namespace
}  // namespace syncline::eni
