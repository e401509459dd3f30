// SPDX-License-Identifier: Apache-2.0
// The process image by its variables: values of the running machine, and outputs that are forced.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

#include "support/running_window.h"
#include "ui/models/variable_model.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Slave 0 has an output, slave 1 inputs of every kind.
NetworkConfig imageConfig() {
  NetworkConfig config;
  config.slaves.resize(2);
  config.slaves[0].send = ImageRange{0, 16};
  config.slaves[1].receive = ImageRange{0, 80};
  config.image.output_bytes = 2;
  config.image.input_bytes = 10;
  config.image.outputs = {{"Lamp", "BOOL", "", 1, 3}, {"Own", "DT1234", "", 12, 4}};
  config.image.inputs = {{"Position", "DINT", "in steps", 32, 0},
                         {"Ready", "BOOL", "", 1, 32},
                         {"Mode", "BIT3", "", 3, 33},
                         {"Speed", "REAL", "", 32, 48}};
  return config;
}

ImageContents imageContents() {
  ImageContents image;
  image.cycle = 7;
  image.time = kSecond;
  image.input_bytes = 10;
  image.bytes = {0xFE, 0xFF, 0xFF, 0xFF, 0b1011, 0, 0x00, 0x00, 0x20, 0x40};  // -2, ready, 5, 2.5
  image.bytes.resize(20, 0xFF);                                               // all of them are known
  for (const int byte : {0x58, 0x12, 0x08, 0x00}) image.bytes.push_back(static_cast<std::uint8_t>(byte));
  return image;
}

class VariableRows : public ::testing::Test {
 protected:
  VariableRows() : tester_(&model_, QAbstractItemModelTester::FailureReportingMode::Fatal) {}
  QString cell(int row, VariableModel::Column column) { return model_.index(row, column).data().toString(); }

  VariableModel model_;
  QAbstractItemModelTester tester_;
};

TEST_F(VariableRows, ShowTheirValuesByType) {
  model_.setVariables(imageConfig(), std::nullopt);
  ASSERT_EQ(model_.rowCount(), 6);
  EXPECT_EQ(cell(0, VariableModel::kValue), QStringLiteral("\u2013")) << "nothing is known yet";
  const auto image = imageContents();
  model_.setImage(&image, {false, false});
  EXPECT_EQ(cell(0, VariableModel::kValue), QStringLiteral("-2"));
  EXPECT_EQ(cell(0, VariableModel::kRaw), QStringLiteral("0xFFFFFFFE"));
  EXPECT_EQ(cell(1, VariableModel::kValue), QStringLiteral("1"));
  EXPECT_EQ(cell(2, VariableModel::kValue), QStringLiteral("5"));
  EXPECT_EQ(cell(3, VariableModel::kValue), QStringLiteral("2.5"));
  EXPECT_EQ(cell(3, VariableModel::kPlace), QStringLiteral("6.0"));
  EXPECT_EQ(cell(4, VariableModel::kValue), QStringLiteral("1"));
  EXPECT_EQ(cell(4, VariableModel::kForced), QStringLiteral("forced"));
  EXPECT_EQ(model_.value(5), (Bytes{0x25, 0x01})) << "bytes of a type of the device's own";
  EXPECT_EQ(cell(5, VariableModel::kForced), QString());
}

TEST_F(VariableRows, NoInputIsShownThatIsNotKnownNow) {
  model_.setVariables(imageConfig(), std::nullopt);
  auto image = imageContents();
  model_.setImage(&image, {false, true});
  EXPECT_EQ(cell(0, VariableModel::kValue), QStringLiteral("\u2013")) << "its slave is silent";
  EXPECT_EQ(cell(4, VariableModel::kValue), QStringLiteral("1")) << "outputs are the master's own";
  EXPECT_EQ(model_.unknownInputs(), 4);
  image.bytes[10 + 4] = 0;
  image.cycle = 8;
  model_.setImage(&image, {false, false});
  EXPECT_EQ(cell(0, VariableModel::kValue), QStringLiteral("-2"));
  EXPECT_EQ(cell(1, VariableModel::kValue), QStringLiteral("\u2013")) << "its byte does not come back";
  EXPECT_EQ(model_.unknownInputs(), 2);
  model_.setImage(nullptr, {});
  EXPECT_EQ(cell(4, VariableModel::kValue), QStringLiteral("\u2013"));
  EXPECT_EQ(cell(4, VariableModel::kForced), QString());
}

TEST_F(VariableRows, AreThoseOfASlaveAndStaySelectedWhereTheyStay) {
  QSignalSpy resets(&model_, &QAbstractItemModel::modelReset);
  model_.setVariables(imageConfig(), 1);
  EXPECT_EQ(model_.rowCount(), 4);
  model_.setVariables(imageConfig(), 1);
  EXPECT_EQ(resets.count(), 1);
  model_.setVariables(imageConfig(), 0);
  EXPECT_EQ(model_.rowCount(), 2);
  EXPECT_TRUE(model_.row(1)->output);
  EXPECT_FALSE(model_.row(2));
}

