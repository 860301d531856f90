#pragma once

#include <gtest/gtest.h>
#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace kriva::test {

/// The message box that waits for an answer; fails where there is none.
inline QMessageBox* askedBox() {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    EXPECT_NE(box, nullptr) << "nobody asks";
    return box;
}

/// Answers the next message box.
inline void answerWith(QMessageBox::StandardButton button) {
    QTimer::singleShot(0, [button] {
        QMessageBox* box = askedBox();
        if (!box)
            return;
        EXPECT_EQ(box->textFormat(), Qt::PlainText);
        EXPECT_NE(box->button(button), nullptr);
        box->button(button) ? box->button(button)->click() : box->reject();
    });
}

/// Answers the next message box by the button with this text, then does what follows, if anything.
inline void answerWith(const QString& text, const std::function<void()>& before = {}) {
    QTimer::singleShot(0, [text, before] {
        QMessageBox* box = askedBox();
        if (!box)
            return;
        EXPECT_EQ(box->textFormat(), Qt::PlainText);
        if (before)
            before(); // the answer may ask something more
        for (QAbstractButton* button : box->buttons())
            if (button->text().remove(QLatin1Char('&')) == text)
                return button->click();
        ADD_FAILURE() << "there is no button " << text.toStdString();
        box->reject();
    });
}

/// Chooses a file in the next file dialog.
inline void chooseFile(const QString& path) {
    QTimer::singleShot(0, [path] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr) << "nobody asks for a file";
        dialog->selectFile(path);
        static_cast<QDialog*>(dialog)->accept();
    });
}

} // namespace kriva::test
