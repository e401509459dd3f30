// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "compile/incremental.h"
#include "support/result.h"

namespace syncline::ui {

class ProjectDocument;

/// Compiles the project a moment after each edit, so that the pages show the register values that
/// will be written and the messages show what is wrong with the configuration.
class ConfigurationMonitor final : public QObject {
  Q_OBJECT

 public:
  explicit ConfigurationMonitor(ProjectDocument& document, QObject* parent = nullptr);

  /// The configuration of the project as it is now (compiles at once when an edit is pending).
  const Result<CompileResult>& current();
  /// The last compiled configuration, empty when the project cannot be compiled.
  [[nodiscard]] const NetworkConfig* config() const { return result_ ? &result_->config : nullptr; }
  [[nodiscard]] const Result<CompileResult>& result() const { return result_; }

 Q_SIGNALS:
  void compiled();

 private:
  void compileNow();

  ProjectDocument& document_;
  QTimer debounce_;
  IncrementalCompiler compiler_;
  Result<CompileResult> result_;
};

}  // namespace syncline::ui
