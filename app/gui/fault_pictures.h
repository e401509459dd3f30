// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {
class MainWindow;
class Workspace;
}  // namespace syncline::ui

namespace syncline {

/// Runs each scenario of the folder `scenarios` (*.toml) for eleven seconds on the virtual clock, its sync window
/// monitored, and writes a picture of the overview to `folder`, named as the scenario. False when there is none, when
/// one did not go online or a file could not be written; stderr says which.
bool renderFaultPictures(ui::MainWindow& window, ui::Workspace& workspace, const QString& scenarios,
                         const QString& folder);

}  // namespace syncline
