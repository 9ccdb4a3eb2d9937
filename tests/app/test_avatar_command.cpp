// Avatars from the command line: a body's mesh becomes a head, and goes out with its hair.
#include "model/files/glb_writing.h"
#include "model/files/head_file.h"
#include "model/files/project_file.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/glb_json.h"
#include "tests/support/mannequin.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::test;

class TestAvatarCommand : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_project;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] QJsonValue vrmIn(const char* name) const
    {
        return jsonOf(contentOf(path(name)))[QLatin1String("extensions")][QLatin1String("VRMC_vrm")];
    }

private Q_SLOTS:
    void initTestCase()
    {
        QFile file(path("body.vrm"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(model::glbFromMesh(makeMannequin(0.6F)));
        file.close();
        m_project = path("Ann.hairpaint");
        const Outcome outcome =
            runProgram({QStringLiteral("new"), QStringLiteral("-o"), m_project, QStringLiteral("--head"),
                        path("body.vrm"), QStringLiteral("--preset"), QStringLiteral("Long straight")});
        QCOMPARE(outcome.error, QString());
        QVERIFY(thinOut(m_project));
    }

    void aBodyIsNoHeadOfAFewCentimetres()
    {
        const model::Result<model::Project> project = model::loadProject(m_project);
        QVERIFY(project);
        QCOMPARE(project->head->unitScale, 1.0F);
        QCOMPARE(model::skeletonOf(*project->head)->joints.size(), kMannequin.size());
    }

    void theAvatarIsNamedAsItsProject()
    {
        const Outcome outcome = runProgram({QStringLiteral("export"), m_project, QStringLiteral("-o"), path("a.vrm"),
                                            QStringLiteral("--atlas"), QStringLiteral("1024")});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(outcome.code, 0);
        const QJsonValue meta = vrmIn("a.vrm")[QLatin1String("meta")];
        QCOMPARE(meta[QLatin1String("name")].toString(), QStringLiteral("Ann"));
        QCOMPARE(meta[QLatin1String("authors")].toArray(), QJsonArray{QStringLiteral("Unknown")});
        QVERIFY(
            jsonOf(contentOf(path("a.vrm")))[QLatin1String("extensions")][QLatin1String("VRMC_springBone")].isObject());
        QVERIFY(QFile::exists(path("a-rootToTip.png")));
    }

    void whatIsImpliedMayBeSaid()
    {
        const Outcome outcome = runProgram(
            {QStringLiteral("export"), m_project, QStringLiteral("-o"), path("b.vrm"), QStringLiteral("--atlas"),
             QStringLiteral("1024"), QStringLiteral("--cards"), QStringLiteral("--bones"),
             QStringLiteral("--with-head"), QStringLiteral("--author"), QStringLiteral("Zoë")});
        QCOMPARE(outcome.error, QString());
        QCOMPARE(vrmIn("b.vrm")[QLatin1String("meta")][QLatin1String("authors")][0].toString(), QStringLiteral("Zoë"));
    }

    void avatarsThatMakeNoSenseAreWrongUsage_data()
    {
        QTest::addColumn<QString>("options");
        QTest::addColumn<QString>("named");
        const auto row = [](const char* options, const char* named) {
            QTest::newRow(options) << QString::fromLatin1(options) << QString::fromLatin1(named);
        };
        row("-o a.glb --author Ann", "--author");
        row("-o a.glb --cards --author Ann", ".vrm");
        row("-o a.vrm --lods 2", "--lods");
        row("-o a.vrm --frames 1-2", "--frames");
        row("-o a.vrm --triangles 999", "1000 to 60000");
        row("-o a.vrm --atlas 2000", "1024, 2048, 4096");
        row("-o a.fbx", ".vrm");
        row("--author Ann --maps .", "--author");
    }
    void avatarsThatMakeNoSenseAreWrongUsage()
    {
        QFETCH(QString, options);
        QFETCH(QString, named);
        const Outcome outcome =
            runProgram(QStringList{QStringLiteral("export"), m_project} + options.split(QLatin1Char(' ')));
        QCOMPARE(outcome.code, 2);
        QVERIFY2(outcome.error.contains(named), qPrintable(outcome.error));
    }

    void aHeadAloneIsNoAvatar()
    {
        const QString bust = path("bust.hairpaint");
        QCOMPARE(runProgram({QStringLiteral("new"), QStringLiteral("-o"), bust}).code, 0);
        const QString problem =
            faultOf(m_folder.path(), {QStringLiteral("export"), bust, QStringLiteral("-o"), path("c.vrm")},
                    QStringLiteral("c.vrm"));
        QCOMPARE(problem, QString());
        const Outcome outcome = runProgram({QStringLiteral("export"), bust, QStringLiteral("-o"), path("c.vrm")});
        QVERIFY2(outcome.error.contains(QLatin1String(".glb with spring bones")), qPrintable(outcome.error));
        QVERIFY(!QFile::exists(path("c.vrm")));
    }

    void aBodyWithoutArmsIsToldOf()
    {
        model::RiggedMesh body = makeMannequin();
        for (model::HeadJoint& joint : body.skeleton.joints)
            if (const std::size_t at = joint.name.find("Hand"); at != std::string::npos)
                joint.name.replace(at, 4, "Claw");
        QFile file(path("claws.glb"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(model::glbFromMesh(body));
        file.close();
        const QString project = path("claws.hairpaint");
        const Outcome made = runProgram(
            {QStringLiteral("new"), QStringLiteral("-o"), project, QStringLiteral("--head"), path("claws.glb")});
        QCOMPARE(made.error, QString());
        const Outcome outcome = runProgram({QStringLiteral("export"), project, QStringLiteral("-o"), path("d.vrm")});
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains(QLatin1String("leftHand, rightHand")), qPrintable(outcome.error));
    }
};

HAIRPAINT_TEST(TestAvatarCommand, Core)
#include "test_avatar_command.moc"
