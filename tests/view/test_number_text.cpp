// What people type into fields for numbers is read in any field's unit and with either decimal sign.
#include "tests/support/test_program.h"
#include "view/look/number_text.h"

#include <QLocale>
#include <QTest>

#include <cmath>

using namespace hairpaint::view;

class TestNumberText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbers_are_read_in_the_fields_unit_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("value");
        const auto row = [](const char* text, const char* unit, double value) {
            QTest::newRow(qPrintable(QStringLiteral("%1 in %2").arg(QString::fromUtf8(text), QString::fromUtf8(unit))))
                << QString::fromUtf8(text) << QString::fromUtf8(unit) << value;
        };
        row("72", "cm", 72.0);
        row("  72 ", "", 72.0);
        row("7.25", "cm", 7.25);
        row("0,5", "cm", 0.5);
        row(",5", "cm", 0.5);
        row("5.", "cm", 5.0);
        row("1,234", "cm", 1.234);
        row("1,234.5", "mm", 1234.5);
        row("1.234,5", "mm", 1234.5);
        row("1 234,5", "mm", 1234.5);
        row("1,234,567", "mm", 1234567.0);
        row("1e3", "mm", 1000.0);
        row("-3", "%", -3.0);
        row("−3", "%", -3.0);
        row("+3", "%", 3.0);
        row("٣٫٥", "cm", 3.5);
        row("12.5 cm", "cm", 12.5);
        row("12.5cm", "cm", 12.5);
        row("12.5 CM", "cm", 12.5);
        row("4mm", "cm", 0.4);
        row("120 mm", "cm", 12.0);
        row("3in", "cm", 7.62);
        row("3\"", "cm", 7.62);
        row("3″", "cm", 7.62);
        row("3 inches", "mm", 76.2);
        row("1 1/2 in", "cm", 3.81);
        row("1½ in", "cm", 3.81);
        row("½\"", "cm", 1.27);
        row("1/2 in", "cm", 1.27);
        row("1 ft", "cm", 30.48);
        row("5' 2\"", "cm", 157.48);
        row("5 ft 2 in", "cm", 157.48);
        row("5ft2in", "cm", 157.48);
        row("1 m 20 cm", "cm", 120.0);
        row("0.12 m", "cm", 12.0);
        row("0.08 mm", "µm", 80.0);
        row("80 μm", "µm", 80.0);
        row("1.5+2", "cm", 3.5);
        row("10 cm - 5 mm", "cm", 9.5);
        row("10 - 5 mm", "cm", 9.5);
        row("10 − 5mm", "cm", 9.5);
        row("3in+1", "cm", 8.62);
        row("2*3,5", "cm", 7.0);
        row("10 cm / 4", "cm", 2.5);
        row("2 × 3 mm", "cm", 0.6);
        row("90", "°", 90.0);
        row("90°", "°", 90.0);
        row("90 deg", "°", 90.0);
        row("1 rad", "°", 180.0 / 3.14159265358979);
        row("50 %", "%", 50.0);
        row("50%", "%", 50.0);
        row("36 km/h", "m/s", 10.0);
        row("3 m/s", "m/s", 3.0);
        row("140 hairs/cm²", "hairs/cm²", 140.0);
        row("140 /cm2", "hairs/cm²", 140.0);
        row("1 /mm²", "hairs/cm²", 100.0);
        row("3 turns", "turns per 10 cm", 3.0);
        row("3 turns per 10 cm", "turns per 10 cm", 3.0);
        row("5600 K", "K", 5600.0);
    }
    void numbers_are_read_in_the_fields_unit()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(double, value);
        for (const char* const language : {"C", "en_US", "es_ES", "de_CH"}) {
            QLocale::setDefault(QLocale(QLatin1StringView(language)));
            const tl::expected<double, QString> read = readNumber(text, {.unit = unit});
            QLocale::setDefault(QLocale::c());
            QVERIFY2(read.has_value(), read ? "" : qPrintable(read.error()));
            QVERIFY2(std::abs(*read - value) < 1e-6 * (1.0 + std::abs(value)), qPrintable(QString::number(*read)));
        }
    }

    void whole_numbers_may_show_their_thousands_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("comma") << QStringLiteral("4,096") << 4096.0;
        QTest::newRow("point") << QStringLiteral("4.096") << 4096.0;
        QTest::newRow("space") << QStringLiteral("4 096") << 4096.0;
        QTest::newRow("none") << QStringLiteral("4096") << 4096.0;
        QTest::newRow("a fraction") << QStringLiteral("0,500") << 0.5;
        QTest::newRow("no thousand") << QStringLiteral("4,09") << 4.09;
    }
    void whole_numbers_may_show_their_thousands()
    {
        QFETCH(QString, text);
        QFETCH(double, value);
        QCOMPARE(readNumber(text, {.whole = true}).value_or(-1.0), value);
    }

    void what_can_not_be_read_is_said_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("says");
        const QString cm = QStringLiteral("cm");
        QTest::newRow("nothing") << QString() << cm << QStringLiteral("no number");
        QTest::newRow("a word") << QStringLiteral("long") << cm << QStringLiteral("“long” is not a number");
        QTest::newRow("an open sum") << QStringLiteral("5+") << cm << QStringLiteral("“5+”");
        QTest::newRow("two numbers") << QStringLiteral("5 6") << cm << QStringLiteral("“5 6”");
        QTest::newRow("points") << QStringLiteral("1.2.3") << cm << QStringLiteral("“1.2.3”");
        QTest::newRow("too large") << QStringLiteral("1e999") << cm << QStringLiteral("too large");
        QTest::newRow("by nothing") << QStringLiteral("5/0") << cm << QStringLiteral("divided by 0");
        QTest::newRow("an angle for a length")
            << QStringLiteral("5°") << cm << QStringLiteral("“°” is no unit for this; use cm, mm, m, in, ft.");
        QTest::newRow("a unit nobody knows")
            << QStringLiteral("5 parsec") << cm << QStringLiteral("“parsec” is no unit for this");
        QTest::newRow("a length for a percentage")
            << QStringLiteral("5 cm") << QStringLiteral("%") << QStringLiteral("use %.");
        QTest::newRow("a unit for a plain number")
            << QStringLiteral("5 cm") << QString() << QStringLiteral("type the number alone");
        QTest::newRow("the larger unit last") << QStringLiteral("2 in 5 ft") << cm << QStringLiteral("not a number");
    }
    void what_can_not_be_read_is_said()
    {
        QFETCH(QString, text);
        QFETCH(QString, unit);
        QFETCH(QString, says);
        const tl::expected<double, QString> read = readNumber(text, {.unit = unit});
        QVERIFY(!read.has_value());
        QVERIFY2(read.error().contains(says), qPrintable(read.error()));
    }
};

HAIRPAINT_TEST(TestNumberText, Widgets)
#include "test_number_text.moc"
