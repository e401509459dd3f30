// SPDX-License-Identifier: Apache-2.0
#include <signal.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QScreen>
#include <QSettings>
#include <QSocketNotifier>
#include <QStandardPaths>
#include <QStyle>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "app/cli/cli.h"
#include "app/composition/eeprom_journal.h"
#include "app/composition/slave_eeprom.h"
#include "app/composition/state_folder.h"
#include "app/gui/bus_functions.h"
#include "app/gui/fault_pictures.h"
#include "app/gui/recording_picture.h"
#include "app/gui/screenshots.h"
#include "link/pcap_link.h"
#include "reasons/because.h"
#include "support/stop_signals.h"
#include "ui/dialogs/bus_commands.h"
#include "ui/dialogs/file_commands.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"
#include "ui/text/translations.h"
#include "ui/theme/theme.h"
#include "ui/window_layout.h"
#include "ui/window_overlay.h"

namespace {

using namespace syncline;

const QString kThemeSetting = QStringLiteral("theme"), kExpertSetting = QStringLiteral("expert");

struct Options {
  QString file, link, theme, screenshots, faults, language, overlay;
  bool demo = false, reset_settings = false;
  int exit_after_ms = 0;
  PictureOptions picture;  // without a name to write to: none is wanted
};

/// What makes a picture of a recording, without a window.
struct PictureSwitches {
  QCommandLineOption out{
      QStringLiteral("picture"),
      QStringLiteral("Write a picture of the recording that is named to OUT (.png, .svg, .pdf), then "
                     "exit; needs no display. Exit codes as synclinectl's."),
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
                            QStringLiteral("With --picture --view stability: adev, tdev, mtie or spectrum."),
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

Options parse(const QCoreApplication& app) {
  QCommandLineParser parser;
  parser.setApplicationDescription(QStringLiteral("EtherCAT configurator and live synchronisation monitor"));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption demo(QStringLiteral("demo"),
                                QStringLiteral("Scan the simulated demonstration machine and go online."));
  const QCommandLineOption link(QStringLiteral("link"), QStringLiteral("Bus to use: sim:FILE[?virtual] or nic:NAME."),
                                QStringLiteral("LINK"));
  const QCommandLineOption theme(QStringLiteral("theme"), QStringLiteral("light, dark or system."),
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
  options.link = parser.value(link);
  options.theme = parser.value(theme);
  options.screenshots = parser.value(screenshots);
  options.faults = parser.value(faults);
  options.language = parser.value(language);
  options.demo = parser.isSet(demo);
  options.reset_settings = parser.isSet(reset);
  options.exit_after_ms = static_cast<int>(parser.value(exit_after).toDouble() * 1000);
  return options;
}

/// A slave whose EEPROM is half written may not come up at its next power-on.
ui::EepromRepairs eeprom_repairs() {
  ui::EepromRepairs repairs;
  repairs.pending = [] {
    std::vector<ui::CutShortWrite> writes;
    for (const auto& journal : pending_journals()) {
      writes.push_back({QString::fromStdString(journal.link), journal.position, QString::fromStdString(journal.begun)});
    }
    return writes;
  };
  repairs.end = [](const ui::CutShortWrite& write, bool undo, const std::atomic<bool>& cancel) -> Status {
    const auto report =
        finish_eeprom({write.link.toStdString(), static_cast<std::uint16_t>(write.position), &cancel}, undo);
    return report ? Status{} : Status(tl::unexpected(report.error()));
  };
  repairs.keep = [](const QString& link, int position, const std::vector<std::uint8_t>& before,
                    const std::vector<std::uint8_t>& after) -> Status {
    const auto slave = static_cast<std::uint16_t>(position);
    if (find_journal(link.toStdString(), slave)) {
      return fail(ErrorCode::kSii, "slave " + std::to_string(position),
                  because("a write of it was cut short; go offline and end that first"));
    }
    return keep_journal({link.toStdString(), slave, {}, before, after});
  };
  repairs.drop = [](const QString& link, int position) {
    drop_journal(link.toStdString(), static_cast<std::uint16_t>(position));
  };
  return repairs;
}

Result<std::vector<ui::NetworkAdapter>> adapters() {
  const auto found = list_adapters();
  if (!found) return tl::unexpected(found.error());
  std::vector<ui::NetworkAdapter> out;
  for (const auto& adapter : *found) {
    out.push_back({QString::fromStdString(adapter.name), QString::fromStdString(adapter.description), adapter.up});
  }
  return out;
}

ui::Environment environment() {
  ui::Environment environment;
  connect_buses(environment);
  environment.list_adapters = adapters;
  environment.eeprom_repairs = eeprom_repairs();
  environment.recovery_folder = QString::fromStdString(state_folder("unsaved"));
  environment.templates_folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/templates");
  environment.version = QStringLiteral(SYNCLINE_VERSION);
  return environment;
}

/// What a handler throws must not tear the program down while slaves drive: the loop ends, and the end is the ordinary
/// one.
class Application final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    try {
      return QApplication::notify(receiver, event);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "syncline: this should not have happened: %s\n", error.what());
    } catch (...) {
      std::fputs("syncline: this should not have happened\n", stderr);
    }
    QApplication::exit(1);
    return false;
  }
};

/// What is answered in the terminal needs no display.
bool only_asks(int argc, char* argv[]) {
  return std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument == "-h" || argument == "--help" || argument == "--help-all" || argument == "-v" ||
           argument == "--version";
  });
}

