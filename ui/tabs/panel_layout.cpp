#include "ui/tabs/panel_layout.h"

#include <utility>

namespace kriva::ui {

void PanelLayout::begin() {
    first_ = tab_.saveState();
    tab_.restoreState(state_);
}

QByteArray PanelLayout::state() const {
    return hasBegun() && isTabShown_ ? tab_.saveState() : state_;
}

void PanelLayout::restore(const QByteArray& state) {
    state_ = state;
    if (!hasBegun())
        return;
    hiddenWithTab_.clear();
    tab_.restoreState(state);
    if (!isTabShown_)
        hideFloating();
}

void PanelLayout::setTabShown(bool isShown) {
    if (!hasBegun() || std::exchange(isTabShown_, isShown) == isShown)
        return;
    if (isShown) {
        for (QDockWidget* dock : std::exchange(hiddenWithTab_, {}))
            dock->show();
    } else {
        state_ = tab_.saveState(); // as a person left it
        hideFloating();
    }
}

void PanelLayout::hideFloating() {
    for (QDockWidget* dock : docks_) {
        if (!dock->isFloating() || dock->isHidden())
            continue;
        if (QWidget* field = dock->focusWidget())
            field->clearFocus(); // what is typed is of the tab that is left
        dock->hide();
        hiddenWithTab_.push_back(dock);
    }
}

} // namespace kriva::ui
