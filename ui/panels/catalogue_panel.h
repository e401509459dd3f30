// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include "eni/catalogue/catalogue_entry.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeView;

namespace syncline::ui {

class CatalogueModel;
class DeviceCatalogue;
struct CatalogueAnswer;

/// Browser of the device catalogue: search as one types, vendor, group, device, revisions, and what is known of the
/// selected one. Enter or a double click wants it in the machine; it can be dragged there, too.
class CataloguePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit CataloguePanel(DeviceCatalogue& catalogue, QWidget* parent = nullptr);
  /// To the search.
  void begin();
  /// The device that was dragged out of the panel; nullptr when it is another one than this number of the catalogue.
  [[nodiscard]] const eni::CatalogueEntry* dragged(qint64 id) const;
  /// Empty: devices can be taken into the machine; else why not, a sentence.
  void setObstacle(const QString& why);
  [[nodiscard]] QSize sizeHint() const override { return {300, 400}; }

 Q_SIGNALS:
  void deviceWanted(const syncline::eni::CatalogueEntry& device);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void buildSearch();
  void buildTree();
  void buildFoot();
  void connectCatalogue();
  void search();
  void showAnswer(const CatalogueAnswer& answer);
  void selectIn(const CatalogueAnswer& answer, std::int64_t kept);
  void showCount(const CatalogueAnswer& answer);
  void showDevice();
  [[nodiscard]] QString fileShown(const QString& path) const;
  void takeSelected();
  void addFiles();
  void addFolder();
  void read(const QStringList& paths);
  void showReading(bool reading);

  DeviceCatalogue& catalogue_;
  CatalogueModel* model_;
  QLineEdit* words_;
  QCheckBox* revisions_;
  QTreeView* tree_;
  QLabel *details_, *count_;
  QPushButton *take_, *add_, *cancel_;
  QProgressBar* bar_;
  QTimer typing_;
  QString answered_;  // the words of the answer that is shown
  bool asked_ = false;
  QString obstacle_;
  bool take_first_ = false;  // of the answer that is on its way
};

}  // namespace syncline::ui
