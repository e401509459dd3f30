// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>
#include <vector>

#include "diagnosis/run_diagnosis.h"
#include "trace/run_report.h"

namespace syncline::ui {

class LiveSession;

/// What the running bus means, renewed once a second from the same rules as `synclinectl run`. What a run showed stays
/// until the next one begins.
class RunFindings final : public QObject {
  Q_OBJECT

 public:
  explicit RunFindings(LiveSession& live, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  /// Looks at once, for tests and for the end of a run.
  void refresh();

 Q_SIGNALS:
  void findingsChanged();

 private:
  void begin();

  LiveSession& live_;
  QTimer timer_;
  std::optional<RunRecorder> recorder_;
  Snapshot last_;  // the window forgets it when it goes offline
  bool news_ = false;
  std::vector<Finding> findings_;
};

}  // namespace syncline::ui
