// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace syncline::ui {

/// A name for a file of a run: without what no file system has in a name, or no shell likes, and not too long.
[[nodiscard]] QString runFileName(QString text);

}  // namespace syncline::ui
