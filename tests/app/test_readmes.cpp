// What the floors' READMEs tell of how to add something is where it is done.
#include "app/cli/command.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QtTest>

using namespace hairpaint;

namespace {

const QStringList kFloors{QStringLiteral("sim"), QStringLiteral("model"), QStringLiteral("view"),
                          QStringLiteral("app")};

QString textOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString underSource(const QString& path)
{
    return test::sourcePath(u"") + path;
}

/// What stands between backticks.
QStringList quoted(const QString& text)
{
    static const QRegularExpression quote(QStringLiteral("`([^`]+)`"));
    QStringList found;
    for (auto match = quote.globalMatch(text); match.hasNext();)
        found += match.next().captured(1);
    return found;
}

/// The files of the four floors, and of `more`, that hold one of the names as a word.
QStringList filesNaming(const QStringList& names, const QStringList& more = {})
{
    QStringList escaped;
    for (const QString& name : names)
        escaped += QRegularExpression::escape(name);
    const QRegularExpression any(QStringLiteral("\\b(?:%1)\\b").arg(escaped.join(QLatin1Char('|'))));
    QStringList files;
    for (const QString& folder : kFloors + more) {
        QDirIterator walk(underSource(folder),
                          {QStringLiteral("*.h"), QStringLiteral("*.cpp"), QStringLiteral("order.txt")}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            const QString path = walk.next();
            if (textOf(path).contains(any))
                files += path.mid(underSource(QString()).size());
        }
    }
    files.sort();
    return files;
}

struct HowTo
{
    QString names;       ///< The line that begins the list.
    QStringList folders; ///< Besides the floors.
    QStringList paths;
};

/// Lists that follow a line "Where `Name` and `Other` are named:" or "... are named, in `folder` too:".
QList<HowTo> howTosIn(const QString& readme)
{
    static const QRegularExpression list(QStringLiteral(
        R"((Where `[^\n]*(?:is|are) named)(?:, in `([^`]+)` too)?:\n\n((?:- [^\n]*\n(?:  [^\n]*\n)*)+))"));
    static const QRegularExpression item(QStringLiteral("^- `([^`]+)`"), QRegularExpression::MultilineOption);
    QList<HowTo> all;
    for (auto match = list.globalMatch(readme); match.hasNext();) {
        const QRegularExpressionMatch found = match.next();
        HowTo one{.names = found.captured(1), .folders = {}, .paths = {}};
        if (!found.captured(2).isEmpty())
            one.folders += found.captured(2);
        for (auto path = item.globalMatch(found.captured(3)); path.hasNext();)
            one.paths += path.next().captured(1);
        one.paths.sort();
        all += one;
    }
    return all;
}

} // namespace

class TestReadmes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsToBeTouchedIsListed()
    {
        int lists = 0;
        for (const QString& floor : kFloors) {
            for (const HowTo& howTo : howTosIn(textOf(underSource(floor + QStringLiteral("/README.md"))))) {
                ++lists;
                QVERIFY(!howTo.paths.isEmpty());
                const QStringList named = filesNaming(quoted(howTo.names), howTo.folders);
                QVERIFY2(named == howTo.paths,
                         qPrintable(howTo.names + QStringLiteral("\n  in the sources: ") +
                                    named.join(QLatin1Char(' ')) + QStringLiteral("\n  in the README: ") +
                                    howTo.paths.join(QLatin1Char(' '))));
            }
        }
        QVERIFY(lists >= 13);
    }

    void whatNoSourceNamesIsNamedInNone()
    {
        static const QRegularExpression claim(QStringLiteral("No source names `([^`]+)`"));
        int claims = 0;
        for (const QString& floor : kFloors) {
            const QString readme = textOf(underSource(floor + QStringLiteral("/README.md")));
            for (auto match = claim.globalMatch(readme); match.hasNext(); ++claims)
                QCOMPARE(filesNaming({match.next().captured(1)}), QStringList());
        }
        QVERIFY(claims > 0);
    }

    /// Paths with a folder of the tree, be they files, files without their ending, or folders.
    void whatIsNamedIsThere_data()
    {
        QTest::addColumn<QString>("readme");
        QTest::newRow("root") << QStringLiteral("README.md");
        QTest::newRow("packaging") << QStringLiteral("resources/packaging/README.md");
        for (const QString& floor : kFloors + QStringList{QStringLiteral("tests")})
            QTest::newRow(qPrintable(floor)) << floor + QStringLiteral("/README.md");
    }

    void whatIsNamedIsThere()
    {
        QFETCH(QString, readme);
        const QString text = textOf(underSource(readme));
        QVERIFY(!text.isEmpty());
        const QString folder = QFileInfo(readme).path();
        static const QRegularExpression path(
            QStringLiteral("^(?:sim|model|view|app|tests|resources|translations)/[\\w/.-]+$"));
        static const QRegularExpression link(QStringLiteral("\\]\\(([^)#:]+)\\)"));
        const auto isThere = [](const QString& wanted) {
            return QFileInfo::exists(underSource(wanted)) ||
                   QFileInfo::exists(underSource(wanted + QStringLiteral(".h"))) ||
                   QFileInfo::exists(underSource(wanted + QStringLiteral(".cpp")));
        };
        for (const QString& name : quoted(text))
            if (path.match(name).hasMatch())
                QVERIFY2(isThere(name), qPrintable(name));
        for (auto match = link.globalMatch(text); match.hasNext();) {
            const QString target = match.next().captured(1);
            QVERIFY2(isThere(folder + QLatin1Char('/') + target), qPrintable(target));
        }
    }

    void theSynopsisIsTheProgramsOwn()
    {
        const QString readme = textOf(underSource(QStringLiteral("app/README.md"))).simplified();
        for (const app::Command& command : app::commands())
            QVERIFY2(readme.contains(usageOf(command)), qPrintable(usageOf(command)));
    }
};

HAIRPAINT_TEST(TestReadmes, None)
#include "test_readmes.moc"
