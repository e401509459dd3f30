// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSet>
#include <QString>
#include <QStringList>

class QWidget;

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::test {

/// Words that no translation made, in a window that speaks the artificial language: two plain letters or more. Names
/// that come from the machine are none, nor are units, keys of settings, names of files, elements of ENI, hexadecimal
/// numbers and names in capitals or with one inside (SYNC0, CoE), which are the same in every language.
class PlainWords {
 public:
  /// What its devices, PDOs, objects and modes are called.
  void addNames(const Project& project);
  void addName(const QString& name);
  [[nodiscard]] QStringList in(const QString& text) const;
  void look(const QString& text, const QString& where);
  /// What a widget shows and what stands in it: painted, tool tips, spoken. Not the cells whose words are those of the
  /// ENI file and of the table of registers.
  void look(QWidget& root);
  /// What it shows beside the pointer, all over it.
  void lookAtTips(QWidget& widget);
  /// Texts with plain words since it was asked last, each once with the widget that shows it.
  [[nodiscard]] QStringList takeFound();
  /// Texts that were looked at; of those that are painted, how many a translation made.
  [[nodiscard]] int seen() const { return seen_; }
  [[nodiscard]] int marked() const { return marked_; }

 private:
  QSet<QString> names_, told_;
  QStringList found_;
  int seen_ = 0, marked_ = 0;
};

}  // namespace syncline::test
