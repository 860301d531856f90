#pragma once

#include "ui/editing/sheet/shown_sheet.h"

namespace kriva::ui {

/// What one panel points out on the canvas: where several do, the last one is followed, and nobody takes back what is
/// another's.
class PointedOut {
  public:
    /// The sheet outlives this.
    explicit PointedOut(ShownSheet& sheet)
        : sheet_(sheet) {}

    /// Somebody chose these places.
    void choose(Points places);
    /// What was chosen is elsewhere now; nothing happens where nothing was.
    void follow(const Points& places);

  private:
    ShownSheet& sheet_;
    Points mine_;
};

} // namespace kriva::ui
