#include "ui/window/dialogs/document_questions.h"

#include "ui/base/message_box.h"

#include <QCoreApplication>
#include <QPushButton>

#include <utility>
#include <vector>

namespace kriva::ui {
namespace {

class Questions {
    Q_DECLARE_TR_FUNCTIONS(DocumentQuestions)
};

/// A message box with answers of its own, each of them a value.
template <class Answer>
class Question {
  public:
    Question(QMessageBox::Icon icon, const QString& title, const QString& text, const QString& more, QWidget* window)
        : box_(icon, {title, text, more.isEmpty() ? QStringList() : QStringList(more)}, QMessageBox::NoButton, window) {
    }
    /// The first one is what Enter does.
    Question& add(const QString& text, QMessageBox::ButtonRole role, Answer answer) {
        return add(box_.addButton(text, role), answer);
    }
    Question& add(QMessageBox::StandardButton button, Answer answer) { return add(box_.addButton(button), answer); }
    /// `otherwise` where the box is closed without an answer.
    [[nodiscard]] Answer ask(Answer otherwise) {
        box_.exec();
        for (const auto& [button, answer] : answers_)
            if (box_.clickedButton() == button)
                return answer;
        return otherwise;
    }

  private:
    Question& add(QPushButton* button, Answer answer) {
        if (answers_.empty())
            box_.setDefaultButton(button);
        answers_.emplace_back(button, answer);
        return *this;
    }

    MessageBox box_;
    std::vector<std::pair<QAbstractButton*, Answer>> answers_;
};

} // namespace

EditedFigureAnswer askAboutEditedFigure(const QString& name, QWidget* window) {
    using enum EditedFigureAnswer;
    return Question<EditedFigureAnswer>(QMessageBox::Question, Questions::tr("An edited figure"),
                                        Questions::tr("The lines of “%1” were edited in another program: they are not "
                                                      "those of the document inside any more.")
                                            .arg(name),
                                        Questions::tr("Open the document as it was, or as it is drawn now?"), window)
        .add(Questions::tr("D&rawing"), QMessageBox::AcceptRole, Drawing)
        .add(Questions::tr("&Document"), QMessageBox::AcceptRole, Document)
        .add(QMessageBox::Cancel, Cancel)
        .ask(Cancel);
}

namespace {

SaveAnswer askToSave(const QString& title, const QString& text, const QString& more, QWidget* window) {
    using enum SaveAnswer;
    return Question<SaveAnswer>(QMessageBox::Warning, title, text, more, window)
        .add(QMessageBox::Save, Save)
        .add(QMessageBox::Discard, Discard)
        .add(QMessageBox::Cancel, Cancel)
        .ask(Cancel);
}

} // namespace

SaveAnswer askAboutUnsaved(const QString& name, QWidget* window) {
    return askToSave(Questions::tr("Unsaved changes"), Questions::tr("Save the changes to “%1”?").arg(name),
                     Questions::tr("Without saving they are lost."), window);
}

SaveAnswer askAboutGone(const QString& name, QWidget* window) {
    return askToSave(Questions::tr("The file is gone"), Questions::tr("Save “%1” again?").arg(name),
                     Questions::tr("Its file was deleted or moved elsewhere."), window);
}

SaveAnswer askAboutChanged(const QString& name, QWidget* window) {
    using enum SaveAnswer;
    return Question<SaveAnswer>(
               QMessageBox::Warning, Questions::tr("Changed elsewhere"),
               Questions::tr("Another program changed “%1” since it was opened or saved here.").arg(name),
               Questions::tr("What is shown here is in no file any more: without saving it is lost."), window)
        .add(Questions::tr("Save &as…"), QMessageBox::AcceptRole, SaveAs)
        .add(Questions::tr("&Overwrite"), QMessageBox::DestructiveRole, Overwrite)
        .add(QMessageBox::Discard, Discard)
        .add(QMessageBox::Cancel, Cancel)
        .ask(Cancel);
}

OpenElsewhereAnswer askAboutOpenElsewhere(const QString& name, QWidget* window) {
    using enum OpenElsewhereAnswer;
    return Question<OpenElsewhereAnswer>(QMessageBox::Question, Questions::tr("Open elsewhere"),
                                         Questions::tr("Another Kriva has “%1” open.").arg(name),
                                         Questions::tr("A copy is a document of its own. Opened anyway, the one that "
                                                       "saves last overwrites the other."),
                                         window)
        .add(Questions::tr("Open a &copy"), QMessageBox::AcceptRole, Copy)
        .add(Questions::tr("Open &anyway"), QMessageBox::DestructiveRole, Anyway)
        .add(QMessageBox::Cancel, Cancel)
        .ask(Cancel);
}

SaveAnswer askToOverwriteOpen(const QString& name, QWidget* window) {
    using enum SaveAnswer;
    return Question<SaveAnswer>(QMessageBox::Warning, Questions::tr("Open elsewhere"),
                                Questions::tr("“%1” is open in another window or in another Kriva.").arg(name),
                                Questions::tr("Overwritten, it is no longer what is shown there."), window)
        .add(Questions::tr("Save &as…"), QMessageBox::AcceptRole, SaveAs)
        .add(Questions::tr("&Overwrite"), QMessageBox::DestructiveRole, Overwrite)
        .add(QMessageBox::Cancel, Cancel)
        .ask(Cancel);
}

SaveAnswer askToOverwriteChanged(const QString& name, QWidget* window) {
    using enum SaveAnswer;
    return Question<SaveAnswer>(
               QMessageBox::Warning, Questions::tr("Changed elsewhere"),
               Questions::tr("Another program changed “%1” since it was opened or saved here.").arg(name),
               Questions::tr("Overwritten, the changes made there are lost; reloaded, those made "
                             "here."),
               window)
        .add(Questions::tr("Save &as…"), QMessageBox::AcceptRole, SaveAs)
        .add(Questions::tr("&Overwrite"), QMessageBox::DestructiveRole, Overwrite)
        .add(Questions::tr("&Reload"), QMessageBox::DestructiveRole, Reload)
        .add(QMessageBox::Cancel, Cancel)
        .ask(Cancel);
}

bool askToReload(const QString& name, QWidget* window) {
    return Question<bool>(QMessageBox::Warning, Questions::tr("Unsaved changes"),
                          Questions::tr("Reload “%1” as it is in its file?").arg(name),
                          Questions::tr("The changes made here are lost."), window)
        .add(QMessageBox::Cancel, false)
        .add(Questions::tr("&Reload"), QMessageBox::DestructiveRole, true)
        .ask(false);
}

void tellNotOpened(const QString& sentence, QWidget* window) {
    std::ignore = Question<bool>(QMessageBox::Critical, Questions::tr("The file was not opened"), sentence, {}, window)
                      .add(QMessageBox::Ok, true)
                      .ask(true);
}

bool tellNotSaved(const QString& sentence, QWidget* window) {
    return Question<bool>(QMessageBox::Critical, Questions::tr("The document was not saved"), sentence,
                          Questions::tr("It is still here, as you see it."), window)
        .add(Questions::tr("Save &as…"), QMessageBox::AcceptRole, true)
        .add(QMessageBox::Cancel, false)
        .ask(false);
}

} // namespace kriva::ui
