#include "ui/shell/examples.h"

#include "core/document/document_json.h"

#include <QCoreApplication>
#include <QFile>

namespace kriva::ui {

const std::vector<Example>& examples() {
    static const std::vector<Example> all{
        {":/examples/elevation-97.kriva", QT_TRANSLATE_NOOP("Menus", "A cubic raised 97 times")},
        {":/examples/de-casteljau.kriva", QT_TRANSLATE_NOOP("Menus", "De Casteljau at t = 1/2")},
        {":/examples/blossom.kriva", QT_TRANSLATE_NOOP("Menus", "The blossom b[t₁, t₂, t₃]")},
        {":/examples/multiple-points.kriva", QT_TRANSLATE_NOOP("Menus", "An arc with double and triple points")},
        {":/examples/self-intersections.kriva", QT_TRANSLATE_NOOP("Menus", "A chain with three self-intersections")},
        {":/examples/clamped-spline.kriva", QT_TRANSLATE_NOOP("Menus", "A clamped cubic spline")},
        {":/examples/runge.kriva", QT_TRANSLATE_NOOP("Menus", "Runge's function")},
        {":/examples/five-runs.kriva", QT_TRANSLATE_NOOP("Menus", "A curve with five monotone runs")},
        {":/examples/leaf.kriva", QT_TRANSLATE_NOOP("Menus", "The outline of a leaf")},
    };
    return all;
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