TEST_F(VariableRows, BitsBeyondTheImageAreNone) {
  const Bytes image{0x0F, 0xF0};
  EXPECT_EQ(bitsOf(image, 2, 12), (Bytes{0x03, 0x0C}));
  EXPECT_TRUE(bitsOf(image, 12, 5).empty());
}

class Variables : public test::RunningWindow {
 protected:
  QTableView& table() { return field<QTableView>("variableTable"); }
  /// Of the row that has all of these words in its name; selects it.
  QString value(const QString& words) {
    field<QLineEdit>("variableSearch").setText(words);
    EXPECT_EQ(table().model()->rowCount(), 1) << qPrintable(words);
    table().setCurrentIndex(table().model()->index(0, 0));
    return table().model()->index(0, VariableModel::kValue).data().toString();
  }
  QString hint() { return field<ValueLabel>("variablesHint").text(); }
};

TEST_F(Variables, StandInTheImageAlsoOffline) {
  load();
  show(-1, "variablesPage");
  const int all = table().model()->rowCount();
  EXPECT_GT(all, 20);
  window_.findChild<QAction*>(QStringLiteral("variablesInputs"))->trigger();
  const int inputs = table().model()->rowCount();
  window_.findChild<QAction*>(QStringLiteral("variablesOutputs"))->trigger();
  EXPECT_EQ(inputs + table().model()->rowCount(), all);
  window_.findChild<QAction*>(QStringLiteral("variablesForced"))->trigger();
  EXPECT_EQ(table().model()->rowCount(), 0);
  EXPECT_TRUE(hint().contains(QStringLiteral("while the machine runs"))) << qPrintable(hint());
  EXPECT_FALSE(field<QPushButton>("variableForce").isEnabled());
  show(kServo, "variablesPage");
  window_.findChild<QAction*>(QStringLiteral("variablesAll"))->trigger();
  EXPECT_LT(table().model()->rowCount(), all);
  EXPECT_GT(table().model()->rowCount(), 2);
}

TEST_F(Variables, OfASlaveAreForcedAfterAQuestionAndReleased) {
  goOnline();
  show(kServo, "variablesPage");
  run(300 * kMillisecond);
  EXPECT_TRUE(hint().startsWith(QStringLiteral("Cycle"))) << qPrintable(hint());
  const auto status = value(QStringLiteral("statusword")).toUInt();
  EXPECT_EQ(status & 0x6FU, 0x40U) << "switch on disabled";
  EXPECT_EQ(value(QStringLiteral("controlword")), QStringLiteral("0"));
  auto& force = field<QPushButton>("variableForce");
  EXPECT_FALSE(force.isEnabled()) << "nothing is typed";
  auto& typed = field<QLineEdit>("variableValue");
  typed.setText(QStringLiteral("70000"));
  EXPECT_FALSE(force.isEnabled()) << "no UINT";
  typed.setText(QStringLiteral("0x6"));
  EXPECT_TRUE(force.isEnabled());
  answerQuestion("forceQuestion", false);
  force.click();
  run(300 * kMillisecond);
  EXPECT_EQ(value(QStringLiteral("controlword")), QStringLiteral("0")) << "the question was not agreed to";
  typed.setText(QStringLiteral("0x6"));
  answerQuestion("forceQuestion", true);
  force.click();
  run(300 * kMillisecond);
  EXPECT_EQ(value(QStringLiteral("controlword")), QStringLiteral("6"));
  auto& pill = field<Pill>("statusForced");
  EXPECT_TRUE(pill.isVisible());
  EXPECT_TRUE(pill.text().contains(QStringLiteral("16"))) << qPrintable(pill.text());
  EXPECT_EQ(value(QStringLiteral("statusword")).toUInt() & 0x6FU, 0x21U) << "ready to switch on";
  field<QLineEdit>("variableSearch").clear();
  window_.findChild<QAction*>(QStringLiteral("variablesForced"))->trigger();
  EXPECT_EQ(table().model()->rowCount(), 1);
  field<QPushButton>("variableReleaseAll").click();
  run(300 * kMillisecond);
  EXPECT_EQ(table().model()->rowCount(), 0) << "the list follows";
  EXPECT_FALSE(pill.isVisible());
  window_.findChild<QAction*>(QStringLiteral("variablesAll"))->trigger();
  EXPECT_EQ(value(QStringLiteral("controlword")), QStringLiteral("0"));
}

TEST_F(Variables, AreNotKnownOfASlaveThatStopsExchanging) {
  goOnline();
  show(kServo, "variablesPage");
  run(300 * kMillisecond);
  ASSERT_NE(value(QStringLiteral("statusword")), QStringLiteral("\u2013"));
  workspace_.live().requestState(AlState::kPreop);
  run(kSecond);
  EXPECT_EQ(value(QStringLiteral("statusword")), QStringLiteral("\u2013"));
  workspace_.live().shutDown();
  QApplication::processEvents();
  EXPECT_EQ(value(QStringLiteral("controlword")), QStringLiteral("\u2013"));
  EXPECT_TRUE(hint().contains(QStringLiteral("while the machine runs"))) << qPrintable(hint());
}

}  // namespace
}  // namespace syncline::ui
