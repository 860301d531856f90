#pragma once

#include <QLabel>

namespace kriva::ui {

/// A label that shows its text letter by letter. A QLabel by itself takes for HTML what looks like it, and then opens
/// the files that it names.
class PlainLabel : public QLabel {
  public:
    explicit PlainLabel(QWidget* parent)
        : QLabel(parent) {
        setTextFormat(Qt::PlainText);
    }
};

} // namespace kriva::ui
