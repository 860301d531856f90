#include "ui/base/examples.h"

#include "core/io/json/document_json.h"

#include <QCoreApplication>
#include <QFile>

#include <algorithm>

namespace kriva::ui {

const std::vector<Example>& examples() {
    static const std::vector<Example> all{
        {":/examples/elevation-97.kriva", QT_TRANSLATE_NOOP("Menus", "A cubic raised 97 times"),
         QT_TRANSLATE_NOOP("Examples", "The polygon of degree 100 lies all but on the curve. Lower the degree with "
                                       "Page Down and watch the gap grow like 1/N.")},
        {":/examples/de-casteljau.kriva", QT_TRANSLATE_NOOP("Menus", "De Casteljau at t = 1/2"),
         QT_TRANSLATE_NOOP("Examples", "Three rows of midpoints lead to the point (7/2, 3/2) of the curve. Move t: the "
                                       "last segment of the scheme stays tangent to the curve.")},
        {":/examples/blossom.kriva", QT_TRANSLATE_NOOP("Menus", "The blossom b[t₁, t₂, t₃]"),
         QT_TRANSLATE_NOOP("Examples", "Each row of the scheme has a parameter of its own, and so the point lies off "
                                       "the curve. Make the three arguments equal: it falls on it.")},
        {":/examples/multiple-points.kriva", QT_TRANSLATE_NOOP("Menus", "An arc with double and triple points"),
         QT_TRANSLATE_NOOP("Examples", "One polygon, whose inner points count once, twice and three times: the more "
                                       "often a point counts, the closer it draws the arc to itself.")},
        {":/examples/self-intersections.kriva", QT_TRANSLATE_NOOP("Menus", "A chain with three self-intersections"),
         QT_TRANSLATE_NOOP("Examples", "A closed chain of six cubics that crosses itself three times. Results names "
                                       "the segments and parameters of every crossing.")},
        {":/examples/clamped-spline.kriva", QT_TRANSLATE_NOOP("Menus", "A clamped cubic spline"),
         QT_TRANSLATE_NOOP("Examples", "The two arrows are the derivatives at the ends. Drag one: the whole chain "
                                       "follows, and every knot stays C2.")},
        {":/examples/runge.kriva", QT_TRANSLATE_NOOP("Menus", "Runge's function"),
         QT_TRANSLATE_NOOP("Examples", "On equally spaced points the interpolation of degree 10 swings out near the "
                                       "ends; the approximation of degree 6 does so far less.")},
        {":/examples/five-runs.kriva", QT_TRANSLATE_NOOP("Menus", "A curve with five monotone runs"),
         QT_TRANSLATE_NOOP("Examples", "The points turn back in x four times: five monotone runs, each a polynomial "
                                       "y(x), joined by Bézier curves.")},
        {":/examples/leaf.kriva", QT_TRANSLATE_NOOP("Menus", "The outline of a leaf"),
         QT_TRANSLATE_NOOP(
             "Examples",
             "Two curves of pairs pass through every point. Drag a middle point: only its own pair changes.")},
    };
    return all;
}

const Example* exampleOf(const QString& resource) {
    const auto found = std::ranges::find_if(
        examples(), [&](const Example& example) { return resource == QLatin1String(example.resource); });
    return found == examples().end() ? nullptr : &*found;
}

Document exampleDocument(const QString& resource) {
    QFile file(resource);
    [[maybe_unused]] const bool isThere = file.open(QIODevice::ReadOnly);
    Q_ASSERT(isThere); // it is part of the program
    const QByteArray text = file.readAll();
    return std::get<Document>(readDocument({text.constData(), static_cast<std::size_t>(text.size())}));
}

Document startDocument() {
    return exampleDocument(QStringLiteral(":/examples/start.kriva"));
}

} // namespace kriva::ui
