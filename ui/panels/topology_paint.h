// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QModelIndex>
#include <QPalette>
#include <QPen>
#include <QRectF>

#include "ui/models/network_model.h"

class QPainter;

namespace syncline::ui {
struct CableBadge;
}  // namespace syncline::ui

/// The parts of the drawn topology in the colours of the palette.
namespace syncline::ui::topology {

struct BoxLook {
  bool selected = false, focused = false;
  bool loose = false;  // nobody knows where it hangs
};
struct PortLook {
  bool free = false;
  bool offered = false;  // what is dragged could be plugged in
  bool aimed = false;    // and would be
};

[[nodiscard]] QPen cablePen(const QPalette& palette, NetworkModel::LinkState link, bool lifted);
void drawBox(QPainter& painter, const QRectF& box, const QPalette& palette, const QModelIndex& index,
             const BoxLook& look);
void drawPort(QPainter& painter, const QPointF& centre, QChar letter, const QPalette& palette, const PortLook& look);

/// The number at a cable: filled where frames are damaged first, an outline where errors were only forwarded.
[[nodiscard]] QSizeF badgeSize(const CableBadge& badge);
void drawBadge(QPainter& painter, const QRectF& area, const QPalette& palette, const CableBadge& badge);

}  // namespace syncline::ui::topology
