// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QMetaType>
#include <QString>
#include <memory>
#include <vector>

#include "findings/finding.h"

namespace syncline::ui {

using syncline::Severity;

inline constexpr int kRecordedRun = -1;

/// One line of the message window.
struct Message {
  QDateTime time;  // time of day: of this computer, or in a recording of the run's clock
  Severity severity = Severity::kNote;
  QString source;  // "Master", "Slave_1002", "Configuration", "Scan" ...
  QString text;
  int slave = -1;     // node to go to, -1 = master
  QString key;        // settings key of a finding
  qint64 moment = 0;  // host clock, ns: of an event of a run; 0: none
  int run = 0;        // which run of this window the moment is of; 0: none, kRecordedRun: of the recording shown
  std::shared_ptr<const Finding> finding{};  // about the project; null of anything else
  std::vector<int> found_at{};               // slaves of which it was found alike
};

}  // namespace syncline::ui

Q_DECLARE_METATYPE(syncline::ui::Message)
