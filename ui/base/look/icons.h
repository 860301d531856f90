#pragma once

#include <QIcon>

namespace kriva::ui {

/// The program's own icons; resources/icons holds one drawing for each.
enum class IconName {
    New,
    Open,
    Save,
    Export,
    Undo,
    Redo,
    AddPoint,
    Edit,
    ZoomIn,
    ZoomOut,
    Fit,
    Grid,
    Delete,
    Duplicate,
    Up,
    Down,
    Play,
    Pause,
    Slower,
    Faster,
    DirectionForward,
    DirectionBackward,
    DirectionBoth,
    StepForward,
    StepBack,
    Loop,
    Visible,
    Hidden,
    Close,
    Float,
    More
};

/// The icon in the text colour of buttons: that of `palette` if one is given, else that of the program when it is
/// painted, so that it follows the theme by itself. Paler where it is disabled, sharp at every size and scale.
[[nodiscard]] QIcon icon(IconName name);
[[nodiscard]] QIcon icon(IconName name, const QPalette& palette);

/// The program's own sign, in its colours.
[[nodiscard]] QIcon applicationIcon();

} // namespace kriva::ui
