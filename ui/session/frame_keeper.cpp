// SPDX-License-Identifier: Apache-2.0
#include "ui/session/frame_keeper.h"

#include <QDir>
#include <utility>

#include "ui/session/network_run.h"
#include "ui/session/post.h"
#include "ui/session/run_file_name.h"

namespace syncline::ui {
namespace {

constexpr std::uint64_t kMiB = 1ULL << 20;

}  // namespace

FrameKeeper::FrameKeeper(NetworkRun& run, std::function<QString()> name, const Environment& environment,
                         QObject* parent)
    : QObject(parent), run_(run), name_(std::move(name)), environment_(environment) {
  // Before the first frame: recordChanged() comes when there is a master, and before it is told to do anything.
  connect(&run_, &NetworkRun::recordChanged, this, [this] {
    stop();
    start();
  });
  connect(&run_, &NetworkRun::phaseChanged, this, [this] {
    if (run_.phase() == NetworkRun::Phase::kOffline) stop();
  });
  connect(&run_, &NetworkRun::eventArrived, this, [this](const Event& event) {
    if (box_) box_->note(event);
  });
}

FrameKeeper::~FrameKeeper() {
  blockSignals(true);  // whoever listens may be half gone
  finish();
}

void FrameKeeper::setWish(const BlackBoxWish& wish) {
  if (wish == wish_) return;
  stop();
  wish_ = wish;
  if (run_.phase() != NetworkRun::Phase::kOffline) start();
}

void FrameKeeper::start() {
  const auto ring = run_.frames();
  if (!wish_.on || !ring) return;
  waitForDisk();  // of a run before, whose files these are as well
  last_ = {};
  const QDir folder(wish_.folder);
  folder.mkpath(QStringLiteral("."));
  auto box = BlackBox::start(ring,
                             {.name = folder.filePath(runFileName(name_())).toStdString(),
                              .most_bytes = static_cast<std::uint64_t>(wish_.mib) * kMiB,
                              .virtual_time = run_.isVirtual(),
                              .program = "syncline " + environment_.version.toStdString(),
                              .link = run_.link().toStdString(),
                              .description = run_.origin().project.name},
                             [this](const Error&) {
                               // By then it may be another one.
                               post(*this, [this] {
                                 if (box_ && box_->report().error) stop();
                               });
                             });
  if (box) {
    box_ = std::move(*box);
  } else {
    last_.error = box.error();
    Q_EMIT ended(last_);
  }
  Q_EMIT changed();
}

void FrameKeeper::stop() {
  if (!box_) return;
  waitForDisk();
  ending_ = true;
  finishing_ = std::move(box_);
  ender_ = std::thread([this, box = finishing_, number = ++number_] {
    (void)box->finish();
    post(*this, [this, number] { onFinished(number); });
  });
  Q_EMIT changed();
}

void FrameKeeper::waitForDisk() {
  if (!ender_.joinable()) return;
  onFinished(number_);
}

void FrameKeeper::onFinished(int number) {
  if (!ending_ || number != number_) return;  // somebody has waited for it
  ender_.join();
  ending_ = false;
  last_ = std::exchange(finishing_, nullptr)->report();
  Q_EMIT ended(last_);
  Q_EMIT changed();
}

void FrameKeeper::finish() {
  stop();
  waitForDisk();
}

}  // namespace syncline::ui
