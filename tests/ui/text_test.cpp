// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>
#include <string>

#include "channels/snapshot.h"
#include "config/dcm_settings.h"
#include "config/project.h"
#include "tests/support/every_event.h"
#include "ui/panels/status_panel.h"
#include "ui/text/error_text.h"
#include "ui/text/event_text.h"
#include "ui/text/message.h"
#include "ui/text/sync_text.h"
#include "ui/text/translations.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

QString plain(QString text) { return text.replace(QChar(0x00A0), u' '); }

TEST(Units, ChooseTheUnitBySize) {
  EXPECT_EQ(plain(timeText(127)), QStringLiteral("127 ns"));
  EXPECT_EQ(plain(timeText(-1'500)), QStringLiteral("\u22121.500 \u00B5s"));
  EXPECT_EQ(plain(timeText(2'000'000)), QStringLiteral("2.000 ms"));
  EXPECT_EQ(plain(signedTimeText(12)), QStringLiteral("+12 ns"));
  EXPECT_EQ(plain(cycleText(62'500)), QStringLiteral("62.5 \u00B5s"));
  EXPECT_EQ(plain(cycleText(1'000'000)), QStringLiteral("1 ms"));
  EXPECT_EQ(plain(cycleText(100'000)), QStringLiteral("100 \u00B5s"));
}

TEST(Units, HexadecimalKeepsItsPrefixSmall) {
  EXPECT_EQ(hexText(0x44c2c52, 8), QStringLiteral("0x044C2C52"));
  EXPECT_EQ(hexText(0x300, 4), QStringLiteral("0x0300"));
}

TEST(Units, CountsOnALogarithmicAxis) {
  EXPECT_EQ(countDecadeText(0), QStringLiteral("1"));
  EXPECT_EQ(countDecadeText(3), QStringLiteral("1000"));
  EXPECT_EQ(countDecadeText(4), QStringLiteral("10\u2074"));
  EXPECT_EQ(decadeText(0), QStringLiteral("1"));
  EXPECT_EQ(decadeText(12), QStringLiteral("10\u207B\u00B9\u00B2"));
}

TEST(Units, FollowTheUsersLocaleOnScreenOnly) {
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_EQ(plain(timeText(1'500)), QStringLiteral("1,500 \u00B5s"));
  QLocale::setDefault(QLocale::c());
}

TEST(Units, NeverShowANegativeZero) {
  EXPECT_EQ(plain(ppmText(-0.001)), QStringLiteral("0.00 ppm"));
  EXPECT_EQ(plain(ppmText(12.345)), QStringLiteral("+12.35 ppm"));
}

/// What stands in sentences is German, too: meanings of AL status codes, DCM errors, why the master is not in sync, the
/// meanings of SDO aborts.
TEST(Translations, WordsInsideSentencesAreGerman) {
  ASSERT_TRUE(installTranslation(QStringLiteral("de")));
  const auto said = [](int slave, EventDetails what) {
    return plain(messageOf(Event{0, slave, std::move(what)}, Project{})->text);
  };
  EXPECT_EQ(said(3, events::AlStatusError{0x14, 0x1B}),
            QStringLiteral("Slave 3: SAFEOP+ERR mit AL-Statuscode 0x001B (SyncManager-Watchdog); zu prüfen: warum "
                           "Ausgänge länger ausblieben als der Watchdog 0x0420 (Schleife, Working Counter)"));
  EXPECT_EQ(said(-1, events::MasterOutOfSync{-7, dc::SyncObstacle::kClockStep}),
            QStringLiteral("Master NICHT SYNCHRON, Fehler \u22127 ns: die Referenzuhr ist gesprungen"));
  EXPECT_EQ(said(-1, events::StateChanged{AlState::kSafeop, AlState::kNone}),
            QStringLiteral("Master: SAFEOP \u2192 unbekannt"));
  EXPECT_FALSE(said(-1, events::DcmError{0x981201CA, 700}).contains(QStringLiteral("drift apart")));
  Error abort{ErrorCode::kSdoAbort, "Slave 1"};
  abort.received = 0x06020000;
  EXPECT_EQ(errorText(abort), QStringLiteral("Slave 1: der Slave hat die SDO-Übertragung abgebrochen mit 0x06020000 "
                                             "(Objekt gibt es nicht)."));
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>()) delete translator;
  QLocale::setDefault(QLocale::c());
}

/// German is complete, and the window's classes find it.
TEST(Translations, GermanReachesTheClasses) {
  ASSERT_TRUE(installTranslation(QStringLiteral("de")));
  EXPECT_EQ(StatusPanel::tr("No link chosen"), QStringLiteral("Kein Link gewählt"));
  EXPECT_EQ(errorText(Error{ErrorCode::kCancelled}), QStringLiteral("Abgebrochen."));
  EXPECT_EQ(bitsText(8), QStringLiteral("1 Byte"));
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>()) delete translator;
  QLocale::setDefault(QLocale::c());
}

TEST(ErrorText, KeepsAFilesNameAndSaysWhatToDo) {
  EXPECT_EQ(errorText({ErrorCode::kXmlMalformed, {}, {}, "a.xml", 3}),
            QStringLiteral("a.xml:3: this is not well-formed XML."));
  EXPECT_EQ(errorText({ErrorCode::kLinkPermission, "eth0", Reason::verbatim(std::string("sudo setcap"))}),
            QStringLiteral("No permission to send raw frames on eth0. Grant it once with: sudo setcap"));
}

TEST(SyncText, ShowsTheVerdictAndNothingElse) {
  Snapshot snapshot;
  snapshot.online = true;
  snapshot.dc.enabled = true;
  snapshot.dc.monitored = true;
  snapshot.dc.state = SyncState::kNotMonitored;  // nobody follows
  EXPECT_EQ(slavesSync(snapshot).tone, theme::Tone::kNeutral);
  EXPECT_EQ(slavesSync(snapshot).text, QStringLiteral("Not monitored"));
  snapshot.dc.state = SyncState::kUnknown;
  EXPECT_EQ(slavesSync(snapshot).tone, theme::Tone::kWarning);
  snapshot.dcm.mode = DcmMode::kBusShift;
  snapshot.dcm.state = SyncState::kOutOfSync;
  snapshot.dcm.obstacle = dc::SyncObstacle::kCyclesLeftOut;
  EXPECT_EQ(masterSync(snapshot).text, QStringLiteral("Out of sync: cycles left out"));
  EXPECT_EQ(masterSync(snapshot).tone, theme::Tone::kBad);
}

TEST(EventText, EveryKindButProgressHasWords) {
  for (const auto& event : test::one_of_each()) {
    const auto message = messageOf(event, Project{});
    ASSERT_EQ(message.has_value(), !event.is<events::ScanProgress>()) << event.what.index();
    const bool has_words = message && !event.is<events::MasterStopped>();
    EXPECT_EQ(has_words && message->text.isEmpty(), false) << event.what.index();
  }
}

TEST(EventText, NamesTheAlStatusCode) {
  const Event event{0, -1, events::AlStatusError{0x14, 0x1B}};
  const auto message = messageOf(event, Project{});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->severity, Severity::kError);
  EXPECT_TRUE(message->text.contains(QStringLiteral("0x001B"))) << qPrintable(message->text);
  EXPECT_TRUE(message->text.contains(QStringLiteral("watchdog"), Qt::CaseInsensitive)) << qPrintable(message->text);
}

}  // namespace
}  // namespace syncline::ui
