// SPDX-License-Identifier: Apache-2.0
#include "ui/session/scan_controller.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <algorithm>

#include "support/ui_test_support.h"

namespace syncline {
namespace {

/// With a device catalogue that knows nothing.
class ScanWithoutEsi : public ::testing::Test {
 protected:
  ScanWithoutEsi() : before_(qgetenv("XDG_CACHE_HOME")) { qputenv("XDG_CACHE_HOME", cache_.path().toUtf8()); }
  ~ScanWithoutEsi() override { qputenv("XDG_CACHE_HOME", before_); }

 private:
  QTemporaryDir cache_;
  QByteArray before_;
};

TEST_F(ScanWithoutEsi, SlavesTellWhatTheyAre) {
  const auto environment = test::virtualEnvironment();
  ui::ScanController scan(environment.scan_bus, environment.describe_slaves, {});
  std::optional<eni::BuiltProject> built;
  QObject::connect(&scan, &ui::ScanController::finished, &scan,
                   [&built](const QString&, const ui::ScanOutcome& found) { built = found.built; });
  scan.start(environment.demo_link);
  ASSERT_TRUE(test::waitFor([&scan] { return !scan.isRunning(); }));
  ASSERT_TRUE(built);
  ASSERT_GT(built->project.slaves.size(), 3U);
  const auto& servo = built->project.slaves[3].device;
  EXPECT_EQ(servo.source, "SII");
  EXPECT_NE(std::ranges::find(servo.dictionary, 0x6040, &ObjectDescription::index), servo.dictionary.end());
  ASSERT_FALSE(servo.rx_pdos.empty());
  ASSERT_FALSE(servo.rx_pdos.front().entries.empty());
  EXPECT_EQ(servo.rx_pdos.front().entries.front().name, "Controlword");
}

}  // namespace
}  // namespace syncline
