// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <vector>

namespace syncline {
struct NetworkConfig;
struct Project;
}  // namespace syncline

namespace syncline::ui {

class LiveSession;
class ProjectDocument;

/// The slave of `project` that stands at `position` of what runs; -1: none any more.
[[nodiscard]] int slaveOf(const Project& project, const NetworkConfig& running, int position);

/// Where each slave of `project` stands in what runs; -1: nowhere.
[[nodiscard]] std::vector<int> positionsIn(const Project& project, const NetworkConfig& running);

/// Which slave of the project is which of the run: by station address and identity, because the project may have been
/// edited since, and slaves may have come, gone or changed places in it.
class RunningSlaves final : public QObject {
  Q_OBJECT

 public:
  RunningSlaves(const ProjectDocument& document, const LiveSession& live);

  /// Position in the run that goes on, or was the last one, of each slave of the project; -1: it does not run.
  [[nodiscard]] const std::vector<int>& positions() const;
  [[nodiscard]] int positionOf(int slave) const;
  /// The slave of the project at that position of the run; -1: there is none any more.
  [[nodiscard]] int slaveOf(int position) const;

 private:
  void find() const;

  const ProjectDocument& document_;
  const LiveSession& live_;
  mutable bool stale_ = true;
  mutable std::vector<int> positions_, slaves_;
};

}  // namespace syncline::ui
