// Each built-in style is drawn as the picture that its file shows it with.
#include "app/headless/picture.h"
#include "app/styles/style_pictures.h"
#include "model/files/preset_file.h"
#include "tests/app/picture_difference.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace hairpaint;

namespace {

/// Limit on the mean difference over all pixels and channels, of 255: as of golden pictures.
constexpr double kMostMeanDifference = 2.0;

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
        const double found = test::meanDifference(now, preset->picture);
        QVERIFY2(found < kMostMeanDifference, qPrintable(QString::number(found)));
    }
};

HAIRPAINT_TEST(TestBuiltInPictures, Core)
#include "test_built_in_pictures.moc"
