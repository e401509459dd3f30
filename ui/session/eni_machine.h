// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>

#include "support/result.h"

namespace syncline {
struct RecoveredProject;
}  // namespace syncline

namespace syncline::ui {

class DeviceCatalogue;

/// Reads an ENI and makes a project of what it lets be seen, with the devices that the catalogue has of it. An error
/// comes at once; `then` is called later, in the window's thread, unless `context` is gone.
[[nodiscard]] Status readEniMachine(const QString& path, DeviceCatalogue& catalogue, QObject* context,
                                    std::function<void(RecoveredProject)> then);

}  // namespace syncline::ui
