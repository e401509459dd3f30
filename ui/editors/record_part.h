// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/result.h"
#include "ui/session/setting_edit.h"

namespace syncline::ui {

/// The records of a list in their text forms ("PS 0x6060:00=08").
using Records = std::vector<std::string>;

/// One part of a record: a column of the table, a field of its own, or both.
struct RecordPart {
  enum class Kind : unsigned char {
    kText,
    kChoice,  // one of `options`
    kToggle,  // "on" or ""
    kSet,     // several of `options`, with commas
    kShown,   // a column without a field
  };
  const char* object_name = "";
  QString label, tip;
  Kind kind = Kind::kText;
  int width = 0;  // of the column; 0: takes what is left; below 0: no column
  std::function<QString(const Records& records, std::size_t row)> text;
  /// The record with this part; an error says in words why not.
  std::function<Result<std::string>(const std::string& record, const QString& typed)> put{};
  /// Word and text for people.
  std::function<QList<std::pair<QString, QString>>()> options{};
};

/// Where the records come from and go to.
struct RecordList {
  const char* key = "";  // its row says what it is; a field's What's This shows it
  QString item;          // "task", for undo steps and buttons
  QString nothing{};     // stands in the empty table
  bool ordered = false;  // the order means something: records can be moved
  std::function<Records()> read;
  /// What makes `after` of `before`, in one undo step.
  std::function<std::vector<SettingEdit>(const Records& before, const Records& after)> edits;
  /// What Add appends.
  std::function<std::string(const Records&)> fresh;
  /// Of a record; nothing for a row that is not there.
  std::function<std::optional<settings::Place>(int row)> place;
  /// Why nothing can be changed; empty: it can.
  std::function<QString()> refusal{};
};

/// Edits for a key with a number for each record, like "slave.N.startup.K".
[[nodiscard]] std::vector<SettingEdit> itemEdits(const char* key, std::size_t slave, const Records& before,
                                                 const Records& after);

}  // namespace syncline::ui
