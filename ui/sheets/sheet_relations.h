#pragma once

#include "core/document/document.h"

#include <QObject>
#include <QTimer>

namespace kriva::ui {

class ShownSheet;

/// What the curves on view have with each other, following the changes: once per turn of the event loop, and on another
/// thread where it takes longer than a frame. What is out of date when it is ready is dropped.
class SheetRelations : public QObject {
    Q_OBJECT
  public:
    explicit SheetRelations(ShownSheet& sheet, QObject* parent = nullptr);

    [[nodiscard]] const Relations& relations() const { return relations_; }

  Q_SIGNALS:
    void changed();

  private:
    void computeSoon();
    void compute();
    void computeElsewhere(Sheet sheet);
    void take(Relations relations, qint64 milliseconds);

    ShownSheet& sheet_;
    Relations relations_;
    QTimer pending_;
    bool isComputing_ = false; ///< on another thread
    bool isOutOfDate_ = false; ///< what is being computed there
    bool isQuick_ = false;     ///< it took less than a frame the last time
};

} // namespace kriva::ui
