// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ui/pages/online_page.h"

class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace syncline::ui {

class RecordModel;

/// The EEPROM of a slave: what it says and its bytes, copied into a file, and written: the alias by anybody, an image
/// by experts.
class SlaveEepromPage final : public OnlinePage {
  Q_OBJECT

 public:
  explicit SlaveEepromPage(Workspace& workspace);
  /// All of it; empty before it was read.
  [[nodiscard]] const std::vector<std::uint8_t>& image() const { return image_; }
  /// Writes it as the EEPROM's whole content, after a question.
  void writeImage(std::vector<std::uint8_t> image);

 protected:
  void slaveChanged() override;
  void ended() override;
  void projectChanged() override;
  void tick(std::optional<Nanoseconds> now) override;

 private:
  /// One that has begun: of which slave of the run, and what was there.
  struct Write {
    std::uint16_t position = 0;
    QString name{};
    QString link{};
    std::vector<std::uint8_t> before{};
    QString done{};
    int words = 0;  // that are different
  };

  QWidget* buildButtons();
  void read();
  void readPiece(std::uint16_t position, std::uint32_t word);
  void takePiece(std::uint16_t position, std::uint32_t word, const RequestOutcome& outcome);
  void showImage();
  void save();
  void load();
  void writeAlias();
  void write(std::vector<std::uint8_t> bytes, const QString& done);
  void settle(const Write& begun, const RequestOutcome& outcome);
  void verify(const Write& begun, const QString& why, const RequestOutcome& now);
  void tellEnd(const Write& begun, const QString& why);
  void showProgress();
  void enable();

  RecordModel* lines_;
  QPlainTextEdit* hex_;
  QPushButton *read_, *save_, *alias_write_, *load_;
  QSpinBox* alias_;
  std::vector<std::uint8_t> image_, reading_;
  std::uint32_t pieces_ = 0, pieces_done_ = 0;
  std::optional<Write> writing_;
  SlaveRequests::Id write_request_ = 0;
};

}  // namespace syncline::ui
