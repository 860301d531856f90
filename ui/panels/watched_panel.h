#pragma once

namespace kriva::ui {

/// A panel that works only while it is looked at. Behind its neighbours a dock is moved out of sight and not hidden, so
/// that no event tells: whoever has the docks does.
class WatchedPanel {
  public:
    virtual ~WatchedPanel() = default;
    virtual void setWatched(bool isWatched) = 0;
};

} // namespace kriva::ui
