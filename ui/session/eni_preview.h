// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "compile/compile.h"
#include "eni/check/eni_check.h"
#include "support/result.h"
#include "ui/models/eni_view.h"

namespace syncline::ui {

class EniWriterThread;
class ProjectCopy;
class ProjectDocument;

/// The ENI that the project would export, made in a thread of its own, and what the checker says of it: at once while
/// somebody looks, with what has become other in it since a time of the user's choice; else when nobody has edited for
/// a moment.
class EniPreview final : public QObject {
  Q_OBJECT

 public:
  /// Since when changes are shown.
  enum class Since : std::uint8_t { kSaved, kExported, kOpened, kLastEdit };

  explicit EniPreview(ProjectDocument& document, QObject* parent = nullptr);
  ~EniPreview() override;

  /// Somebody looks from now on, or nobody. The first time is what kOpened means.
  void setWatched(bool watched);
  [[nodiscard]] EniDialect dialect() const { return dialect_; }
  /// Also that of exports.
  void setDialect(EniDialect dialect);
  /// Exports come with a report.
  [[nodiscard]] bool reported() const { return reported_; }
  void setReported(bool reported);
  [[nodiscard]] Since since() const { return since_; }
  /// Changes are shown again where what depends on a setting was.
  void setSince(Since since);
  /// Shows which lines depend on a setting ("slave.3.alias") in place of changes; "": changes again. Of several that
  /// are asked for, the last one counts: what comes late of those before is nobody's answer.
  void showDependents(const std::string& key);
  /// The setting that was asked for last; "": changes are shown.
  [[nodiscard]] const std::string& dependentsOf() const { return key_; }
  /// The project as it is now was exported.
  void noteExport();

  /// The newest that is whole; null before the first.
  [[nodiscard]] const std::shared_ptr<const EniView>& view() const { return view_; }
  /// It is of the project as it is now: nothing is being computed, and nothing failed.
  [[nodiscard]] bool isCurrent() const { return view_ != nullptr && !computing_ && !failure_; }
  [[nodiscard]] bool isComputing() const { return computing_; }
  /// Why there is no newer one than view().
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }
  /// When view() was made.
  [[nodiscard]] const QDateTime& time() const { return time_; }
  /// What the checker says of view(); null while it is being checked.
  [[nodiscard]] const std::shared_ptr<const eni::EniCheck>& check() const { return check_; }

 Q_SIGNALS:
  /// Another view(), or none can be made.
  void changed();
  /// isComputing() or check() is another.
  void progressed();
  void reportedChanged();

 private:
  void onEdit();
  void start();
  void request();
  void ask();
  [[nodiscard]] const std::shared_ptr<const ProjectCopy>& before() const;
  void take(std::uint64_t number, const Result<std::shared_ptr<const EniView>>& view);
  void takeCheck(std::uint64_t number, const std::shared_ptr<const eni::EniCheck>& check);

  ProjectDocument& document_;
  QTimer debounce_, idle_;
  EniDialect dialect_ = EniDialect::kEcEngineer;
  Since since_ = Since::kOpened;
  std::string key_;  // of the setting whose lines are shown in place of changes
  bool reported_ = false;
  bool watched_ = false, computing_ = false, edited_ = true;
  bool other_ = false;        // machine or network than before
  std::uint64_t number_ = 0;  // of the last request
  std::string asked_key_;
  EniDialect asked_dialect_ = EniDialect::kEcEngineer;
  std::shared_ptr<const ProjectCopy> asked_, asked_before_;  // the last request
  std::shared_ptr<const ProjectCopy> now_, saved_, exported_, opened_, last_;
  std::shared_ptr<const EniView> view_;
  std::shared_ptr<const eni::EniCheck> check_;
  std::optional<Error> failure_;
  QDateTime time_;
  std::unique_ptr<EniWriterThread> writer_;
};

}  // namespace syncline::ui
