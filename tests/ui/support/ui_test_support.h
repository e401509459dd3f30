// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QString>
#include <QTest>
#include <QWidget>
#include <functional>

#include "app/gui/bus_functions.h"
#include "config/project.h"
#include "ui/widgets/wait_until.h"

namespace syncline::test {

/// The environment of the program, with the demonstration machine on the virtual clock.
inline ui::Environment virtualEnvironment() {
  ui::Environment environment;
  connect_buses(environment);
  environment.version = QStringLiteral("test");
  return environment;
}

/// For what other threads do; a sanitizer makes them as much slower.
#if defined(SYNCLINE_SANITIZED)
inline constexpr qint64 kPatienceMs = 60'000;
#else
inline constexpr qint64 kPatienceMs = 10'000;
#endif

/// Runs the event loop until `done`; false when that takes too long.
inline bool waitFor(const std::function<bool()>& done) { return ui::waitUntil(done, kPatienceMs); }

/// Finds a control by its object name; fails the test when there is none.
template <class Widget>
Widget* find(QWidget& root, const char* name) {
  auto* widget = root.findChild<Widget*>(QLatin1String(name));
  EXPECT_NE(widget, nullptr) << "no widget " << name;
  return widget;
}

/// As a user does it: all of the field is replaced, Enter takes it. Empty text: nothing is replaced.
inline void type(QWidget& field, const QString& text, bool enter = true) {
  field.setFocus();
  if (!text.isEmpty()) {
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
  }
  if (enter) QTest::keyClick(&field, Qt::Key_Return);
}

/// Two drives with distributed clocks and a coupler without, made by hand.
inline Project smallProject() {
  DeviceDescription coupler;
  coupler.identity = {2, 0x044C2C52, 0x00110000, 0};
  coupler.type = "Coupler";
  coupler.name = "Coupler";
  DeviceDescription drive;
  drive.identity = {0x539, 0x02200301, 0x00040000, 0};
  drive.type = "Drive";
  drive.name = "Servo drive";
  drive.dc = DcDescription{};
  DcOpMode mode;
  mode.name = "DC";
  mode.description = "DC synchronous";
  mode.assign_activate = 0x0300;
  mode.cycle_time_sync0.factor = 1;
  drive.dc->op_modes = {mode};
  const auto pdo = [](std::uint16_t index, const char* name, std::vector<std::uint16_t> exclude) {
    Pdo result;
    result.index = index;
    result.name = name;
    result.sync_manager = 2;
    result.exclude = std::move(exclude);
    result.entries = {{0x6040, 0, 16, "Controlword", "UINT"}, {0, 0, 8, "", ""}, {0x607A, 0, 32, "Target", "DINT"}};
    return result;
  };
  drive.rx_pdos = {pdo(0x1600, "Position", {0x1601}), pdo(0x1601, "Velocity", {0x1600}), pdo(0x1602, "Extra", {})};
  Project project;
  project.slaves.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    auto& slave = project.slaves[i];
    slave.device = i == 0 ? coupler : drive;
    slave.name = "Slave_" + std::to_string(1001 + i);
    slave.station_address = static_cast<std::uint16_t>(1001 + i);
    if (i > 0) {
      slave.previous = PreviousPort{static_cast<std::uint16_t>(i - 1), 1};
      slave.dc.op_mode = "DC";
      slave.assigned_rx_pdos = {0x1600};
    }
  }
  return project;
}

}  // namespace syncline::test
