// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

/// What stands between words, clauses and sentences is the language's own: "a, b", but "a，b" in Chinese. One place for
/// all of them; empty parts are left out.
namespace syncline::ui {

/// "a, b, c"
[[nodiscard]] QString joinedParts(QStringList parts);
/// "a; b; c": of parts that have commas of their own.
[[nodiscard]] QString joinedClauses(QStringList clauses);
/// With the full stop that it lacks.
[[nodiscard]] QString asSentence(const QString& text);
/// "One. Two": each but the last gets the full stop that it lacks; that may end with a command to be copied.
[[nodiscard]] QString joinedSentences(QStringList sentences);

}  // namespace syncline::ui
