// SPDX-License-Identifier: Apache-2.0
#include "ui/text/joined_text.h"

#include <QCoreApplication>

namespace syncline::ui {
namespace {

QString joinedBy(const QString& pair, QStringList& parts) {
  parts.removeAll(QString());
  if (parts.isEmpty()) return {};
  auto all = parts.front();
  for (qsizetype i = 1; i < parts.size(); ++i) all = pair.arg(all, parts[i]);
  return all;
}

bool hasFullStop(const QString& sentence) {
  return QStringLiteral(".!?:\u2026\u3002\uFF01\uFF1F\uFF1A").contains(sentence.back());
}

}  // namespace

QString joinedParts(QStringList parts) {
  return joinedBy(QCoreApplication::translate("JoinedText", "%1, %2", "parts of one sentence"), parts);
}

QString joinedClauses(QStringList clauses) {
  return joinedBy(QCoreApplication::translate("JoinedText", "%1; %2", "clauses of one sentence"), clauses);
}

QString asSentence(const QString& text) {
  if (text.isEmpty() || hasFullStop(text)) return text;
  return QCoreApplication::translate("JoinedText", "%1.", "a sentence and its full stop").arg(text);
}

QString joinedSentences(QStringList sentences) {
  sentences.removeAll(QString());
  for (qsizetype i = 0; i + 1 < sentences.size(); ++i) sentences[i] = asSentence(sentences[i]);
  return joinedBy(QCoreApplication::translate("JoinedText", "%1 %2", "one sentence behind the other"), sentences);
}

}  // namespace syncline::ui
