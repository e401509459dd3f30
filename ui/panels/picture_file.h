// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QPalette>
#include <QSize>
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>

#include "support/result.h"
#include "support/types.h"

class QPainter;
class QWidget;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

/// What a picture is written as: pixels, or lines and letters that stay sharp at every size.
enum class PictureForm : std::uint8_t { kPng, kSvg, kPdf };

/// By the ending of a file's name; nothing: it is none of them.
[[nodiscard]] std::optional<PictureForm> pictureFormOf(const QString& path);

/// A picture on white and how it is drawn, in pixels of a screen with `dpi`.
struct Picture {
  QSize size;
  int dpi = 96;
  QString title;
  std::function<void(QPainter&)> paint;
};
/// The bytes of a file. PNG has two pixels for each in both directions.
[[nodiscard]] QByteArray pictureFile(const Picture& picture, PictureForm form);

/// On white, whatever the theme is.
[[nodiscard]] QPalette picturePalette();
/// A widget's children in a picture with what it is of below them. `paint` draws them, in picturePalette(), at the
/// place that it is given; `inset`: what the widget leaves free at its left, in pixels.
[[nodiscard]] Picture captioned(const QWidget& widget, const QString& caption,
                                const std::function<void(QPainter&, const QPoint&)>& paint, int inset = 0);
/// Draws the children of a widget without what can be pressed or chosen in them, whose room stays; of a choice its text
/// is drawn, which says what the picture is of.
void renderWithoutControls(QWidget& widget, QPainter& painter, const QPoint& place);
/// "Syncline, 2026-03-01 12:00:00.000 \u2013 12:00:10.250 UTC, cycle 1 ms", of host clock times, and of a simulated
/// machine that it is one; without a run only the program.
[[nodiscard]] QString captionOf(const RunRecord* run, Nanoseconds begin, Nanoseconds end);

/// Whole or not at all. kBadValue where the name ends in none of the forms, kFileNotWritable.
[[nodiscard]] Status writePicture(const Picture& picture, const QString& path);
/// Asks for a name of one of the forms and writes; what goes wrong is shown.
void exportPicture(QWidget* parent, const QString& title, const QString& proposed,
                   const std::function<Picture()>& picture);
void copyPicture(const Picture& picture);

}  // namespace syncline::ui
