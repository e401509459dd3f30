// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractItemView>

#include "config/wiring_tree.h"
#include "ui/models/drop_place.h"
#include "ui/panels/topology_layout.h"

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::ui {

struct DraggedDevice;

class CableCounters;
class NetworkModel;

/// The wiring drawn: slaves with their ports, cables in the colour of their link with what was counted at them. A cable
/// is dragged from a slave to a free port; devices of the catalogue are dropped on ports and slaves. Draws only what is
/// visible.
class TopologyView final : public QAbstractItemView {
  Q_OBJECT

 public:
  TopologyView(NetworkModel& model, const CableCounters& cables, QWidget* parent = nullptr);
  void setProject(const Project& project);
  /// Cables can be plugged in elsewhere.
  void setEditable(bool editable);
  [[nodiscard]] double zoom() const { return zoom_; }
  void setZoom(double zoom);
  /// In the viewport.
  [[nodiscard]] QPoint portPosition(int slave, int port) const;
  /// Of the number at the slave's cable, in the viewport; empty: there is none.
  [[nodiscard]] QRect badgeRect(int slave) const;

  [[nodiscard]] QRect visualRect(const QModelIndex& index) const override;
  void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;
  [[nodiscard]] QModelIndex indexAt(const QPoint& point) const override;

 Q_SIGNALS:
  void rewireWanted(int slave, int position, int port);
  void deviceDroppedAt(qint64 device, int position, int port);
  void deviceDropped(qint64 device, syncline::ui::DropPlace place);
  void zoomChanged(double zoom);
  /// The number at a cable was clicked.
  void countersWanted(int slave);

 protected:
  QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
  [[nodiscard]] int horizontalOffset() const override;
  [[nodiscard]] int verticalOffset() const override;
  [[nodiscard]] bool isIndexHidden(const QModelIndex&) const override { return false; }
  void setSelection(const QRect& rect, QItemSelectionModel::SelectionFlags command) override;
  [[nodiscard]] QRegion visualRegionForSelection(const QItemSelection& selection) const override;
  void updateGeometries() override;
  bool viewportEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void dataChanged(const QModelIndex& from, const QModelIndex& to, const QList<int>& roles) override;

 private:
  struct PortPlace {
    int slave = -1, port = -1;
    bool operator==(const PortPlace&) const = default;
  };
  [[nodiscard]] QRectF boxOf(int slave) const;
  [[nodiscard]] QPointF anchorOf(int slave, int port) const;
  [[nodiscard]] QPointF onPaper(const QPointF& viewport_point) const;
  [[nodiscard]] QPolygonF cableOf(int slave) const;
  [[nodiscard]] QRectF badgeOnPaper(int slave) const;
  [[nodiscard]] int badgeAt(const QPoint& point) const;
  [[nodiscard]] int cableAt(const QPoint& point) const;
  [[nodiscard]] PortPlace freePortAt(const QPoint& point) const;
  [[nodiscard]] bool mayPlug(int slave, const PortPlace& at) const;
  [[nodiscard]] bool mayPlug(const DraggedDevice& device, const PortPlace& at) const;
  void drawCable(QPainter& painter, int slave) const;
  void drawBadge(QPainter& painter, int slave) const;
  void drawNode(QPainter& painter, int slave) const;
  void drawPorts(QPainter& painter, int slave) const;
  void endDrag();

  NetworkModel& network_;
  const CableCounters& cables_;
  const Project* project_ = nullptr;
  TopologyLayout layout_;
  double zoom_ = 1;
  bool editable_ = true;
  QPoint pressed_;
  int clicked_badge_ = -1;
  int grabbed_ = -1;       // slave under the mouse since it was pressed
  bool dragging_ = false;  // its cable follows the mouse
  QPoint mouse_;
  std::optional<WiringTree> tree_;  // while something is dragged
  PortPlace aim_;                   // free port under the mouse
};

}  // namespace syncline::ui
