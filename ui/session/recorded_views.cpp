// SPDX-License-Identifier: Apache-2.0
#include "ui/session/recorded_views.h"

#include <utility>

#include "config/monitor_view.h"
#include "config/project.h"
#include "eni/project/project_file.h"
#include "record/recording.h"

namespace syncline::ui {

std::vector<MonitorView> recordedViews(const RecordingAbout& about) {
  for (const auto& document : about.documents) {
    if (document.kind != "project") continue;
    auto machine = eni::parse_machine(document.body, document.name);
    // Of several networks nobody knows which one it was.
    if (machine && machine->networks.size() == 1) return std::move(machine->networks.front().views);
  }
  return {};
}

}  // namespace syncline::ui
