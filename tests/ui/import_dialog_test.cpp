// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/import_dialog.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>

#include "support/ui_test_support.h"

namespace syncline::ui {
namespace {

using test::find;

TEST(ImportDialog, TakesAllUnlessToldOtherwise) {
  const ImportDialog dialog(QStringLiteral("/captures/machine.pcapng"));
  const auto limits = dialog.limits();
  EXPECT_EQ(limits.from, 0);
  EXPECT_EQ(limits.until, 0);
  EXPECT_EQ(limits.most_frames, 0U);
  EXPECT_EQ(limits.deviation_ns, 0U);
  EXPECT_EQ(limits.dcm_error_ns, 0);
}

TEST(ImportDialog, SaysAPartOfTheFileAndWhatItIsHeldAgainst) {
  ImportDialog dialog(QStringLiteral("/captures/machine.pcapng"));
  find<QDoubleSpinBox>(dialog, "importFrom")->setValue(1.5);
  find<QDoubleSpinBox>(dialog, "importUntil")->setValue(2.25);
  find<QSpinBox>(dialog, "importFrames")->setValue(7000);
  find<QDoubleSpinBox>(dialog, "importDeviationLimit")->setValue(0.1);
  find<QDoubleSpinBox>(dialog, "importErrorLimit")->setValue(4);
  const auto limits = dialog.limits();
  EXPECT_EQ(limits.from, 1'500 * kMillisecond);
  EXPECT_EQ(limits.until, 2'250 * kMillisecond);
  EXPECT_EQ(limits.most_frames, 7'000U);
  EXPECT_EQ(limits.deviation_ns, 100U);
  EXPECT_EQ(limits.dcm_error_ns, 4'000);
}

TEST(ImportDialog, AnEndBeforeTheBeginIsNotTaken) {
  ImportDialog dialog(QStringLiteral("machine.pcap"));
  auto* accept = find<QPushButton>(dialog, "importAccept");
  find<QDoubleSpinBox>(dialog, "importFrom")->setValue(3);
  EXPECT_TRUE(accept->isEnabled()) << "to the end of the file";
  find<QDoubleSpinBox>(dialog, "importUntil")->setValue(2);
  EXPECT_FALSE(accept->isEnabled());
  find<QDoubleSpinBox>(dialog, "importUntil")->setValue(4);
  EXPECT_TRUE(accept->isEnabled());
}

}  // namespace
}  // namespace syncline::ui
