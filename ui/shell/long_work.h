#pragma once

#include "core/work/work_budget.h"

#include <QString>

#include <functional>
#include <optional>
#include <utility>

class QWidget;

namespace kriva::ui {

/// Does the work on a thread of its own while its window goes on being painted. Where it takes long a dialog with the
/// sentence says so and lets a person end it, and so does the window's end. Whether the work was done to its end.
///
/// The work holds copies of all that it looks at, and spends its budget in every loop that may be long.
[[nodiscard]] bool finishes(const std::function<void(WorkBudget&)>& work, const QString& sentence, QWidget* window);

/// What the work gives; nothing where a person ended it.
template <class T>
[[nodiscard]] std::optional<T> workedOut(const std::function<T(WorkBudget&)>& work, const QString& sentence,
                                         QWidget* window) {
    std::optional<T> result;
    if (!finishes([&](WorkBudget& budget) { result = work(budget); }, sentence, window))
        return {};
    return result;
}

} // namespace kriva::ui
