// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QMetaType>
#include <QString>

namespace syncline::ui {

enum class Severity : unsigned char { kInfo, kWarning, kError };

/// One line of the message window.
struct Message {
  QDateTime time;
  Severity severity = Severity::kInfo;
  QString source;  // "Master", "Slave_1002", "Configuration", "Scan" ...
  QString text;
  int slave = -1;  // node to go to, -1 = master
  QString key;     // settings key of a finding
};

}  // namespace syncline::ui

Q_DECLARE_METATYPE(syncline::ui::Message)
