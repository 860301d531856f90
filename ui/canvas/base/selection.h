#pragma once

#include "core/curve/editing/grip.h"
#include "core/figure/figure.h"
#include "ui/document/serial.h"

#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

namespace kriva::ui {

/// One grip of one curve of the sheet.
struct GripRef {
    Serial serial = 0;
    GripId id;
    friend constexpr auto operator<=>(const GripRef&, const GripRef&) = default;
};

/// Grips, each once, by curve, kind and index. There may be as many as points, and every repaint asks for them: they
/// lie in one piece, and what is read or made in order costs no search.
class Selection {
  public:
    Selection() = default;
    Selection(std::initializer_list<GripRef> grips)
        : Selection(std::vector<GripRef>(grips)) {}
    /// In any order.
    explicit Selection(std::vector<GripRef> grips);

    [[nodiscard]] auto begin() const { return grips_.begin(); }
    [[nodiscard]] auto end() const { return grips_.end(); }
    [[nodiscard]] std::size_t size() const { return grips_.size(); }
    [[nodiscard]] bool empty() const { return grips_.empty(); }
    [[nodiscard]] const GripRef& front() const { return grips_.front(); }
    [[nodiscard]] const GripRef& back() const { return grips_.back(); }
    [[nodiscard]] bool contains(const GripRef& grip) const;
    /// Those of one curve, its points first.
    [[nodiscard]] std::span<const GripRef> ofCurve(Serial serial) const;

    /// In constant time behind all others, else linear in what comes behind it.
    void insert(const GripRef& grip);
    /// Likewise the points of a curve from one index up to another, which is not one of them.
    void insertPoints(Serial serial, int first, int end);

    friend Selection united(const Selection& a, const Selection& b);
    friend Selection without(const Selection& selection, const Selection& removed);
    friend bool operator==(const Selection&, const Selection&) = default;

  private:
    std::vector<GripRef> grips_; ///< ascending
};

[[nodiscard]] Selection united(const Selection& a, const Selection& b);
[[nodiscard]] Selection without(const Selection& selection, const Selection& removed);

/// A mark that cannot be taken hold of: a point that was worked out from others.
struct MarkPlace {
    Role role = Role::point;
    Point at;
    friend bool operator==(const MarkPlace&, const MarkPlace&) = default;
};

/// What lies under a pixel: a grip, else a curve or a mark or both, else nothing.
struct Hit {
    std::optional<GripRef> grip;
    std::optional<Serial> curve;
    std::optional<MarkPlace> mark = {};
    friend bool operator==(const Hit&, const Hit&) = default;
};

/// A place on a curve.
struct CurvePlace {
    Serial curve = 0;
    Point near; ///< as the pointer says it
};

} // namespace kriva::ui
