// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <vector>

#include "findings/finding.h"

namespace syncline::ui {

class NetworkRun;

/// What the running bus means, renewed once a second from the same rules as `synclinectl run`. What a run showed stays
/// until the next one begins.
class RunFindings final : public QObject {
  Q_OBJECT

 public:
  explicit RunFindings(NetworkRun& run, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  /// Looks at once, for tests and for the end of a run.
  void refresh();

 Q_SIGNALS:
  void findingsChanged();

 private:
  NetworkRun& run_;
  QTimer timer_;
  bool news_ = false;
  std::vector<Finding> findings_;
};

}  // namespace syncline::ui
