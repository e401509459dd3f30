// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QStringList>
#include <QWidget>

namespace syncline::test {

/// The texts that a widget paints, without those of what stands in it, piece by piece as they are drawn.
[[nodiscard]] QStringList drawnWords(QWidget& widget);

}  // namespace syncline::test
