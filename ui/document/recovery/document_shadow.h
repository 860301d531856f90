#pragma once

#include "ui/document/open_document.h"

#include <chrono>
#include <deque>
#include <memory>
#include <unordered_map>

namespace kriva::ui {

/// A document at one moment, for another thread: copying it copies no curve.
struct DocumentSnapshot {
    Document rest; ///< all but the curves
    std::array<std::vector<std::shared_ptr<const Curve>>, kSheetCount> curves;
};

/// The document itself again.
[[nodiscard]] Document documentOf(const DocumentSnapshot& snapshot);

/// Keeps a copy of each curve of an open document, and copies anew only those that changed, a few at a time: so the
/// window never waits for a large document, and a snapshot is of one moment all the same.
class DocumentShadow : public QObject {
    Q_OBJECT
  public:
    explicit DocumentShadow(const OpenDocument& document, QObject* parent = nullptr);

    /// Copies what changed since the last time, at least one curve, until all is copied or the time is over; whether
    /// all is copied.
    bool catchUp(std::chrono::nanoseconds most);
    /// Of the present value. All is copied.
    [[nodiscard]] DocumentSnapshot snapshot() const;
    /// Gives the memory back; the next time all is copied anew.
    void drop();

  Q_SIGNALS:
    /// A curve, or which there are.
    void documentChanged();

  private:
    void markCurve(SheetIndex sheet, Serial serial);
    void markSheet(SheetIndex sheet);

    const OpenDocument& document_;
    std::array<std::unordered_map<Serial, std::shared_ptr<const Curve>>, kSheetCount> copies_;
    /// What is to be copied. What changes again goes to the end, so that a curve being dragged keeps no other waiting.
    std::deque<std::pair<SheetIndex, Serial>> changed_;
    bool isFollowing_ = false; ///< from the first catchUp() to drop()
};

} // namespace kriva::ui
