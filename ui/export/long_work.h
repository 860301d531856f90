#pragma once

#include <QString>

#include <functional>
#include <optional>
#include <stop_token>

class QWidget;

namespace kriva::ui {

/// Does the work on a thread of its own while its window goes on being painted. Where it takes long a dialog with the
/// sentence says so and lets a person end it. Whether the work was done to its end.
///
/// The work holds copies of all that it looks at, and ends soon after it is told to stop.
[[nodiscard]] bool finishes(const std::function<void(std::stop_token)>& work, const QString& sentence, QWidget* window);

/// What the work gives; nothing where a person ended it.
template <class T>
[[nodiscard]] std::optional<T> workedOut(const std::function<T(std::stop_token)>& work, const QString& sentence,
                                         QWidget* window) {
    std::optional<T> result;
    if (!finishes([&](const std::stop_token& stop) { result = work(stop); }, sentence, window))
        return {};
    return result;
}

} // namespace kriva::ui
