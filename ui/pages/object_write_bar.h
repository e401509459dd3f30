// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "protocol/coe.h"
#include "ui/models/dictionary.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace syncline::ui {

/// A new value for the selected entry: typed by its type, checked against its range before anything is sent.
class ObjectWriteBar final : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectWriteBar(QWidget* parent = nullptr);
  /// Null: nothing that could be written is selected; `why` says so. `bytes`: what it holds, as far as known.
  void setEntry(coe::ObjectAddress object, const DictionaryEntry* entry, const std::vector<std::uint8_t>& bytes,
                const QString& why);
  /// The slave can be asked.
  void setPossible(bool possible);

 Q_SIGNALS:
  void writeWanted(syncline::coe::ObjectAddress object, const std::vector<std::uint8_t>& bytes);

 private:
  void check();
  void send();

  QLabel *title_, *note_;
  QLineEdit* value_;
  QComboBox* words_;
  QPushButton* write_;
  coe::ObjectAddress object_;
  std::optional<DictionaryEntry> entry_;
  bool possible_ = false;
};

}  // namespace syncline::ui
