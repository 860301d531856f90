#pragma once

#include <QString>

#include <optional>

namespace kriva::ui {

/// The name of an undo step: a source text marked with QT_TRANSLATE_NOOP("Step", ...), translated only when it is
/// shown, so that the history follows the language.
struct StepLabel {
    const char* source = "";
    std::optional<int> number = {}; ///< replaces %1: the index of a point, say

    [[nodiscard]] QString text() const;
    friend bool operator==(const StepLabel&, const StepLabel&) = default;
};

/// A label as it is kept in a QUndoCommand, and back from there in the present language.
[[nodiscard]] QString stored(const StepLabel& label);
[[nodiscard]] QString resolvedStep(const QString& stored);

} // namespace kriva::ui
