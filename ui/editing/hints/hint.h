#pragma once

#include <QString>

#include <optional>

namespace kriva::ui {

/// Something worth telling in the status row: a source text marked with QT_TRANSLATE_NOOP("Hint", ...).
struct Hint {
    const char* source = "";
    std::optional<double> number = {}; ///< replaces %1

    [[nodiscard]] QString text() const;
};

} // namespace kriva::ui
