// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/composition/open_link.h"
#include "app/composition/open_master.h"
#include "capture/import_capture.h"
#include "engine/compare_bus.h"
#include "engine/describe_slaves.h"
#include "engine/opened_link.h"
#include "engine/scan_bus.h"
#include "ui/session/bus_connection.h"
#include "ui/text/link_text.h"

namespace syncline {

/// The window's way to buses: what it asks for by the text of a LINK.
inline void connect_buses(ui::Environment& environment) {
  environment.open_master = [](const QString& link, const Project& machine) {
    return link == ui::kMachineItself ? open_master(machine) : open_master(link.toStdString());
  };
  environment.scan_bus = [](const QString& link, bool look_only, const std::atomic<bool>& cancelled,
                            const std::function<void(const Event&)>& tell) {
    ScanRequest request;
    request.options.look_only = look_only;
    request.on_event = tell;
    request.cancel = &cancelled;
    return scan_bus(open_link(link.toStdString()), request);
  };
  environment.describe_slaves = [](Project& project, const QString& link, const std::atomic<bool>& cancelled) {
    return describe_slaves(
        project, [&] { return open_link(link.toStdString()); }, &cancelled);
  };
  environment.compare_bus = [](const NetworkConfig& config, const QString& link,
                               const std::atomic<bool>& cancelled) -> Result<ui::BusComparison> {
    auto compared = compare_bus(config, open_link(link.toStdString()), {.look_only = true}, &cancelled);
    if (!compared) return tl::unexpected(compared.error());
    return ui::BusComparison{std::move(compared->differences), std::move(compared->findings)};
  };
  environment.import_capture = [](const QString& path, const ImportLimits& limits, const ImportProgress& progress) {
    return import_capture(path.toStdString(), limits, progress);
  };
  environment.demo_link = QString::fromStdString(demo_link(true));
  environment.esi_folders = {QString::fromStdString(resource_folder()) + QStringLiteral("/esi")};
}

}  // namespace syncline
