// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPalette>

/// Colours of the plots. Traces begin with the Okabe-Ito set; its light members are darkened or replaced on a light
/// canvas (and the dark ones on a dark one), so that each trace keeps at least 3:1 against the canvas and any two can
/// be told apart by who sees no red or no green. Text never takes a trace's colour.
namespace syncline::ui::plot_colors {

inline constexpr int kTraceCount = 6;
/// `slot` counts round: two slots with the same colour never stand side by side before kTraceCount.
[[nodiscard]] QColor trace(const QPalette& palette, int slot);
/// For the quantity that bounds or surrounds the others: neutral.
[[nodiscard]] QColor envelope(const QPalette& palette);
/// Of another recording over the one that is shown: muted, what lies below shines through.
[[nodiscard]] QColor overlay(const QPalette& palette);
[[nodiscard]] QColor grid(const QPalette& palette);
[[nodiscard]] QColor limitLine(const QPalette& palette);
[[nodiscard]] QColor limitFill(const QPalette& palette);
[[nodiscard]] QColor cursor(const QPalette& palette);
/// WCAG 2 contrast of two opaque colours, 1..21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

}  // namespace syncline::ui::plot_colors
