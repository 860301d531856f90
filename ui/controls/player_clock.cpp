#include "ui/controls/player_clock.h"

namespace kriva::ui {

bool PlayerClock::advance() {
    const bool goesBack =
        direction == PlayDirection::backwards || (direction == PlayDirection::toAndFro && isOnWayBack);
    const int next = stage + (goesBack ? -1 : 1);
    if (next >= 0 && next <= last) {
        stage = next;
        return true;
    }
    if (direction == PlayDirection::toAndFro && (isLooping || !isOnWayBack)) {
        isOnWayBack = !isOnWayBack;
        return last > 0 && advance();
    }
    if (!isLooping || last == 0)
        return false;
    stage = goesBack ? last : 0;
    return true;
}

void PlayerClock::rewindAtEnd() {
    if (direction == PlayDirection::forwards && stage >= last)
        stage = 0;
    else if (direction == PlayDirection::backwards && stage <= 0)
        stage = last;
    else if (direction == PlayDirection::toAndFro && stage <= 0)
        isOnWayBack = false;
}

} // namespace kriva::ui
