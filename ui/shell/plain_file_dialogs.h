#pragma once

#include <QObject>

namespace kriva::ui {

/// Keeps the questions of Qt's own file dialog from reading the names of files as HTML: its boxes ("%1 already exists")
/// show them letter by letter as long as this lives.
class PlainFileDialogs : public QObject {
    Q_OBJECT
  public:
    explicit PlainFileDialogs(QObject* parent);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace kriva::ui
