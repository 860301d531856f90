#pragma once

#include "ui/canvas/base/hit_test.h"
#include "ui/canvas/base/snapping.h"
#include "ui/canvas/drawing/figure_item.h"

#include <QString>

#include <optional>
#include <vector>

class QGraphicsScene;

namespace kriva::ui {

/// What a canvas shows of one curve of the sheet.
struct CanvasCurve {
    Serial serial = 0; ///< 0 of what belongs to no curve
    Figure figure;
    std::vector<Grip> grips; ///< of what is shown: what is hidden is never hit
    bool isActive = false;
    bool isOnTop = false; ///< drawn over the active curve
    QString name = {};    ///< what a person calls it
    /// What it looks like is still being worked out: what is shown of it stays, else it is this figure. The grips hold.
    bool isFigureDue = false;
    std::optional<Box> box = {}; ///< of the figure, where it is known
};

/// The curves that a canvas shows, each an item of its scene. Items are prepared when they are next painted or asked
/// what lies under a pixel, as finely as a frame has time for.
class CanvasCurves {
  public:
    explicit CanvasCurves(QGraphicsScene& scene)
        : scene_(scene) {}

    /// All of them, from the lowest to the topmost.
    void set(std::vector<CanvasCurve> curves);
    /// One in place; the others are not touched.
    void update(CanvasCurve curve);

    /// Everything is to be prepared anew: another sight.
    void invalidate();
    /// Chooses the sight's fineness by what there is to paint. Gives where, in pixels, the curves look different now.
    Box prepare(Sight& sight);

    /// They hold as long as nothing is set, updated or prepared.
    [[nodiscard]] std::vector<HitTarget> targets() const;
    /// What a dragged point may snap to.
    [[nodiscard]] std::vector<SnapTarget> snapTargets() const;
    /// All points that can be taken hold of, by curve and index.
    [[nodiscard]] std::vector<GripRef> points() const;
    [[nodiscard]] std::optional<Point> placeOf(const GripRef& grip) const;
    [[nodiscard]] Points placesOf(const Selection& selection) const;
    /// Of all figures and grips.
    [[nodiscard]] Box box() const;
    /// Of the figures of curves alone.
    [[nodiscard]] Box boxOfFigures() const;

    struct Named {
        Serial serial = 0;
        QString name;
        int pointCount = 0;
    };
    /// Those that can be taken hold of.
    [[nodiscard]] std::vector<Named> named() const;

  private:
    struct Entry {
        Serial serial = 0;
        QString name;
        bool isActive = false;
        bool isPrepared = false;
        bool isSettled = false; ///< and what changed is known
        std::vector<Grip> grips;
        std::optional<Box> box;     ///< of the figure, once it was asked for
        FigureItem* item = nullptr; ///< owned by the scene

        [[nodiscard]] Box boxOfFigure() const { return box ? *box : boxOf(item->figure()); }
    };

    [[nodiscard]] Entry entryFor(const CanvasCurve& curve, std::vector<Entry>& before);
    static void fill(Entry& entry, CanvasCurve curve);
    void choose(Sight& sight);
    [[nodiscard]] FrameLoad prepareStale(const Sight& sight);

    QGraphicsScene& scene_;
    std::vector<Entry> entries_;
    MarkPictures pictures_;
};

} // namespace kriva::ui
