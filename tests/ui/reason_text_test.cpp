// SPDX-License-Identifier: Apache-2.0
// What errors and counts say in the user's language.
#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "channels/event.h"
#include "channels/event_finding.h"
#include "findings/error_text.h"
#include "findings/finding.h"
#include "reasons/because.h"
#include "settings/setting_type.h"
#include "support/result.h"
#include "support/speak.h"
#include "ui/text/error_text.h"
#include "ui/text/finding_text.h"

namespace syncline::ui {
namespace {

TEST(ReasonText, AnErrorsOwnWordsAreTranslatedWithItsFigures) {
  const Error busy{ErrorCode::kSii, "slave 3",
                   because("the EEPROM stays busy at word 0x{word}{which}", "0040", " (twice)")};
  const Error number{ErrorCode::kXmlBadValue, "CycleTime", because("\"{text}\" is no number", "1k"), "a.xml", 7};
  const test::Speak speak(QStringLiteral("de"));
  EXPECT_TRUE(errorText(busy).contains(QStringLiteral("das EEPROM bleibt bei Wort 0x0040 beschäftigt (twice)")))
      << qPrintable(errorText(busy));
  EXPECT_TRUE(errorText(number).contains(QStringLiteral("\"1k\" ist keine Zahl"))) << qPrintable(errorText(number));
  EXPECT_EQ(reasonText(Reason::verbatim(std::string("Achse X"))), QStringLiteral("Achse X"));
}

TEST(ReasonText, OneInAnothersPlaceIsTranslatedAndTheTextsOfOthersAreNot) {
  const test::Speak speak(QStringLiteral("de"));
  const auto device = because("Device {device}: {reason}", "{reason}", because("\"{text}\" is no number", "{text}"));
  EXPECT_TRUE(reasonText(device).contains(QStringLiteral("{reason}: \"{text}\" ist keine Zahl")))
      << qPrintable(reasonText(device));
  EXPECT_EQ(reasonText(Reason::verbatim(std::string("no carrier"))), QStringLiteral("no carrier"));
  EXPECT_EQ(reasonText(because("no carrier")), QStringLiteral("keine Verbindung am Kabel"));
  EXPECT_NE(reasonText(Reason::of_system(ENOSPC)), QString::fromLocal8Bit(std::strerror(ENOSPC)));
}

TEST(ReasonText, WhatIsTypedWronglyIsSaidInTheUsersLanguage) {
  const auto typed = settings::parse_value(settings::Number{}, "abc");
  ASSERT_FALSE(typed);
  for (const auto& code : test::translatedLanguages()) {
    const test::Speak speak(code);
    const auto said = reasonText(typed.error().detail);
    EXPECT_NE(said, QString::fromStdString(typed.error().detail.text())) << qPrintable(code);
    EXPECT_TRUE(said.contains(QStringLiteral("abc"))) << qPrintable(said);
  }
}

TEST(ReasonText, ACountOfOneHasItsOwnWords) {
  const auto text = [](std::int64_t count) {
    return findingText(event_finding(Event{0, -1, events::FramesLost{count}}).value());
  };
  EXPECT_EQ(text(1), QStringLiteral("1 frame lost"));
  EXPECT_EQ(text(0), QStringLiteral("0 frames lost"));
  const test::Speak speak(QStringLiteral("de"));
  EXPECT_EQ(text(1), QStringLiteral("1 Frame verloren"));
  EXPECT_EQ(text(3), QStringLiteral("3 Frames verloren"));
}

}  // namespace
}  // namespace syncline::ui
