#pragma once

#include "core/document/document.h"

#include <QString>

#include <vector>

namespace kriva::ui {

/// One of the documents that come with the program.
struct Example {
    const char* resource; ///< ":/examples/NAME.kriva"
    const char* name;     ///< marked with QT_TRANSLATE_NOOP("Menus", ...)
    const char* lookAt;   ///< what there is to see, marked with QT_TRANSLATE_NOOP("Examples", ...)
};

/// The classic figures, in the order of the menu.
[[nodiscard]] const std::vector<Example>& examples();

/// The one of this resource; null for any other document.
[[nodiscard]] const Example* exampleOf(const QString& resource);

/// A document of the program's own resources.
[[nodiscard]] Document exampleDocument(const QString& resource);

/// What a new window begins with: something to look at in each tab.
[[nodiscard]] Document startDocument();

} // namespace kriva::ui
