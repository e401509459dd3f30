// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QIcon>
#include <QPalette>
#include <QString>

#include "protocol/al_state.h"

/// Colours and icons. Everything follows from the palette, so that a widget needs no style sheet and
/// the dark theme needs no second set of drawings.
namespace syncline::ui::theme {

enum class Mode : unsigned char { kSystem, kLight, kDark, kContrast };
[[nodiscard]] QString modeName(Mode mode);             // "light", for settings and command line
[[nodiscard]] Mode modeFromName(const QString& name);  // kSystem when unknown

/// Fusion (window_style.h) with our palette. kSystem takes light, dark or high contrast (a ground of nothing but black)
/// from the desktop's own palette.
void apply(Mode mode);
[[nodiscard]] Mode current();
/// Ours for a light desktop, whatever is applied.
[[nodiscard]] QPalette lightPalette();
[[nodiscard]] bool isDark(const QPalette& palette);

enum class Tone : unsigned char { kNeutral, kGood, kBusy, kWarning, kBad, kAccent };
/// Text and line colour of a tone on the window and base colours, at least 4.5:1; 7:1 in high contrast.
[[nodiscard]] QColor toneColor(const QPalette& palette, Tone tone);
/// Quiet fill behind text of that tone.
[[nodiscard]] QColor toneFill(const QPalette& palette, Tone tone);
[[nodiscard]] Tone stateTone(AlState state);
/// Secondary text.
[[nodiscard]] QColor mutedText(const QPalette& palette);
/// Hairlines between and around areas.
[[nodiscard]] QColor outline(const QPalette& palette);

/// Line icon of resources/icons drawn in the palette's text colour (or `color`).
[[nodiscard]] QIcon icon(const QString& name, const QPalette& palette, const QColor& color = {});

}  // namespace syncline::ui::theme
