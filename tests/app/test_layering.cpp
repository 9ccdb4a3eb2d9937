// The folders' order: sim <- model <- view <- app, never upward; in a floor as the table of its README says.
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <vector>

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
    {"view/rendering/light", R"(^(epoxy|tbb)|^Q[A-Z])"},
    {"view/rendering/software", R"(^(epoxy|tbb)|^Q[A-Z])"},
    {"view/rendering/gl", R"(^(hwy|tbb)|^Q[A-Z])"},
    {"app", R"(^tests/)"},
};

const QStringList kFloorsWithRooms{QStringLiteral("sim"), QStringLiteral("model"), QStringLiteral("view"),
                                   QStringLiteral("app")};

/// A folder of a floor and the rooms of the same floor that its files may include.
struct Room
{
    QString name; ///< The folder below the floor's; may lie in another room's.
    QStringList uses;
};

/// The table of a floor's README.
std::vector<Room> roomsOf(const QString& floor)
{
    static const QRegularExpression row(QStringLiteral("^\\| `([\\w/]+)` \\| ([\\w/, ]*?) *\\| "),
                                        QRegularExpression::MultilineOption);
    QFile readme(test::sourcePath(u"") + floor + QStringLiteral("/README.md"));
    if (!readme.open(QIODevice::ReadOnly))
        return {};
    std::vector<Room> rooms;
    for (auto match = row.globalMatch(QString::fromUtf8(readme.readAll())); match.hasNext();) {
        const QRegularExpressionMatch found = match.next();
        rooms.push_back({found.captured(1), found.captured(2).split(QStringLiteral(", "), Qt::SkipEmptyParts)});
    }
    return rooms;
}

/// In which room a path below a floor lies: the one whose folder is the innermost. Empty: in the floor itself.
QString roomAt(const std::vector<Room>& rooms, const QString& path)
{
    QString innermost;
    for (const Room& room : rooms)
        if (path.startsWith(room.name + QLatin1Char('/')) && room.name.size() > innermost.size())
            innermost = room.name;
    return innermost;
}

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
        for (const QString& floor : kFloorsWithRooms)
            QTest::newRow(qPrintable(floor)) << floor;
    }

    /// So that there are no circles; and no row allows what nobody needs.
    void roomsUseOnlyThoseBeforeThem()
    {
        QFETCH(QString, floor);
        const std::vector<Room> rooms = roomsOf(floor);
        QVERIFY(rooms.size() > 4);
        QStringList before;
        QHash<QString, QStringList> unused;
        for (const Room& room : rooms) {
            for (const QString& one : room.uses)
                QVERIFY2(before.contains(one), qPrintable(one + QStringLiteral(" does not stand before ") + room.name));
            before += room.name;
            unused[room.name] = room.uses;
        }
        const QString root = test::sourcePath(u"") + floor + QLatin1Char('/');
        for (const QString& file : sourcesIn(floor)) {
            const QString from = roomAt(rooms, file.mid(root.size()));
            if (from.isEmpty())
                continue;
            const auto allowed = std::ranges::find(rooms, from, &Room::name)->uses;
            for (const QString& name : includesOf(file)) {
                const QString to =
                    name.startsWith(floor + QLatin1Char('/')) ? roomAt(rooms, name.mid(floor.size() + 1)) : QString();
                if (to.isEmpty() || to == from)
                    continue;
                QVERIFY2(allowed.contains(to), qPrintable(file + QStringLiteral(" includes ") + name));
                unused[from].removeAll(to);
            }
        }
        for (auto room = unused.cbegin(); room != unused.cend(); ++room)
            QVERIFY2(room->isEmpty(),
                     qPrintable(room.key() + QStringLiteral(" no longer uses ") + room->join(QLatin1Char(' '))));
    }

    void everyFolderIsARoom_data() { roomsUseOnlyThoseBeforeThem_data(); }

    /// No heap in a floor's root, no room that the table does not know.
    void everyFolderIsARoom()
    {
        QFETCH(QString, floor);
        const QDir folder(test::sourcePath(u"") + floor);
        QStringList heap = folder.entryList({QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files);
        heap.removeAll(QStringLiteral("main.cpp"));
        QCOMPARE(heap, QStringList());
        QStringList told;
        for (const Room& room : roomsOf(floor)) {
            QVERIFY2(!sourcesIn(floor + QLatin1Char('/') + room.name).isEmpty(), qPrintable(room.name));
            if (!room.name.contains(QLatin1Char('/')))
                told += room.name;
        }
        told.sort();
        QCOMPARE(told, folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name));
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
                    continue; // They define the same classes as a sibling; each system builds one of them.
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
        for (const QString& floor : kFloorsWithRooms) {
            for (const QString& path : sourcesIn(floor)) {
                QFile file(path);
                QVERIFY(file.open(QIODevice::ReadOnly));
                if (printing.match(QString::fromUtf8(file.readAll())).hasMatch())
                    found.append(file.fileName().mid(test::sourcePath(u"").size()));
            }
        }
        found.sort();
        // The console opens the streams and writes nothing; the launcher is a program of its own.
        QCOMPARE(found, (QStringList{QStringLiteral("app/cli/console.cpp"), QStringLiteral("app/cli/terminal.cpp"),
                                     QStringLiteral("app/importer/main.cpp"),
                                     QStringLiteral("app/importer/request_service.cpp"),
                                     QStringLiteral("app/launcher/main.cpp")}));
    }

    /// Others ask for its traits, so that another tool is its own file and a line.
    void noFileNamesAToolButItsOwn()
    {
        const QRegularExpression tool(QStringLiteral(R"(\bToolId::[A-Z]\w*)"));
        int own = 0;
        for (const QString& floor : kFloorsWithRooms) {
            for (const QString& path : sourcesIn(floor)) {
                QFile file(path);
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
