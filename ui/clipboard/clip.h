#pragma once

#include "core/io/json/fragment.h"

#include <QMimeData>

#include <memory>

namespace kriva::ui {

/// The name of Kriva's own format on a clipboard: a fragment as JSON.
inline constexpr char kFragmentFormat[] = "application/x-kriva-fragment+json";

/// A fragment for the clipboard: for Kriva itself, as an SVG figure of its curve in the scale of its page, and as a
/// table of its points.
[[nodiscard]] std::unique_ptr<QMimeData> clipOf(const Fragment& fragment, std::optional<double> mmPerUnit);

/// What can be pasted into a sheet: a fragment of any sheet or a table of points as a fragment of its own kind, the
/// paths of an SVG figure or of path data as new curves; else one line that says why not, and where.
[[nodiscard]] std::variant<Fragment, std::vector<Curve>, QString> readClip(const QMimeData& clip, SheetIndex sheet);

} // namespace kriva::ui
