#pragma once

#include <QObject>

namespace kriva::ui {

/// Keeps Qt's own file dialog from being led astray by the names of files, as long as this lives: its questions ("%1
/// already exists") do not read them as HTML, and its lists, that of what completes a name too, show them as
/// printable() does.
class PlainFileDialogs : public QObject {
    Q_OBJECT
  public:
    explicit PlainFileDialogs(QObject* parent);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace kriva::ui
