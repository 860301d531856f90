#pragma once

#include <QObject>

namespace kriva {

/// The system's ways to end a program: SIGTERM, SIGINT, SIGHUP. They are told on the thread of the window, where
/// everything may be done; those that were ignored when the program started stay so. There is at most one of these.
class EndSignals : public QObject {
    Q_OBJECT
  public:
    explicit EndSignals(QObject* parent = nullptr);
    ~EndSignals() override;

  Q_SIGNALS:
    /// From now on the program ends by itself within two seconds, even where its window's thread is busy.
    void received();
};

} // namespace kriva
