// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <vector>

#include "protocol/al_state.h"

class QMenu;
class QWidget;

namespace syncline::ui {

class Workspace;
struct RequestOutcome;

/// Leads one slave of the running bus to a state, or acknowledges its error, while the others stay where they are; asks
/// before a machine is hurt.
class SlaveStateCommands final : public QObject {
  Q_OBJECT

 public:
  SlaveStateCommands(Workspace& workspace, QWidget& window, QObject* parent = nullptr);

  /// Those that the slave can have: BOOT where it takes files.
  [[nodiscard]] std::vector<AlState> states(int slave) const;
  /// Why nothing can be requested of it now; empty when it can.
  [[nodiscard]] QString obstacle(int slave) const;
  /// Its AL status shows an error.
  [[nodiscard]] bool failed(int slave) const;
  void request(int slave, AlState state);
  void acknowledge(int slave);
  /// Entries for all of that, switched off where it cannot be.
  void addTo(QMenu& menu, int slave);

 Q_SIGNALS:
  /// What became of it, in words; of the slave of the project that it is by then.
  void told(int slave, const QString& text, bool bad);

 private:
  [[nodiscard]] QString consequence(int slave, AlState state) const;
  void tell(std::uint16_t position, const RequestOutcome& outcome, const QString& done);

  Workspace& workspace_;
  QWidget& window_;
};

}  // namespace syncline::ui
