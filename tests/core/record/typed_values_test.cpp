// SPDX-License-Identifier: Apache-2.0
#include "record/typed_values.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>

#include "findings/figure.h"
#include "findings/finding.h"
#include "reasons/because.h"
#include "reasons/placeholder.h"

namespace syncline {
namespace {

TEST(TypedValues, EachKindOfEventComesBack) {
  const std::vector<EventDetails> all = {
      events::StateChanged{AlState::kSafeop, AlState::kOp},
      events::AlStatusError{0x14, 0x1A},
      events::HotConnect{events::HotConnect::What::kConnected, SharedText("tool changer")},
      events::MasterOutOfSync{-12'345'678'901, dc::SyncObstacle::kLateFrames},
      events::WkcError{6, 3, 1ULL << 40},
      events::FramesLate{3, 12'345, 2},
      events::LinkUp{SharedText("eth1"), 5 * kSecond},
      events::Emergency{0xA12, 1, {1, 2, 3, 4, 255}, {0x539, 2, 3, 4}},
      events::CableChanged{2, -1, true},
      events::Failure{Error{ErrorCode::kSdoAbort, "slave 3",
                            because("\"{text}\" is no {type}", Reason::verbatim(std::string("no")), 7), "file", 7, -1,
                            0x06020000, 9}},
      events::EventsLost{UINT64_MAX / 4},
  };
  for (const auto& what : all) {
    const auto bytes = encode_event(what);
    const auto back = decode_event(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->index(), what.index());
    EXPECT_EQ(encode_event(*back), bytes);
  }
  const auto failure = decode_event(encode_event(all[9]));
  EXPECT_EQ(std::get<events::Failure>(*failure).error, std::get<events::Failure>(all[9]).error);
  EXPECT_EQ(std::get<events::HotConnect>(*decode_event(encode_event(all[2]))).group.str(), "tool changer");
}

/// As programs recorded it that knew sentences alone, and by one that knows rows that we have not.
TEST(TypedValues, AnErrorWithoutItsRowKeepsItsSentence) {
  const auto detail_of = [](std::string_view bytes) {
    const auto what = decode_event(bytes);
    EXPECT_TRUE(what);
    return what ? std::get<events::Failure>(*what).error.detail : Reason();
  };
  const std::string sentence = "\"no\" is no 7";
  const auto whole =
      encode_event(events::Failure{Error{ErrorCode::kBadValue, "a", because("\"{text}\" is no {type}", "no", 7)}});
  EXPECT_EQ(detail_of(whole), because("\"{text}\" is no {type}", "no", 7));
  const auto row = whole.find("\"{text}");
  ASSERT_NE(row, std::string::npos);
  EXPECT_EQ(detail_of(std::string_view(whole).substr(0, row - 1)).text(), sentence);
  auto other = whole;
  other[row + 9] = 'I';
  EXPECT_EQ(detail_of(other).text(), sentence);
  const auto plain = encode_event(events::Failure{Error{ErrorCode::kBadValue, "a", because("it is a number")}});
  const auto end = plain.rfind("it is a number");
  EXPECT_EQ(detail_of(std::string_view(plain).substr(0, end - 1)).words(), "it is a number");
}

template <std::size_t index = 0>
void each_kind_has_a_number_of_its_own(std::set<std::string>& seen) {
  if constexpr (index < std::variant_size_v<EventDetails>) {
    const EventDetails what = std::variant_alternative_t<index, EventDetails>{};
    const auto bytes = encode_event(what);
    EXPECT_TRUE(seen.insert(bytes.substr(0, 1)).second) << index;
    const auto back = decode_event(bytes);
    ASSERT_TRUE(back) << index;
    EXPECT_EQ(back->index(), index);
    each_kind_has_a_number_of_its_own<index + 1>(seen);
  }
}

TEST(TypedValues, NoTwoKindsOfEventsShareANumber) {
  std::set<std::string> seen;
  each_kind_has_a_number_of_its_own(seen);
}

/// What an earlier program did not write yet stays as it is; what a later one has added is passed over.
TEST(TypedValues, ShorterAndLongerOnesAreRead) {
  const auto bytes = encode_event(events::WkcError{6, 3, 9});
  const auto shorter = decode_event(std::string_view(bytes).substr(0, bytes.size() - 1));
  ASSERT_TRUE(shorter);
  EXPECT_EQ(std::get<events::WkcError>(*shorter).count, 1U);
  const auto longer = decode_event(bytes + "new");
  ASSERT_TRUE(longer);
  EXPECT_EQ(std::get<events::WkcError>(*longer).count, 9U);
}

TEST(TypedValues, WhatIsNoneIsNothing) {
  EXPECT_FALSE(decode_event(""));
  EXPECT_FALSE(decode_event("\x7e"));                                              // no kind has this number
  EXPECT_FALSE(decode_event(std::string("\x0a\x7e", 2)));                          // a state beyond the last
  EXPECT_FALSE(decode_event(std::string("\x36\x7e", 2)));                          // a text longer than the bytes
  EXPECT_FALSE(decode_event("\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff"));  // no number ends
  EXPECT_TRUE(rc::check([](const std::string& bytes) {
    (void)decode_event(bytes);
    (void)decode_finding(bytes);
  }));
}

/// One for each placeholder of the words.
std::vector<Figure> figures_for(std::initializer_list<std::string_view> texts) {
  std::vector<Figure> figures;
  for (const auto text : texts) {
    for (auto open = text.find('{'); open != std::string_view::npos; open = text.find('{', open + 1)) {
      const Placeholder placeholder(text.substr(open + 1, text.find('}', open) - open - 1));
      if (std::ranges::find(figures, placeholder.name, &Figure::name) != figures.end()) continue;
      figures.push_back({placeholder.name, Figure::Unit::kTimes, 3, 0, "at least"});
    }
  }
  return figures;
}

TEST(TypedValues, FindingsComeBackWithTheirWords) {
  const auto words = all_finding_words();
  for (const auto& row : words) {
    Finding finding{row.code, Severity::kWarning, Place(3, "slave.3.dc.op_mode")};
    finding.from = 5;
    finding.to = 1LL << 60;
    finding.place.file = "run.xml";
    finding.place.part = {PlaceKind::kSlaveInitCmd, 3, 4};
    for (const auto& facts : row.facts) {
      finding.facts = facts.text;
      finding.figures = figures_for({facts_template(finding), row.mend});
      finding.figures.push_back({"name", Figure::Unit::kText, 0, 0, "Servo"});
      const auto back = decode_finding(encode_finding(finding));
      ASSERT_TRUE(back) << row.code;
      EXPECT_EQ(*back, finding);
      EXPECT_EQ(describe(*back), describe(finding));
    }
  }
}

/// A row whose words have a variant with a name.
const FindingWords& row_with_variant() {
  return *std::ranges::find_if(all_finding_words(), [](const FindingWords& row) { return !row.facts[1].text.empty(); });
}

/// No words stand in the file: those of the program that opens it are shown, in its language.
TEST(TypedValues, AFindingIsRecordedByItsNameAndItsFigures) {
  const auto& row = row_with_variant();
  Finding finding{row.code};
  for (const auto& facts : row.facts) {
    if (facts.text.empty()) continue;
    finding.facts = facts.text;
    finding.figures = figures_for({facts.text, row.mend});
    const auto bytes = encode_finding(finding);
    EXPECT_EQ(bytes.find(facts.text), std::string::npos);
    EXPECT_NE(bytes.find("/" + std::string(facts.variant)), std::string::npos);
  }
}

/// As programs recorded it before sentences had names.
TEST(TypedValues, AFindingThatWasRecordedWithItsSentenceIsRead) {
  const auto& row = row_with_variant();
  Finding finding{row.code};
  finding.facts = row.facts[1].text;
  finding.figures = figures_for({finding.facts, row.mend});
  auto bytes = encode_finding(finding);
  const auto name = "/" + std::string(row.facts[1].variant);
  const auto counted = [](std::string_view text) {
    std::string out;
    auto size = text.size() * 2;
    for (; size >= 0x80; size >>= 7) out += static_cast<char>(size | 0x80);
    return (out += static_cast<char>(size)) += text;
  };
  bytes.replace(bytes.find(counted(name)), counted(name).size(), counted(finding.facts));
  const auto back = decode_finding(bytes);
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, finding);
}

/// Today's words want a figure that was not recorded: the recorded words are better than a hole in the sentence.
TEST(TypedValues, WordsThatAFigureIsMissingForAreNotUsed) {
  const auto& row = *std::ranges::find_if(all_finding_words(), [](const FindingWords& words) {
    return words.facts[0].text.find('{') != std::string_view::npos;
  });
  EXPECT_FALSE(decode_finding(encode_finding(Finding{row.code})));
}

TEST(TypedValues, AFindingOfANewerProgramIsNone) {
  EXPECT_FALSE(decode_finding(encode_finding(Finding{"no-such-code"})));
  Finding finding{all_finding_words().front().code};
  finding.facts = "A sentence that this program does not have.";
  EXPECT_FALSE(decode_finding(encode_finding(finding)));
}

}  // namespace
}  // namespace syncline
