#include "tests/support/long_run.h"
#include "tests/support/sheet_curves.h"
#include "ui/document/document_file.h"
#include "ui/document/recovery/found_recoveries.h"
#include "ui/document/sharing/open_files.h"

#include <gtest/gtest.h>
#include <QDir>
#include <QElapsedTimer>
#include <QLockFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>

#include <csignal>
#include <map>
#include <memory>
#include <random>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

constexpr int kLongestEnding = 120'000; // ms until what does not come is a failure
constexpr int kPromise = 10'000;        // ms of work that may be lost

/// The editor with somebody at work in it, see edited_kriva.cpp, in a home of its own.
class EditedKriva {
  public:
    explicit EditedKriva(const QTemporaryDir& home)
        : home_(home.path()) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"})
            environment.insert(QString::fromLatin1(name), home_);
        process_.setProcessEnvironment(environment);
    }
    ~EditedKriva() {
        process_.kill();
        process_.waitForFinished();
    }
    Q_DISABLE_COPY_MOVE(EditedKriva)

    void start(const QString& how, const QStringList& files = {}, int quiet = 1'000, int longest = 5'000) {
        process_.start(QStringLiteral(KRIVA_EDITED),
                       QStringList{how, QString::number(quiet), QString::number(longest)} + files);
    }
    /// Reads on until it prints this line.
    bool waitFor(const QByteArray& line) {
        while (!lines_.contains(line)) {
            if (!process_.canReadLine() && !process_.waitForReadyRead(kLongestEnding))
                return false;
            takeLines();
        }
        return true;
    }
    void end(int signal) {
        ::kill(static_cast<pid_t>(process_.processId()), signal);
        EXPECT_TRUE(process_.waitForFinished(kLongestEnding)) << "it goes on";
        takeLines();
    }
    void takeLines() {
        while (process_.canReadLine())
            lines_.append(process_.readLine().trimmed());
    }
    [[nodiscard]] bool endedByItself(int code) const {
        return process_.exitStatus() == QProcess::NormalExit && process_.exitCode() == code;
    }
    [[nodiscard]] const QByteArrayList& lines() const { return lines_; }
    /// Milliseconds since the first change, by the number of the change.
    [[nodiscard]] std::map<int, int> changes() const {
        std::map<int, int> found;
        for (const QByteArray& line : lines_)
            if (const QByteArrayList words = line.split(' '); words.size() == 2 && words[0].toInt() > 0)
                found[words[0].toInt()] = words[1].toInt();
        return found;
    }
    /// The number of the last change before a line; 0 without one.
    [[nodiscard]] int lastChangeBefore(const QByteArray& line) const {
        int last = 0;
        for (auto i = lines_.begin(); i != lines_.end() && *i != line; ++i)
            last = std::max(last, i->split(' ').at(0).toInt());
        return last;
    }
    [[nodiscard]] std::vector<FoundRecovery> found() const { return takeRecoveries(home_ + u"/kriva/recovery"_s); }
    [[nodiscard]] bool hasLeftSomething() const {
        return !QDir(home_ + u"/kriva/recovery"_s).entryList({u"*.kriva"_s}).isEmpty();
    }

  private:
    QString home_;
    QProcess process_;
    QByteArrayList lines_;
};

/// The number of the change after which it is so; nothing where it cannot be read.
std::optional<int> changeOf(const FoundRecovery& found) {
    const auto loaded = documentFrom(readRecovery(found));
    const LoadedFile* file = std::get_if<LoadedFile>(&loaded);
    if (!file || found.state != RecoveryState::Whole)
        return {};
    return qRound(pointAt(file->document.sheets[test::kElevation].curves.at(0), 0).x);
}

/// Kills it and looks at what is left.
void expectYoungEnough(EditedKriva& kriva, const char* what) {
    kriva.end(SIGKILL);
    const std::map<int, int> changes = kriva.changes();
    ASSERT_FALSE(changes.empty());
    const int last = changes.rbegin()->second;
    const auto found = kriva.found();
    ASSERT_LE(found.size(), 1U);
    if (found.empty()) {
        EXPECT_LE(last, kPromise) << what << ": nothing is left";
        return;
    }
    const std::optional<int> change = changeOf(found[0]);
    ASSERT_NE(change, std::nullopt) << what;
    const auto firstLost = changes.find(*change + 1);
    if (firstLost != changes.end()) {
        EXPECT_LE(last - firstLost->second, kPromise) << what;
    }
    EXPECT_GE(*change, changes.begin()->first) << what;
}

