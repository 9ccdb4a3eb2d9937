// The folders' order: sim <- model <- view <- app, never upward.
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QRegularExpression>
#include <QtTest>

namespace {

struct Layer
{
    const char* folder;
    const char* forbidden; ///< Regular expression over what an include names.
};

constexpr Layer kLayers[] = {
    {"sim", R"(^(model|view|app|tests|resources)/|^Q[A-Z]|^(zip|epoxy|OpenImageIO|assimp))"},
    // Rooms of sim, each using only those before it.
    {"sim/base", R"(^sim/(?!base/))"},
    {"sim/skin", R"(^sim/(?!(base|skin)/))"},
    {"sim/groom", R"(^sim/(?!(base|skin|groom)/))"},
    {"sim/solver", R"(^sim/(?!(base|skin|groom|solver)/))"},
    {"sim/motion", R"(^sim/(?!(base|skin|groom|solver|motion)/))"},
    {"model",
     R"(^(view|app|tests)/|^(QWidget|QApplication|QMessageBox|QDialog|QOpenGL|OpenImageIO|assimp|epoxy|hwy|tbb))"},
    {"view", R"(^(app|tests)/|^(OpenImageIO|assimp|zip|tbb))"},
    {"view/rendering", R"(^(model|app|tests)/|^view/(?!rendering/)|^Q[A-Z])"},
    // Our own renderer and its formulas; OpenGL.
    {"view/rendering/light", R"(^(epoxy|tbb)|^view/(?!rendering/(light|software/strand_block))|^Q[A-Z])"},
    {"view/rendering/software", R"(^(epoxy|tbb)|^view/rendering/gl/|^Q[A-Z])"},
    {"view/rendering/gl", R"(^(hwy|tbb)|^view/rendering/(software|light)/|^Q[A-Z])"},
    {"app", R"(^tests/)"},
};

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
        const QRegularExpression include(QLatin1String(R"(^\s*#\s*include\s*[<\x22]([^>\x22]+)[>\x22])"),
                                         QRegularExpression::MultilineOption);
        const QRegularExpression bad(forbidden);
        int files = 0;
        QDirIterator walk(QStringLiteral(HAIRPAINT_SOURCE_DIR "/") + folder,
                          {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            QFile file(walk.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            ++files;
            auto match = include.globalMatch(QString::fromUtf8(file.readAll()));
            while (match.hasNext()) {
                const QString name = match.next().captured(1);
                QVERIFY2(!bad.match(name).hasMatch(),
                         qPrintable(file.fileName() + QStringLiteral(" includes ") + name));
            }
        }
        QVERIFY(files > 3);
    }

    /// A class that has grown too large is divided into classes, not into files.
    void noClassIsSlicedOverFiles()
    {
        const QRegularExpression member(QStringLiteral("^(?:[A-Za-z_][\\w:<>,&* ]*[ &*])?([A-Z]\\w*)::~?\\w+\\("),
                                        QRegularExpression::MultilineOption);
        QHash<QString, QString> fileOf;
        for (const char* folder : {"app", "model", "view", "sim"}) {
            QDirIterator walk(QStringLiteral(HAIRPAINT_SOURCE_DIR "/") + QLatin1String(folder),
                              {QStringLiteral("*.cpp")}, QDir::Files, QDirIterator::Subdirectories);
            while (walk.hasNext()) {
                QFile file(walk.next());
                if (file.fileName().endsWith(QLatin1String("_wgl.cpp")) ||
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

    void noFileIsOverlong()
    {
        for (const char* folder : {"app", "model", "view", "sim", "tests", "resources"}) {
            QDirIterator walk(QStringLiteral(HAIRPAINT_SOURCE_DIR "/") + QLatin1String(folder),
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
