#include "ui/sheets/sheet_relations.h"

#include "ui/sheets/shown_sheet.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QPointer>
#include <QThreadPool>

namespace kriva::ui {
namespace {

constexpr qint64 kFrame = 8; ///< milliseconds, the half of a frame: the other half is for drawing

} // namespace

SheetRelations::SheetRelations(ShownSheet& sheet, QObject* parent)
    : QObject(parent)
    , sheet_(sheet) {
    pending_.setSingleShot(true);
    pending_.setInterval(0);
    connect(&pending_, &QTimer::timeout, this, &SheetRelations::compute);
    connect(&sheet.document(), &OpenDocument::replaced, this, [this] {
        isQuick_ = false;
        computeSoon();
    });
    connect(&sheet.document(), &OpenDocument::curvesChanged, this, &SheetRelations::computeSoon);
    connect(&sheet.document(), &OpenDocument::viewChanged, this, &SheetRelations::computeSoon);
    connect(&sheet, &ShownSheet::shownCurveChanged, this, &SheetRelations::computeSoon);
    computeSoon();
}

void SheetRelations::computeSoon() {
    if (!pending_.isActive())
        pending_.start();
}

void SheetRelations::compute() {
    isOutOfDate_ = isComputing_;
    if (isComputing_)
        return;
    if (!isQuick_)
        return computeElsewhere(sheet_.sheetOnView());
    QElapsedTimer clock;
    clock.start();
    Relations relations = relationsOf(sheet_.sheetOnView(), sheet_.index());
    take(std::move(relations), clock.elapsed());
}

void SheetRelations::computeElsewhere(Sheet sheet) {
    isComputing_ = true;
    const auto work = [self = QPointer(this), sheet = std::move(sheet), index = sheet_.index()] {
        QElapsedTimer clock;
        clock.start();
        Relations relations = relationsOf(sheet, index);
        const auto deliver = [self, relations = std::move(relations), took = clock.elapsed()] {
            if (!self)
                return;
            self->isComputing_ = false;
            if (self->isOutOfDate_ || self->pending_.isActive())
                self->computeSoon();
            else
                self->take(relations, took);
        };
        QMetaObject::invokeMethod(QCoreApplication::instance(), deliver);
    };
    QThreadPool::globalInstance()->start(work);
}

void SheetRelations::take(Relations relations, qint64 milliseconds) {
    isQuick_ = milliseconds < kFrame;
    if (relations.results.empty() && relations_.results.empty())
        return;
    relations_ = std::move(relations);
    Q_EMIT changed();
}

} // namespace kriva::ui