TEST(Ending, aKillAtAnyMomentLosesTenSecondsAtMost) {
    const int kills = test::isLongRun() ? 50 : 6;
    constexpr int kAtOnce = 10; // each mostly waits
    std::mt19937 random(20260202);
    for (int done = 0; done < kills;) {
        std::vector<std::unique_ptr<QTemporaryDir>> homes;
        std::vector<std::unique_ptr<EditedKriva>> programs;
        std::multimap<int, EditedKriva*> moments; // ms after the start of the last one
        for (int i = 0; i < kAtOnce && done < kills; ++i, ++done) {
            homes.push_back(std::make_unique<QTemporaryDir>());
            programs.push_back(std::make_unique<EditedKriva>(*homes.back()));
            test::isLongRun() ? programs.back()->start(u"edit"_s) : programs.back()->start(u"edit"_s, {}, 20, 100);
            moments.emplace(static_cast<int>(random() % (test::isLongRun() ? 14'000 : 1'000)), programs.back().get());
        }
        for (const auto& program : programs)
            ASSERT_TRUE(program->waitFor("begun"));
        QElapsedTimer clock;
        clock.start();
        for (const auto& [moment, program] : moments) {
            QThread::msleep(static_cast<unsigned long>(std::max<qint64>(0, moment - clock.elapsed())));
            expectYoungEnough(*program, qPrintable(u"killed %1 ms after it had begun"_s.arg(moment)));
        }
    }
}

TEST(Ending, aKillWithAnOldStateOnTheDiskLeavesThatOne) {
    const QTemporaryDir home;
    EditedKriva kriva(home);
    kriva.start(u"edit"_s, {}, 1, 1);
    ASSERT_TRUE(kriva.waitFor("begun"));
    while (!kriva.hasLeftSomething())
        QThread::yieldCurrentThread();
    kriva.end(SIGKILL);
    const auto found = kriva.found();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(changeOf(found[0]), std::nullopt);
}

struct EndCase {
    int signal;
    const char* how;
};

class EndedBy : public testing::TestWithParam<EndCase> {};

TEST_P(EndedBy, keepsTheLastChangeAndAsksNothing) {
    const QTemporaryDir home;
    EditedKriva kriva(home);
    // Nothing is written before the signal comes; and the exit code is another one where it does not end in time.
    kriva.start(QString::fromLatin1(GetParam().how), {}, 3'600'000, 3'600'000);
    ASSERT_TRUE(kriva.waitFor("begun"));
    kriva.end(GetParam().signal);
    EXPECT_TRUE(kriva.endedByItself(0));
    const auto found = kriva.found();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_GE(changeOf(found[0]).value_or(0), kriva.changes().rbegin()->first);
}

INSTANTIATE_TEST_SUITE_P(While, EndedBy,
                         testing::Values(EndCase{SIGTERM, "edit"}, EndCase{SIGTERM, "drag"}, EndCase{SIGTERM, "dialog"},
                                         EndCase{SIGTERM, "work"}, EndCase{SIGINT, "edit"}, EndCase{SIGINT, "dialog"},
                                         EndCase{SIGHUP, "edit"}, EndCase{SIGHUP, "drag"}),
                         [](const auto& tested) {
                             const char* signal = tested.param.signal == SIGTERM  ? "Sigterm"
                                                  : tested.param.signal == SIGINT ? "Sigint"
                                                                                  : "Sighup";
                             return std::string(signal) + "_" + tested.param.how;
                         });

TEST(Ending, theSessionManagerFindsAllWorkOnTheDiskAndNobodyIsAsked) {
    const QTemporaryDir home;
    EditedKriva kriva(home);
    kriva.start(u"session"_s, {}, 3'600'000, 3'600'000);
    ASSERT_TRUE(kriva.waitFor("kept"));
    kriva.end(SIGKILL);
    const int change = kriva.lastChangeBefore("kept"); // more may have come behind it
    EXPECT_GT(change, 0);
    const auto found = kriva.found();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_GE(changeOf(found[0]).value_or(0), change);
}

TEST(Ending, aWindowThatIsBusyForEverEndsInTimeAllTheSame) {
    const QTemporaryDir home;
    EditedKriva kriva(home);
    kriva.start(u"busy"_s);
    ASSERT_TRUE(kriva.waitFor("begun"));
    kriva.end(SIGTERM);
    EXPECT_TRUE(kriva.endedByItself(1));
}

