// SPDX-License-Identifier: Apache-2.0
#include "ui/session/run_difference.h"

#include <algorithm>
#include <utility>

#include "compare/compare_run_time.h"
#include "ui/session/configuration_monitor.h"
#include "ui/session/live_session.h"
#include "ui/session/project_document.h"

namespace syncline::ui {
namespace {

/// The parameters of the controller are the one thing that a master takes while it runs; its mode is not among them.
bool onlyParameters(const Project& running, const Project& project) {
  auto with = running;
  with.master.dc.dcm = project.master.dc.dcm;
  with.views = project.views;  // no master knows of them
  return with == project && running.master.dc.dcm.mode == project.master.dc.dcm.mode;
}

}  // namespace

RunDifference::RunDifference(ProjectDocument& document, ConfigurationMonitor& configuration, LiveSession& live,
                             QObject* parent)
    : QObject(parent), document_(document), configuration_(configuration), live_(live) {
  connect(&live_, &LiveSession::phaseChanged, this, &RunDifference::look);
  connect(&live_, &LiveSession::applyingChanged, this, &RunDifference::look);
  connect(&live_, &LiveSession::applied, this, &RunDifference::look);
  connect(&configuration_, &ConfigurationMonitor::compiled, this, &RunDifference::look);
}

void RunDifference::look() {
  const bool runs = live_.phase() == LiveSession::Phase::kStarting || live_.phase() == LiveSession::Phase::kOnline;
  const auto& project = document_.project();
  const bool before = std::exchange(differs_, false);
  slaves_.clear();
  applicable_ = false;
  if (runs && !(project == running())) {
    const auto* config = configuration_.config();
    auto network =
        config != nullptr ? compare_configs(live_.origin().config, *config) : std::vector<ConfigDifference>{};
    const auto run_time = compare_run_time(running(), project);
    differs_ = config == nullptr || !network.empty() || !run_time.empty();
    std::erase_if(network, [](const ConfigDifference& one) { return one.group != DifferenceGroup::kSlaves; });
    slaves_ = std::move(network);
    applicable_ = differs_ && !live_.run().applying() && onlyParameters(running(), project);
  }
  if (before || differs_) Q_EMIT changed();
}

const Project& RunDifference::running() const { return live_.origin().project; }

std::vector<SettingDifference> RunDifference::settings() const {
  return compare_settings(running(), document_.project());
}

void RunDifference::apply() {
  const auto* config = configuration_.config();
  if (!applicable_ || config == nullptr) return;
  live_.run().apply({document_.project(), live_.origin().path, *config});
}

}  // namespace syncline::ui
