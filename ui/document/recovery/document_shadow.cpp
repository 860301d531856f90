#include "ui/document/recovery/document_shadow.h"

namespace kriva::ui {

Document documentOf(const DocumentSnapshot& snapshot) {
    Document document = snapshot.rest;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        document.sheets[sheet].curves.reserve(snapshot.curves[sheet].size());
        for (const std::shared_ptr<const Curve>& curve : snapshot.curves[sheet])
            document.sheets[sheet].curves.push_back(*curve);
    }
    return document;
}

DocumentShadow::DocumentShadow(const OpenDocument& document, QObject* parent)
    : QObject(parent)
    , document_(document) {
    connect(&document, &OpenDocument::curveChanged, this, &DocumentShadow::markCurve);
    connect(&document, &OpenDocument::curvesChanged, this, &DocumentShadow::markSheet);
    connect(&document, &OpenDocument::replaced, this, &DocumentShadow::drop);
}

void DocumentShadow::markCurve(SheetIndex sheet, Serial serial) {
    if (isFollowing_) {
        const std::pair one(sheet, serial);
        std::erase(changed_, one);
        changed_.push_back(one);
    }
    Q_EMIT documentChanged();
}

void DocumentShadow::markSheet(SheetIndex sheet) {
    if (isFollowing_) {
        // A curve that went elsewhere may have changed with it.
        std::erase_if(changed_, [sheet](const auto& one) { return one.first == sheet; });
        for (const Serial serial : document_.serials(sheet))
            changed_.emplace_back(sheet, serial);
    }
    Q_EMIT documentChanged();
}

bool DocumentShadow::catchUp(std::chrono::nanoseconds most) {
    const auto start = std::chrono::steady_clock::now();
    if (!isFollowing_) {
        isFollowing_ = true;
        for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet)
            for (const Serial serial : document_.serials(sheet))
                changed_.emplace_back(sheet, serial);
    }
    while (!changed_.empty()) {
        const auto [sheet, serial] = changed_.front();
        changed_.pop_front();
        if (document_.find(sheet, serial))
            copies_[sheet][serial] = document_.snapshot(sheet, serial);
        if (std::chrono::steady_clock::now() - start >= most)
            break;
    }
    return changed_.empty();
}

DocumentSnapshot DocumentShadow::snapshot() const {
    const Document& value = document_.value();
    DocumentSnapshot snapshot;
    snapshot.rest.title = value.title;
    snapshot.rest.active = value.active;
    for (SheetIndex sheet = 0; sheet < kSheetCount; ++sheet) {
        snapshot.rest.sheets[sheet].view = value.sheets[sheet].view;
        for (const Serial serial : document_.serials(sheet))
            snapshot.curves[sheet].push_back(copies_[sheet].at(serial));
    }
    return snapshot;
}

void DocumentShadow::drop() {
    isFollowing_ = false;
    changed_.clear();
    for (auto& copies : copies_)
        copies.clear();
}

} // namespace kriva::ui
