// The table of skin tones.
#include "model/project/skin_tone.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace hairpaint::model;

class TestSkinTone : public QObject
{
    Q_OBJECT
private:
    static double luminance(QRgb colour) { return 0.21 * qRed(colour) + 0.72 * qGreen(colour) + 0.07 * qBlue(colour); }

private Q_SLOTS:
    void eachIsFoundByItsId()
    {
        for (const SkinLook& look : skinLooks()) {
            QCOMPARE(findSkinLook(QString::fromLatin1(look.id)), &look);
            QCOMPARE(&skinLook(look.tone), &look);
        }
        QCOMPARE(findSkinLook(u"green"), nullptr);
        QCOMPARE(findSkinLook(u""), nullptr);
    }

    void tonesGrowDarkerAndLipsAndLidsAreAShadeApart()
    {
        QCOMPARE(skinLooks().size(), std::size_t{8}); // Six of skin after the clay, and the head's own.
        double before = 256.0;
        for (const SkinLook& look : skinLooks().subspan(1, 6)) {
            QVERIFY2(luminance(look.skin) < before - 15.0, look.id);
            before = luminance(look.skin);
        }
        for (const SkinLook& look : skinLooks())
            for (const QRgb part : {look.lips, look.lids}) {
                const double darker = luminance(look.skin) - luminance(part);
                QVERIFY2(darker > 3.0 && darker < 60.0, look.id); // A shade, and no lipstick.
            }
    }
};

HAIRPAINT_TEST(TestSkinTone, None)
#include "test_skin_tone.moc"
