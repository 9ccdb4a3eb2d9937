// The folders' order: sim <- model <- view <- app, never upward.
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QRegularExpression>
#include <QtTest>

using namespace hairpaint;

namespace {

struct Layer
{
    const char* folder;
    const char* forbidden; ///< Regular expression over what an include names.
};

constexpr Layer kLayers[] = {
    {"sim", R"(^(model|view|app|tests|resources)/|^Q[A-Z]|^(zip|epoxy|OpenImageIO|assimp))"},
    {"model",
     R"(^(view|app|tests)/|^(QWidget|QApplication|QMessageBox|QDialog|QOpenGL|OpenImageIO|assimp|epoxy|hwy|tbb))"},
    {"view", R"(^(app|tests)/|^(OpenImageIO|assimp|zip|tbb))"},
    {"view/rendering", R"(^(model|app|tests)/|^Q[A-Z])"},
    // Our own renderer and its formulas; OpenGL.
    {"view/rendering/light", R"(^(epoxy|tbb)|^view/(?!rendering/(light|software/strand_block))|^Q[A-Z])"},
    {"view/rendering/software", R"(^(epoxy|tbb)|^view/rendering/gl/|^Q[A-Z])"},
    {"view/rendering/gl", R"(^(hwy|tbb)|^view/rendering/(software|light)/|^Q[A-Z])"},
    {"app", R"(^tests/)"},
};

/// A folder of a floor and the rooms of the same floor that its files may include. They stand before it, so that there
/// are no circles.
struct Room
{
    const char* floor;
    const char* name;
    const char* uses;
};

constexpr Room kRooms[] = {
    {"sim", "base", ""},
    {"sim", "skin", "base"},
    {"sim", "groom", "base skin"},
    {"sim", "solver", "base skin groom"},
    {"sim", "motion", "base skin groom solver"},

    {"model", "values", ""},
    {"model", "bodies", ""},
    {"model", "project", "values bodies"},
    {"model", "disk", "values"},
    {"model", "maps", "values project"},
    {"model", "patches", "project maps"},
    {"model", "heads", "values"},
    {"model", "styles", "values project maps"},
    {"model", "document", "values project maps patches styles"},
    {"model", "tools", "values project maps document"},
    {"model", "handles", "values project maps styles document tools"},
    {"model", "files", "values project disk maps heads styles"},
    {"model", "growth", "values project maps heads styles files"},
    {"model", "journal", "values project disk document files"},
    {"model", "repair", "values project files"},
    {"model", "exporting", "values project disk heads files"},
    {"model", "importing", "values project files"},

    {"view", "rendering", ""},
    {"view", "picking", "rendering"},
    {"view", "look", ""},
    {"view", "editing", "look"},
    {"view", "widgets", "look editing"},
    {"view", "paint_area", "look editing"},
    {"view", "head_area", "rendering picking look editing"},
    {"view", "panels", "look editing widgets"},
    {"view", "dialogs", "rendering look editing widgets paint_area head_area"},

    {"app", "importer", ""},
    {"app", "launcher", ""},
    {"app", "background", ""},
    {"app", "settings", "background"},
    {"app", "session", "background"},
    {"app", "headless", ""},
    {"app", "styles", "background session headless"},
    {"app", "recovery", "background styles"},
    {"app", "project", "background settings session styles recovery"},
    {"app", "exchange", "background settings session headless styles project"},
    {"app", "window", "background settings session headless styles recovery project exchange"},
    {"app", "cli", "background session headless styles"},
};

/// Every include of a file, as it is written.
QStringList includesOf(const QString& path)
{
    static const QRegularExpression include(QLatin1String(R"(^\s*#\s*include\s*[<\x22]([^>\x22]+)[>\x22])"),
                                            QRegularExpression::MultilineOption);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QStringList names;
    auto match = include.globalMatch(QString::fromUtf8(file.readAll()));
    while (match.hasNext())
        names += match.next().captured(1);
    return names;
}

QStringList sourcesIn(const QString& folder)
{
    QStringList files;
    QDirIterator walk(test::sourcePath(u"") + folder, {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                      QDirIterator::Subdirectories);
    while (walk.hasNext())
        files += walk.next();
    return files;
}

} // namespace

class TestLayering : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void noIncludeGoesUpward_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<QString>("forbidden");
        for (const Layer& layer : kLayers)
            QTest::newRow(layer.folder) << QString::fromLatin1(layer.folder) << QString::fromLatin1(layer.forbidden);
    }

    void noIncludeGoesUpward()
    {
        QFETCH(QString, folder);
        QFETCH(QString, forbidden);
        const QRegularExpression bad(forbidden);
        const QStringList files = sourcesIn(folder);
        QVERIFY(files.size() > 3);
        for (const QString& file : files)
            for (const QString& name : includesOf(file))
                QVERIFY2(!bad.match(name).hasMatch(), qPrintable(file + QStringLiteral(" includes ") + name));
    }

    void roomsUseOnlyThoseBeforeThem_data()
    {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<QString>("room");
        QTest::addColumn<QString>("uses");
        for (const Room& room : kRooms)
            QTest::addRow("%s/%s", room.floor, room.name)
                << QString::fromLatin1(room.floor) << QString::fromLatin1(room.name) << QString::fromLatin1(room.uses);
    }

    void roomsUseOnlyThoseBeforeThem()
    {
        QFETCH(QString, floor);
        QFETCH(QString, room);
        QFETCH(QString, uses);
        QStringList before;
        for (const Room& other : kRooms) {
            if (floor == QLatin1StringView(other.floor)) {
                if (room == QLatin1StringView(other.name))
                    break;
                before += QString::fromLatin1(other.name);
            }
        }
        const QStringList allowed = uses.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        QStringList unused = allowed;
        for (const QString& one : allowed)
            QVERIFY2(before.contains(one), qPrintable(one + QStringLiteral(" does not stand before ") + room));
        const QStringList files = sourcesIn(floor + QLatin1Char('/') + room);
        QVERIFY(!files.isEmpty());
        for (const QString& file : files) {
            for (const QString& name : includesOf(file)) {
                const QStringList parts = name.split(QLatin1Char('/'));
                if (parts.size() < 3 || parts[0] != floor || parts[1] == room)
                    continue;
                QVERIFY2(allowed.contains(parts[1]), qPrintable(file + QStringLiteral(" includes ") + name));
                unused.removeAll(parts[1]);
            }
        }
        QVERIFY2(unused.isEmpty(), qPrintable(QStringLiteral("no longer used: ") + unused.join(QLatin1Char(' '))));
    }

    /// No heap in a floor's root, no room that the table does not know.
    void everyFolderIsARoom()
    {
        QHash<QString, QStringList> rooms;
        for (const Room& room : kRooms)
            rooms[QString::fromLatin1(room.floor)] += QString::fromLatin1(room.name);
        for (auto floor = rooms.begin(); floor != rooms.end(); ++floor) {
            const QDir folder(test::sourcePath(u"") + floor.key());
            QStringList heap = folder.entryList({QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files);
            heap.removeAll(QStringLiteral("main.cpp"));
            QCOMPARE(heap, QStringList());
            QStringList found = folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
            floor->sort();
            QCOMPARE(found, *floor);
        }
    }

    /// A class that has grown too large is divided into classes, not into files.
    void noClassIsSlicedOverFiles()
    {
        const QRegularExpression member(QStringLiteral("^(?:[A-Za-z_][\\w:<>,&* ]*[ &*])?([A-Z]\\w*)::~?\\w+\\("),
                                        QRegularExpression::MultilineOption);
        QHash<QString, QString> fileOf;
        for (const char* folder : {"app", "model", "view", "sim"}) {
            QDirIterator walk(test::sourcePath(u"") + QLatin1String(folder), {QStringLiteral("*.cpp")}, QDir::Files,
                              QDirIterator::Subdirectories);
            while (walk.hasNext()) {
                QFile file(walk.next());
                if (file.fileName().endsWith(QLatin1String("_wgl.cpp")) ||
                    file.fileName().endsWith(QLatin1String("_windows.cpp")) ||
                    file.fileName().endsWith(QLatin1String("_portable.cpp")))
                    continue; // Of two guarded files one is built.
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QString room = QFileInfo(file).path() + QLatin1Char('/');
                auto match = member.globalMatch(QString::fromUtf8(file.readAll()));
                while (match.hasNext()) {
                    const QString type = match.next().captured(1);
                    const QString before = fileOf.value(room + type, file.fileName());
                    QVERIFY2(
                        before == file.fileName(),
                        qPrintable(QStringLiteral("%1 is defined in %2 and in %3").arg(type, before, file.fileName())));
                    fileOf.insert(room + type, file.fileName());
                }
            }
        }
        QVERIFY(fileOf.size() > 100);
    }

    /// What is printed goes through one function, which knows what a terminal would obey (the helper's standard output
    /// and error are no terminal's).
    void oneFileAloneWritesToStandardOutputAndError()
    {
        const QRegularExpression printing(QStringLiteral(
            R"(\b((stdout|stderr|STD(OUT|ERR)_FILENO|std::(cout|cerr|clog)|QTextStream)\b|(v?f?printf|f?puts|f?putc|putchar|perror)\())"));
        QStringList found;
        for (const char* folder : {"app", "model", "view", "sim"}) {
            QDirIterator walk(test::sourcePath(u"") + QLatin1String(folder),
                              {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                              QDirIterator::Subdirectories);
            while (walk.hasNext()) {
                QFile file(walk.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                if (printing.match(QString::fromUtf8(file.readAll())).hasMatch())
                    found.append(file.fileName().mid(test::sourcePath(u"").size()));
            }
        }
        found.sort();
        // The console opens the streams and writes nothing.
        QCOMPARE(found, (QStringList{QStringLiteral("app/cli/console.cpp"), QStringLiteral("app/cli/terminal.cpp"),
                                     QStringLiteral("app/importer/main.cpp"),
                                     QStringLiteral("app/importer/request_service.cpp")}));
    }

    /// Others ask for its traits, so that another tool is its own file and a line.
    void noFileNamesAToolButItsOwn()
    {
        const QRegularExpression tool(QStringLiteral(R"(\bToolId::[A-Z]\w*)"));
        int own = 0;
        for (const char* folder : {"app", "model", "view", "sim"}) {
            QDirIterator walk(test::sourcePath(u"") + QLatin1String(folder),
                              {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                              QDirIterator::Subdirectories);
            while (walk.hasNext()) {
                QFile file(walk.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QRegularExpressionMatch named = tool.match(QString::fromUtf8(file.readAll()));
                if (!named.hasMatch())
                    continue;
                ++own;
                QVERIFY2(file.fileName().endsWith(QLatin1String("_tool.cpp")) &&
                             file.fileName().contains(QLatin1String("/model/tools/")),
                         qPrintable(file.fileName() + QLatin1Char(' ') + named.captured()));
            }
        }
        QCOMPARE(own, 11); // The eraser is in the brush's.
    }

    void noFileIsOverlong()
    {
        for (const char* folder : {"app", "model", "view", "sim", "tests", "resources"}) {
            QDirIterator walk(test::sourcePath(u"") + QLatin1String(folder),
                              {QStringLiteral("*.h"), QStringLiteral("*.cpp"), QStringLiteral("*.comp"),
                               QStringLiteral("*.vert"), QStringLiteral("*.frag"), QStringLiteral("*.glsl")},
                              QDir::Files, QDirIterator::Subdirectories);
            while (walk.hasNext()) {
                QFile file(walk.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const qsizetype lines = file.readAll().count('\n');
                QVERIFY2(lines <= 500, qPrintable(QStringLiteral("%1 has %2 lines").arg(file.fileName()).arg(lines)));
            }
        }
    }
};

HAIRPAINT_TEST(TestLayering, None)
#include "test_layering.moc"
