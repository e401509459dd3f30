// SPDX-License-Identifier: Apache-2.0
#include "ui/session/variable_watch.h"

#include <QStringList>
#include <algorithm>
#include <utility>

#include "channels/watch_command.h"
#include "config/network_config.h"
#include "config/watched_variable.h"
#include "ui/session/project_document.h"

namespace syncline::ui {
namespace {

const QString kOutput = QStringLiteral("out "), kInput = QStringLiteral("in ");

}  // namespace

VariableWatch::VariableWatch(ProjectDocument& document, WindowMemory& memory, QObject* parent)
    : QObject(parent), document_(document), kept_(memory, QStringLiteral("watchedVariables"), document.path()) {
  load();
  connect(&document_, &ProjectDocument::machineReplaced, this, [this] { replaced_ = true; });
  connect(&document_, &ProjectDocument::taken, this, [this] {
    if (!std::exchange(replaced_, false)) return;  // another network of it
    kept_.setPath(document_.path());
    load();
    Q_EMIT changed();
  });
  // Saved under another name it is the same machine, whatever that file held before.
  connect(&document_, &ProjectDocument::pathChanged, this, [this] {
    if (kept_.setPath(document_.path())) store();
  });
}

/// "in Servo.Inputs.Position actual value"
void VariableWatch::load() {
  names_.clear();
  for (const auto& line : kept_.read()) {
    const bool output = line.startsWith(kOutput);
    if ((!output && !line.startsWith(kInput)) || !hasRoom()) continue;
    names_.push_back({line.sliced((output ? kOutput : kInput).size()).toStdString(), output});
  }
}

void VariableWatch::store() {
  QStringList lines;
  for (const auto& [name, output] : names_) lines << (output ? kOutput : kInput) + QString::fromStdString(name);
  kept_.write(lines);
}

bool VariableWatch::has(const VariableName& name) const { return std::ranges::find(names_, name) != names_.end(); }

bool VariableWatch::hasRoom() const { return names_.size() < kMostWatched; }

void VariableWatch::add(const VariableName& name) {
  if (has(name) || !hasRoom()) return;
  auto names = names_;
  names.push_back(name);
  set(std::move(names));
}

void VariableWatch::remove(const VariableName& name) {
  auto names = names_;
  std::erase(names, name);
  set(std::move(names));
}

void VariableWatch::clear() { set({}); }

void VariableWatch::set(std::vector<VariableName> names) {
  if (names == names_) return;
  names_ = std::move(names);
  store();
  Q_EMIT changed();
}

std::vector<WatchedVariable> watchedOf(const NetworkConfig& config, const std::vector<VariableName>& names) {
  std::vector<WatchedVariable> result;
  if (names.empty()) return result;
  const auto all = watchable_variables(config);
  for (const auto& sought : names) {
    const auto found = std::ranges::find_if(all, [&sought](const WatchedVariable& variable) {
      return variable.output == sought.output && variable.name == sought.name;
    });
    const bool fresh = found != all.end() && std::ranges::find(result, *found) == result.end();
    if (fresh) result.push_back(*found);
  }
  return result;
}

}  // namespace syncline::ui
