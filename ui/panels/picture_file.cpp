// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/picture_file.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QPointer>
#include <QStringList>
#include <QSvgGenerator>
#include <QSvgRenderer>
#include <QWidget>
#include <array>

#include "reasons/because.h"
#include "record/run_record.h"
#include "support/whole_file.h"
#include "ui/files/save_name.h"
#include "ui/text/error_text.h"
#include "ui/text/units.h"
#include "ui/theme/theme.h"

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

/// Empty: the user does not want to.
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

constexpr int kCaptionHeight = 22, kPaperMargin = 10;

QString utcRangeText(Nanoseconds begin, Nanoseconds end) {
  const auto at = [](Nanoseconds time) {
    return QDateTime::fromMSecsSinceEpoch(time / kMillisecond + kDcEpochUnixSeconds * 1000, Qt::UTC);
  };
  const auto clock = QStringLiteral("HH:mm:ss.zzz");
  const auto whole = QStringLiteral("yyyy-MM-dd ") + clock;
  const bool same_day = at(begin).date() == at(end).date();
  return QStringLiteral("%1 \u2013 %2 UTC").arg(at(begin).toString(whole), at(end).toString(same_day ? clock : whole));
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

QPalette picturePalette() {
  auto palette = theme::lightPalette();
  for (const auto role : {QPalette::Window, QPalette::Base, QPalette::Button}) palette.setColor(role, Qt::white);
  return palette;
}

Picture captioned(const QWidget& widget, const QString& caption,
                  const std::function<void(QPainter&, const QPoint&)>& paint, int inset) {
  const auto size = widget.size();
  const auto whole = [paint, size, caption, inset, font = widget.font()](QPainter& painter) {
    paint(painter, QPoint(kPaperMargin, kPaperMargin));
    painter.setPen(picturePalette().color(QPalette::Text));
    painter.setFont(font);
    painter.drawText(QRect(kPaperMargin + inset, kPaperMargin + size.height(), size.width(), kCaptionHeight),
                     Qt::AlignVCenter, caption);
  };
  return {size + QSize(2 * kPaperMargin, 2 * kPaperMargin + kCaptionHeight), widget.logicalDpiX(), caption, whole};
}

void renderWithoutControls(QWidget& widget, QPainter& painter, const QPoint& place) {
  const QPointer<QWidget> focus = QApplication::focusWidget();
  QList<QWidget*> controls;
  for (auto* child : widget.findChildren<QWidget*>()) {
    const bool is_control =
        qobject_cast<QComboBox*>(child) != nullptr || qobject_cast<QAbstractButton*>(child) != nullptr;
    const bool in_table = qobject_cast<QAbstractItemView*>(child->parentWidget()) != nullptr;
    if (is_control && !in_table && child->isVisibleTo(&widget)) controls << child;
  }
  for (auto* control : controls) {
    auto keep = control->sizePolicy();
    keep.setRetainSizeWhenHidden(true);
    control->setSizePolicy(keep);
    control->hide();
  }
  widget.render(&painter, place, {}, QWidget::DrawChildren);
  painter.save();
  painter.setPen(widget.palette().color(QPalette::WindowText));
  for (auto* control : controls) {
    if (const auto* choice = qobject_cast<QComboBox*>(control)) {
      const QRect room(place + control->mapTo(&widget, QPoint()), control->size());
      painter.setFont(control->font());
      painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, choice->currentText());
    }
    auto usual = control->sizePolicy();
    usual.setRetainSizeWhenHidden(false);
    control->setSizePolicy(usual);
    control->show();
  }
  painter.restore();
  if (focus) focus->setFocus();
}

QString captionOf(const RunRecord* run, Nanoseconds begin, Nanoseconds end) {
  if (run == nullptr) return QStringLiteral("Syncline");
  const auto text = run->simulated()
                        ? QCoreApplication::translate("Picture", "Syncline, simulated machine, %1, cycle %2")
                        : QCoreApplication::translate("Picture", "Syncline, %1, cycle %2");
  return text.arg(utcRangeText(begin, end), cycleText(run->limits().cycle_time));
}

Status writePicture(const Picture& picture, const QString& path) {
  const auto form = pictureFormOf(path);
  if (!form) return fail(ErrorCode::kBadValue, path.toStdString(), because("its name must end in .png, .svg or .pdf"));
  const auto bytes = pictureFile(picture, *form);
  return write_whole_file(path.toStdString(),
                          std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

void exportPicture(QWidget* parent, const QString& title, const QString& proposed,
                   const std::function<Picture()>& picture) {
  const auto path = askForPictureName(parent, title, proposed);
  if (path.isEmpty() || !mayWriteOrTell(parent, title, path)) return;
  if (const auto status = writePicture(picture(), path); !status)
    QMessageBox::warning(parent, title, errorText(status.error()));
}

void copyPicture(const Picture& picture) {
  QApplication::clipboard()->setImage(QImage::fromData(pictureFile(picture, PictureForm::kPng)));
}

}  // namespace syncline::ui
