// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "config/project.h"
#include "settings/settings_table.h"

class QButtonGroup;
class QCheckBox;
class QLabel;
class QMenu;

namespace syncline {
struct Finding;
}  // namespace syncline

namespace syncline::ui {

class Card;
class ChoiceEdit;
class NumberEdit;
class Page;
class PresetEdit;
class TextEdit;

/// Makes the fields of a page from rows of the table of settings: label, unit, limits in this project, step, tool tip
/// and What's This come from the row; what a user does becomes one undo step. Keys have placeholders: "slave.N.alias"
/// is the alias of the node that the page shows. Expert settings are hidden while the window does not show them, unless
/// they differ from their default; so are fields that the shown device has no use for.
class FieldBinder final : public QObject {
  Q_OBJECT

 public:
  using Applies = std::function<bool(const SlaveSettings&)>;
  using Options = std::function<std::vector<settings::Option>(const Project&, const settings::Place&)>;
  using Label = std::function<QString(const Project&, const settings::Place&)>;

  explicit FieldBinder(Page& page);

  /// Key of the setting ("slave.3.alias") whose field has or holds the widget; "": none has.
  [[nodiscard]] QString keyOf(const QWidget* widget) const;

  /// A field for each key, of the kind that its row asks for, named after the key: "slave.N.eoe.host_name" is
  /// "slaveEoeHostName". Only for slaves that `applies` says yes to. A card of nothing else is hidden while none of
  /// its fields is shown, and says so when all of them are for experts.
  void keys(Card& card, std::initializer_list<const char*> keys, const Applies& applies = {});
  /// The same as choices among `options`.
  void chosen(Card& card, std::initializer_list<const char*> keys, const Options& options, const Applies& applies);
  /// A field for each place of a key that has several: as many rows as the shown slave has of them.
  void items(Card& card, const char* key, Label label, Options options = {});

  TextEdit* text(Card& card, const char* object_name, const char* key);
  /// Without a row in a card, for the place that the page says; nothing while there is none.
  TextEdit* textField(const char* object_name, const char* key,
                      std::function<std::optional<settings::Place>()> place = {});
  NumberEdit* number(Card& card, const char* object_name, const char* key, const QString& label = {});
  /// Without a row of its own in a card.
  NumberEdit* numberField(const char* object_name, const char* key);
  PresetEdit* presetField(const char* object_name, const char* key, std::span<const std::int64_t> usual);
  QCheckBox* toggle(Card& card, const char* object_name, const char* key);
  /// Ticked while the setting is unset; unticked, it keeps the value that was in force.
  QCheckBox* automatic(Card& card, const char* object_name, const char* key, const QString& label, const QString& tip);
  /// `options`: instead of those of the row.
  ChoiceEdit* choice(Card& card, const char* object_name, const char* key, Options options = {});
  /// Radio buttons of a choice in a grid.
  QButtonGroup* buttons(Card& card, const char* key, const QList<std::pair<std::int64_t, const char*>>& object_names,
                        int columns);

  /// Adds a field of another kind: words and bookkeeping from the row, the rest is the caller's.
  void bind(QWidget& field, const char* key, std::function<void()> show = {});

  /// The same for another place than the page's; nothing while there is none.
  void bindAt(QWidget& field, const char* key, std::function<std::optional<settings::Place>()> place,
              std::function<void()> show);

  /// One undo step; empty, or why it was refused (the messages say it, too).
  QString set(const char* key, const settings::Value& value);
  [[nodiscard]] settings::Value value(const char* key) const;
  [[nodiscard]] settings::Place place() const;

  /// Shows the project as it is now. Tells nobody.
  void refresh();
  /// Whether a field has something to show of this node.
  [[nodiscard]] bool wanted(int node) const;
  /// The title of the page says that its fields are for experts: their cards need not.
  void setExpertPage() { expert_page_ = true; }
  /// Takes what was typed and not taken yet; false when a field refused.
  bool commit();
  void revert();

  /// The shown field of a setting; null: none is shown.
  [[nodiscard]] QWidget* fieldOf(const settings::Setting& setting, const settings::Place& place) const;
  /// What is found wrong with a setting.
  struct Note {
    std::string key;
    QString text;
    bool error = false;
  };
  /// Each note below the field that it is about, from now on: of a list whenever its record is selected.
  void showNotes(std::vector<Note> notes);

  struct Bound {
    const settings::Setting* setting = nullptr;
    QWidget* widget = nullptr;
    std::function<void()> show;
    std::function<std::optional<settings::Place>()> place;  // nothing: the shown node has no such item
    Applies applies{};
    Card* card = nullptr;
    QWidget* row = nullptr;  // of the card
    Label label{};           // of an item
    bool marked = false;     // as a setting for experts; else its card or page says so
    QLabel* note = nullptr;  // below it, made when there is something to say
  };
  [[nodiscard]] const std::vector<Bound>& bound() const { return bound_; }
  /// Those that have fields here, once each; also of lists that nobody has filled yet.
  [[nodiscard]] std::vector<const settings::Setting*> settings() const;

 Q_SIGNALS:
  /// The context menu of a field asks what of the ENI depends on it. It does so only where somebody is connected.
  void eniWanted(const QString& key);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Where = std::function<std::optional<settings::Place>()>;
  /// The field that is or holds the widget; null: none does.
  [[nodiscard]] const Bound* boundOf(const QWidget* widget) const;
  void addReset(QMenu& menu, const Bound& bound);
  /// The rows of a key with several places.
  struct Items {
    Card* card = nullptr;
    const char* key = nullptr;
    Label label;
    Options options;
    std::vector<settings::Place> places;
    bool own_card = false;
    std::size_t made = 0;
  };

  void addKeys(Card& card, std::initializer_list<const char*> keys, const Options& options, const Applies& applies);
  QWidget* makeField(Card& card, const QString& object_name, const char* key, const Options& options);
  bool ownCard(Card& card, bool experts);
  void addRow(Card& card, const QString& label, QWidget& field);
  void addWide(Card& card, QWidget& field);
  QString take(const char* key, const Where& where, const settings::Value& value);
  QString takeText(const char* key, const Where& where, const QString& text);
  [[nodiscard]] settings::Value read(const char* key, const Where& where) const;
  [[nodiscard]] settings::Place at(const Where& where) const { return where().value_or(place()); }
  void placeNotes();
  [[nodiscard]] const Note* noteOf(const Bound& bound) const;
  static QLabel* makeNote(const Bound& bound);
  void fillItems(const std::shared_ptr<Items>& items);
  [[nodiscard]] bool shows(const Bound& bound, const settings::Place& place) const;
  void showRows();

  Page& page_;
  std::vector<Bound> bound_;
  std::vector<Note> notes_;
  std::vector<std::shared_ptr<Items>> items_;
  std::vector<Card*> own_cards_;  // of nothing but fields
  Where where_;                   // of the field that is being made
  bool expert_page_ = false, expert_card_ = false;
};

/// Those of the findings that are about settings and are more than notes.
[[nodiscard]] std::vector<FieldBinder::Note> notesOf(const std::vector<Finding>& findings, const Project& project);

/// "slave.N.eoe.host_name": "slaveEoeHostName".
[[nodiscard]] QString fieldName(const char* key);

}  // namespace syncline::ui
