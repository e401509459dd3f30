// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {
class MainWindow;
class Workspace;
}  // namespace syncline::ui

namespace syncline {

/// Runs the demonstration machine on the virtual clock and writes a picture of every page in both themes
/// to `folder`. False when the machine did not get in sync or a file could not be written.
bool renderScreenshots(ui::MainWindow& window, ui::Workspace& workspace, const QString& link, const QString& folder);

}  // namespace syncline
