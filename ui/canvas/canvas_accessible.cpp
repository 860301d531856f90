#include "ui/canvas/canvas_accessible.h"

#include "ui/canvas/canvas_view.h"

#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QLocale>
#include <QPointer>

#include <algorithm>
#include <map>

namespace kriva::ui {
namespace {

using Named = CanvasCurves::Named;

class CanvasInterface;

/// What lies on a canvas: a curve, or a point of one. It may be gone already; then it is not valid.
class ItemInterface : public QAccessibleInterface {
  public:
    explicit ItemInterface(CanvasView& view)
        : view_(&view) {}

    [[nodiscard]] QObject* object() const override { return nullptr; }
    [[nodiscard]] QAccessibleInterface* childAt(int, int) const override { return nullptr; }
    void setText(QAccessible::Text, const QString&) override {}

  protected:
    [[nodiscard]] CanvasView* view() const { return view_; }
    [[nodiscard]] CanvasInterface* canvas() const;
    [[nodiscard]] QRect onScreen(const QRectF& pixels) const {
        return {view_->viewport()->mapToGlobal(pixels.topLeft().toPoint()), pixels.size().toSize()};
    }

  private:
    QPointer<CanvasView> view_;
};

/// A point, by the index in its curve. It can be selected.
class PointInterface : public ItemInterface, public QAccessibleActionInterface {
    Q_DECLARE_TR_FUNCTIONS(CanvasAccessible)
  public:
    PointInterface(CanvasView& view, const GripRef& grip)
        : ItemInterface(view)
        , grip_(grip) {}

    [[nodiscard]] const GripRef& grip() const { return grip_; }
    [[nodiscard]] bool isValid() const override { return view() && place(); }
    [[nodiscard]] QAccessibleInterface* parent() const override;
    [[nodiscard]] int childCount() const override { return 0; }
    [[nodiscard]] QAccessibleInterface* child(int) const override { return nullptr; }
    [[nodiscard]] int indexOfChild(const QAccessibleInterface*) const override { return -1; }
    [[nodiscard]] QAccessible::Role role() const override { return QAccessible::ListItem; }
    [[nodiscard]] QString text(QAccessible::Text kind) const override;
    [[nodiscard]] QRect rect() const override;
    [[nodiscard]] QAccessible::State state() const override;
    void* interface_cast(QAccessible::InterfaceType type) override {
        return type == QAccessible::ActionInterface ? static_cast<QAccessibleActionInterface*>(this) : nullptr;
    }

    [[nodiscard]] QStringList actionNames() const override { return {setFocusAction()}; }
    void doAction(const QString& name) override {
        if (name == setFocusAction() && isValid()) {
            view()->setFocus();
            view()->choose(grip_);
        }
    }
    [[nodiscard]] QStringList keyBindingsForAction(const QString&) const override { return {}; }

  private:
    [[nodiscard]] std::optional<Point> place() const { return view()->scene().curves().placeOf(grip_); }

    GripRef grip_;
};

class CurveInterface : public ItemInterface {
  public:
    CurveInterface(CanvasView& view, Serial serial)
        : ItemInterface(view)
        , serial_(serial) {}

    [[nodiscard]] Serial serial() const { return serial_; }
    [[nodiscard]] bool isValid() const override { return view() && curve(); }
    [[nodiscard]] QAccessibleInterface* parent() const override;
    [[nodiscard]] int childCount() const override {
        const auto known = curve();
        return known ? known->pointCount : 0;
    }
    [[nodiscard]] QAccessibleInterface* child(int index) const override;
    [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override;
    [[nodiscard]] QAccessible::Role role() const override { return QAccessible::List; }
    [[nodiscard]] QString text(QAccessible::Text kind) const override {
        const auto known = curve();
        return known && kind == QAccessible::Name ? known->name : QString();
    }
    [[nodiscard]] QRect rect() const override { return isValid() ? onScreen(view()->viewport()->rect()) : QRect(); }
    [[nodiscard]] QAccessible::State state() const override { return {}; }

  private:
    [[nodiscard]] std::optional<Named> curve() const {
        for (const Named& named : view()->scene().curves().named())
            if (named.serial == serial_)
                return named;
        return std::nullopt;
    }

    Serial serial_;
};

/// The canvas; it owns the interfaces of what lies on it, made when they are first asked for.
class CanvasInterface : public QAccessibleWidget {
  public:
    explicit CanvasInterface(CanvasView& view)
        : QAccessibleWidget(&view, QAccessible::Canvas)
        , view_(view) {}
    ~CanvasInterface() override {
        for (const auto& [key, id] : ids_)
            QAccessible::deleteAccessibleInterface(id);
    }

