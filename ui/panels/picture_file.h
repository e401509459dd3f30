// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>

class QPainter;
class QWidget;

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

/// Asks for a name of one of the forms; empty: the user does not want to.
[[nodiscard]] QString askForPictureName(QWidget* parent, const QString& title, const QString& proposed);

}  // namespace syncline::ui
