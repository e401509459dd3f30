// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <cstdint>
#include <optional>

#include "support/types.h"

namespace syncline::ui {

struct RequestOutcome;

class Workspace;

/// What a slave of the running bus has in the registers of its SYNC unit, asked again and again beside the cycle.
class DcReadBack final : public QObject {
  Q_OBJECT

 public:
  /// Between two readings, run time.
  static constexpr Nanoseconds kPeriod = 2 * kSecond;
  struct Registers {
    std::uint16_t activation = 0;          // 0x0980
    std::uint32_t cycle0 = 0, cycle1 = 0;  // 0x09A0, 0x09A4, ns
    bool operator==(const Registers&) const = default;
  };

  explicit DcReadBack(Workspace& workspace, QObject* parent = nullptr);
  /// Asks when it is time; once a tick while the slave (of the project) is shown. `now`: of the run.
  void tick(int slave, Nanoseconds now);
  /// Of that slave; nothing before it has answered, and when it is not there or has no such registers.
  [[nodiscard]] const std::optional<Registers>& registers() const { return registers_; }

 private:
  void forget();
  void take(const RequestOutcome& outcome);

  Workspace& workspace_;
  std::optional<std::uint16_t> station_;  // whose they are
  std::optional<Registers> registers_;
  Nanoseconds next_ = 0;
  bool asked_ = false;
};

}  // namespace syncline::ui
