// Light presets, names and the colour of a temperature.
#include "model/project/light_settings.h"
#include "tests/support/test_program.h"

#include <QSet>
#include <QtTest>

using namespace hairpaint::model;

class TestLightSettings : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aNeutralTemperatureChangesNothing()
    {
        for (const float channel : temperatureColour(kNeutralTemperatureK))
            QVERIFY(std::abs(channel - 1.0F) < 1e-5F);
    }

    void warmLightIsRedderAndAsBright()
    {
        float lastRatio = 1e9F;
        const int steps = static_cast<int>((kGreatestTemperatureK - kLeastTemperatureK) / 100.0F);
        for (int step = 0; step <= steps; ++step) {
            const float kelvin = kLeastTemperatureK + 100.0F * static_cast<float>(step);
            const std::array<float, 3> colour = temperatureColour(kelvin);
            QVERIFY(std::abs(0.2126F * colour[0] + 0.7152F * colour[1] + 0.0722F * colour[2] - 1.0F) < 1e-4F);
            const float ratio = colour[0] / std::max(colour[2], 1e-3F);
            QVERIFY2(ratio <= lastRatio * 1.001F, qPrintable(QString::number(static_cast<double>(kelvin))));
            lastRatio = ratio;
        }
        // A lamp of 2856 K (illuminant A) beside daylight of 6500 K.
        const std::array<float, 3> lamp = temperatureColour(2856.0F);
        QVERIFY(lamp[0] > 1.6F && lamp[0] < 2.2F && lamp[2] < 0.35F);
    }

    void everyPresetIsFoundAndDiffers()
    {
        QSet<QString> ids;
        for (const LightPreset& preset : lightPresets()) {
            QCOMPARE(findLightPreset(QString::fromLatin1(preset.id)), &preset);
            QVERIFY(!preset.titleText().isEmpty());
            ids.insert(QString::fromLatin1(preset.id));
            for (const LightPreset& other : lightPresets())
                QCOMPARE(other.light == preset.light, &other == &preset);
        }
        QCOMPARE(ids, (QSet<QString>{QStringLiteral("studio"), QStringLiteral("daylight"), QStringLiteral("sunset"),
                                     QStringLiteral("club"), QStringLiteral("backlit")}));
        QCOMPARE(findLightPreset(u"moon"), nullptr);
    }

    void aPresetLeavesTheScatteringAsItIs()
    {
        LightSettings current;
        current.scattering = Scattering::IlluminatedLines;
        for (const LightPreset& preset : lightPresets())
            QCOMPARE(preset.appliedTo(current).scattering, Scattering::IlluminatedLines);
    }
};

HAIRPAINT_TEST(TestLightSettings, None)
#include "test_light_settings.moc"
