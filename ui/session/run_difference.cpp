// SPDX-License-Identifier: Apache-2.0
#include "ui/session/run_difference.h"

#include <utility>

#include "compare/compare_run_time.h"
#include "compare/compare_settings.h"
#include "ui/session/comparison.h"
#include "ui/session/configuration_monitor.h"
#include "ui/session/live_session.h"
#include "ui/session/project_document.h"

namespace syncline::ui {
namespace {

/// What runs with all of the project that a master takes while it runs: the parameters of the controller, among which
/// its mode is not. No master knows of the views.
Project withParameters(Project running, const Project& project) {
  const auto mode = running.master.dc.dcm.mode;
  running.master.dc.dcm = project.master.dc.dcm;
  running.master.dc.dcm.mode = mode;
  running.views = project.views;
  return running;
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
  const auto phase = live_.phase();
  const bool listens = phase == LiveSession::Phase::kStarting || phase == LiveSession::Phase::kOnline;
  const bool runs = listens || phase == LiveSession::Phase::kSilent;
  const auto& project = document_.project();
  const bool before = std::exchange(differs_, false);
  network_.clear();
  applicable_ = false;
  if (runs && !(project == running())) {
    const auto* config = configuration_.config();
    auto network =
        config != nullptr ? compare_configs(live_.origin().config, *config) : std::vector<ConfigDifference>{};
    const auto run_time = compare_run_time(running(), project);
    differs_ = config == nullptr || !network.empty() || !run_time.empty();
    network_ = std::move(network);
    applicable_ = differs_ && listens && !live_.run().applying() && withParameters(running(), project) == project;
  }
  if (before || differs_) Q_EMIT changed();
}

const Project& RunDifference::running() const { return live_.origin().project; }

int RunDifference::changes() const { return changesOf(compare_settings(running(), document_.project()), network_); }

/// The project is looked at anew: a click that takes what was typed in a field comes before it is compiled.
void RunDifference::apply() {
  const auto& compiled = configuration_.current();  // told to look() by it
  if (!applicable_ || !compiled) return;
  live_.run().apply({withParameters(running(), document_.project()), live_.origin().path, compiled->config});
}

}  // namespace syncline::ui
