#pragma once

#include <QLineEdit>

namespace kriva::ui {

/// A field that does not take every text. Enter and leaving apply what was typed once, Escape takes it back. What is
/// refused stays in place as long as the field has the focus, marked, with the reason as tooltip and description; a
/// field that is left shows what holds.
class CheckedField : public QLineEdit {
    Q_OBJECT
  public:
    explicit CheckedField(QWidget* parent = nullptr);

    /// Applies the typed text as Enter does. False if it is refused: then nothing was applied and it stays on show.
    bool commit();
    [[nodiscard]] bool isEdited() const { return text() != shown_; }
    /// What holds is always accepted.
    [[nodiscard]] bool isAccepted() const { return !isEdited() || accepts(text()); }
    /// Says beside the field why its text is refused.
    void tellRefusal();

  protected:
    [[nodiscard]] virtual bool accepts(const QString& text) const = 0;
    /// Why a text that is not accepted is none.
    [[nodiscard]] virtual QString refusal() const = 0;
    /// What holds, in the present language.
    [[nodiscard]] virtual QString heldText() const = 0;
    /// Takes an accepted text.
    virtual void apply(const QString& text) = 0;

    void showHeld();
    void showVerdict();
    /// A text being typed stays; what is shown in a field without the focus is what holds.
    void followHeld();

    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    QString shown_; ///< what holds, as it was shown last; what differs from it was typed
};

} // namespace kriva::ui
