// SPDX-License-Identifier: Apache-2.0
#include "ui/text/joined_text.h"

#include <gtest/gtest.h>

#include "findings/finding.h"
#include "findings/run_codes.h"
#include "support/speak.h"
#include "ui/text/finding_text.h"

namespace syncline::ui {
namespace {

TEST(JoinedText, PartsClausesAndSentences) {
  EXPECT_EQ(joinedParts({QStringLiteral("a"), {}, QStringLiteral("%1"), QStringLiteral("c")}),
            QStringLiteral("a, %1, c"));
  EXPECT_EQ(joinedClauses({QStringLiteral("a, b"), QStringLiteral("c")}), QStringLiteral("a, b; c"));
  EXPECT_EQ(joinedSentences({QStringLiteral("One"), {}, QStringLiteral("Two?"), QStringLiteral("sudo three")}),
            QStringLiteral("One. Two? sudo three"));
  EXPECT_EQ(asSentence(QStringLiteral("One")), QStringLiteral("One."));
  EXPECT_EQ(joinedParts({}), QString());
}

TEST(JoinedText, ChineseHasItsOwnStops) {
  const test::Speak speak(QStringLiteral("zh_CN"));
  EXPECT_EQ(joinedParts({QStringLiteral("一"), QStringLiteral("二")}), QStringLiteral("一，二"));
  EXPECT_EQ(joinedSentences({QStringLiteral("一"), QStringLiteral("二。")}), QStringLiteral("一。二。"));
  EXPECT_EQ(asSentence(QStringLiteral("二。")), QStringLiteral("二。"));
  const Finding finding{code::kNotMonitored, Severity::kNote};
  EXPECT_FALSE(findingWhole(finding).contains(QStringLiteral("。."))) << qPrintable(findingWhole(finding));
}

}  // namespace
}  // namespace syncline::ui
