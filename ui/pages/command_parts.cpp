// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/command_parts.h"

#include "protocol/object_value.h"

namespace syncline::ui {

QList<std::pair<QString, QString>> transitionOptions() {
  QList<std::pair<QString, QString>> all;
  constexpr std::pair<const char*, const char*> kKnown[] = {
      {"IP", QT_TRANSLATE_NOOP("SlaveStartupPage", "INIT to PREOP")},
      {"PS", QT_TRANSLATE_NOOP("SlaveStartupPage", "PREOP to SAFEOP")},
      {"SO", QT_TRANSLATE_NOOP("SlaveStartupPage", "SAFEOP to OP")},
      {"IB", QT_TRANSLATE_NOOP("SlaveStartupPage", "INIT to BOOT")},
      {"PP", QT_TRANSLATE_NOOP("SlaveStartupPage", "PREOP again")},
      {"OS", QT_TRANSLATE_NOOP("SlaveStartupPage", "OP to SAFEOP")},
      {"OP", QT_TRANSLATE_NOOP("SlaveStartupPage", "OP to PREOP")},
      {"SP", QT_TRANSLATE_NOOP("SlaveStartupPage", "SAFEOP to PREOP")},
      {"SI", QT_TRANSLATE_NOOP("SlaveStartupPage", "SAFEOP to INIT")},
      {"PI", QT_TRANSLATE_NOOP("SlaveStartupPage", "PREOP to INIT")}};
  for (const auto& [word, text] : kKnown) all.append({QLatin1String(word), CommandWords::tr(text)});
  return all;
}

QString bytesText(const std::vector<std::uint8_t>& bytes) {
  return QString::fromStdString(value_text(kBytesType, bytes));
}

}  // namespace syncline::ui