    [[nodiscard]] int childCount() const override { return static_cast<int>(view_.scene().curves().named().size()); }
    [[nodiscard]] QAccessibleInterface* child(int index) const override {
        const std::vector<Named> curves = view_.scene().curves().named();
        const auto i = static_cast<std::size_t>(index);
        return index >= 0 && i < curves.size() ? ofCurve(curves[i].serial) : nullptr;
    }
    [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override {
        const auto* curve = dynamic_cast<const CurveInterface*>(child);
        const std::vector<Named> curves = view_.scene().curves().named();
        const auto found =
            std::ranges::find_if(curves, [&](const Named& named) { return curve && named.serial == curve->serial(); });
        return found == curves.end() ? -1 : static_cast<int>(found - curves.begin());
    }
    [[nodiscard]] QAccessibleInterface* childAt(int x, int y) const override {
        const Hit hit = view_.scene().hitAt(view_.viewport()->mapFromGlobal(QPointF(x, y)));
        if (hit.grip && hit.grip->id.kind == GripKind::point)
            return ofPoint(*hit.grip);
        return hit.curve ? ofCurve(*hit.curve) : nullptr;
    }
    [[nodiscard]] QAccessibleInterface* focusChild() const override {
        const Selection& selection = view_.scene().selection();
        return selection.size() == 1 && view_.hasFocus() ? ofPoint(selection.front()) : nullptr;
    }

    [[nodiscard]] QAccessibleInterface* ofCurve(Serial serial) const {
        return known({serial, {GripKind::point, -1, 0}}, [&] { return new CurveInterface(view_, serial); });
    }
    [[nodiscard]] QAccessibleInterface* ofPoint(const GripRef& grip) const {
        return known(grip, [&] { return new PointInterface(view_, grip); });
    }

  private:
    template <class Make>
    [[nodiscard]] QAccessibleInterface* known(const GripRef& key, Make make) const {
        const auto found = ids_.find(key);
        if (found != ids_.end())
            return QAccessible::accessibleInterface(found->second);
        QAccessibleInterface* made = make();
        ids_.emplace(key, QAccessible::registerAccessibleInterface(made));
        return made;
    }

    CanvasView& view_;
    mutable std::map<GripRef, QAccessible::Id> ids_; ///< a curve's own has the index -1
};

CanvasInterface* ItemInterface::canvas() const {
    return view_ ? static_cast<CanvasInterface*>(QAccessible::queryAccessibleInterface(view_)) : nullptr;
}

QAccessibleInterface* PointInterface::parent() const {
    return canvas() ? canvas()->ofCurve(grip_.serial) : nullptr;
}

QString PointInterface::text(QAccessible::Text kind) const {
    if (!isValid())
        return {};
    const Point at = *place();
    if (kind == QAccessible::Name)
        return tr("Point %1").arg(grip_.id.index);
    if (kind == QAccessible::Value)
        return QStringLiteral("x %1; y %2").arg(QLocale().toString(at.x), QLocale().toString(at.y));
    return {};
}

QRect PointInterface::rect() const {
    if (!isValid())
        return {};
    const QPointF pixel = view()->mapping().toPixels(*place());
    return onScreen({pixel - QPointF(kGripReach, kGripReach), QSizeF(2 * kGripReach, 2 * kGripReach)});
}

QAccessible::State PointInterface::state() const {
    QAccessible::State state;
    state.focusable = state.selectable = true;
    state.invalid = !isValid();
    state.selected = isValid() && view()->scene().selection().contains(grip_);
    state.focused = state.selected && view()->scene().selection().size() == 1 && view()->hasFocus();
    return state;
}

QAccessibleInterface* CurveInterface::parent() const {
    return canvas();
}

QAccessibleInterface* CurveInterface::child(int index) const {
    if (index < 0 || index >= childCount())
        return nullptr;
    return canvas()->ofPoint({serial_, {GripKind::point, index, 0}});
}

int CurveInterface::indexOfChild(const QAccessibleInterface* child) const {
    const auto* point = dynamic_cast<const PointInterface*>(child);
    return point && point->grip().serial == serial_ ? point->grip().id.index : -1;
}

QAccessibleInterface* canvasInterface(const QString&, QObject* object) {
    auto* view = qobject_cast<CanvasView*>(object);
    return view ? new CanvasInterface(*view) : nullptr;
}

} // namespace

void makeAccessible() {
    QAccessible::installFactory(canvasInterface);
}

void announcePoint(CanvasView& canvas, const GripRef& grip) {
    if (!QAccessible::isActive() || grip.id.kind != GripKind::point)
        return;
    auto* whole = static_cast<CanvasInterface*>(QAccessible::queryAccessibleInterface(&canvas));
    QAccessibleEvent event(whole->ofPoint(grip), QAccessible::Focus);
    QAccessible::updateAccessibility(&event);
}

} // namespace kriva::ui
