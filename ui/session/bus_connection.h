// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>

#include "link/link.h"
#include "support/clock.h"
#include "support/result.h"
#include "ui/session/eeprom_repair.h"

namespace syncline::ui {

/// A link and the clock it runs on. The clock outlives the link.
struct BusConnection {
  std::unique_ptr<Clock> clock;
  std::unique_ptr<Link> link;
};

/// Opens a LINK text ("sim:FILE", "nic:NAME"). Called from the window's thread and from the scan's.
using LinkOpener = std::function<Result<BusConnection>(const QString& link)>;

/// What the program that hosts the window knows and the window does not: given once at construction.
struct Environment {
  LinkOpener open_link;
  QString demo_link;          // LINK of the demonstration machine
  QStringList esi_folders;    // where the device descriptions lie
  QString version;
  EepromRepairs eeprom_repairs{};  // none: nothing is offered
};

}  // namespace syncline::ui
