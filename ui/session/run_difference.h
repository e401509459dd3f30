// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

#include "compare/compare_configs.h"

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::ui {

class ConfigurationMonitor;
class LiveSession;
class ProjectDocument;

/// What the project would do otherwise than the machine that runs: editing does not touch it. Names and comments do not
/// count.
class RunDifference final : public QObject {
  Q_OBJECT

 public:
  RunDifference(ProjectDocument& document, ConfigurationMonitor& configuration, LiveSession& live,
                QObject* parent = nullptr);

  /// Something runs and the project is not that.
  [[nodiscard]] bool differs() const { return differs_; }
  /// See changesOf(); 0 where something else differs, like the description of a device.
  [[nodiscard]] int changes() const;
  /// The project from which the machine was started, with what was applied since.
  [[nodiscard]] const Project& running() const;
  /// All of it can be given to the machine while it runs, which is not taking it just now.
  [[nodiscard]] bool applicable() const { return applicable_; }
  /// Gives it to the machine; nothing when not applicable().
  void apply();

 Q_SIGNALS:
  void changed();

 private:
  void look();

  ProjectDocument& document_;
  ConfigurationMonitor& configuration_;
  LiveSession& live_;
  std::vector<ConfigDifference> network_;
  bool differs_ = false, applicable_ = false;
};

}  // namespace syncline::ui
