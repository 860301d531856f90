#pragma once

#include <QComboBox>

namespace kriva::ui {

/// A choice among names that come and go. It stays where it is as long as there is an entry.
class KeptChoice : public QComboBox {
    Q_OBJECT
  public:
    explicit KeptChoice(QWidget* parent = nullptr);

    /// Tells nobody: whoever sets other names shows what is chosen among them.
    void setNames(const QStringList& names);
};

} // namespace kriva::ui
