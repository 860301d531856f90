#pragma once

#include "core/document/document.h"
#include "ui/document/serial.h"

#include <memory>
#include <unordered_map>

namespace kriva::ui {

/// A curve at its place among the curves of its sheet.
struct PlacedCurve {
    Curve curve;
    int index = 0;
    friend bool operator==(const PlacedCurve&, const PlacedCurve&) = default;
};

/// What is to stand in the place of a curve: nothing where it goes.
struct CurveExchange {
    Serial serial = 0;
    std::optional<PlacedCurve> other;
};

/// The value of a document whose curves have serials: a curve is found by its serial whatever becomes of the others,
/// and has the same one when it went and comes back. No serial is given twice while this lives.
class SerialDocument {
  public:
    [[nodiscard]] const Document& value() const { return value_; }
    [[nodiscard]] const Sheet& sheet(SheetIndex sheet) const { return value_.sheets[sheet]; }
    [[nodiscard]] const std::vector<Serial>& serials(SheetIndex sheet) const { return serials_[sheet]; }
    [[nodiscard]] std::optional<int> indexOf(SheetIndex sheet, Serial serial) const;
    /// Null where the curve is not there.
    [[nodiscard]] const Curve* find(SheetIndex sheet, Serial serial) const;
    /// A copy of the curve, which must be there, for other threads; one for all who ask before the curve changes and
    /// keep it.
    [[nodiscard]] std::shared_ptr<const Curve> snapshot(SheetIndex sheet, Serial serial) const;
    /// The curve that edits without a curve of their own go to; 0 in an empty sheet.
    [[nodiscard]] Serial activeCurve(SheetIndex sheet) const;

    /// Another document, all of its curves with new serials.
    void replace(Document document);
    [[nodiscard]] Serial newSerial() { return ++lastSerial_; }
    /// Puts another value in place of the curve, which must be there, and gives the one before.
    Curve put(SheetIndex sheet, Serial serial, Curve curve);
    /// Puts `other` in place of the curve, or takes it out, and gives what was there. Whether the curve is shown stays
    /// as it is; the active curve stays active as long as it is there.
    std::optional<PlacedCurve> exchange(SheetIndex sheet, Serial serial, std::optional<PlacedCurve> other);
    void setActiveSheet(SheetIndex sheet) { value_.active = sheet; }
    [[nodiscard]] SheetView& view(SheetIndex sheet) { return value_.sheets[sheet].view; }

  private:
    PlacedCurve takeOut(SheetIndex sheet, int index);
    void putIn(SheetIndex sheet, Serial serial, PlacedCurve curve);

    Document value_;
    std::array<std::vector<Serial>, kSheetCount> serials_;
    mutable std::unordered_map<Serial, std::weak_ptr<const Curve>> snapshots_; ///< of curves as they are
    Serial lastSerial_ = 0;
};

} // namespace kriva::ui