TEST(Ending, whatIsSavedLeavesNothing) {
    const QTemporaryDir home;
    const QString path = home.filePath(u"arch.kriva"_s);
    Document document;
    document.sheets[test::kElevation].curves = {
        withPointsAdded(emptyCurve(test::kElevation), Points{{0, 0}, {1, 2}, {3, 0}})};
    ASSERT_EQ(saveDocument(path, document), std::nullopt);
    EditedKriva kriva(home);
    kriva.start(u"save"_s, {path}, 1, 1);
    ASSERT_TRUE(kriva.waitFor("saved"));
    kriva.end(SIGTERM);
    EXPECT_TRUE(kriva.endedByItself(0));
    EXPECT_TRUE(kriva.found().empty());
    EXPECT_EQ(pointAt(std::get<LoadedFile>(loadDocument(path)).document.sheets[test::kElevation].curves[0], 0).x, 101);
}

/// A program that was killed while a document of a file was changed, and those after it.
class NextStart : public testing::Test {
  protected:
    NextStart() {
        Document document;
        document.sheets[test::kElevation].curves = {
            withPointsAdded(emptyCurve(test::kElevation), Points{{0, 0}, {1, 2}, {3, 0}})};
        EXPECT_EQ(saveDocument(path, document), std::nullopt);
        before = boundedRead(path);
        EditedKriva kriva(home);
        kriva.start(u"edit"_s, {path}, 1, 1);
        EXPECT_TRUE(kriva.waitFor("begun"));
        kriva.end(SIGTERM);
        change = kriva.changes().rbegin()->first;
    }
    [[nodiscard]] bool isUntouched() const { return boundedRead(path) == before; }

    const QTemporaryDir home;
    const QString path = home.filePath(u"arch.kriva"_s);
    std::variant<QByteArray, ReadError> before;
    int change = 0;
};

TEST_F(NextStart, recoversItAsModifiedUnderItsName) {
    EditedKriva kriva(home);
    kriva.start(u"look"_s, {path});
    ASSERT_TRUE(kriva.waitFor("looked"));
    EXPECT_EQ(kriva.lines().mid(0, 3), (QByteArrayList{"asked", "window arch.kriva[*] – Kriva", "modified"}));
    EXPECT_GE(kriva.lines().value(3).toInt(), change);
    EXPECT_EQ(kriva.lines().size(), 5) << "the file that is asked for is open in the one window";
    EXPECT_TRUE(isUntouched());
    kriva.end(SIGKILL);
    EXPECT_EQ(kriva.found().size(), 1U) << "it is still unsaved";
}

TEST_F(NextStart, discardsItOrAsksAgain) {
    for (const char* how : {"later", "discard"}) {
        EditedKriva kriva(home);
        kriva.start(QString::fromLatin1(how), {path});
        ASSERT_TRUE(kriva.waitFor("looked"));
        EXPECT_EQ(kriva.lines(), (QByteArrayList{"asked", "window arch.kriva[*] – Kriva", "saved", "0", "looked"}));
        EXPECT_TRUE(isUntouched());
        kriva.end(SIGTERM);
    }
    EditedKriva kriva(home);
    kriva.start(u"look"_s, {path});
    ASSERT_TRUE(kriva.waitFor("looked"));
    EXPECT_FALSE(kriva.lines().contains("asked"));
}

TEST_F(NextStart, twoProgramsNeverTakeTheSame) {
    EditedKriva first(home);
    first.start(u"look"_s);
    ASSERT_TRUE(first.waitFor("looked"));
    EditedKriva second(home);
    second.start(u"look"_s);
    ASSERT_TRUE(second.waitFor("looked"));
    EXPECT_TRUE(first.lines().contains("asked"));
    EXPECT_FALSE(second.lines().contains("asked"));
}

TEST_F(NextStart, aFileIsLockedAsLongAsAProgramHasItOpen) {
    const QByteArray stateBefore = qgetenv("XDG_STATE_HOME");
    qputenv("XDG_STATE_HOME", home.path().toUtf8());
    EditedKriva kriva(home);
    kriva.start(u"discard"_s, {path});
    EXPECT_TRUE(kriva.waitFor("looked"));
    OpenFiles files;
    EXPECT_TRUE(std::holds_alternative<OpenFiles::HeldElsewhere>(files.claim(path, &files)));
    kriva.end(SIGKILL);
    EXPECT_FALSE(std::holds_alternative<OpenFiles::HeldElsewhere>(files.claim(path, &files)));
    qputenv("XDG_STATE_HOME", stateBefore);
}

} // namespace
} // namespace kriva::ui
