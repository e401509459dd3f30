// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QTimer>
#include <optional>
#include <vector>

#include "config/project.h"
#include "eni/catalogue/catalogue_entry.h"
#include "support/result.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace syncline::ui {

class DeviceCatalogue;
struct CatalogueAnswer;

/// Chooses what takes the place of a slave: another revision, or any device that one searches for. Says which settings
/// the chosen one does not take, before it is taken.
class ReplaceDialog final : public QDialog {
  Q_OBJECT

 public:
  /// The project is that of the moment: whoever takes what was chosen looks where the slave is then.
  ReplaceDialog(const Project& project, int slave, DeviceCatalogue& catalogue, QWidget* parent);
  /// What was chosen.
  [[nodiscard]] const std::optional<DeviceDescription>& device() const { return device_; }

 private:
  void search();
  void showEntries(const std::vector<eni::CatalogueEntry>& entries);
  void readChosen();
  void showEffect(const Result<DeviceDescription>& read);

  Project project_;
  int slave_;
  DeviceCatalogue& catalogue_;
  std::vector<eni::CatalogueEntry> entries_;
  std::optional<DeviceDescription> device_;
  QLineEdit* words_;
  QListWidget* list_;
  QLabel* effect_;
  QPushButton* replace_;
  QTimer typing_;
};

}  // namespace syncline::ui
