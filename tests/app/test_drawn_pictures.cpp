// Maps drawn as images: pictures show hair where they are green and long hair where they are blue, the same every time.
#include "tests/app/project_folder.h"
#include "tests/app/thin_project.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <array>

using namespace hairpaint::test;

namespace {

/// The lowest row with some hair between two columns: pixels that `bald` shows otherwise. -1 where there is none.
int lowestHair(const QImage& picture, const QImage& bald, int fromX, int toX)
{
    for (int y = bald.height() - 1; y >= 0; --y) {
        int hair = 0;
        for (int x = fromX; x < toX; ++x)
            hair += picture.pixel(x, y) != bald.pixel(x, y) ? 1 : 0;
        if (hair >= 3)
            return y;
    }
    return -1;
}

} // namespace

class TestDrawnPictures : public QObject
{
    Q_OBJECT
private:
    ProjectFolder m_folder;

    /// A picture from behind, 256 by 256; null where it can't be taken.
    [[nodiscard]] QImage backOf(const QString& project, const char* settleSeconds) const
    {
        const QString out = m_folder.path("back.png");
        const Outcome outcome = runProgram(
            {QStringLiteral("render"), project, QStringLiteral("-o"), out, QStringLiteral("--size"),
             QStringLiteral("256x256"), QStringLiteral("--view"), QStringLiteral("back"), QStringLiteral("--fit"),
             QStringLiteral("bust"), QStringLiteral("--settle"), QString::fromLatin1(settleSeconds)});
        return outcome.code == 0 ? QImage(out) : QImage();
    }

private Q_SLOTS:
    void aPictureShowsLongHairWhereTheImageIsBlue()
    {
        // The crown is the map's middle; the left half is seen on the right.
        QImage crown(256, 256, QImage::Format_RGB32);
        QImage left(256, 256, QImage::Format_RGB32);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                const bool inside = (x - 128) * (x - 128) + (y - 128) * (y - 128) < 60 * 60;
                crown.setPixel(x, y, inside ? qRgb(205, 255, 205) : qRgb(255, 255, 255));
                left.setPixel(x, y, x < 128 ? qRgb(0, 0, 255) : qRgb(204, 204, 255)); // all and a fifth
            }
        QVERIFY(crown.save(m_folder.path("crown.png")) && left.save(m_folder.path("left.png")));
        QVERIFY(left.mirrored(true, false).save(m_folder.path("right.png")));
        const auto picture = [this](const QString& density, const QString& length) {
            return backOf(m_folder.project("blue.hairpaint",
                                           {QStringLiteral("density=") + density, QStringLiteral("length=") + length}),
                          "2");
        };
        const QImage bald = picture(m_folder.filled("bald.png", Qt::white), m_folder.path("left.png"));
        QCOMPARE(bald.size(), QSize(256, 256));
        for (const bool blueLeft : {true, false}) {
            const QImage hair = picture(m_folder.path("crown.png"), m_folder.path(blueLeft ? "left.png" : "right.png"));
            QCOMPARE(hair.size(), bald.size());
            const int rowLeft = lowestHair(hair, bald, 0, 112);
            const int rowRight = lowestHair(hair, bald, 144, 256);
            const int lower = blueLeft ? rowRight - rowLeft : rowLeft - rowRight;
            QVERIFY2(rowLeft > 0 && rowRight > 0 && lower > 40,
                     qPrintable(QStringLiteral("down to row %1 left, %2 right").arg(rowLeft).arg(rowRight)));
        }
    }

    /// The map's left half is the head's own right, which the view from behind shows on the right.
    void aPictureShowsHairWhereTheImageIsGreen()
    {
        const auto picture = [this](const QString& density) {
            const QString file = m_folder.project(
                "half.hairpaint", {QStringLiteral("density=") + density,
                                   QStringLiteral("length=") + m_folder.filled("short.png", QColor(230, 230, 255))});
            return backOf(file, "0");
        };
        const QImage bald = picture(m_folder.filled("bald.png", Qt::white));
        const QImage half = picture(drawn("left_half"));
        QCOMPARE(bald.size(), QSize(256, 256));
        QCOMPARE(half.size(), QSize(256, 256));
        int left = 0;
        int right = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x)
                if (bald.pixel(x, y) != half.pixel(x, y))
                    ++(x < 128 ? left : right);
        QVERIFY2(right > 4000 && left < right / 10,
                 qPrintable(QStringLiteral("%1 pixels differ on the left, %2 on the right").arg(left).arg(right)));
    }

    void theSameImagesGiveTheSameBytes()
    {
        std::array<QByteArray, 2> projects;
        std::array<QByteArray, 2> hairs;
        std::array<QByteArray, 2> pictures;
        for (std::size_t i = 0; i < 2; ++i) {
            const QString file = m_folder.project("same.hairpaint", {QStringLiteral("density=") + drawn("density"),
                                                                     QStringLiteral("length=") + drawn("length"),
                                                                     QStringLiteral("curl=") + drawn("curl")});
            projects[i] = contentOf(file);
            QVERIFY(thinOut(file));
            const QString hair = m_folder.path("same.hair");
            const QString out = m_folder.path("same.png");
            QCOMPARE(runProgram({QStringLiteral("export"), file, QStringLiteral("-o"), hair, QStringLiteral("--settle"),
                                 QStringLiteral("0.2")})
                         .code,
                     0);
            QCOMPARE(runProgram({QStringLiteral("render"), file, QStringLiteral("-o"), out, QStringLiteral("--size"),
                                 QStringLiteral("160x160"), QStringLiteral("--settle"), QStringLiteral("0.2")})
                         .code,
                     0);
            hairs[i] = contentOf(hair);
            pictures[i] = contentOf(out);
            QVERIFY(!projects[i].isEmpty() && !hairs[i].isEmpty() && !pictures[i].isEmpty());
        }
        QVERIFY(projects[0] == projects[1]);
        QVERIFY(hairs[0] == hairs[1]);
        QVERIFY(pictures[0] == pictures[1]);
    }
};

HAIRPAINT_TEST(TestDrawnPictures, Core)
#include "test_drawn_pictures.moc"
