// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "channels/slave_evidence.h"
#include "ui/models/count_history.h"

namespace syncline {
struct Project;
struct Snapshot;
}  // namespace syncline

namespace syncline::ui {

/// One end of a cable, and what its port counted since going online.
struct CableEnd {
  struct Reading {
    PortErrors errors;
    Nanoseconds age = 0;
    std::array<std::uint32_t, kCountersOfPort> growth{};  // in CountHistory::kSpan
  };
  int slave = -1, port = 0;        // of the project; -1: the master's adapter, which counts nothing
  std::optional<Reading> reading;  // nothing: offline, not read yet, or the slave does not answer
};

enum class CableDamage : std::uint8_t {
  kNone,
  kForwarded,  // nothing but errors that were marked further in front
  kHere,       // frames damaged on it, or links lost
  kFirst,      // and before all others
};

/// What is shown at a cable.
struct CableBadge {
  CableDamage damage = CableDamage::kNone;
  std::uint32_t count = 0;  // damaged frames at both ends; else lost links; else forwarded errors
  bool at_least = false;
  int slave = -1;  // whose counters tell most
  bool operator==(const CableBadge&) const = default;
};

/// The error counters of the ports (0x0300 to 0x0313) as the cables between them: of the slaves that answer in the run
/// that goes on, and of nothing else. A cable is that by which a slave hangs.
class CableCounters final : public QObject {
  Q_OBJECT

 public:
  void setProject(const Project& project);
  /// `positions`: of each slave in the snapshot; -1: it is not in it.
  void setSnapshot(const Snapshot& snapshot, const std::vector<int>& positions);
  [[nodiscard]] CableBadge badge(int slave) const;
  /// The end towards the master first. None: nobody knows the slave's cable.
  [[nodiscard]] std::vector<CableEnd> ends(int slave) const;

 Q_SIGNALS:
  /// Other badges.
  void changed();

 private:
  struct Plug {
    int slave = -1, port = 0;
    bool operator==(const Plug&) const = default;
  };
  struct Cable {
    Plug near, far;
    bool operator==(const Cable&) const = default;
  };
  using Ports = std::array<PortErrors, 4>;
  struct Read {
    Ports ports;
    Nanoseconds age = 0;
  };
  void read(const Snapshot& snapshot, const std::vector<int>& positions);
  void follow(Nanoseconds now);
  [[nodiscard]] CableBadge judge(const Cable& cable, const Plug& first) const;
  [[nodiscard]] const PortErrors* errorsAt(const Plug& plug) const;

  std::vector<std::optional<Cable>> cables_;  // of each slave
  std::vector<std::optional<Read>> reads_;    // of each slave
  std::vector<CableBadge> badges_;
  std::map<int, CountHistory> histories_;  // of those that counted something
  std::optional<Nanoseconds> seen_;        // the snapshot before
};

/// "12", or "≥255".
[[nodiscard]] QString badgeText(const CableBadge& badge);

}  // namespace syncline::ui
