// SPDX-License-Identifier: Apache-2.0
#include "protocol/error_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace syncline {
namespace {

using testing::HasSubstr;

TEST(ErrorText, EveryCodeHasASentenceWhosePlaceholdersAreKnown) {
  for (int i = 0; i <= static_cast<int>(ErrorCode::kCancelled); ++i) {
    Error error;
    error.code = static_cast<ErrorCode>(i);
    error.subject = "SUBJECT";
    error.detail = "DETAIL";
    error.file = "FILE";
    const auto text = describe(error);
    EXPECT_FALSE(text.empty()) << i;
    EXPECT_EQ(text.find('{'), std::string::npos) << text;
  }
}

TEST(ErrorText, AlStateSaysStatesCodeAndHint) {
  Error error{ErrorCode::kAlState, "Slave 2 (Servo)"};
  error.expected = 8;
  error.received = 0x14;
  error.extra = 0x001B;
  EXPECT_EQ(describe(error),
            "Slave 2 (Servo) refused OP and stays in SAFEOP+ERR: AL status code 0x001B (SyncManager watchdog); check "
            "why outputs stopped for longer than the watchdog 0x0420 (loop, working counter).");
}

TEST(ErrorText, AbortCodeIsShownInWords) {
  Error error{ErrorCode::kSdoAbort, "Slave 1, 0x1C12:01"};
  error.received = 0x06020000;
  EXPECT_EQ(describe(error),
            "Slave 1, 0x1C12:01: the slave aborted the SDO transfer with 0x06020000 (object does not exist).");
}

TEST(ErrorText, FileAndLineLeadTheSentence) {
  Error error{ErrorCode::kXmlBadValue, "Vendor/Id", "\"#x1G\" is not a number", "a.xml", 12};
  EXPECT_EQ(describe(error), "a.xml:12: the value of <Vendor/Id> cannot be used: \"#x1G\" is not a number.");
  Error without_line{ErrorCode::kXmlMalformed, {}, "", "a.xml"};
  EXPECT_EQ(describe(without_line), "a.xml: this is not well-formed XML.");
  Error elsewhere{ErrorCode::kBadValue, "cycle", "0", "m.syncline", 3};
  EXPECT_EQ(describe(elsewhere), "m.syncline:3: The value of cycle cannot be used: 0.");
}

TEST(ErrorText, PermissionNamesTheCommand) {
  EXPECT_THAT(describe({ErrorCode::kLinkPermission, "eth0", "sudo setcap x=ep /opt/bin"}),
              HasSubstr("sudo setcap x=ep /opt/bin"));
}

TEST(ErrorText, TranslatedTemplatesMayReorderAndMayBeBroken) {
  Error error{ErrorCode::kWorkingCounter, "LRW"};
  error.expected = 3;
  error.received = 1;
  EXPECT_EQ(fill_error_template("{expected} statt {received}: {subject}", error), "3 statt 1: LRW");
  EXPECT_EQ(fill_error_template("{nobody} {subject", error), "{nobody} {subject");
  EXPECT_EQ(fill_error_template("", error), "");
}

TEST(ErrorText, FactsAreNotReadAsTemplates) {
  EXPECT_THAT(describe({ErrorCode::kUnknownKey, "{detail}", "x"}), HasSubstr("\"{detail}\""));
}

}  // namespace
}  // namespace syncline
