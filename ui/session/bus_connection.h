// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "channels/background_master.h"
#include "eni/project_builder.h"
#include "support/result.h"
#include "ui/session/eeprom_repair.h"

namespace syncline::ui {

/// Makes a master on the bus behind a LINK text ("sim:FILE", "nic:NAME"). Called from the window's thread and from the
/// scan's.
using MasterOpener = std::function<Result<std::unique_ptr<BackgroundMaster>>(const QString& link)>;

/// Completes the slaves of a scan of `link` that have no ESI with what they tell themselves; what could not be read is
/// a warning of the project. Called from the scan's thread; ends early when `cancelled`.
using SlaveDescriber =
    std::function<Status(eni::BuiltProject& built, const QString& link, const std::atomic<bool>& cancelled)>;

/// A network adapter that can carry EtherCAT.
struct NetworkAdapter {
  QString name;         // "eth0"
  QString description;  // "" when unknown
  bool up = false;      // interface up and carrier present
};
using AdapterLister = std::function<Result<std::vector<NetworkAdapter>>()>;

/// What the program that hosts the window knows and the window does not: given once at construction.
struct Environment {
  MasterOpener open_master;
  SlaveDescriber describe_slaves{};  // none: slaves stay as their EEPROM describes them
  AdapterLister list_adapters{};     // none: there are no network adapters
  QString demo_link;                 // LINK of the demonstration machine
  QStringList esi_folders;           // where the device descriptions lie
  QString version;
  EepromRepairs eeprom_repairs{};  // none: nothing is offered
};

}  // namespace syncline::ui
