// A character of several parts: it comes in by the command line, is drawn, gets hair on its scalp alone, and leaves as
// an avatar with its parts and their textures.
#include "model/files/glb_writing.h"
#include "model/files/project_file.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/character.h"
#include "tests/support/glb_json.h"
#include "tests/support/test_program.h"

#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

using namespace hairpaint;
using namespace hairpaint::test;

class TestCharacters : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_project;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] static QStringList meshNames(const QJsonObject& glb)
    {
        QStringList names;
        for (const auto& mesh : glb[QLatin1String("meshes")].toArray())
            names.append(mesh[QLatin1String("name")].toString());
        return names;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QFile file(path("Ann.glb"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(model::glbFromMesh(makeCharacter()));
        file.close();
        m_project = path("Ann.hairpaint");
        const Outcome made =
            runProgram({QStringLiteral("new"), QStringLiteral("-o"), m_project, QStringLiteral("--head"),
                        path("Ann.glb"), QStringLiteral("--preset"), QStringLiteral("Long straight")});
        QCOMPARE(made.error, QString());
        QVERIFY2(made.output.contains(QStringLiteral("Glasses")), qPrintable(made.output)); // It has no uvs.
        QVERIFY(thinOut(m_project));
    }

    void hairGrowsOnTheScalpAlone()
    {
        const Outcome outcome = runProgram({QStringLiteral("export"), m_project, QStringLiteral("-o"), path("a.hair")});
        QCOMPARE(outcome.error, QString());
        const auto strands = readHair(path("a.hair"));
        QVERIFY(strands.size() > 100);
        for (const std::vector<glm::vec3>& strand : strands)
            QVERIFY(std::abs(glm::distance(strand.front(), kCharacterHead) - 0.12F) < 0.005F);
    }

    void itLeavesAsAnAvatarWithItsPartsAndTextures()
    {
        const Outcome outcome = runProgram({QStringLiteral("export"), m_project, QStringLiteral("-o"), path("a.vrm"),
                                            QStringLiteral("--atlas"), QStringLiteral("1024")});
        QCOMPARE(outcome.error, QString());
        const QByteArray vrm = contentOf(path("a.vrm"));
        const QJsonObject json = jsonOf(vrm);
        for (const char* part : {"Body", "Eye_L", "Eye_R", "Bag", "Glasses"})
            QVERIFY2(meshNames(json).contains(QString::fromLatin1(part)), part);
        // The body's base colour is the picture that it came with.
        for (const auto& value : json[QLatin1String("materials")].toArray()) {
            const QJsonObject material = value.toObject();
            if (material[QLatin1String("name")].toString() != QLatin1String("Body"))
                continue;
            const int texture = material[QLatin1String("pbrMetallicRoughness")][QLatin1String("baseColorTexture")]
                                        [QLatin1String("index")]
                                            .toInt(-1);
            const int image = json[QLatin1String("textures")][texture][QLatin1String("source")].toInt(-1);
            const QJsonValue view = json[QLatin1String("bufferViews")]
                                        [json[QLatin1String("images")][image][QLatin1String("bufferView")].toInt(-1)];
            const qsizetype bin = 28 + qFromLittleEndian<quint32>(vrm.constData() + 12);
            const QImage picture = QImage::fromData(
                vrm.sliced(bin + view[QLatin1String("byteOffset")].toInt(), view[QLatin1String("byteLength")].toInt()));
            QCOMPARE(picture.size(), QSize(64, 64));
            QCOMPARE(picture.pixelColor(2, 2), QColor(200, 30, 30));
            QCOMPARE(picture.pixelColor(18, 2), QColor(30, 30, 200));
            return;
        }
        QFAIL("there is no material of the body");
    }

    void itsPartsAreDrawn()
    {
        const Outcome outcome =
            runProgram({QStringLiteral("render"), m_project, QStringLiteral("-o"), path("a.png"),
                        QStringLiteral("--size"), QStringLiteral("400x400"), QStringLiteral("--fit"),
                        QStringLiteral("bust"), QStringLiteral("--hairs"), QStringLiteral("1")});
        QCOMPARE(outcome.error, QString());
        const QImage picture(path("a.png"));
        int red = 0;
        int blue = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                red += colour.red() > 2 * std::max(colour.green(), colour.blue()) ? 1 : 0;
                blue += colour.blue() > 2 * std::max(colour.green(), colour.red()) ? 1 : 0;
            }
        QVERIFY2(red > 200 && blue > 200, qPrintable(QStringLiteral("%1 red, %2 blue").arg(red).arg(blue)));
    }

    void unknownPartsAreNamed()
    {
        const Outcome outcome =
            runProgram({QStringLiteral("new"), QStringLiteral("-o"), path("b.hairpaint"), QStringLiteral("--head"),
                        path("Ann.glb"), QStringLiteral("--grow-on"), QStringLiteral("Skull")});
        QCOMPARE(outcome.code, 1);
        QVERIFY2(outcome.error.contains(QStringLiteral("Skull")), qPrintable(outcome.error));
        QVERIFY(!QFile::exists(path("b.hairpaint")));
    }

    void whatIsNotNamedStaysOut()
    {
        const Outcome outcome =
            runProgram({QStringLiteral("new"), QStringLiteral("-o"), path("c.hairpaint"), QStringLiteral("--head"),
                        path("Ann.glb"), QStringLiteral("--head-part"), QStringLiteral("Head"),
                        QStringLiteral("--head-part"), QStringLiteral("Iris")});
        QCOMPARE(outcome.error, QString());
        const model::Result<model::Project> project = model::loadProject(path("c.hairpaint"));
        QVERIFY(project);
        QCOMPARE(project->head->parts.size(), std::size_t{2});
    }
};

HAIRPAINT_TEST(TestCharacters, Core)
#include "test_characters.moc"
