// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <functional>
#include <span>
#include <vector>

#include "settings/settings_table.h"

class QButtonGroup;
class QCheckBox;

namespace syncline::ui {

class Card;
class ChoiceEdit;
class NumberEdit;
class Page;
class PresetEdit;
class TextEdit;

/// Makes the fields of a page from rows of the table of settings: label, unit, limits in this project, step, tool tip
/// and What's This come from the row; what a user does becomes one undo step. Keys have placeholders: "slave.N.alias"
/// is the alias of the node that the page shows.
class FieldBinder final : public QObject {
  Q_OBJECT

 public:
  explicit FieldBinder(Page& page);

  TextEdit* text(Card& card, const char* object_name, const char* key);
  NumberEdit* number(Card& card, const char* object_name, const char* key);
  /// Without a row of its own in a card.
  NumberEdit* numberField(const char* object_name, const char* key);
  PresetEdit* presetField(const char* object_name, const char* key, std::span<const std::int64_t> usual);
  QCheckBox* toggle(Card& card, const char* object_name, const char* key);
  /// Ticked while the setting is unset; unticked, it keeps the value that was in force.
  QCheckBox* automatic(Card& card, const char* object_name, const char* key, const QString& label, const QString& tip);
  ChoiceEdit* choice(Card& card, const char* object_name, const char* key);
  /// Radio buttons of a choice in a grid.
  QButtonGroup* buttons(Card& card, const char* key, const QList<std::pair<std::int64_t, const char*>>& object_names,
                        int columns);

  /// Adds a field of another kind: words and bookkeeping from the row, the rest is the caller's.
  void bind(QWidget& field, const char* key, std::function<void()> show = {});

  /// One undo step; empty, or why it was refused (the messages say it, too).
  QString set(const char* key, const settings::Value& value);
  [[nodiscard]] settings::Value value(const char* key) const;
  [[nodiscard]] settings::Place place() const;

  /// Shows the project as it is now. Tells nobody.
  void refresh();
  /// Takes what was typed and not taken yet; false when a field refused.
  bool commit();
  void revert();

  struct Bound {
    const settings::Setting* setting = nullptr;
    QWidget* widget = nullptr;
    std::function<void()> show;
  };
  [[nodiscard]] const std::vector<Bound>& bound() const { return bound_; }

 private:
  Page& page_;
  std::vector<Bound> bound_;
};

}  // namespace syncline::ui
