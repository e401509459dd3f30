// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <tuple>

#include "tests/support/diagnosed_run.h"
#include "tests/support/small_machines.h"

namespace syncline::test {

/// Two monitored axes in each mode and cycle of a suite.
class TwoAxesRun : public ::testing::TestWithParam<std::tuple<DcmMode, Nanoseconds>> {
 protected:
  DiagnosedRun machine;
  void SetUp() override {
    add_two_axes(machine.network);
    auto& master = machine.network.project.master;
    std::tie(master.dc.dcm.mode, master.cycle_time) = GetParam();
    master.dc.sync_window.enabled = true;
  }
};

}  // namespace syncline::test
