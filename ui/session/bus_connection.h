// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "channels/background_master.h"
#include "channels/event.h"
#include "channels/values/bus_scan.h"
#include "compare/compare_configs.h"
#include "config/project.h"
#include "support/result.h"
#include "ui/session/eeprom_repair.h"

namespace syncline {
struct ImportedRun;
struct ImportLimits;
}  // namespace syncline

namespace syncline::ui {

/// Makes a master on the bus behind a LINK text ("sim:FILE", "nic:NAME", kMachineItself for that of `machine`). Called
/// from the window's thread.
using MasterOpener =
    std::function<Result<std::unique_ptr<BackgroundMaster>>(const QString& link, const Project& machine)>;

/// Scans the bus behind a LINK text; `look_only`: without writing anything to it. `tell` gets progress and warnings, in
/// the calling thread; ends early when `cancelled`. Called from the scan's thread.
using BusScanner =
    std::function<Result<BusScan>(const QString& link, bool look_only, const std::atomic<bool>& cancelled,
                                  const std::function<void(const Event&)>& tell)>;

/// Completes the slaves of a scan of `link` that have no ESI with what they tell themselves; what could not be read is
/// returned. Called from the scan's thread; ends early when `cancelled`.
using SlaveDescriber = std::function<Result<std::vector<Error>>(Project& project, const QString& link,
                                                                const std::atomic<bool>& cancelled)>;

/// What a configuration (left) and a bus (right) have otherwise, and what of the bus could not be read.
struct BusComparison {
  std::vector<ConfigDifference> differences;
  std::vector<Finding> findings;
};

/// Compares a configuration with the bus behind a LINK text, without writing anything to it. Called from a thread of
/// its own; ends early when `cancelled`.
using BusComparer = std::function<Result<BusComparison>(const NetworkConfig& config, const QString& link,
                                                        const std::atomic<bool>& cancelled)>;

/// A network adapter that can carry EtherCAT.
struct NetworkAdapter {
  QString name;     // "eth0"
  QString driver;   // of the system's, "" when unknown
  bool up = false;  // interface up and carrier present
};
using AdapterLister = std::function<Result<std::vector<NetworkAdapter>>()>;

/// Makes a run of a capture; `progress` gets the bytes that are read and those of the file (0: not known), in the
/// calling thread, and ends it by false. Called from the reader's thread.
using CaptureImporter =
    std::function<Result<ImportedRun>(const QString& path, const ImportLimits& limits,
                                      const std::function<bool(std::uint64_t done, std::uint64_t all)>& progress)>;

/// What the program that hosts the window knows and the window does not: given once at construction.
struct Environment {
  MasterOpener open_master;
  BusScanner scan_bus;
  SlaveDescriber describe_slaves{};  // none: slaves stay as their EEPROM describes them
  AdapterLister list_adapters{};     // none: there are no network adapters
  QString demo_link;                 // LINK of the demonstration machine
  QStringList esi_folders;           // where the device descriptions lie
  QString version;
  EepromRepairs eeprom_repairs{};    // none: nothing is offered
  QString recovery_folder{};         // for unsaved work; "" = none is kept
  QString templates_folder{};        // for projects that others begin with; "" = none are kept
  QString settings_file{};           // for what the window remembers; "" = nothing
  BusComparer compare_bus{};         // none: nothing is compared with a bus
  CaptureImporter import_capture{};  // none: captures are no recordings
};

}  // namespace syncline::ui
