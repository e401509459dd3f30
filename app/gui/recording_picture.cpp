// SPDX-License-Identifier: Apache-2.0
#include "app/gui/recording_picture.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QRegularExpression>
#include <QSize>
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "app/cli/cli.h"
#include "app/cli/command_files.h"
#include "app/cli/duration.h"
#include "app/cli/record_range.h"
#include "reasons/because.h"
#include "record/recording.h"
#include "ui/panels/picture_file.h"
#include "ui/panels/recording_picture.h"
#include "ui/panels/signal_chooser.h"
#include "ui/session/opened_recording.h"
#include "ui/session/recording_overlay.h"
#include "ui/text/error_text.h"
#include "ui/text/finding_text.h"

namespace syncline {
namespace {

constexpr int kLeastSide = 100, kMostSide = 8192;

int told(const QString& words, int code) {
  std::fprintf(stderr, "syncline: %s\n", qUtf8Printable(words));
  return code;
}

int told(const Error& error) {
  return told(ui::errorText(error), error.code == ErrorCode::kBadValue ? cli::kUsage : cli::kFailed);
}

/// What a file has lost is not in its picture either.
void warnOf(const ReplayedRun& run, const QString& file) {
  for (const auto& finding : run.record->findings()) {
    if (!is_about_file(finding) || finding.severity < Severity::kWarning) continue;
    std::fprintf(stderr, "syncline: %s: %s\n", qUtf8Printable(file), qUtf8Printable(ui::findingWhole(finding)));
  }
}

std::optional<QSize> sizeOf(const QString& text) {
  static const QRegularExpression form(QStringLiteral("^(\\d{1,5})x(\\d{1,5})$"));
  const auto match = form.match(text);
  const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
  const bool fits =
      std::min(size.width(), size.height()) >= kLeastSide && std::max(size.width(), size.height()) <= kMostSide;
  return match.hasMatch() && fits ? std::optional(size) : std::nullopt;
}

/// What can be said before the recording is read; the words of what is wrong, or none.
QString understand(const PictureOptions& options, ui::RecordingPicture& wanted) {
  if (options.file.isEmpty()) return QStringLiteral("--picture: name a recording, too");
  const bool table = options.out.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive);
  if (!table && !ui::pictureFormOf(options.out))
    return QStringLiteral("--picture %1: its name must end in .png, .svg, .pdf or .csv").arg(options.out);
  const auto view = ui::pictureViewOf(options.view.isEmpty() ? QStringLiteral("plots") : options.view);
  if (!view)
    return QStringLiteral("--view %1: take one of %2")
        .arg(options.view, ui::pictureViewNames().join(QStringLiteral(", ")));
  wanted.view = *view;
  if (table && (*view == ui::PictureView::kOverview || *view == ui::PictureView::kPlots))
    return QStringLiteral(
               "--picture %1: tables are of the views distribution, stability, cycle, slaves and free; every "
               "cycle is in \"synclinectl record export\", the overview in \"record figures\"")
        .arg(options.out);
  const bool of_signals = *view == ui::PictureView::kDistribution || *view == ui::PictureView::kStability;
  const bool free = *view == ui::PictureView::kFree;
  if (!options.signal_keys.isEmpty() && !of_signals && !free)
    return QStringLiteral("--signal: the views free, distribution and stability are of signals");
  if (!options.own_view.isEmpty() && (!free || !options.signal_keys.isEmpty()))
    return QStringLiteral("--own-view: with --view free, and without --signal");
  wanted.own_view = options.own_view;
  if (!free && options.signal_keys.size() > static_cast<qsizetype>(ui::SignalChooser::kMost))
    return QStringLiteral("--signal: four at most");
  if (!options.figure.isEmpty()) {
    const bool of_stability = *view == ui::PictureView::kStability, of_cycle = *view == ui::PictureView::kCycle;
    if (of_stability) wanted.figure = ui::stabilityFigureOf(options.figure);
    if (of_cycle) wanted.cycle_figure = ui::cycleFigureOf(options.figure);
    if (!wanted.figure && !wanted.cycle_figure)
      return QStringLiteral(
                 "--figure %1: the view stability has adev, tdev, mtie and spectrum, the view cycle "
                 "arrivals and bathtub")
          .arg(options.figure);
  }
  if ((!options.from.isEmpty() || !options.to.isEmpty()) && *view == ui::PictureView::kOverview)
    return QStringLiteral("--from, --to: the overview is since the run was armed; see \"synclinectl record figures\"");
  if (!options.slave.isEmpty()) {
    bool number = false;
    wanted.slave = options.slave.toInt(&number);
    if (!number || wanted.slave < 0) return QStringLiteral("--slave %1: a position from 0").arg(options.slave);
  }
  if (!options.size.isEmpty()) {
    const auto size = sizeOf(options.size);
    if (!size)
      return QStringLiteral("--size %1: width and height from %2 to %3, such as 1280x460")
          .arg(options.size)
          .arg(kLeastSide)
          .arg(kMostSide);
    wanted.size = *size;
  }
  return {};
}

/// Of the recording that lies over it; the words of what is wrong, or none.
QString understandOverlay(const PictureOptions& options, const ui::RecordingPicture& wanted,
                          std::optional<Nanoseconds>& offset) {
  if (options.overlay.isEmpty()) {
    const bool any = !options.align.isEmpty() || !options.offset.isEmpty();
    return any ? QStringLiteral("--align, --offset: they go with --overlay") : QString();
  }
  if (wanted.view != ui::PictureView::kPlots && wanted.view != ui::PictureView::kDistribution)
    return QStringLiteral("--overlay: only the views plots and distribution have it");
  if (!options.align.isEmpty() && options.align != QLatin1String("begin") && options.align != QLatin1String("armed"))
    return QStringLiteral("--align %1: take one of begin, armed").arg(options.align);
  if (options.offset.isEmpty()) return {};
  const bool back = options.offset.startsWith(u'-');
  const auto time = cli::parse_duration(options.offset.mid(back ? 1 : 0).toStdString());
  if (!time) return QStringLiteral("--offset %1: take a time such as 1.5s or -20ms").arg(options.offset);
  offset = back ? -*time : *time;
  return {};
}

/// Reads it and lays it where it is to lie; an exit code.
int layOver(const PictureOptions& options, std::optional<Nanoseconds> offset, ui::RecordingOverlay& overlay) {
  std::optional<Error> error;
  QEventLoop reading;
  QObject::connect(&overlay, &ui::RecordingOverlay::changed, &reading, &QEventLoop::quit);
  QObject::connect(&overlay, &ui::RecordingOverlay::failed, &reading, [&](const QString&, const Error& why) {
    error = why;
    reading.quit();
  });
  overlay.read(options.overlay);
  reading.exec();
  if (error) return told(*error);
  using Place = ui::RecordingOverlay::Place;
  if (options.align == QLatin1String("armed") && !overlay.align(Place::kArmed, {}))
    return told(QStringLiteral("--align armed: one of the two recordings was not armed"), cli::kUsage);
  if (offset) overlay.setOffset(overlay.offset() + *offset);
  return cli::kDone;
}

Status complete(const PictureOptions& options, const ReplayedRun& run, ui::RecordingPicture& wanted) {
  const auto slaves = run.info.about.slaves.size();
  if (wanted.slave >= 0 && static_cast<std::size_t>(wanted.slave) >= slaves) {
    return fail(ErrorCode::kBadValue, "--slave " + std::to_string(wanted.slave),
                because("slaves in the recording: {count}, counted from 0", slaves));
  }
  for (const auto& text : options.signal_keys) {
    const bool free = wanted.view == ui::PictureView::kFree;
    const auto source = free ? ui::drawnSignalOf(text, *run.record) : ui::signalSourceOf(text, *run.record);
    if (!source) return tl::unexpected(source.error());
    wanted.sources.push_back(*source);
  }
  const cli::RecordRange range{options.from.toStdString(), options.to.toStdString()};
  if (!range.any()) return {};
  const auto stretch = cli::stretch_of(range, run.info);
  if (!stretch) return tl::unexpected(stretch.error());
  wanted.range = {stretch->begin, stretch->end - 1};
  return {};
}

}  // namespace

