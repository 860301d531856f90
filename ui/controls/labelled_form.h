#pragma once

#include <QFormLayout>

namespace kriva::ui {

/// Rows of a field with its label in front, which names it to screen readers too. The texts come later, and again
/// whenever the language changes.
class LabelledForm : public QFormLayout {
    Q_OBJECT
  public:
    using QFormLayout::QFormLayout;

    void addField(QWidget* field);
    /// With a mnemonic, where it has one.
    void setLabel(QWidget* field, const QString& text);
};

} // namespace kriva::ui
