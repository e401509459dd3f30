// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dc/outlier_gate.h"
#include "support/types.h"

namespace syncline::dc {

struct DcmObservation;

/// What the reference clock will show when a frame passes it, for those who write its time (0x0910).
///
/// It counts from the stamp for which the last frame was written, not from when that frame really left: so what is
/// wrong with one send stamp mostly cancels with the next, instead of shaking the reference clock and all slaves with
/// it. A frame that left far from its stamp shall be taken back at once (DcmAction::write_again). Where the kernel says
/// when the driver got a frame, the usual way from the stamp to there is in the forecast. Values only; one thread.
class WriteForecast {
 public:
  /// `limit`, ns: nMaxValidVal, see OutlierGate.
  explicit WriteForecast(double limit) : gate_(limit) {}
  void start();
  /// The reference clock has stepped: what was usual holds no more.
  void forget() { gate_.start(); }
  /// A reading of one cycle (with reference time); `surprise`: by how much it is off what was expected at its send
  /// time, ns, which is an outlier only when the expectation is `trusted`.
  OutlierGate::Verdict take(const DcmObservation& observation, double surprise, bool trusted);
  /// A reading of a second write; true when that one, too, left far from its stamp.
  bool take_again(const DcmObservation& observation, double surprise);
  /// A clock that runs `ppm` fast against the host; where no reading is known, nothing.
  [[nodiscard]] std::optional<Nanoseconds> at(Nanoseconds stamp, double ppm = 0) const;
  /// From the stamp to the driver, ns.
  [[nodiscard]] Nanoseconds usual_way() const;

 private:
  struct Reading {
    Nanoseconds host_time = 0, reference_time = 0;
  };
  [[nodiscard]] double strayed(const DcmObservation& observation, double surprise) const;
  void count_from(const DcmObservation& observation);

  OutlierGate gate_;
  double way_out_ = 0;
  std::optional<Reading> last_;
};

}  // namespace syncline::dc
