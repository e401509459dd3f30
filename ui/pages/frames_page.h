// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

#include "ui/editors/page.h"

class QLabel;
class QTableView;
class QVBoxLayout;

namespace syncline {

struct Snapshot;

struct ImageReport;
struct NetworkConfig;
}  // namespace syncline

namespace syncline::ui {

class RecordModel;

/// The cyclic frames: their datagrams, what they cost on the wire, which slaves make the cost, and what could be left
/// out of them.
class FramesPage final : public Page {
  Q_OBJECT

 public:
  explicit FramesPage(Workspace& workspace);
  [[nodiscard]] bool appliesTo(int slave) const override { return slave < 0; }
  [[nodiscard]] PagePurpose purpose() const override { return PagePurpose::kBoth; }
  void refresh() override;
  void showLive(const Snapshot&) override {}

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  RecordModel* addTable(QVBoxLayout& layout, const char* object_name, const QString& heading, const QStringList& titles,
                        QTableView*& view);
  void showFrames(const ImageReport& report);
  void showDatagrams(const NetworkConfig& config);
  void showCost(const ImageReport& report);
  [[nodiscard]] int frame() const;

  QLabel* summary_;
  RecordModel *frames_, *datagrams_, *slaves_, *movable_;
  QTableView *frame_table_, *datagram_table_, *slave_table_, *movable_table_;
};

}  // namespace syncline::ui
