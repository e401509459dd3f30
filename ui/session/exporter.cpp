// SPDX-License-Identifier: Apache-2.0
#include "ui/session/exporter.h"

#include "eni/format/eni_file.h"
#include "ui/session/configuration_monitor.h"

namespace syncline::ui {

Status exportEni(ConfigurationMonitor& configuration, const QString& path) {
  const auto& compiled = configuration.current();
  if (!compiled) return tl::unexpected(compiled.error());
  return eni::save_eni(compiled->config, path.toStdString());
}

}  // namespace syncline::ui
