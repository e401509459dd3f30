// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <functional>

#include "support/types.h"

namespace syncline::ui {
class MainWindow;
class Workspace;
}  // namespace syncline::ui

namespace syncline {

/// Scans a simulated machine and runs it in the window for so much of its time, its sync window monitored, at once and
/// not by the clock on the wall. False when it did not go online within a minute.
bool runForPictures(ui::MainWindow& window, ui::Workspace& workspace, const QString& link, Nanoseconds duration);

/// Lets the window work until something is so; false after a minute.
bool waitUntil(const std::function<bool()>& done);

/// The master's node with the overview in front, up to date.
void showOverview(ui::MainWindow& window);

}  // namespace syncline
