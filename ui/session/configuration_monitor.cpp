// SPDX-License-Identifier: Apache-2.0
#include "ui/session/configuration_monitor.h"

#include <algorithm>
#include <chrono>

#include "reasons/because.h"
#include "ui/session/project_document.h"

namespace syncline::ui {

ConfigurationMonitor::ConfigurationMonitor(ProjectDocument& document, QObject* parent)
    : QObject(parent), document_(document), result_(fail(ErrorCode::kConfiguration, "project", because("no slaves"))) {
  debounce_.setSingleShot(true);
  debounce_.setInterval(std::chrono::milliseconds(20));
  connect(&debounce_, &QTimer::timeout, this, &ConfigurationMonitor::compileNow);
  connect(&document_, &ProjectDocument::projectChanged, this, [this](bool structural) {
    // A new set of slaves must never be shown beside the registers of the old one.
    if (structural) {
      compileNow();
    } else {
      debounce_.start();
    }
  });
}

const Result<CompileResult>& ConfigurationMonitor::current() {
  if (debounce_.isActive()) compileNow();
  return result_;
}

void ConfigurationMonitor::compileNow() {
  debounce_.stop();
  if (const auto updated = compiler_.update(document_.project())) {
    result_ = **updated;
  } else {
    result_ = tl::unexpected(updated.error());
  }
  Q_EMIT compiled();
}

}  // namespace syncline::ui
