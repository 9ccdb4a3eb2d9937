// Hair exported from the command line: every format, one group or all, for a program.
#include "model/commands/commands.h"
#include "model/exporting/export_format.h"
#include "model/files/project_file.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::test;

class TestExportCommand : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_project;
    std::size_t m_hairs = 0; ///< That are exported.

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] Outcome exported(const char* name, const QStringList& options = {}) const
    {
        return runProgram(QStringList{QStringLiteral("export"), m_project, QStringLiteral("-o"), path(name)} + options);
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = path("two.hairpaint");
        QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), m_project, QStringLiteral("--preset"),
                             QStringLiteral("Two plaits")})
                     .code,
                 0);
        const model::Result<model::Project> project = model::loadProject(m_project);
        QVERIFY(project);
        model::Document document(thinned(*project));
        model::HairGroup other = document.committed().groups.front();
        other.name = QStringLiteral("Other");
        document.push(model::addGroupCommand(document, other));
        QVERIFY(model::saveProject(document.committed(), m_project, {}));
        m_hairs = static_cast<std::size_t>(infoOf(m_project)[QLatin1String("exported")].toInt());
        QVERIFY2(m_hairs > 1000, qPrintable(QString::number(m_hairs)));
    }

    void everyFormatIsWritten_data()
    {
        QTest::addColumn<QString>("suffix");
        for (const model::ExportFormat& format : model::exportFormats())
            QTest::newRow(format.suffix) << QString::fromLatin1(format.suffix);
    }
    void everyFormatIsWritten()
    {
        QFETCH(QString, suffix);
        const QByteArray name = "all." + suffix.toLatin1();
        const Outcome outcome = exported(name.constData(), {QStringLiteral("--target"), QStringLiteral("blender")});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        QVERIFY(contentOf(path(name.constData())).size() > 10'000);
    }

    void oneGroupIsPartOfAll()
    {
        QCOMPARE(exported("all.hair").code, 0);
        QCOMPARE(exported("one.hair", {QStringLiteral("--group"), QStringLiteral("Other")}).code, 0);
        QCOMPARE(exported("few.hair", {QStringLiteral("--hairs"), QStringLiteral("500")}).code, 0);
        const auto all = readHair(path("all.hair"));
        const auto one = readHair(path("one.hair"));
        QCOMPARE(all.size(), m_hairs);
        QVERIFY(one.size() > 1000 && one.size() < all.size());
        QVERIFY(std::equal(one.begin(), one.end(), all.end() - static_cast<std::ptrdiff_t>(one.size())));
        QCOMPARE(readHair(path("few.hair")).size(), std::size_t{500});
    }

    void toleranceMakesFilesSmaller()
    {
        QCOMPARE(exported("whole.hair").code, 0);
        QCOMPARE(exported("less.hair", {QStringLiteral("--tolerance"), QStringLiteral("1")}).code, 0);
        // The wisps of a plait swing by some 4 mm to each side, and every swing less than that may go.
        QCOMPARE(exported("least.hair", {QStringLiteral("--tolerance"), QStringLiteral("4")}).code, 0);
        QCOMPARE(readHair(path("less.hair")).size(), m_hairs);
        QCOMPARE(readHair(path("least.hair")).size(), m_hairs);
        const auto bytes = [this](const char* name) { return QFileInfo(path(name)).size(); };
        QVERIFY(bytes("less.hair") * 5 < bytes("whole.hair") * 4);
        QVERIFY(bytes("least.hair") * 5 < bytes("whole.hair") * 2);
    }

    void aProgramGetsItsUnitAndAxis()
    {
        QCOMPARE(exported("own.hair").code, 0);
        QCOMPARE(exported("unreal.hair", {QStringLiteral("--target"), QStringLiteral("unreal")}).code, 0);
        const auto own = readHair(path("own.hair"));
        const auto other = readHair(path("unreal.hair"));
        QCOMPARE(other.size(), own.size());
        for (std::size_t i = 0; i < own.size(); i += 100) {
            const glm::vec3 tip = own[i].back();
            QCOMPARE(other[i].back(), 100.0F * glm::vec3(tip.x, -tip.z, tip.y));
        }
        QVERIFY(contentOf(path("unreal.hair")).left(128).contains("centimetres, z up"));
    }

    void aFilmIsAFileAFrame()
    {
        const QStringList film{QStringLiteral("--frames"), QStringLiteral("2-4"),     QStringLiteral("--motion"),
                               QStringLiteral("turn"),     QStringLiteral("--hairs"), QStringLiteral("200")};
        const Outcome outcome = exported("film.hair", film);
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        QCOMPARE(QDir(m_folder.path()).entryList({QStringLiteral("film*")}, QDir::Files),
                 (QStringList{QStringLiteral("film.0002.hair"), QStringLiteral("film.0003.hair"),
                              QStringLiteral("film.0004.hair")}));
        const auto first = readHair(path("film.0002.hair"));
        const auto last = readHair(path("film.0004.hair"));
        QCOMPARE(first.size(), std::size_t{200});
        QCOMPARE(last.size(), first.size());
        float moved = 0.0F;
        for (std::size_t i = 0; i < first.size(); ++i) {
            QCOMPARE(last[i].size(), first[i].size());
            moved = std::max(moved, glm::distance(first[i].back(), last[i].back()));
        }
        QVERIFY(moved > 1e-4F && moved < 0.5F);
    }

    void aFilmThatCantBeWrittenLeavesNothing()
    {
        QVERIFY(QDir().mkpath(path("blocked.0003.obj")));
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("export"), m_project, QStringLiteral("-o"), path("blocked.obj"),
                          QStringLiteral("--frames"), QStringLiteral("2-4")},
                         QStringLiteral("blocked.0003.obj")),
                 QString());
    }

    void everyMapGoesIntoAFolder()
    {
        QVERIFY(QDir().mkpath(path("maps")));
        const Outcome outcome = runProgram({QStringLiteral("export"), m_project, QStringLiteral("--maps"), path("maps"),
                                            QStringLiteral("--grey"), QStringLiteral("--uv-sheet"), path("sheet.svg")});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        QVERIFY(contentOf(path("sheet.svg")).startsWith("<svg"));
        const QStringList names = QDir(path("maps")).entryList(QDir::Files | QDir::Hidden);
        QCOMPARE(names.size(), 2 * static_cast<qsizetype>(model::mapSpecs().size()));
        // The density comes back as it was.
        QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), path("back.hairpaint"),
                             QStringLiteral("--map"), QStringLiteral("density:grey=") + path("maps/Scalp-density.png")})
                     .code,
                 0);
        const auto density = [](const QString& file) {
            const model::Result<model::Project> project = model::loadProject(file);
            return model::Document(*project).resolvedNow(project->groups.front().id, model::MapKind::Density);
        };
        const auto before = density(m_project);
        const auto after = density(path("back.hairpaint"));
        QCOMPARE(after->size(), before->size());
        for (int x = 0; x < before->size(); x += 3)
            QCOMPARE(after->texel(x, before->size() / 2)[0], before->texel(x, before->size() / 2)[0]);
    }

    void aFolderThatIsNotThereIsToldOf()
    {
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("export"), m_project, QStringLiteral("--maps"), path("nowhere")},
                         QStringLiteral("nowhere")),
                 QString());
    }

    void aGroupThatIsNotThereIsToldOf()
    {
        QCOMPARE(faultOf(m_folder.path(),
                         {QStringLiteral("export"), m_project, QStringLiteral("-o"), path("none.hair"),
                          QStringLiteral("--group"), QStringLiteral("Moustache")},
                         QStringLiteral("Moustache")),
                 QString());
    }
};

HAIRPAINT_TEST(TestExportCommand, Core)
#include "test_export_command.moc"