/// A picture is the same with and without a display: it is drawn on none.
bool draws_a_picture(int argc, char* argv[]) {
  return std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument == "--picture" || argument.starts_with("--picture=");
  });
}

/// The platform without a display has no size hints and says so for every widget, and a service has no folder of a
/// session, which a picture does not need.
void without_chatter(QtMsgType, const QMessageLogContext&, const QString& text) {
  for (const char* chatter : {"propagateSizeHints", "XDG_RUNTIME_DIR"}) {
    if (text.contains(QLatin1String(chatter))) return;
  }
  std::fprintf(stderr, "%s\n", qUtf8Printable(text));
}

void begin(const Options& options, ui::MainWindow& window, ui::Workspace& workspace) {
  if (!options.link.isEmpty()) workspace.setLink(options.link);
  window.bus().offerRepairs();
  window.files().offerRecovery([options, &window, &workspace] {
    if (!options.overlay.isEmpty()) {
      QObject::connect(
          &workspace.recording(), &ui::OpenedRecording::changed, &window,
          [options, &window] { window.overlay().open(options.overlay); },
          Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
    }
    if (!options.file.isEmpty()) window.files().openAny(options.file);
    if (!options.demo) return;
    window.bus().startDemo(options.link.isEmpty() ? workspace.environment().demo_link : options.link);
  });
}

/// Where the usual size does not fit, its frame neither, the window takes the whole screen.
void show(ui::MainWindow& window) {
  const auto room = window.screen()->availableSize();
  const int frame = window.style()->pixelMetric(QStyle::PM_TitleBarHeight);
  if (window.width() > room.width() || window.height() + frame > room.height()) return window.showMaximized();
  window.show();
}

}  // namespace

int main(int argc, char* argv[]) {
  ::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of that file
  if (only_asks(argc, argv)) {
    const QCoreApplication text(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("syncline"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SYNCLINE_VERSION));
    parse(text);  // prints and ends
  }
  const bool draws = draws_a_picture(argc, argv);
  if (draws) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(without_chatter);
  }
  Application app(argc, argv);
  QApplication::setApplicationName(QStringLiteral("syncline"));
  QApplication::setOrganizationName(QStringLiteral("syncline"));
  QApplication::setApplicationVersion(QStringLiteral(SYNCLINE_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("org.syncline.Syncline"));
  const auto options = parse(app);
  if (draws) {
    ui::installTranslation(options.language);
    ui::theme::apply(ui::theme::Mode::kLight);
    return writePictureOf(options.picture);
  }
  QSettings settings(QSettings::IniFormat, QSettings::UserScope, QApplication::organizationName(),
                     QApplication::applicationName());
  if (options.reset_settings) {
    settings.clear();
    settings.sync();
  }
  // Pictures are the same on every machine.
  const bool own = options.language.isEmpty() && options.screenshots.isEmpty();
  ui::installTranslation(own ? settings.value(ui::kLanguageSetting).toString() : options.language);
  ui::theme::apply(
      ui::theme::modeFromName(options.theme.isEmpty() ? settings.value(kThemeSetting).toString() : options.theme));
  auto surroundings = environment();
  if (options.screenshots.isEmpty()) {
    surroundings.settings_file = settings.fileName();
  } else {
    surroundings.recovery_folder.clear();  // its edits are nobody's work
    surroundings.templates_folder.clear();
  }
  ui::Workspace workspace(std::move(surroundings));
  ui::MainWindow window(workspace);
  if (options.screenshots.isEmpty()) workspace.setExpert(settings.value(kExpertSetting).toBool());
  if (!options.screenshots.isEmpty()) {
    window.show();
    if (!options.faults.isEmpty())
      return renderFaultPictures(window, workspace, options.faults, options.screenshots) ? 0 : 1;
    return renderScreenshots(window, workspace, workspace.environment().demo_link, options.screenshots) ? 0 : 1;
  }
  show(window);
  // Asks nothing: who closes the terminal or shuts the machine down does not answer. The slaves go to INIT all the
  // same.
  const StopSignals stop;
  QSocketNotifier asked_to_end(stop.descriptor(), QSocketNotifier::Read);
  QObject::connect(&asked_to_end, &QSocketNotifier::activated, &app, [&] {
    asked_to_end.setEnabled(false);
    workspace.scan().cancel();
    QApplication::exit(0);
  });
  QTimer::singleShot(0, &window, [&] { begin(options, window, workspace); });
  if (options.exit_after_ms > 0)
    QTimer::singleShot(options.exit_after_ms, &app, [] { QApplication::exit(0); });  // asks nothing, unlike quit()
  const int result = QApplication::exec();
  if (options.theme.isEmpty()) settings.setValue(kThemeSetting, ui::theme::modeName(ui::theme::current()));
  settings.setValue(kExpertSetting, workspace.expert());
  window.panels().remember();
  workspace.runs().shutDown();
  return result;
}
