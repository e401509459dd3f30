// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "support/result.h"

namespace syncline {
struct Finding;
}  // namespace syncline

namespace syncline::ui {

class Workspace;

/// Writes the ENI of the project as it is now, in the dialect of its preview, with its report where that is wanted:
/// both or none. Fails when the project cannot be compiled
/// or the file cannot be written; findings of severity error do not stop it (the messages show them).
/// kFileNotWritable, too, where one of them is a file that is open here (held_file.h).
/// Returns what the checker finds wrong in what was written.
[[nodiscard]] Result<std::vector<Finding>> exportEni(Workspace& workspace, const QString& path);

/// Where the report of an ENI goes: "m.report.html" beside "m.eni.xml" or "m.xml".
[[nodiscard]] QString reportFile(const QString& path);

}  // namespace syncline::ui
