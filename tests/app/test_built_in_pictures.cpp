// Each built-in style is drawn as the picture that its file shows it with.
#include "app/headless/picture.h"
#include "app/styles/style_pictures.h"
#include "model/files/preset_file.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cstdlib>

using namespace hairpaint;

namespace {

/// Limit on the mean difference over all pixels and channels, of 255: as of golden pictures.
constexpr double kMostMeanDifference = 2.0;

double meanDifferenceOf(const QImage& a, const QImage& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QColor here = a.pixelColor(x, y);
            const QColor there = b.pixelColor(x, y);
            sum += std::abs(here.red() - there.red()) + std::abs(here.green() - there.green()) +
                   std::abs(here.blue() - there.blue());
        }
    return sum / (3.0 * a.width() * a.height());
}

} // namespace

class TestBuiltInPictures : public QObject
{
    Q_OBJECT
private:
    app::PictureMaker m_maker;

private Q_SLOTS:
    void aStyleLooksAsItsPicture_data()
    {
        QTest::addColumn<QString>("path");
        for (const model::PresetEntry& entry : model::listPresets({}))
            QTest::newRow(qPrintable(entry.name)) << entry.path;
    }
    void aStyleLooksAsItsPicture()
    {
        QFETCH(QString, path);
        const model::Result<model::Preset> preset = model::loadPreset(path);
        QVERIFY(preset.has_value());
        const QImage now = app::stylePicture(*preset, m_maker);
        QCOMPARE(now.size(), preset->picture.size());
        const double found = meanDifferenceOf(now, preset->picture);
        QVERIFY2(found < kMostMeanDifference, qPrintable(QString::number(found)));
    }
};

HAIRPAINT_TEST(TestBuiltInPictures, Core)
#include "test_built_in_pictures.moc"
