// SPDX-License-Identifier: Apache-2.0
#include "app/gui/options.h"

#include <QCommandLineParser>
#include <QList>
#include <cstdio>
#include <cstdlib>

#include "app/cli/cli.h"
#include "ui/text/translations.h"

namespace syncline {
namespace {

constexpr int kLongestExitAfter = 1'000'000;  // s

/// What makes a picture of a recording, without a window.
struct PictureSwitches {
  QCommandLineOption out{
      QStringLiteral("picture"),
      QStringLiteral("Write a picture of the recording that is named to OUT (.png, .svg, .pdf), or what it shows "
                     "as a table (.csv), then exit; needs no display. Exit codes as synclinectl's."),
      QStringLiteral("OUT")};
  QCommandLineOption view{QStringLiteral("view"),
                          QStringLiteral("With --picture: overview, plots (default), distribution, stability, cycle, "
                                         "slaves or free."),
                          QStringLiteral("NAME")};
  QCommandLineOption own_view{QStringLiteral("own-view"),
                              QStringLiteral("With --picture --view free: a view of the project in the recording; the "
                                             "first one without it."),
                              QStringLiteral("NAME")};
  QCommandLineOption from{
      QStringLiteral("from"),
      QStringLiteral("With --picture: begin of the range since the recording's, e.g. 1.5s or 2min."),
      QStringLiteral("TIME")};
  QCommandLineOption to{QStringLiteral("to"), QStringLiteral("With --picture: end of the range."),
                        QStringLiteral("TIME")};
  QCommandLineOption signal{
      QStringLiteral("signal"),
      QStringLiteral("With --picture: a signal of distribution or stability, e.g. dcm_error_ns, or deviation_ns@3 of "
                     "slave 3; up to four times. Of the view free any signal, e.g. al_status@3, as often as wanted."),
      QStringLiteral("KEY")};
  QCommandLineOption figure{QStringLiteral("figure"),
                            QStringLiteral("With --picture --view stability: adev, tdev, mtie or spectrum; with "
                                           "--view cycle: arrivals (default) or bathtub."),
                            QStringLiteral("NAME")};
  QCommandLineOption slave{
      QStringLiteral("slave"),
      QStringLiteral("With --picture: the slave that the plots draw in any case, whose cycle it is."),
      QStringLiteral("POSITION")};
  QCommandLineOption size{QStringLiteral("size"),
                          QStringLiteral("With --picture: its size in pixels of a screen; a PNG has twice as many."),
                          QStringLiteral("WxH")};

  QCommandLineOption align{
      QStringLiteral("align"),
      QStringLiteral("With --picture --overlay: what lies over each other, begin (default) or armed."),
      QStringLiteral("MOMENT")};
  QCommandLineOption offset{
      QStringLiteral("offset"),
      QStringLiteral("With --picture --overlay: how much later the other recording is drawn, e.g. 1.5s or -20ms."),
      QStringLiteral("TIME")};

