// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/picture_file.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QStringList>
#include <QSvgGenerator>
#include <QSvgRenderer>
#include <array>

namespace syncline::ui {
namespace {

struct FormName {
  PictureForm form;
  const char* ending;
  const char* filter;
};
constexpr std::array kForms{
    FormName{PictureForm::kPng, "png", QT_TRANSLATE_NOOP("PictureFile", "PNG picture (*.png)")},
    FormName{PictureForm::kSvg, "svg", QT_TRANSLATE_NOOP("PictureFile", "SVG drawing (*.svg)")},
    FormName{PictureForm::kPdf, "pdf", QT_TRANSLATE_NOOP("PictureFile", "PDF document (*.pdf)")},
};

QString filterOf(const FormName& form) { return QCoreApplication::translate("PictureFile", form.filter); }

void writePng(QBuffer& file, const Picture& picture) {
  constexpr int kScale = 2;
  QImage image(picture.size * kScale, QImage::Format_RGB32);
  image.setDevicePixelRatio(kScale);
  image.fill(Qt::white);
  QPainter painter(&image);
  picture.paint(painter);
  painter.end();
  image.save(&file, "PNG");
}

void writeSvg(QBuffer& file, const Picture& picture) {
  QSvgGenerator drawing;
  drawing.setOutputDevice(&file);
  drawing.setResolution(picture.dpi);
  drawing.setSize(picture.size);
  drawing.setViewBox(QRect({}, picture.size));
  drawing.setTitle(picture.title);
  QPainter painter(&drawing);
  painter.fillRect(QRect({}, picture.size), Qt::white);
  picture.paint(painter);
}

/// One page of the picture's size. By way of the SVG: what a widget draws into a PDF itself is clipped at wrong places.
void writePdf(QBuffer& file, const Picture& picture) {
  constexpr double kPointsPerInch = 72;
  QSvgRenderer drawing(pictureFile(picture, PictureForm::kSvg));
  QPdfWriter page(&file);
  page.setTitle(picture.title);
  page.setCreator(QCoreApplication::applicationName());
  page.setResolution(picture.dpi);
  page.setPageSize(
      QPageSize(QSizeF(picture.size) * kPointsPerInch / picture.dpi, QPageSize::Point, {}, QPageSize::ExactMatch));
  page.setPageMargins({});
  QPainter painter(&page);
  // Cells of a heat map are no photograph: JPEG would change their colours.
  painter.setRenderHint(QPainter::LosslessImageRendering);
  drawing.render(&painter, QRectF({}, QSizeF(picture.size)));
}

}  // namespace

std::optional<PictureForm> pictureFormOf(const QString& path) {
  const auto ending = QFileInfo(path).suffix().toLower();
  for (const auto& form : kForms) {
    if (ending == QLatin1String(form.ending)) return form.form;
  }
  return std::nullopt;
}

QByteArray pictureFile(const Picture& picture, PictureForm form) {
  QByteArray bytes;
  QBuffer file(&bytes);
  file.open(QIODevice::WriteOnly);
  switch (form) {
    case PictureForm::kPng:
      writePng(file, picture);
      break;
    case PictureForm::kSvg:
      writeSvg(file, picture);
      break;
    case PictureForm::kPdf:
      writePdf(file, picture);
      break;
  }
  return bytes;
}

QString askForPictureName(QWidget* parent, const QString& title, const QString& proposed) {
  QStringList filters;
  for (const auto& form : kForms) filters << filterOf(form);
  QFileDialog dialog(parent, title);
  dialog.setObjectName(QStringLiteral("pictureFileDialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(filters);
  dialog.setDefaultSuffix(QLatin1String(kForms.front().ending));
  dialog.selectFile(proposed);
  // For a name without an ending; the dialog changes that of one that has it, and asks before a file is replaced.
  QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    for (const auto& form : kForms) {
      if (filter == filterOf(form)) dialog.setDefaultSuffix(QLatin1String(form.ending));
    }
  });
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

}  // namespace syncline::ui
