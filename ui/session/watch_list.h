// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>
#include <vector>

#include "protocol/coe.h"
#include "ui/session/remembered_lines.h"

namespace syncline::ui {

class ProjectDocument;
class WindowMemory;

/// Which objects of each slave are watched. Kept with what the window remembers of a project's file; of one without a
/// file until the window closes.
class WatchList final : public QObject {
  Q_OBJECT

 public:
  WatchList(ProjectDocument& document, WindowMemory& memory, QObject* parent = nullptr);

  /// Of the slave with that station address.
  [[nodiscard]] std::vector<coe::ObjectAddress> of(std::uint16_t station) const;
  void set(std::uint16_t station, std::vector<coe::ObjectAddress> objects);

 private:
  void load();
  void store();

  ProjectDocument& document_;
  RememberedLines kept_;
  std::map<std::uint16_t, std::vector<coe::ObjectAddress>> watched_;
};

}  // namespace syncline::ui