int writePictureOf(const PictureOptions& options) {
  ui::RecordingPicture wanted;
  if (const auto wrong = understand(options, wanted); !wrong.isEmpty()) return told(wrong, cli::kUsage);
  std::optional<Nanoseconds> offset;
  if (const auto wrong = understandOverlay(options, wanted, offset); !wrong.isEmpty()) return told(wrong, cli::kUsage);
  const auto distinct = cli::CommandFiles()
                            .reads_recording("file", options.file.toStdString())
                            .reads_recording("--overlay", options.overlay.toStdString())
                            .writes("--picture", options.out.toStdString())
                            .check();
  if (!distinct) return told(distinct.error());
  ui::OpenedRecording recording;
  std::optional<Error> error;
  QEventLoop reading;
  QObject::connect(&recording, &ui::OpenedRecording::finished, &reading, &QEventLoop::quit);
  QObject::connect(&recording, &ui::OpenedRecording::failed, &reading, [&](const QString&, const Error& why) {
    error = why;
    reading.quit();
  });
  recording.read(options.file);
  reading.exec();
  if (error) return told(*error);
  recording.show();
  warnOf(recording.run(), options.file);
  if (auto status = complete(options, recording.run(), wanted); !status) return told(status.error());
  ui::RecordingOverlay overlay(recording);
  if (!options.overlay.isEmpty()) {
    if (const int code = layOver(options, offset, overlay); code != cli::kDone) return code;
    warnOf(overlay.run(), options.overlay);
    wanted.overlay = {overlay.run().record.get(), overlay.shift(), overlay.ownName(), overlay.name()};
  }
  if (auto status = ui::writeRecordingPicture(recording.run(), wanted, options.out); !status)
    return told(status.error());
  return cli::kDone;
}

}  // namespace syncline
