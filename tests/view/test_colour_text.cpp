// Colours as other programs put them into the clipboard.
#include "tests/support/test_program.h"
#include "view/look/colour_text.h"

#include <QtTest>

using hairpaint::view::colourFromText;

class TestColourText : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aColourIsReadInEveryUsualForm_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("name"); // Empty: none.
        const QString colour = QStringLiteral("#1a2b3c");
        for (const char* text :
             {"#1a2b3c", "1A2B3C", " #1a2b3c ", "0x1a2b3c", "#1a2b3cff", "1a2b3c80", "rgb(26, 43, 60)", "RGB(26 43 60)",
              "rgba(26,43,60,0.5)", "rgb(26 43 60 / 50%)", "rgb(10.2%, 16.9%, 23.5%)"})
            QTest::newRow(text) << QString::fromLatin1(text) << colour;
        QTest::newRow("three digits") << QStringLiteral("#abc") << QStringLiteral("#aabbcc");
        QTest::newRow("three and an alpha") << QStringLiteral("abcf") << QStringLiteral("#aabbcc");
        for (const char* text : {"", "#", "#12", "#12345", "12345g", "0x", "rgb(1,2)", "rgb(1,2,256)", "rgb(1,2,-3)",
                                 "rgb(1..2,3,4)", "rgb(1,2,3", "red-ish"})
            QTest::newRow(*text == '\0' ? "nothing" : text) << QString::fromLatin1(text) << QString();
    }
    void aColourIsReadInEveryUsualForm()
    {
        QFETCH(const QString, text);
        QFETCH(const QString, name);
        const std::optional<QColor> colour = colourFromText(text);
        QCOMPARE(colour ? colour->name() : QString(), name);
    }
};

HAIRPAINT_TEST(TestColourText, None)
#include "test_colour_text.moc"
