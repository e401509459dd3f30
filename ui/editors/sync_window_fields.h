// SPDX-License-Identifier: Apache-2.0
#pragma once

class QCheckBox;
class QLabel;

namespace syncline {
struct DcMasterSettings;
}

namespace syncline::ui {

class Card;
class NumberEdit;
class Page;

/// Sync window monitoring: whether, with which limit (2^n - 1 ns) and which settle time.
class SyncWindowFields {
 public:
  SyncWindowFields(Page& page, Card& card);
  /// Says what the exponent gives, and switches off what is not in use.
  void show(const DcMasterSettings& dc);

 private:
  QCheckBox* monitoring_;
  NumberEdit *exponent_, *settle_;
  QLabel* limit_;
};

}  // namespace syncline::ui
