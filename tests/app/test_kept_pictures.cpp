// Pictures that are kept: without background, in linear light, the same from the window and from the command line.
#include "app/headless/exr_file.h"
#include "app/headless/picture.h"
#include "app/headless/settled_hair.h"
#include "model/files/importer_client.h"
#include "tests/app/program.h"
#include "tests/app/thin_project.h"
#include "tests/support/locations.h"
#include "tests/support/test_program.h"
#include "view/head_area/stage.h"

#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <vector>

using namespace hairpaint;
using namespace hairpaint::test;

namespace {

constexpr QSize kKeptSize(96, 96);

/// sRGB, 0..1.
double encodedOf(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double linearOf(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace

class TestKeptPictures : public QObject
{
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_project;

    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }

    [[nodiscard]] Outcome render(const char* output, const QStringList& options) const
    {
        return runProgram(QStringList{QStringLiteral("render"), m_project, QStringLiteral("-o"), path(output),
                                      QStringLiteral("--size"), QStringLiteral("96x96"), QStringLiteral("--settle"),
                                      QStringLiteral("0")} +
                          options);
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_project = path("long.hairpaint");
        const Outcome made = runProgram({QStringLiteral("new"), QStringLiteral("-o"), m_project,
                                         QStringLiteral("--preset"), QStringLiteral("Long straight")});
        QVERIFY2(made.code == 0 && thinOut(m_project), qPrintable(made.error));
    }

    void anExrFileHoldsTheLightItIsGiven_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("a pixel") << QSize(1, 1);
        QTest::newRow("some lines of a block") << QSize(37, 5);
        QTest::newRow("some blocks") << QSize(33, 50);
    }

    void anExrFileHoldsTheLightItIsGiven()
    {
        QFETCH(QSize, size);
        std::vector<float> rgba;
        const int count = size.width() * size.height();
        for (int i = 0; i < count; ++i) {
            const float alpha = static_cast<float>(i % 7 + 1) / 7.0F;
            for (const int c : {0, 1, 2})
                rgba.push_back(alpha * static_cast<float>((i * (c + 3)) % 251) / 251.0F);
            rgba.push_back(alpha);
        }
        QFile file(path("written.exr"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(app::exrBytes(rgba, size));
        file.close();
        const auto read = model::ImporterClient(test::importProgram()).readImage(file.fileName());
        QVERIFY2(read, read ? "" : qPrintable(read.error().message));
        QCOMPARE(QSize(read->width, read->height), size);
        QCOMPARE(read->channels, 4);
        for (std::size_t i = 0; i < rgba.size(); ++i) { // Read back with its alpha taken out of its light.
            const double straight = double{rgba[i]} / (i % 4 == 3 ? 1.0 : double{rgba[i / 4 * 4 + 3]});
            QVERIFY2(std::abs(read->pixels[i] / 65535.0 - straight) < 1e-4, qPrintable(QString::number(i)));
        }
    }

    /// What the window saves, and what the command line does.
    void windowAndCommandLineGiveTheSamePicture_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("transparent");
        QTest::addColumn<int>("samples");
        QTest::newRow("png") << QStringLiteral("same.png") << false << 4;
        QTest::newRow("png without background") << QStringLiteral("bare.png") << true << 1;
        QTest::newRow("exr") << QStringLiteral("same.exr") << true << 16;
    }

    void windowAndCommandLineGiveTheSamePicture()
    {
        QFETCH(QString, name);
        QFETCH(bool, transparent);
        QFETCH(int, samples);
        QStringList options{QStringLiteral("--camera"), QStringLiteral("30,10,90"), QStringLiteral("--samples"),
                            QString::number(samples)};
        if (transparent)
            options.append(QStringLiteral("--transparent"));
        const Outcome outcome = render(name.toLatin1().constData(), options);
        QVERIFY2(outcome.code == 0, qPrintable(outcome.error));

        model::Result<model::Project> project = model::loadProject(m_project);
        QVERIFY(project.has_value());
        const app::SettledHair hair(std::move(*project), 0.0);
        rendering::Camera from;
        from.azimuthRad = 30.0F * 0.01745329252F;
        from.elevationRad = 10.0F * 0.01745329252F;
        rendering::Camera camera =
            view::pictureCamera(from, rendering::Fit::Hair, *hair.project().head, hair.frame().get(), 1.0F);
        camera.distanceM = 90.0F * 0.01F;
        rendering::Scene scene = app::pictureScene(hair.project(), hair.frame(), camera);
        scene.transparent = transparent;
        const QString own = path("own-") + name;
        QVERIFY(app::PictureMaker().save(scene, kKeptSize, {.samples = samples}, own));
        QVERIFY(!contentOf(own).isEmpty());
        QVERIFY(contentOf(own) == contentOf(path(name.toLatin1().constData())));
    }

    void aPictureWithoutBackgroundLiesOverAnyOther()
    {
        QVERIFY(render("over.png", {QStringLiteral("--transparent")}).code == 0);
        QVERIFY(render("whole.png", {}).code == 0);
        const QImage over(path("over.png"));
        const QImage whole(path("whole.png"));
        QVERIFY(over.hasAlphaChannel() && !whole.hasAlphaChannel());
        int soft = 0;
        for (int y = 0; y < kKeptSize.height(); ++y) {
            const QColor background = whole.pixelColor(0, y);
            QCOMPARE(over.pixelColor(0, y).alpha(), 0);
            for (int x = 0; x < kKeptSize.width(); ++x) {
                const QColor top = over.pixelColor(x, y);
                soft += top.alpha() > 0 && top.alpha() < 255 ? 1 : 0;
                const auto laid = [&](double colour, double below) {
                    return encodedOf(linearOf(colour) * top.alphaF() + linearOf(below) * (1.0 - top.alphaF()));
                };
                const QColor wanted = whole.pixelColor(x, y);
                QVERIFY2(std::abs(laid(top.redF(), background.redF()) - wanted.redF()) < 0.03 &&
                             std::abs(laid(top.blueF(), background.blueF()) - wanted.blueF()) < 0.03,
                         qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
            }
        }
        QVERIFY2(soft > 100, qPrintable(QString::number(soft)));
    }

    void whatCannotBeDrawnIsSaid_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("word");
        const auto add = [](const char* option, const char* value, const char* word) {
            QTest::addRow("%s %s", option, value)
                << QStringList{QString::fromLatin1(option), QString::fromLatin1(value)} << QString::fromLatin1(word);
        };
        add("--samples", "3", "16");
        add("--samples", "2", "16");
        add("--samples", "32", "16");
        QTest::newRow("samples of a large picture") << QStringList{QStringLiteral("--samples"), QStringLiteral("4"),
                                                                   QStringLiteral("--size"), QStringLiteral("16x4100")}
                                                    << QStringLiteral("4096");
        add("--camera", "30", "AZIMUTH");
        add("--camera", "30,95", "AZIMUTH");
        add("--camera", "30,10,2", "AZIMUTH");
        add("--camera", "a,b", "AZIMUTH");
        QTest::newRow("two directions") << QStringList{QStringLiteral("--camera"), QStringLiteral("0,0"),
                                                       QStringLiteral("--view"), QStringLiteral("front")}
                                        << QStringLiteral("exclude");
    }

    void whatCannotBeDrawnIsSaid()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, word);
        const Outcome outcome = render("none.png", options);
        QCOMPARE(outcome.code, 2);
        QVERIFY2(outcome.error.contains(word), qPrintable(outcome.error));
        QVERIFY(!QFile::exists(path("none.png")));
    }
};

HAIRPAINT_TEST(TestKeptPictures, Core)
#include "test_kept_pictures.moc"
