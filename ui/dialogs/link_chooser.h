// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>

#include "ui/session/bus_connection.h"

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace syncline::ui {

/// Chooses the bus: the simulated demonstration machine, the project's own machine simulated, a scenario file, or a
/// network card.
class LinkChooser final : public QDialog {
  Q_OBJECT

 public:
  LinkChooser(const Environment& environment, const QString& current, const QString& action, QWidget* parent = nullptr);
  /// Offers the simulated bus of the project itself, of so many slaves, in front of the other links.
  void offerMachine(int slaves);
  [[nodiscard]] QString link() const;

 private:
  QListWidgetItem* addLink(const QString& link, const QString& title, const QString& detail, const QString& icon);
  void select();
  void addAdapters(const AdapterLister& list_adapters);
  void browse();

  QString current_;
  QListWidget* list_;
  QLabel* note_;
  QDialogButtonBox* buttons_;
};

}  // namespace syncline::ui
