// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <functional>
#include <vector>

#include "settings/setting.h"

namespace syncline {
struct Finding;
struct Project;
}  // namespace syncline

namespace syncline::ui {

/// Slaves with their DC operation mode and Sync Unit Cycle, and what is found wrong with them. Whoever edits a cell
/// gives a word of the setting's options; it goes through the settings table as everywhere.
class DcModeModel final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kSlave, kMode, kFactor, kCycle, kNote, kColumns };
  enum Role { kChoicesRole = Qt::UserRole + 1, kSeverityRole };  // a list of {text, word}; 0 none, 1 warning, 2 error
  /// Sets a value; empty, or why it was refused.
  using Take = std::function<QString(const char* key, const settings::Place& place, const settings::Value& value)>;

  DcModeModel(const Project& project, Take take, QObject* parent = nullptr);
  /// The project as it is now, with the findings of its compiler.
  void refresh(const std::vector<Finding>& findings);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  /// Why a value was not taken.
  void refused(const QString& reason);

 private:
  struct Note {
    QString text;
    int severity = 0;
  };
  [[nodiscard]] QVariant textOf(int row, int column) const;
  [[nodiscard]] QVariantList choices(int row, int column) const;

  const Project& project_;
  Take take_;
  std::vector<Note> notes_;
};

}  // namespace syncline::ui
