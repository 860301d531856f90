#pragma once

#include "core/curve/file_error.h"
#include "core/document/document.h"

namespace kriva {

/// What was cut or copied out of a sheet, on its way to another place.
struct Fragment {
    enum class Content { points, curve };

    Content content = Content::curve;
    Curve curve; ///< of points: nothing but these, with all that belongs to them
    friend bool operator==(const Fragment&, const Fragment&) = default;
};

/// The fragment of some points of a curve; `indices` ascending.
[[nodiscard]] Fragment fragmentOf(const Curve& curve, std::span<const int> indices);

/// A fragment as UTF-8 JSON, its curve as in a document: {"format":"kriva-fragment","version":1,"content":"points",
/// "sheet":"spline","curve":{...}}. readFragment gives it back bit for bit.
[[nodiscard]] std::string writeFragment(const Fragment& fragment);

/// Refuses whatever a document would refuse, with the place of the first fault.
[[nodiscard]] std::variant<Fragment, FileError> readFragment(std::string_view text);

} // namespace kriva
