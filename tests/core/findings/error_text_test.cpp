// SPDX-License-Identifier: Apache-2.0
#include "findings/error_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "findings/finding.h"
#include "findings/reason_of.h"
#include "findings/value_bytes.h"
#include "reasons/because.h"

namespace syncline {
namespace {

using testing::HasSubstr;

Reason others(std::string text) { return Reason::verbatim(std::move(text)); }

TEST(ErrorText, EveryCodeHasARowWhosePlaceholdersAreKnown) {
  std::set<std::string> codes;
  for (int i = 0; i <= static_cast<int>(ErrorCode::kCatalogue); ++i) {
    Error error;
    error.code = static_cast<ErrorCode>(i);
    const auto code = finding_of(error).code;
    EXPECT_NE(find_finding_words(code), nullptr) << i;
    EXPECT_TRUE(codes.insert(std::string(code)).second) << code << " is the row of another one, too";
    error.subject = "SUBJECT";
    error.detail = others("DETAIL");
    error.file = "FILE";
    const auto text = describe(error);
    EXPECT_FALSE(text.empty()) << i;
    EXPECT_EQ(text.find('{'), std::string::npos) << text;
  }
}

/// What stands in another sentence is what stands alone, and can be said in other languages: by its row's words.
TEST(ErrorText, AsAReasonItSaysTheSame) {
  for (int i = 0; i <= static_cast<int>(ErrorCode::kCatalogue); ++i) {
    for (const int number : {0, 1, 0x001B, 0x06020000}) {
      for (const auto& detail : {Reason(), because("it has no slaves"), others("theirs")}) {
        Error error{static_cast<ErrorCode>(i), "SUBJECT", detail};
        error.expected = error.received = error.extra = number;
        const auto reason = reason_of(error);
        EXPECT_EQ(reason.text(), describe(finding_of(error)));
        EXPECT_FALSE(reason.words().empty()) << reason.text();
        error.file = "a.xml";
        error.line = 7;
        EXPECT_THAT(reason_of(error).text(), testing::EndsWith(describe(finding_of(error))));
        EXPECT_THAT(describe(error), HasSubstr("a.xml"));
      }
    }
  }
}

TEST(ErrorText, AsAReasonItComesBackFromItsBytes) {
  Error slaves{ErrorCode::kSlaveCount};
  slaves.expected = 2;
  slaves.received = 1;
  for (const auto& reason :
       {reason_of(Error{ErrorCode::kXmlBadValue, "Id", because("\"{text}\" is no number", "1k"), "a.xml", 3}),
        reason_of(Error{ErrorCode::kFileNotFound, {}, {}, "b.xml"}), reason_of(slaves)}) {
    ValueWriter out;
    auto copy = reason;
    out(WordedReason{copy});
    const auto bytes = out.take();
    auto back = Reason::phrase(reason.text());
    WordedReason worded{back};
    ValueReader{bytes}(worded);
    EXPECT_EQ(back, reason) << reason.text();
    EXPECT_FALSE(back.given().empty());
  }
  EXPECT_EQ(reason_of_any_words("{subject} is no row{because}.", {Reason(), Reason()}), std::nullopt);
  EXPECT_EQ(reason_of_any_words("{subject} is missing{because}.", {Reason()}), std::nullopt) << "one is missing";
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
  Error error{ErrorCode::kXmlBadValue, "Vendor/Id", because("\"{text}\" is no number", "#x1G"), "a.xml", 12};
  EXPECT_EQ(describe(error), "a.xml:12: the value of <Vendor/Id> cannot be used: \"#x1G\" is no number.");
  Error without_line{ErrorCode::kXmlMalformed, {}, {}, "a.xml"};
  EXPECT_EQ(describe(without_line), "a.xml: this is not well-formed XML.");
  Error elsewhere{ErrorCode::kBadValue, "cycle", others("0"), "m.syncline", 3};
  EXPECT_EQ(describe(elsewhere), "m.syncline:3: The value of cycle cannot be used: 0.");
}

TEST(ErrorText, PermissionNamesTheCommand) {
  EXPECT_THAT(describe({ErrorCode::kLinkPermission, "eth0", others("sudo setcap x=ep /opt/bin")}),
              HasSubstr("sudo setcap x=ep /opt/bin"));
}

TEST(ErrorText, TranslatedTemplatesMayReorderAndMayBeBroken) {
  Error error{ErrorCode::kWorkingCounter, "LRW"};
  error.expected = 3;
  error.received = 1;
  const auto finding = finding_of(error);
  EXPECT_EQ(fill_finding_template("{expected} statt {received}: {subject}", finding), "3 statt 1: LRW");
  EXPECT_EQ(fill_finding_template("{nobody} {subject", finding), "{nobody} {subject");
  EXPECT_EQ(fill_finding_template("", finding), "");
}

TEST(ErrorText, AFindingOfAnErrorKeepsItsPlaceAndSaysWhatToDo) {
  const auto finding = finding_of({ErrorCode::kFileNotWritable, {}, others("disk full"), "out.xml"});
  EXPECT_EQ(finding.code, "file-not-writable");
  EXPECT_EQ(finding.severity, Severity::kError);
  EXPECT_EQ(finding.place.file, "out.xml");
  EXPECT_EQ(describe(finding),
            "The file out.xml cannot be written: disk full. Check the folder's permissions and free space.");
}

TEST(ErrorText, AStateCodeWithoutAdviceHasNone) {
  Error error{ErrorCode::kAlState, "Slave 2"};
  error.expected = 4;
  error.received = 0x12;
  EXPECT_EQ(describe(error), "Slave 2 refused SAFEOP and stays in PREOP+ERR: AL status code 0x0000 (no error).");
}

TEST(ErrorText, TheDeviceSaysWhyItEndsAFileTransfer) {
  Error error{ErrorCode::kFileTransfer, "slave 1", others("busy")};
  error.received = 0x8002;
  EXPECT_THAT(describe(error), testing::StartsWith("slave 1: the slave ended the file transfer with 0x8002 ("));
}

TEST(ErrorText, FactsAreNotReadAsTemplates) {
  EXPECT_THAT(describe({ErrorCode::kUnknownKey, "{detail}", others("x")}), HasSubstr("\"{detail}\""));
}

}  // namespace
}  // namespace syncline
