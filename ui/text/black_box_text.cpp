// SPDX-License-Identifier: Apache-2.0
#include "ui/text/black_box_text.h"

#include <QCoreApplication>
#include <QLocale>

#include "ui/text/error_text.h"
#include "ui/text/recorded_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

struct BlackBoxText {
  Q_DECLARE_TR_FUNCTIONS(BlackBoxText)
};

}  // namespace

QString blackBoxText(const BlackBox::Report& report) {
  QStringList lines;
  if (report.frames > 0) {
    lines << BlackBoxText::tr("The last %1 of the run, %2 frames, in %3")
                 .arg(spanText(report.end - report.begin), countText(report.frames),
                      QString::fromStdString(report.name) + QStringLiteral("_*.pcapng"));
    lines << BlackBoxText::tr("%n file(s), %1", nullptr, static_cast<int>(report.files))
                 .arg(QLocale().formattedDataSize(static_cast<qint64>(report.bytes)));
  }
  if (report.lost > 0)
    lines << BlackBoxText::tr("%1 frames are missing: the disk was too slow").arg(countText(report.lost));
  if (report.error) lines << errorText(*report.error);
  return lines.isEmpty() ? BlackBoxText::tr("No frame of the run yet") : lines.join(u'\n');
}

}  // namespace syncline::ui
