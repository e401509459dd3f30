// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <string>
#include <vector>

#include "ui/session/remembered_lines.h"

namespace syncline {
struct NetworkConfig;
struct WatchedVariable;
}  // namespace syncline

namespace syncline::ui {

class ProjectDocument;
class WindowMemory;

/// A variable of the process image by what it is called, whatever machine runs.
struct VariableName {
  std::string name;
  bool output = false;
  bool operator==(const VariableName&) const = default;
};

/// Which variables the monitor watches, in the order in which they were chosen. Kept with what the window remembers of
/// a project's file; of one without a file until the window closes.
class VariableWatch final : public QObject {
  Q_OBJECT

 public:
  VariableWatch(ProjectDocument& document, WindowMemory& memory, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<VariableName>& names() const { return names_; }
  [[nodiscard]] bool has(const VariableName& name) const;
  /// There is room for one more.
  [[nodiscard]] bool hasRoom() const;
  /// Nothing happens where it is watched already, or there is no room.
  void add(const VariableName& name);
  void remove(const VariableName& name);
  void clear();

 Q_SIGNALS:
  void changed();

 private:
  void load();
  void store();
  void set(std::vector<VariableName> names);

  ProjectDocument& document_;
  RememberedLines kept_;
  bool replaced_ = false;  // another machine comes
  std::vector<VariableName> names_;
};

/// Those of them that a configuration has, in their order.
[[nodiscard]] std::vector<WatchedVariable> watchedOf(const NetworkConfig& config,
                                                     const std::vector<VariableName>& names);

}  // namespace syncline::ui
