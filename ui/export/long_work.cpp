#include "ui/export/long_work.h"

#include "ui/base/look/plain_label.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QEventLoop>
#include <QPointer>
#include <QProgressBar>
#include <QTimer>
#include <QVBoxLayout>

#include <thread>

namespace kriva::ui {
namespace {

/// In milliseconds: what is done by then needs no dialog.
constexpr int kPatience = 500;

/// Says what is being done, nobody knows how long, and is rejected by whoever will not wait.
QDialog* waitingDialog(const QString& sentence, QWidget* window) {
    auto* dialog = new QDialog(window);
    dialog->setModal(true);
    dialog->setWindowTitle(sentence);
    auto* label = new PlainLabel(dialog);
    label->setText(sentence);
    auto* bar = new QProgressBar(dialog);
    bar->setRange(0, 0);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(label);
    layout->addWidget(bar);
    layout->addWidget(buttons);
    return dialog;
}

} // namespace

bool finishes(const std::function<void(std::stop_token)>& work, const QString& sentence, QWidget* window) {
    std::stop_source stop;
    bool hasEnded = false;
    QEventLoop waiting;
    const std::jthread thread([&] {
        work(stop.get_token());
        QMetaObject::invokeMethod(&waiting, [&] {
            hasEnded = true;
            waiting.quit();
        });
    });

    QTimer::singleShot(kPatience, &waiting, &QEventLoop::quit);
    waiting.exec(QEventLoop::ExcludeUserInputEvents); // nothing may change meanwhile
    if (!hasEnded) {
        const QPointer dialog = waitingDialog(sentence, window);
        QObject::connect(dialog, &QDialog::rejected, &waiting, [&stop] { stop.request_stop(); });
        dialog->show();
        waiting.exec(); // also ended by the end of the program
        delete dialog;
    }
    const bool isDone = hasEnded && !stop.stop_requested();
    stop.request_stop();
    return isDone;
}

} // namespace kriva::ui
