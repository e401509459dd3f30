// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "compile/incremental.h"
#include "eni/check/eni_check.h"
#include "support/result.h"
#include "ui/models/eni_view.h"

namespace syncline::ui {

class ProjectCopy;

/// Makes ENIs of projects in a thread of its own. Of several requests the last one counts.
class EniWriterThread {
 public:
  struct Request {
    std::uint64_t number = 0;
    EniDialect dialect = EniDialect::kEcEngineer;
    std::shared_ptr<const ProjectCopy> now, before;  // before: null = nothing to compare with
    std::string key;  // of a setting: its dependents in place of what became other; "" = none
  };
  /// Called in the thread.
  struct Answers {
    std::function<void(std::uint64_t number, Result<std::shared_ptr<const EniView>> view)> written;
    std::function<void(std::uint64_t number, std::shared_ptr<const eni::EniCheck> check)> checked;
  };

  explicit EniWriterThread(Answers answers);
  ~EniWriterThread();

  void ask(Request request);

 private:
  void run();
  [[nodiscard]] bool superseded(bool patient);
  [[nodiscard]] Result<std::shared_ptr<const EniView>> write(const Request& request);
  [[nodiscard]] std::shared_ptr<const EniLines> linesOf(const std::shared_ptr<const ProjectCopy>& project,
                                                        EniDialect dialect);
  [[nodiscard]] std::shared_ptr<EniView> dependents(const Request& request,
                                                    const std::shared_ptr<const EniLines>& text);
  void remember(const std::shared_ptr<const ProjectCopy>& project, EniDialect dialect,
                const std::shared_ptr<const EniLines>& lines);

  /// Texts made before, which are likely to be asked for again to compare with.
  struct Known {
    std::shared_ptr<const ProjectCopy> project;
    EniDialect dialect;
    std::shared_ptr<const EniLines> lines;
  };

  Answers answers_;
  std::vector<Known> known_;  // newest last
  IncrementalCompiler compilers_[2]{IncrementalCompiler({EniDialect::kEcEngineer}),
                                    IncrementalCompiler({EniDialect::kTwinCat})};
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Request> next_;
  bool ending_ = false;
  std::thread thread_;  // last: it uses everything above
};

}  // namespace syncline::ui
