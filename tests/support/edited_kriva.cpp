// The editor with somebody at work in it, for end_signals_test: a process of its own, since it is to be killed.
//   edited_kriva HOW QUIET LONGEST [FILE...]     QUIET, LONGEST: milliseconds, see RecoveryTiming
// HOW is what is going on when it ends:
//   edit      the first point moves, again and again, each time as a step
//   drag      the same in a drag that never ends
//   dialog    the same behind the question before unsaved changes are lost
//   work      the same while long work runs in the background
//   busy      a change, then the thread of the window comes back from nothing any more
//   session   the session manager asks for what is unsaved: "kept" is printed once that is done, and work goes on
//   save      a change that is saved
//   look      nothing; what is offered for recovery is recovered
//   discard, later     the same, but discarded or left
// Each change prints a line: its number, which is the x of the first point, and the milliseconds since the first one.
// Once it is looked at, "window TITLE", "modified" or "saved", and x are printed, for each window.
#include "app/editor.h"
#include "tests/support/test_window.h"
#include "ui/window/dialogs/recovery_dialog.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QSessionManager>
#include <QThreadPool>

#include <cstdio>
#include <unistd.h>

namespace {

using namespace kriva;

constexpr int kPause = 20;         // ms between two changes
constexpr int kChangesBefore = 10; // until something else goes on as well

class Hand : public QObject {
  public:
    explicit Hand(QString how)
        : how_(std::move(how)) {
        connect(&clock_, &QTimer::timeout, this, &Hand::act);
        clock_.start(kPause);
    }

  private:
    [[nodiscard]] static QList<ui::MainWindow*> windows() {
        QList<ui::MainWindow*> found;
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* window = qobject_cast<ui::MainWindow*>(widget); window && window->isVisible())
                found.append(window);
        return found;
    }

    void act() {
        if (answer() || windows().isEmpty())
            return;
        if (isLooking())
            return look();
        change(*windows().front());
        if (how_ == QLatin1String("save")) {
            clock_.stop();
            windows().front()->session().save();
            print("saved");
        }
        if (++changes_ == kChangesBefore)
            // From a turn of its own: a clock does not go on in a loop that it has called itself.
            QTimer::singleShot(0, this, [this] { begin(*windows().front()); });
    }

    [[nodiscard]] bool isLooking() const {
        return how_ == QLatin1String("look") || how_ == QLatin1String("discard") || how_ == QLatin1String("later");
    }

    /// What is offered at the start.
    bool answer() {
        auto* dialog = qobject_cast<ui::RecoveryDialog*>(QApplication::activeModalWidget());
        if (!dialog)
            return false;
        const auto wanted = how_ == QLatin1String("discard") ? ui::RecoveryChoice::Discard
                            : how_ == QLatin1String("later") ? ui::RecoveryChoice::Later
                                                             : ui::RecoveryChoice::Recover;
        for (auto* choice : dialog->findChildren<QComboBox*>())
            choice->setCurrentIndex(choice->findData(static_cast<int>(wanted)));
        print("asked");
        dialog->accept();
        return true;
    }

    void look() {
        clock_.stop();
        for (ui::MainWindow* window : windows()) {
            print("window " + window->windowTitle().toStdString());
            print(window->isWindowModified() ? "modified" : "saved");
            const auto& curves = window->document().sheet(test::kElevation).curves;
            print(QString::number(curves.empty() ? 0 : pointAt(curves[0], 0).x).toStdString());
        }
        print("looked");
    }

    void change(ui::MainWindow& window) {
        if (!sinceFirst_.isValid())
            sinceFirst_.start();
        ++x_;
        ui::OpenDocument& document = window.document();
        const Serial serial = document.serials(test::kElevation).at(0);
        const Curve& curve = *document.find(0, serial);
        Curve moved = withGripsMoved(curve, std::array{grips(curve).at(0).id}, {x_ - pointAt(curve, 0).x, 0});
        if (document.hasGesture())
            document.preview(std::move(moved));
        else
            document.change(0, serial, std::move(moved), {"Move point %1", 0});
        print(QStringLiteral("%1 %2").arg(x_).arg(sinceFirst_.elapsed()).toStdString());
    }

    void begin(ui::MainWindow& window) {
        if (how_ == QLatin1String("drag")) {
            window.document().setActiveSheet(test::kElevation);
            QWidget* canvas = window.tab(test::kElevation).canvas().viewport();
            const QPoint at = test::pixelOf(window.tab(test::kElevation), 1);
            QTest::mousePress(canvas, Qt::LeftButton, {}, at);
            QTest::mouseMove(canvas, at + QPoint(20, 20));
            print(window.document().hasGesture() ? "begun" : "no drag");
        } else if (how_ == QLatin1String("work")) {
            for (int i = 0; i < QThread::idealThreadCount(); ++i)
                QThreadPool::globalInstance()->start([] { ::sleep(3600); });
            print("begun");
        } else if (how_ == QLatin1String("session")) {
            Q_EMIT qApp->commitDataRequest(*qApp->findChild<QSessionManager*>());
            print("kept");
        } else if (how_ == QLatin1String("busy")) {
            print("begun");
            for (;;)
                ::sleep(3600); // a signal wakes it up
        } else if (how_ == QLatin1String("dialog")) {
            QTimer::singleShot(0, &window, [] { print("begun"); });
            std::ignore = window.session().mayClose(); // and the clock goes on behind it
        } else {
            print("begun");
        }
    }

    static void print(const std::string& line) {
        std::fputs((line + '\n').c_str(), stdout);
        std::fflush(stdout);
    }

    using Serial = ui::Serial;
    QString how_;
    QTimer clock_;
    QElapsedTimer sinceFirst_;
    int x_ = 100;
    int changes_ = 0;
};

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 4)
        return 2;
    const Hand hand(arguments[1]);
    return runEditor(
        {arguments.sliced(4),
         ui::Language::English,
         {std::chrono::milliseconds(arguments[2].toInt()), std::chrono::milliseconds(arguments[3].toInt())}});
}
