// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "config/identity.h"
#include "eni/esi/diag_messages.h"

namespace syncline::ui {

class DeviceCatalogue;
using DiagTexts = std::vector<eni::DiagMessageText>;

/// What the messages of a device's diagnosis history say, out of the ESI file that the catalogue has of it. The file
/// may be long: it is read in a thread of its own, once for a device.
class DiagTextReader final : public QObject {
  Q_OBJECT

 public:
  explicit DiagTextReader(DeviceCatalogue& catalogue, QObject* parent = nullptr);

  /// told() comes when they are there; also at once when they are known. No ESI: none.
  void want(const Identity& identity);

 Q_SIGNALS:
  void told(const syncline::Identity& identity, const syncline::ui::DiagTexts& texts);

 private:
  void readFile(const Identity& identity, const std::string& file, const Identity& in_file);
  void keep(const Identity& identity, DiagTexts texts);

  DeviceCatalogue& catalogue_;
  std::map<std::string, DiagTexts> known_;  // by identity
  std::string asked_;
};

}  // namespace syncline::ui
