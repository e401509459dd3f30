// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <functional>

#include "ui/editors/record_part.h"

class QAbstractButton;

namespace syncline::ui {

class Card;
class Page;

/// Fields for the parts of one record of a list, and the buttons that add, remove and move records. As other fields:
/// what is typed is taken by Enter, by leaving the field and by a command; each edit is one undo step.
class RecordForm final : public QObject {
  Q_OBJECT

 public:
  /// `row`: the record that is shown, -1 is none.
  RecordForm(Page& page, RecordList list, std::vector<RecordPart> parts, std::function<int()> row);

  /// A row of the card for each part with a field.
  void addFields(Card& card);
  /// Add, Remove and, where the order means something, Up and Down. Named PREFIXAdd ...
  QWidget* makeButtons(const QString& prefix);
  /// After makeButtons(): what these buttons do, by Ins, Del, Alt+Up and Alt+Down where the list has the focus.
  void takeKeysOf(QWidget& list);
  /// Which buttons can do something, after the page has refreshed its fields.
  void refresh();

  /// Puts `record` in place of the one that is shown, or behind it.
  QString replace(const std::string& record);
  void insert(const std::string& record);
  /// To another row, of the list as it is without it; the others keep their order.
  void moveTo(int from, int to);

 Q_SIGNALS:
  /// The record that an edit brought or left.
  void rowWanted(int row);

 private:
  void addField(Card& card, const RecordPart& part);
  QWidget* makeText(const RecordPart& part);
  QWidget* makeChoice(const RecordPart& part);
  QWidget* makeToggle(const RecordPart& part);
  QWidget* makeSet(const RecordPart& part);
  void bind(QWidget& field, const RecordPart& part, std::function<void(const QString& text)> show);
  QString take(const RecordPart& part, const QString& typed);
  QString write(const Records& before, const Records& after);
  void remove();
  void move(int by);
  [[nodiscard]] QString current(const RecordPart& part) const;
  [[nodiscard]] bool editable() const { return !list_.refusal || list_.refusal().isEmpty(); }

  Page& page_;
  RecordList list_;
  std::vector<RecordPart> parts_;
  std::function<int()> row_;
  QString add_tip_;
  QAbstractButton *add_ = nullptr, *remove_ = nullptr, *up_ = nullptr, *down_ = nullptr;
  QList<QWidget*> fields_;
};

}  // namespace syncline::ui
