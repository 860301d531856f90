#include <QApplication>
#include <QMainWindow>

// The least that any Qt program does before a person sees its window; start.py measures Kriva against it.
int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    QMainWindow window;
    window.resize(1200, 760);
    window.show();
    return QApplication::exec();
}
