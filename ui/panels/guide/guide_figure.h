#pragma once

#include "core/figure/style/theme.h"

#include <QImage>
#include <QString>

namespace kriva::ui {

/// How wide a picture of the guide is, and for which page.
struct GuideFigureLook {
    int width = 0; ///< in pixels that do not depend on the screen
    double devicePixelRatio = 1;
    Theme theme = Theme::light;
};

/// The figure of the document :/guide/figures/NAME.kriva as the canvas draws it, in the present language, on nothing;
/// null where there is no such document.
[[nodiscard]] QImage guideFigure(const QString& name, const GuideFigureLook& look);

} // namespace kriva::ui
