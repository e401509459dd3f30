// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QString>
#include <vector>

#include "support/result.h"

namespace syncline {
struct Machine;
}  // namespace syncline

namespace syncline::ui {

/// Unsaved work as it is kept on the disk: what it is of, and the project file as it would have been saved.
struct KeptWork {
  QString path;       // of the project; "" = never saved
  QDateTime saved;    // when it was kept
  QString last_edit;  // "Change: Alias"
  int slaves = 0;     // of the first network
};

/// What a window that is gone has left.
struct LostWork {
  QString file;
  KeptWork work;
};

/// The file is whole or not there. Any thread.
[[nodiscard]] Status keepWork(const QString& file, const KeptWork& work, const Machine& machine);
[[nodiscard]] Result<KeptWork> readWork(const QString& file);
[[nodiscard]] Result<Machine> readMachine(const QString& file);

inline constexpr const char* kRecoveryExtension = ".recovery";

}  // namespace syncline::ui
