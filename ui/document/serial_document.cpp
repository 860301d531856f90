#include "ui/document/serial_document.h"

#include <algorithm>
#include <utility>

namespace kriva::ui {
namespace {

std::ptrdiff_t offset(int index) {
    return static_cast<std::ptrdiff_t>(index);
}

} // namespace

std::optional<int> SerialDocument::indexOf(SheetIndex sheet, Serial serial) const {
    const auto found = std::ranges::find(serials_[sheet], serial);
    if (found == serials_[sheet].end())
        return {};
    return static_cast<int>(found - serials_[sheet].begin());
}

const Curve* SerialDocument::find(SheetIndex sheet, Serial serial) const {
    const std::optional<int> index = indexOf(sheet, serial);
    return index ? &value_.sheets[sheet].curves[static_cast<std::size_t>(*index)] : nullptr;
}

std::shared_ptr<const Curve> SerialDocument::snapshot(SheetIndex sheet, Serial serial) const {
    std::weak_ptr<const Curve>& known = snapshots_[serial];
    std::shared_ptr<const Curve> snapshot = known.lock();
    if (!snapshot)
        known = snapshot = std::make_shared<const Curve>(*find(sheet, serial));
    return snapshot;
}

Serial SerialDocument::activeCurve(SheetIndex sheet) const {
    const auto& serials = serials_[sheet];
    return serials.empty() ? 0 : serials[static_cast<std::size_t>(value_.sheets[sheet].view.activeCurve)];
}

void SerialDocument::replace(Document document) {
    value_ = std::move(document);
    snapshots_.clear();
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        serials_[sheet].clear();
        for (std::size_t i = 0; i < value_.sheets[sheet].curves.size(); ++i)
            serials_[sheet].push_back(newSerial());
    }
}

Curve SerialDocument::put(SheetIndex sheet, Serial serial, Curve curve) {
    snapshots_.erase(serial);
    Curve& place = value_.sheets[sheet].curves[static_cast<std::size_t>(*indexOf(sheet, serial))];
    return std::exchange(place, std::move(curve));
}

std::optional<PlacedCurve> SerialDocument::exchange(SheetIndex sheet, Serial serial, std::optional<PlacedCurve> other) {
    snapshots_.erase(serial);
    const Serial active = activeCurve(sheet);
    std::optional<PlacedCurve> before;
    if (const std::optional<int> index = indexOf(sheet, serial))
        before = takeOut(sheet, *index);
    if (before && other) // whether a curve is shown is not undone
        other->curve = withView(std::move(other->curve), viewOf(before->curve));
    if (other)
        putIn(sheet, serial, std::move(*other));
    const int last = std::max(0, static_cast<int>(serials_[sheet].size()) - 1);
    int& activeIndex = value_.sheets[sheet].view.activeCurve;
    activeIndex = indexOf(sheet, active).value_or(std::min(activeIndex, last));
    return before;
}

PlacedCurve SerialDocument::takeOut(SheetIndex sheet, int index) {
    const auto place = value_.sheets[sheet].curves.begin() + offset(index);
    PlacedCurve taken{std::move(*place), index};
    value_.sheets[sheet].curves.erase(place);
    serials_[sheet].erase(serials_[sheet].begin() + offset(index));
    return taken;
}

void SerialDocument::putIn(SheetIndex sheet, Serial serial, PlacedCurve curve) {
    auto& curves = value_.sheets[sheet].curves;
    curves.insert(curves.begin() + offset(curve.index), std::move(curve.curve));
    serials_[sheet].insert(serials_[sheet].begin() + offset(curve.index), serial);
}

} // namespace kriva::ui