  [[nodiscard]] QList<QCommandLineOption> all() const {
    return {out, view, own_view, from, to, signal, figure, slave, size, align, offset};
  }
  [[nodiscard]] PictureOptions of(const QCommandLineParser& parser) const {
    return {{},
            parser.value(out),
            parser.value(view),
            parser.value(own_view),
            parser.value(from),
            parser.value(to),
            parser.value(figure),
            parser.value(slave),
            parser.value(size),
            {},
            parser.value(align),
            parser.value(offset),
            parser.values(signal)};
  }
};

[[noreturn]] void refuse(const QString& words) {
  std::fprintf(stderr, "syncline: %s\n", qUtf8Printable(words));
  std::exit(cli::kUsage);
}

/// Null where the option is not given, empty where its value is.
QString given(const QCommandLineParser& parser, const QCommandLineOption& option) {
  if (!parser.isSet(option)) return {};
  const auto value = parser.value(option);
  return value.isNull() ? QStringLiteral("") : value;
}

/// Nothing is taken for another value: who typed it sees that the window is not as asked.
void refuse_values(const Options& options, const QString& exit_after) {
  const QStringList themes{QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("contrast"),
                           QStringLiteral("system")};
  if (!options.theme.isNull() && !themes.contains(options.theme))
    refuse(QStringLiteral("--theme: \"%1\" is none of %2").arg(options.theme, themes.join(QStringLiteral(", "))));
  QStringList codes;
  for (const auto& language : ui::languages()) codes << language.code;
  if (!options.language.isNull() && !codes.contains(options.language))
    refuse(QStringLiteral("--language: \"%1\" is none of %2").arg(options.language, codes.join(QStringLiteral(", "))));
  if (!exit_after.isNull() && options.exit_after_ms <= 0)
    refuse(QStringLiteral("--exit-after: \"%1\" is no number of seconds from 0.001 to %2")
               .arg(exit_after)
               .arg(kLongestExitAfter));
}

/// 0 where it is no number that a timer takes.
int milliseconds_of(const QString& seconds) {
  bool is_number = false;
  const double value = seconds.toDouble(&is_number);
  return is_number && value >= 0.001 && value <= kLongestExitAfter ? static_cast<int>(value * 1000) : 0;
}

}  // namespace

Options parse_options(const QCoreApplication& app) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("EtherCAT configurator and live synchronisation monitor"));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption demo(QStringLiteral("demo"),
                                QStringLiteral("Scan the simulated demonstration machine and go online."));
  const QCommandLineOption link(QStringLiteral("link"), QStringLiteral("Bus to use: sim:FILE[?virtual] or nic:NAME."),
                                QStringLiteral("LINK"));
  const QCommandLineOption theme(QStringLiteral("theme"), QStringLiteral("light, dark, contrast or system."),
                                 QStringLiteral("NAME"));
  const QCommandLineOption language(
      QStringLiteral("language"),
      QStringLiteral("Language of the window: en, de or zh_CN; default is that of View > Language."),
      QStringLiteral("CODE"));
  const QCommandLineOption screenshots(
      QStringLiteral("screenshots"), QStringLiteral("Write a picture of every page in both themes to DIR, then exit."),
      QStringLiteral("DIR"));
  const QCommandLineOption exit_after(QStringLiteral("exit-after"), QStringLiteral("Close after SECONDS."),
                                      QStringLiteral("SECONDS"));
  const QCommandLineOption reset(
      QStringLiteral("reset-settings"),
      QStringLiteral("Forget what the window remembers (layout, theme, language, expert settings, recent projects), "
                     "then start."));
  const QCommandLineOption faults(
      QStringLiteral("faults"),
      QStringLiteral("With --screenshots: the overview of each scenario of FOLDER instead of the pages."),
      QStringLiteral("FOLDER"));
  const QCommandLineOption overlay(
      QStringLiteral("overlay"),
      QStringLiteral("Another recording, laid over the one that is named: in the window, or with --picture."),
      QStringLiteral("RECORDING"));
  const PictureSwitches picture;
  parser.addOption(overlay);
  parser.addOptions({demo, link, theme, language, screenshots, faults, exit_after, reset});
  parser.addOptions(picture.all());
  parser.addPositionalArgument(QStringLiteral("file"),
                               QStringLiteral("Project, ENI, ESI, capture, recording or scenario to open."),
                               QStringLiteral("[file]"));
  if (!parser.parse(QCoreApplication::arguments())) refuse(parser.errorText());
  parser.process(app);
  Options options;
  if (parser.positionalArguments().size() > 1) {
    refuse(
        QStringLiteral("\"%1\": one file is opened, and that is \"%2\"; lay another recording over it with --overlay")
            .arg(parser.positionalArguments().at(1), parser.positionalArguments().constFirst()));
  }
  if (!parser.positionalArguments().isEmpty()) options.file = parser.positionalArguments().constFirst();
  options.picture = picture.of(parser);
  options.picture.file = options.file;
  options.overlay = options.picture.overlay = parser.value(overlay);
  if (!options.overlay.isEmpty() && options.file.isEmpty())
    refuse(QStringLiteral("--overlay: name the recording that it lies over, too"));
  if (!parser.isSet(picture.out)) {
    for (const auto& option : picture.all()) {
      if (parser.isSet(option)) refuse(QStringLiteral("--%1 goes with --picture").arg(option.names().constFirst()));
    }
  } else if (options.picture.out.isEmpty()) {
    refuse(QStringLiteral("--picture: name the file to write"));
  }
  if (parser.isSet(faults) && !parser.isSet(screenshots)) refuse(QStringLiteral("--faults goes with --screenshots"));
  for (const auto& option : {demo, link, theme, screenshots, exit_after, reset}) {
    if (parser.isSet(picture.out) && parser.isSet(option))
      refuse(QStringLiteral("--%1: a picture of a recording needs no window, leave --%1 or --picture out")
                 .arg(option.names().constFirst()));
  }
  options.link = parser.value(link);
  options.theme = given(parser, theme);
  options.screenshots = parser.value(screenshots);
  options.faults = parser.value(faults);
  options.language = given(parser, language);
  options.demo = parser.isSet(demo);
  options.reset_settings = parser.isSet(reset);
  options.exit_after_ms = milliseconds_of(parser.value(exit_after));
  refuse_values(options, parser.isSet(exit_after) ? given(parser, exit_after) : QString());
  return options;
}

}  // namespace syncline
