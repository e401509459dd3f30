// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "compare/compare_configs.h"
#include "compare/compare_settings.h"
#include "config/project.h"
#include "protocol/coe.h"
#include "support/result.h"
#include "ui/session/bus_connection.h"

namespace syncline::ui {

/// One of the two that are compared.
struct ComparedSide {
  enum class Kind : std::uint8_t { kProject, kRunning, kFile, kBus };
  Kind kind = Kind::kProject;
  QString path{};  // of a kFile; the LINK of a kBus
  bool operator==(const ComparedSide&) const = default;
};

/// What two of them have otherwise.
struct Compared {
  std::vector<ConfigDifference> network;    // what a machine does otherwise
  std::vector<SettingDifference> settings;  // where both are projects
  std::vector<std::string> names;           // of the left project's slaves
  std::vector<Finding> unread;              // what of a bus could not be read
};

/// Changes of a project, for people: settings that matter, and slaves that came, went or changed their places; not what
/// follows from these in the network.
[[nodiscard]] int changesOf(const std::vector<SettingDifference>& settings,
                            const std::vector<ConfigDifference>& network);

/// Compares projects, files, what runs and buses in a thread of its own. One comparison at a time.
class Comparison final : public QObject {
  Q_OBJECT

 public:
  /// `compare_bus`: may be empty, then no side is a bus.
  explicit Comparison(BusComparer compare_bus, QObject* parent = nullptr);
  ~Comparison() override;

  /// `project`, `running`: what sides of these kinds are now. Only the right side can be a bus. finished() follows
  /// once, also for one that was under way: that one is cancelled, and nobody waits for it.
  void start(const ComparedSide& left, const ComparedSide& right, const Project& project, const Project& running);
  [[nodiscard]] bool isRunning() const { return running_; }
  /// The last one; none before the first, or where it failed.
  [[nodiscard]] const std::optional<Compared>& result() const { return result_; }
  /// Why there is none.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

 Q_SIGNALS:
  void finished();

 private:
  struct Request {
    ComparedSide left, right;
    Project project, running;
  };
  void work(Request request);
  void deliver(Result<Compared> outcome);

  BusComparer compare_bus_;
  std::thread worker_;
  std::atomic<bool> cancelled_{false};
  bool running_ = false;
  std::optional<Request> next_;  // instead of the one under way
  std::optional<Compared> result_;
  std::optional<Error> failure_;
};

}  // namespace syncline::ui
